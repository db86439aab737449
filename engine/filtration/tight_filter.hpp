// The tight filter of thesis 7.5 on an over-refined mesh, and the ratio that the mesh proves for it.
//
// s'(v) = max(d_P(v), f_P(n_v) / 2), n_v the nearest input of v; inputs enter at 0, every other simplex at the largest
// s' of its vertices. So an input p and the Steiner vertices nearest to it that lie within f_P(p) / 2, its clump, come
// at one time; let W be the union of their cells. Cover the space at scale b by the cells of the Steiner vertices of no
// clump with t <= b and, for each clump, by ball(p, min(b, just under r_p)) before its value t and all of its cells
// afterwards, where
//
//     r_p = min(distance from p to the cells outside W, distance from the other inputs to W).
//
// The ball lies in W and meets no cell outside W nor another clump's ball, so the sets grow with b, the ball is a
// component of its own that retracts to its part of Vor(p) (7.5.6), and the nerve is the lower-star filtration of t,
// inputs entering alone at 0; of cospherical vertices by the cells of mesh_filter.hpp, which the balls, smaller than
// r_p, lie in as well. A point x of W with d_P(x) < t / c and nearest input p is in the ball when t <= c r_p,
// and when its nearest input is another one then d_P(x) >= r_p. With F = min(d_P, rho) as in mesh_filter.hpp, hi(W) >=
// F on W, and lo, hi of the other cells as there, the diagrams are within ln c on the log scale,
//
//     c = max over clumps of max(hi(W) / t, t / r_p), over the other vertices of max(hi / t, t / lo).
//
// A cell Vor(u) is no nearer to an input q != u than |q - u| / 2 and |q - u| - R_u. Where R_v <= eps/(3 (1 + eps))
// f_P(v) for all cells that come nearer than rho to an input, 7.5.1 and 7.5.3 say that c <= 1 + eps for t = s'; the
// mesh of refine.hpp with that size rule in a domain of tight_domain_factor(eps) enclosing radii is such: a cell that
// reaches out of that domain has its vertex beyond 3 rho from the centre, all of it rho or more from the inputs.
#pragma once
#include "filtration/any_mesh.hpp"
#include "mesh/input_tree.hpp"

namespace netmesh {

// The size rule for a promise of eps, 0 < eps <= 1/2.
inline double tight_size(double eps) { return eps / (3 * (1 + eps)); }
inline double tight_domain_factor(double eps) { return 3.0625 + 4 * tight_size(eps); }

// value[v]: t(v), cut at rho; interval[v]: r_p and hi(W) for the vertices of clumps. The mesh may be over-refined or
// not. O(cells + vertices log n). Scratch: 20 bytes a vertex, 29 an input. out_of_memory.
Status tight_filter(const AnyMesh& mesh, FilterValues values, const Work& work, Evaluation* out);

}  // namespace netmesh
