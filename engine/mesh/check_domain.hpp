// What a mesh says of its domain and of who is exempt from quality, checked by plain loops.
#pragma once
#include <cstdint>

#include "delaunay/check.hpp"
#include "mesh/domain.hpp"

namespace netmesh {

// - Vertices of the hull are exempt, as their cells are not bounded; the domain contains all inputs.
// - A mesh with a boundary net (thesis 3.5) has all vertices of its hull on the domain's sphere. There are as many
//   exempt vertices as places on that sphere that are delta apart, delta the diameter of the ball about the domain's
//   centre that contains the inputs; and they leave no point of it farther than delta from all.
// - Any other mesh has the domain inside of its hull, and no exempt vertex that is not on the hull.
// - Vertices of shells do not count: domains[v] is the cage that v is in, none outside of all; null: no cages.
// `whole`: all vertices have to belong to cells. Vertex::cell need not be known. A compact store. O(cells), and the
// square of the boundary net. Changes Vertex::queued and sets it back to 0.
template <int D>
CheckResult check_domain(const Store<D>& store, const Domain<D>& domain, const std::uint32_t* domains, bool whole);

}  // namespace netmesh
