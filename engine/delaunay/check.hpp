// Independent checkers: they read vertices, neighbours and coordinates, nothing that was cached, and decide exactly.
#pragma once
#include <cstdint>

#include "delaunay/any_store.hpp"

namespace netmesh {

struct CheckResult {
    const char* violation;  // static text; null when all is well
    std::uint32_t cell;     // where; `none` when it is not about one cell
};

// On a compact store, O(cells) each (in-ball and orientation tests: one a facet). The first violation found is
// returned.

// Vertices distinct and in range, neighbours mutual with equal facets, each vertex's cell at that vertex.
CheckResult check_combinatorial(const AnyStore& store);

// Every cell positively oriented, and the hull closed and locally convex: with one point covered exactly once (which is
// checked too) the cells then cover the convex hull once. Needs check_combinatorial.
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
