// Circumscribed balls in floating point, each with a proven bound on the error of its centre.
//
// Why a bound on the centre is enough. For a ball (c, r^2) whose true centre is c*, with |c - c*| <= error * r, the
// function f(q) = (|q-c|^2 - r^2) - (|q-c*|^2 - r*^2) is affine, has gradient 2(c* - c), and vanishes at the vertex
// from which r^2 was measured. So |f(q)| <= 2 |q - v| error r <= error (|q-c|^2 + 3 r^2): power() decides the sign of
// the true power of q whenever it is larger than that plus the rounding of its own evaluation.
#pragma once
#include <cstdint>

#include "delaunay/any_store.hpp"
#include "predicates/weights.hpp"

namespace netmesh {

// Computed power |q - centre|^2 - radius2 of q, and in *bound what its error cannot exceed (NaN or infinite when
// nothing is known). A caller compares with > and < so that NaN decides nothing.
template <int D> inline double power(const Cell<D>& cell, const double* q, double* bound) {
    const double first = q[0] - cell.centre[0];
    double d2 = first * first;
    for (int i = 1; i < D; ++i) {
        const double d = q[i] - cell.centre[i];
        d2 += d * d;
    }
    *bound = (static_cast<double>(cell.error) + (D + 8) * unit_roundoff) * (d2 + 3 * cell.radius2) + 0x1p-960;
    return d2 - cell.radius2;
}

// The same with weights, of a point of that height (weights.hpp): radius2 is the power at `centre` of the vertices,
// less the largest weight, so at least the squared distance to each of them, and that is what errors are relative to. A
// height is three roundings off at most.
template <int D> inline double power(const Cell<D>& cell, const double* q, double height, double* bound) {
    const double first = q[0] - cell.centre[0];
    double d2 = first * first;
    for (int i = 1; i < D; ++i) {
        const double d = q[i] - cell.centre[i];
        d2 += d * d;
    }
    d2 += height;
    *bound = (static_cast<double>(cell.error) + (D + 12) * unit_roundoff) * (d2 + 3 * cell.radius2) + 0x1p-960;
    return d2 - cell.radius2;
}

// A ghost's ball: nothing is known of it, so that every question about it goes to ghost_in_conflict.
template <int D> inline void make_ghost(Cell<D>& cell) {
    for (int k = 0; k < D; ++k) cell.centre[k] = 0;
    cell.radius2 = infinity;
    cell.error = static_cast<float>(infinity);
}

// What the error bound of solve_sphere multiplies. A minor of order k of edges e_i is computed with at most
// (D+1)(D+2)/2 + D + 8 roundings on each of its products, entries and b included, and the products' absolute values add
// up to at most c_k |e_1| ... |e_k|, c_k = k! / k^(k/2) (predicates/float_stage.hpp). With b in one row, b_i = |e_i|^2
// / 2, they add up to at most c_(D-1) |e_1| ... |e_D| sum |e_i| / 2, and |e_i| <= 2 R. So each coordinate of the centre
// errs by at most R k u (D c_(D-1) + c_D) |e_1| ... |e_D| / |det| (1 + small); sqrt(D) makes that Euclidean, 3 covers a
// determinant that is up to half wrong and a radius that is up to a quarter wrong.
template <int D> constexpr double shape_factor() {
    constexpr double c[7] = {1, 1, 1, 1.15471, 1.5, 2.14664, 3.33334}, root[7] = {0, 1, 1.42, 1.74, 2, 2.24, 2.45};
    constexpr int roundings = (D + 1) * (D + 2) / 2 + D + 8;
    return 3 * root[D] * roundings * unit_roundoff * (D * c[D - 1] + c[D]);
}

// Halves of squared edge lengths between which no product of up to D+1 entries of A and b underflows or overflows by
// more than the error bounds allow for.
constexpr double edge_square_min = 0x1p-150;
constexpr double edge_square_max = 0x1p150;

// For corners that results depend on.
constexpr double corner_error_max = 0x1p-22;
// More than any error of a ball that was kept with error_max = corner_error_max, rounded up by a hundredth. A ball
// solved with that error_max that has a greater one is of solve_flat_sphere: coordinates do not resolve its centre, but
// its radius is known within corner_error_max of itself.
constexpr float blurred_error = 0x1p-21f;

// The ball through D+1 points by solving for its centre, in about 100 bits when the error bound in doubles is above
// error_max (<= 1/4), in integers when that does not do either; error is +infinity, and centre a vertex, when no bound
// could be proven.
template <int D> void solve_sphere(const double* const* p, double error_max, Cell<D>& cell);

// With weights: the centre that has equal powers of D+1 points, in doubles alone. Where that is not enough, as of cells
// that are nearly flat and of sizes far from 1, error is +infinity.
template <int D>
void solve_power_sphere(const double* const* p, const Weights& weights, double error_max, Cell<D>& cell);

// That of a cell of `store` by its vertices.
template <int D> [[gnu::noinline]] void solve_cell(const Store<D>& store, double error_max, Cell<D>& cell) {
    const double* p[D + 1];
    for (int i = 0; i <= D; ++i) p[i] = store.point(cell.vertex[i]);
    solve_sphere<D>(p, error_max, cell);
}

template <int D>
[[gnu::noinline]] void solve_cell(const Store<D>& store, const Weights& weights, double error_max, Cell<D>& cell) {
    const double* p[D + 1];
    for (int i = 0; i <= D; ++i) p[i] = store.point(cell.vertex[i]);
    solve_power_sphere<D>(p, weights, error_max, cell);
}
template <int D> inline void solve_cell(const Store<D>& store, NoWeights, double error_max, Cell<D>& cell) {
    solve_cell<D>(store, error_max, cell);
}

// The ball of every cell of a compact store anew, from its vertices alone: what is read off then depends neither on how
// the triangulation was made nor on what was cached, and is the same after it has been written to a file and loaded.
// O(cells).
template <int D> void recompute_balls(Store<D>& store);

// nearest2 of every vertex anew, over the edges of cells. O(cells).
void measure_edges(const AnyStore& store);

// The ball through q and the facet shared by `inside` (conflicts with q) and `outside` (does not): it belongs to the
// pencil spanned by the two balls, so its centre is a convex combination of theirs. Returns false when the bound so
// obtained is above error_max; then nothing is written. No square system is solved: O(D).
//
// With a = power of q outside (>= 0) and b = -power inside, the new centre is w c_in + v c_out, w = a / (a + b), v = b
// / (a + b). Errors e_in, e_out of the two centres leave w e_in + v e_out of its own, whose square is at most w e_in^2
// + v e_out^2. Errors alpha of a and beta of b move w by (v alpha - w beta) / (a + b), exactly so with the true w, v
// and the computed a + b; the computed w, v are as good with the true a + b, which is 1.02 times smaller at most. Add
// the rounding of the centre's coordinates: (x + y + z)^2 <= 2.2 x^2 + 2.2 y^2 + 11 z^2.
//
// With weights the same, of a point q of that height: powers at q are those that the two have at its centre.
template <int D, bool weighted = false>
inline bool pencil_sphere(const Cell<D>& inside, const Cell<D>& outside, const double* q, double error_max,
                          Cell<D>& cell, double height = 0) {
    constexpr double u = unit_roundoff;
    double a, b, bound_in, bound_out;
    if constexpr (weighted) {
        b = -power<D>(inside, q, height, &bound_in);
        a = power<D>(outside, q, height, &bound_out);
    } else {
        b = -power<D>(inside, q, &bound_in);
        a = power<D>(outside, q, &bound_out);
    }
    const double sum = a + b;
    if (!(bound_in + bound_out < 0x1p-6 * sum)) return false;
    const double inverse = 1 / sum;
    const double w = a * inverse, v = b * inverse;
    double apart2 = 0, radius2 = 0, size2 = 0;
    double centre[D];
    for (int i = 0; i < D; ++i) {
        const double d = inside.centre[i] - outside.centre[i];
        centre[i] = outside.centre[i] + w * d;
        apart2 += d * d;
        size2 += centre[i] * centre[i];
        const double e = q[i] - centre[i];
        radius2 += e * e;
    }
    if (weighted) radius2 += height;
    const double in2 = static_cast<double>(inside.error) * inside.error * inside.radius2;
    const double out2 = static_cast<double>(outside.error) * outside.error * outside.radius2;
    const double w_error = 1.02 * (w * bound_in + v * bound_out) * inverse + 8 * u;
    const double distance2 = 2.3 * (w * in2 + v * out2 + w_error * w_error * apart2) + (50 * u * u) * size2;
    const double error2 = distance2 / radius2;
    if (!(error2 < error_max * error_max) || !(radius2 > 0x1p-800)) return false;
    for (int i = 0; i < D; ++i) cell.centre[i] = centre[i];
    cell.radius2 = radius2;
    cell.error = static_cast<float>(1.01 * square_root(error2));
    return true;
}

}  // namespace netmesh
