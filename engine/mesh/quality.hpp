// Aspect ratios of the clipped Voronoi cells of a mesh, from its cells as they are.
#pragma once
#include <cstdint>

#include "mesh/domain.hpp"

namespace netmesh {

// Out-radius over in-radius of clipped Voronoi cells (2.4, 7.3.1): out-radius to the farthest corner inside the domain
// or crossing of a Voronoi edge with its sphere, in-radius half of vertex.nearest2's root. Corners of cells so flat
// (heights of about 1e-13 of their edges) that doubles do not determine them are left out; the certificate counts such
// a cell as reaching to rho. *worst: the largest over inserted vertices that are not exempt; *vertex: where; 0 and
// `none` when there are none. Needs a compact store with spheres and nearest2. O(cells); scratch: 8 bytes a vertex.
// out_of_memory.
template <int D>
Status worst_aspect_ratio(const Store<D>& store, const Domain<D>& domain, Arena& arena, double* worst,
                          std::uint32_t* vertex);

// The same recomputed by the checker: from vertices, neighbour words and coordinates alone, corners by solving for
// them anew.
template <int D>
Status recomputed_aspect_ratio(const Store<D>& store, const Domain<D>& domain, Arena& arena, double* worst,
                               std::uint32_t* vertex);

// out2[v], for every vertex: squared out-radius of v's clipped cell, corners as the mesh has them or solved for anew.
// O(cells), no scratch.
enum class Corners { kept, recomputed };
template <int D> void clipped_out_radii(const Store<D>& store, const Domain<D>& domain, Corners corners, double* out2);

// nearest2[v], for every vertex: squared distance to the nearest other vertex, over the edges of cells. O(cells).
template <int D> void recomputed_nearest2(const Store<D>& store, double* nearest2);

}  // namespace netmesh
