// Lower-star filters of Lipschitz functions on a quality mesh (thesis 8.6), and the ratio that the mesh proves for
// them.
//
// A vertex v gets a value t(v), a simplex the largest value of its vertices. Let lo_v <= F <= hi_v on all of v's
// Voronoi cell for the function F whose sublevel sets are meant. The union of the cells with t <= b contains the
// sublevel set at b / c and is contained in the one at c b, c = max over v of max(hi_v / t_v, t_v / lo_v), and the
// cells' nerve is the filtration (8.6.1): the diagrams are within ln c on the log scale. The best values reach c* = max
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
// A mesh on which the complete filter certifies c certifies at most sqrt(2 + c^2) for d_k, k >= 2. Write d for d_1 and
// t for d_k(v) >= d(v), R for R_v. Of the complete filter min(rho, h) <= c^2 l, with h >= R: where h is the distance
// from a corner to the nearest input of a Steiner vertex that holds as no input is nearer to a corner than v is, and h
// = R for inputs. Where rho is the least, hi <= rho <= c^2 l <= c^2 lo, as lower ends ascend with the function. Else R
// <= c^2 l. Steiner vertices: where R >= d / 2, l = d / 2, so R <= c^2 t / 2 and hi / lo <= (t + R) / (t / 2) <= 2 +
// c^2; where R < d / 2 <= t / 2, hi / lo <= (t + R) / (t - R) <= 3. Inputs: l is half the distance n to the nearest
// neighbour in the mesh, and n <= t, as for k >= 2 the k-th nearest input is another: the same again. For the
// k-distance n <= t sqrt(k / (k - 1)) alone, its own distance 0 being one of the k: at most sqrt(2 + sqrt(k / (k - 1))
// c^2). With c^2 = 2 + tau the constants are sqrt(4 + tau) and, k = 2, sqrt(2 + sqrt 2 (2 + tau)); the sqrt(2 + tau)
// that cells inside the domain have is not kept at its boundary, where R_v is that of the whole cell.
//
// General functions. f(v) - L R_v <= f <= f(v) + L R_v; where f >= d_2 / c is known (8.6.3), also f(x) >= |x - v| / c
// as above, so that lo = f(v) / (1 + c L). For a general f the clipping argument of 7.4.4 is an assumption: the caller
// names a value `cut` and answers for it that f >= cut outside the domain ball of the mesh and that the sublevel sets
// from cut on are contractible. Then F = min(f, cut), and cells outside the domain have the value cut. Where f(v) <= L
// R_v and no c is known the mesh proves no ratio: it is infinite.
#pragma once
#include "filtration/filter.hpp"
#include "mesh/input_tree.hpp"

namespace netmesh {

enum class InputDistance { kth, root_mean_square };
struct NeighbourDistance {
    InputDistance kind;
    std::uint32_t k;  // 2 <= k <= number of inputs
};

// d_k or D_k at x, 1 <= k <= number of inputs. scratch[k].
template <int D>
double input_distance(const InputTree<D>& tree, NeighbourDistance distance, const double* x, Neighbour* scratch);

// value[v]: d_k or D_k at v, clamped for certified values, cut at rho. Scratch: 8 bytes a vertex, 5 an input, 16 k.
// out_of_memory, cancelled.
template <int D>
Status distance_filter(const FilteredMesh<D>& mesh, NeighbourDistance distance, FilterValues values, const Work& work,
                       Evaluation* out);

// value[v]: f(v), cut and clamped. Scratch: 8 bytes a vertex. out_of_memory, cancelled, not_finite (culprit: a vertex
// with f(v) < 0 or not finite).
template <int D>
Status function_filter(const FilteredMesh<D>& mesh, const netmesh_function& function, FilterValues values,
                       const Work& work, Evaluation* out);

struct LipschitzBounds {
    double lipschitz;        // L
    double distance_factor;  // c, 0: unknown
    double cut;
};

// The same for values f(v) >= 0 that are there already.
template <int D>
Status clamp_function(const FilteredMesh<D>& mesh, const LipschitzBounds& bounds, FilterValues values, Arena& arena,
                      Evaluation* out);

}  // namespace netmesh
