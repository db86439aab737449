// The alpha-mesh filters of thesis 7.4 on a quality mesh, and the interleaving ratio that the mesh proves for them.
//
// Let F(x) = min(d_P(x), rho), rho the radius of a ball that contains P. Beyond rho the offsets are star-shaped about
// its centre, so F has the diagram of the offsets. For each vertex v let lo_v <= F <= hi_v on all of its (unclipped)
// Voronoi cell; for an input v, lo_v < nn / 2, nn the distance to its nearest neighbour in the mesh, and lo_v <= F
// where |x - v| >= lo_v. Cover the space at scale b by the cells of Steiner vertices with t(v) <= b and, for an input
// v, by the ball(v, min(b, lo_v)) before t(v) and the cell afterwards; t(v) may be above nn / 2. All of these are
// closed and convex and grow with b. The balls lie inside their cells and meet no other, so the nerve is the lower-star
// filtration of t on the whole Delaunay triangulation, inputs entering alone at 0. The cover at b lies in the sublevel
// set of F at max(b, hi_v over t_v <= b), as F <= b on the balls. The sublevel set at a lies in the cover at max(a, t_v
// over lo_v <= a): a point of it in a cell with lo_v > a is in an input's, F its distance from v, and so in the ball(v,
// a). With c = max over v of max(hi_v / t_v, t_v / lo_v) the cover at b then lies in the offset at c b and the other
// way round: the diagrams are within ln c on the log scale. The best values reach c* = max sqrt(hi_v / lo_v): any t
// between hi / c* and c* lo does, and the filter's own value clamped to that interval stays closest to the thesis.
//
// The bounds are those of certificate/interval.hpp, rounded outwards, the corners' own error bounds included. An
// unbounded cell has hi = rho.
//
// Cospherical vertices. The triangulation is that of lifts raised by infinitely small weights (predicates.cpp), and in
// general position it is the nerve of the cells that these weights have: so it is these cells that cover, here and in
// all filters of whole cells. They are closed and convex too, and their half-spaces are those of Voronoi cells but for
// right-hand sides, which differ by as little as the weights. So each point of such a cell is as near as that to the
// Voronoi cell (Hoffman), bounded or not, and F, which is Lipschitz, leaves the range of lo_v and hi_v there by as
// little at most. These are strict bounds on Voronoi cells, as they are rounded outwards by 2^-40 of themselves, far
// more than roundings need (rounding.hpp), or are where F is cut, which nothing exceeds. Hence they are bounds of F on
// the weighted cells, too, as soon as the weights are small enough. Balls of radius lo_v < nn / 2 lie inside these; and
// a point in the weighted cell of an input v where F < lo_v is within nn / 2 of v, so that F is its distance from v.
//
// Cells clipped to a ball B of centre o that contains P, of radius rho or more (AnyMesh::part): the offset in B
// has the diagram of the offset, as the projection to B moves points nearer to P, and where F = rho it is all of B,
// with the diagram of a point. So all of the above holds with Vor(v) in B for each cell, lo and hi needed there alone,
// and the nerve of what is left of the cells for the triangulation: it has the homology of a point, as B has. R and hi
// are those of clipped_reach.hpp, an exempt vertex's cell still has d / 2 and rho. Vertices whose cells do not meet B,
// absent ones, have rho for value and interval, as what comes last and is exact: they count nowhere.
//
// A cell whose unclipped out-radius is at most (tau/2) nn(v) has hi <= (2 + tau) lo and hi <= tau s, s the thesis's
// value: for a Steiner vertex R_v <= (tau/2) d, so hi <= d + R_v <= tau d, and lo >= d/2; for an input hi <= tau lo, s
// = lo. Refinement with `certify_filter` (mesh/loop/quality_rule.hpp) brings every other cell there too. So c* <=
// sqrt(2 + tau), and with the thesis's values c <= tau.
#pragma once
#include "filtration/any_mesh.hpp"

namespace netmesh {

constexpr std::size_t mesh_filter_vertex_bytes = sizeof(double);  // scratch of each vertex that is no input

// value[v]: t(v), cut at rho; the basic filter gives inputs 0 and says from which scale its ratio holds, the largest
// out-radius of an input. O(cells). out_of_memory.
Status complete_filter(const AnyMesh& mesh, FilterValues values, const Work& work, Evaluation* out);
Status basic_filter(const AnyMesh& mesh, FilterValues values, const Work& work, Evaluation* out);

}  // namespace netmesh
