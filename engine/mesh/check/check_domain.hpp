// What a mesh says of its domain and of who is exempt from quality, checked by plain loops.
#pragma once
#include <cstdint>

#include "delaunay/check.hpp"
#include "mesh/any_domain.hpp"

namespace netmesh {

struct NetPromise {
    double tau;
    double spacing;  // 0: there may be a net, of spacing 1, or none
};

// - Vertices of the hull are exempt, as their cells are not bounded; the domain contains all inputs.
// - A mesh with a boundary net (thesis 3.5) has all vertices of its hull on the domain's sphere. Exempt vertices are
//   delta apart there, delta the net's spacing times the diameter 2 rho of the ball about the domain's centre that
//   contains the inputs, and they leave no point of the sphere farther than delta from all. Its radius is what keeps
//   refinement to tau inside of it: 3 rho and (K sqrt 2 + 1) delta + rho or more, K = 2 tau / (tau - 2).
// - Any other mesh has the domain inside of its hull, and no exempt vertex that is not on the hull.
// - Vertices of shells do not count: domains[v] is the cage that v is in, none outside of all; null: no cages.
// `whole`: all vertices have to belong to cells. Vertex::cell need not be known. A compact store. O(cells), and the
// square of the boundary net. Changes Vertex::queued and sets it back to 0.
CheckResult check_domain(const AnyStore& store, const AnyDomain& domain, const std::uint32_t* domains, bool whole,
                         const NetPromise& net);

}  // namespace netmesh
