// Independent checkers: they read vertices, neighbours and coordinates, nothing that was cached, and decide exactly.
#pragma once
#include <cstdint>

#include "delaunay/any_store.hpp"

namespace netmesh {

struct CheckResult {
    const char* violation;  // static text; null when all is well
    std::uint32_t cell;     // where; `none` when it is not about one cell
};

// On a compact store, O(cells) each (in-ball and orientation tests: one a facet, about 2 D one of the hull). The first
// violation found is returned.

// Vertices distinct and in range, neighbours mutual with equal facets, each vertex's cell at that vertex.
CheckResult check_combinatorial(const AnyStore& store);

// The cells are a triangulation of the convex hull of their vertices: each positively oriented, neighbours on opposite
// sides of their facet, the hull closed and locally convex, and as a whole the boundary of one convex body, once (proof
// at check_hull). So nothing is pinched, doubled, apart from the rest or wound twice. Needs check_combinatorial.
CheckResult check_geometric(const AnyStore& store);

// No vertex opposite a facet strictly inside the ball on the other side; with the above, by Delaunay's lemma, no vertex
// strictly inside any ball. Needs check_geometric.
CheckResult check_delaunay(const AnyStore& store);

#ifdef NETMESH_VALIDATE
// What is wrong with a store in use, ghosts and free slots included: counts, vertices, mutual neighbours, orientation
// and the Delaunay property, all exactly; null when all is well or when it has more than validated_cells_max slots.
// O(cells).
constexpr std::uint32_t validated_cells_max = 3000;
const char* violation_in_use(const AnyStore& store);
#endif

}  // namespace netmesh
