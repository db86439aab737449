// Aspect ratios of the clipped Voronoi cells of a mesh.
#pragma once
#include <cstdint>

#include "mesh/any_domain.hpp"

namespace netmesh {

// Out-radius over in-radius of clipped Voronoi cells (2.4, 7.3.1): out-radius as clipped_cell.hpp has it, in-radius
// half of vertex.nearest2's root. *worst: the largest over inserted vertices that are not exempt, +infinity where a
// cell is not bounded; *vertex: where; 0 and `none` when there are none. Needs a compact store with spheres and
// nearest2. Scratch: 8 bytes a vertex, the star of a vertex. out_of_memory.
Status worst_aspect_ratio(const AnyStore& store, const AnyDomain& domain, Arena& arena, double* worst,
                          std::uint32_t* vertex);

// nearest2[v], for every vertex: squared distance to the nearest other vertex, over the edges of cells. O(cells).
void recomputed_nearest2(const AnyStore& store, double* nearest2);

}  // namespace netmesh
