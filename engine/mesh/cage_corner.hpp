// How far the cell of a cage reaches.
#pragma once
#include "mesh/cage.hpp"
#include "mesh/corner.hpp"

namespace netmesh {

// The cell of a cage is that of its vertices together, clipped to the ball of the domain around it. The farthest point
// from the cage's centre of those that are corners within the ball or on edges of the cell; *corner is left as it is
// when there is none. *leaves_ball: there is a corner outside of the ball, or one that is not known. False when the gap
// is too small for the search.
template <int D>
bool find_cage_corner(Store<D>& store, const Cage& cage, const Domain<D>& ball, Corner<D>* corner, bool* leaves_ball);

// Offers what of the clipped cell of a cage is neither a corner nor on an edge but farther from the cage's centre than
// the root of bound2 (clipped_cell.hpp). O(cells), and vertices for each pole of a face of the cage's cell beyond
// that.
template <int D>
void find_cage_pole(const Store<D>& store, const Cage& cage, const Domain<D>& ball, double bound2, Corner<D>* corner);

}  // namespace netmesh
