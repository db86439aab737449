// Lower-star filters of Lipschitz functions on a quality mesh (thesis 8.6), and the ratio that the mesh proves for
// them.
//
// A vertex v gets a value t(v), a simplex the largest value of its vertices. Let lo_v <= F <= hi_v on all of v's
// Voronoi cell for the function F whose sublevel sets are meant. The union of the cells with t <= b contains the
// sublevel set at b / c and is contained in the one at c b, c = max over v of max(hi_v / t_v, t_v / lo_v), and the
// cells' nerve is the filtration (8.6.1; of cospherical vertices the nerve of the cells of mesh_filter.hpp, on which lo
// and hi hold as well): the diagrams are within ln c on the log scale. The best values reach c* = max
// sqrt(hi_v / lo_v), see mesh_filter.hpp; the function's own values reach 1 / (1 - c t eps) on an eps-refined mesh
// (8.6.3).
//
// Distances. d_k(x), the distance to the k-th nearest input, and the k-distance D_k(x), the root mean square of the
// distances to the k nearest, are 1-Lipschitz; so for the out-radius R_v of the cell, hi = d_k(v) + R_v and lo = d_k(v)
// - R_v. In v's cell no input is nearer than v itself, hence d_k(x) >= d_1(x) >= |x - v|, so that lo = d_k(v) / 2 holds
// too. From rho, the radius of the smallest enclosing ball of the inputs, on the sublevel sets are star-shaped about
// its centre (where a ball about an input, or the ball about a mean of k inputs that D_k is made of, contains x and the
// centre, it contains the segment between them), so everything is cut at rho: F = min(d_k, rho). For k = 1 both
// functions are the distance to the inputs, 0 at the inputs: that is the complete filter.
//
// A mesh on which the complete filter certifies c with whole cells certifies at most sqrt(2 + c^2) for d_k, k >= 2.
// Write d for d_1 and t for d_k(v) >= d(v), R for R_v. Of the complete filter min(rho, h) <= c^2 l, with h >= R: where
// h is the distance from a corner to the nearest input of a Steiner vertex that holds as no input is nearer to a corner
// than v is, and h = R for inputs. Where rho is the least, hi <= rho <= c^2 l <= c^2 lo, as lower ends ascend with the
// function. Else R
// <= c^2 l. Steiner vertices: where R >= d / 2, l = d / 2, so R <= c^2 t / 2 and hi / lo <= (t + R) / (t / 2) <= 2 +
// c^2; where R < d / 2 <= t / 2, hi / lo <= (t + R) / (t - R) <= 3. Inputs: l is half the distance n to the nearest
// neighbour in the mesh, and n <= t, as for k >= 2 the k-th nearest input is another: the same again. For the
// k-distance n <= t sqrt(k / (k - 1)) alone, its own distance 0 being one of the k: at most sqrt(2 + sqrt(k / (k - 1))
// c^2). With c^2 = 2 + tau the constants are sqrt(4 + tau) and, k = 2, sqrt(2 + sqrt 2 (2 + tau)); the sqrt(2 + tau)
// that cells inside the domain have is not kept at its boundary, where R_v is that of the whole cell.
//
// General functions. F = min(f, cut), where the caller answers for it that f >= cut outside the domain ball of the
// mesh, of radius r about c, and that the sublevel sets of f from cut on are contractible; for a general f the clipping
// argument of 7.4.4 is an assumption. F is L-Lipschitz as f is, it is cut outside the ball, and has the diagram of f:
// all of space is contractible, as the sublevel sets of f from cut on are. On the cell of v, whose out-radius is R and
// whose points in the ball are within R' of v (mesh/clip/clipped_reach.hpp),
//   - F <= min(f(v) + L R, cut);
//   - F >= f(v) - L R', as F = cut outside the ball; f(v) as it is, not cut;
//   - F >= cut - L b where no point of the cell is more than b below the ball's sphere, and b <= r always;
//   - F >= f(v) / (1 + c L) where f >= d_2 / c is known (8.6.3), as f(x) >= |x - v| / c as above.
// Cells outside of the ball have the value cut. f is what the caller computes: roundings of that are not counted.
//
// The additive bound. With lo <= F <= hi on v's cell and t its value let e be the largest of hi - t and t - lo over all
// v. The union of the cells with t <= b lies in the sublevel set of F at b + e and contains that at b - e. Voronoi
// cells are closed and convex, so the nerve theorem holds for each such union, and for the inclusions of one in
// another: these unions have the homology of the filtration. So the two are interleaved by e, their diagrams within e
// in the bottleneck distance: each pair moves by at most e, and a bar longer than 2 e is real. With its own values e <=
// L R' for a cell in the ball or across its sphere: one that leaves the ball has a point on the sphere within R' of v,
// where f >= cut, so hi - f(v) <= L R'. And e <= L r whatever the mesh: every Lipschitz function has a finite bound.
// Where f is at a vertex less than the cut on the sphere and L allow there is none, it is infinite: the caller's
// figures are wrong.
//
// A ratio needs lo > 0 on all cells; where the mesh does not prove that, no values have one: it is infinite, and the
// function's own values stay. f may take any finite values.
//
// A mesh for an additive error of E has the sizes max(E, f - cut) / L (wanted_reach): a cell with f(v) <= cut + E
// has L R' <= E, another L R' <= f(v) - cut, so that it is at the cut.
#pragma once
#include "filtration/any_mesh.hpp"
#include "mesh/input_tree.hpp"

namespace netmesh {

enum class InputDistance { kth, root_mean_square };
struct NeighbourDistance {
    InputDistance kind;
    std::uint32_t k;  // 2 <= k <= number of inputs
};

// d_k or D_k at x, 1 <= k <= number of inputs. scratch[k].
double input_distance(const AnyInputTree& tree, NeighbourDistance distance, const double* x, Neighbour* scratch);

// value[v]: d_k or D_k at v, clamped for certified values, cut at rho. Scratch: 8 bytes a vertex, 5 an input, 16 k.
// out_of_memory, cancelled.
Status distance_filter(const AnyMesh& mesh, NeighbourDistance distance, FilterValues values, const Work& work,
                       Evaluation* out);

// value[v]: f(v), cut and, where there is a ratio, clamped. Scratch: 56 bytes a vertex. out_of_memory, cancelled,
// not_finite (culprit: a vertex at which f is not).
Status function_filter(const AnyMesh& mesh, const netmesh_function& function, FilterValues values, const Work& work,
                       Evaluation* out);

// How far a clipped cell may reach whose vertex has the value f, for an additive error of E. A hair less than the bound
// needs, for its rounding outwards, and some units in the last place of values. +infinity where L = 0, 0 where doubles
// do not resolve E.
inline double wanted_reach(const netmesh_function& function, double error, double f) {
    if (!(function.lipschitz > 0)) return infinity;
    const double most = f - function.cut > error ? f - function.cut : error;
    const double units = 0x1p-51 * (absolute(f) + absolute(function.cut));
    if (most <= units && units < infinity) return 0;
    return (units < most ? most - units : most) / function.lipschitz * (1 - 0x1p-16);  // f may be no number
}

struct LipschitzBounds {
    double lipschitz;        // L
    double distance_factor;  // c, 0: unknown
    double cut;
};

// The same for values f(v) that are there already.
Status clamp_function(const AnyMesh& mesh, const LipschitzBounds& bounds, FilterValues values, Arena& arena,
                      Evaluation* out);

}  // namespace netmesh
