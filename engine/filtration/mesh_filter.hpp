// The alpha-mesh filters of thesis 7.4 on a quality mesh, and the interleaving ratio that the mesh proves for them.
//
// Let F(x) = min(d_P(x), rho), rho the radius of a ball that contains P. Beyond rho the offsets are star-shaped about
// its centre, so F has the diagram of the offsets. For each vertex v let lo_v <= F <= hi_v on all of its (unclipped)
// Voronoi cell. Cover the space at scale b by the cells of Steiner vertices with t(v) <= b and, for an input v, by the
// ball(v, b) before t(v) and the cell afterwards. All of these are closed and convex and grow with b, the balls stay
// inside their cells, so the nerve is the lower-star filtration of t on the whole Delaunay triangulation, inputs
// entering alone at 0. With c = max over v of max(hi_v / t_v, t_v / lo_v) the cover at b lies in the offset at c b and
// the other way round: the diagrams are within ln c on the log scale. The best values reach c* = max sqrt(hi_v / lo_v):
// any t between hi / c* and c* lo does, and the filter's own value clamped to that interval stays closest to the
// thesis.
//
// Bounds: an input has lo = r_v = half its nearest-neighbour distance and hi = R_v. A Steiner vertex with nearest input
// n has hi = max |corner - n| and lo = max(d/2, d - R_v), d = |v - n|: a point of the cell is no farther from v than
// from any input, so its distance s to v and to the inputs satisfy d_P >= max(d - s, s). A frame cell is unbounded: hi
// = rho. What is computed is rounded outwards, the centres' own error bounds included.
//
// A cell whose unclipped out-radius is at most (tau/2) nn(v) has hi <= (2 + tau) lo and hi <= tau s, s the thesis's value: for a
// Steiner vertex R_v <= (tau/2) d, so hi <= d + R_v <= tau d, and lo >= d/2; for an input hi <= tau lo, s = lo. Refinement with
// `certify` (mesh/refine.hpp) brings every other cell there too. So c* <= sqrt(2 + tau), and with the thesis's values c <= tau.
//
// Neither narrower bounds (sharp_bounds.hpp) nor clumps (tight_filter.hpp) make c* smaller on such meshes. Its worst cells stand next
// to an input whose lo = d/2 they reach. A clump of an input and its Steiner vertices, at the best of seven radii, had the smaller
// ratio for up to 4 inputs of 10, but for none of those that decide: over tau 2.05 to 3.08 and 29 meshes in the plane and in space
// c* went from 2.0064 to 2.0049 and from 2.0491 to 2.0484 in two cases, and stayed in 27.
#pragma once
#include <cstdint>

#include "certificate/certificate.hpp"
#include "mesh/domain.hpp"

namespace netmesh {

enum class MeshFilter { complete, basic };

// value[v] for every vertex: t(v), cut at rho; the basic filter gives inputs 0. intervals[v], when asked for: lo_v and hi_v. Needs a
// compact, complete mesh.
// O(cells). Scratch: 16 bytes a vertex. out_of_memory.
template <int D>
Status mesh_filter_values(const Store<D>& store, const Domain<D>& domain, MeshFilter filter, FilterValues values,
                          Arena& arena, double* value, Certificate* certificate, Interval* intervals = nullptr);

}  // namespace netmesh
