// The farthest corner of the cell of a cage.
#pragma once
#include "mesh/cage.hpp"
#include "mesh/corner.hpp"

namespace netmesh {

// The cell of a cage is that of its vertices together, clipped to the ball of the domain around it. *corner is left as
// it is when the clipped cell has none. False when the gap is too small for the search.
template <int D> bool find_cage_corner(Store<D>& store, const Cage& cage, const Domain<D>& ball, Corner<D>* corner);

}  // namespace netmesh
