// The determinant in doubles with a bound on its error.
//
// Entries are differences of coordinates, the lift is a sum of squares, the determinant is expanded column by column.
// Let u = 2^-53 and d_i the exact differences. In the computed value every product of the Leibniz sum carries at most
// e(N) factors 1 + delta, |delta| <= u:
//     e(1) = 1 (the difference),  e(k) = e(k-1) + 1 (difference) + 1 (product) + (k-1) (sums)  for coordinate columns,
//     e = e(D) + (D+2) (the lift) + 1 + D  when the lift is the last of D+1 columns.
// So the error is at most e u (1 + e u) times the permanent of the matrix of absolute values, and an inequality of
// Carlen, Lieb and Loss (An inequality of Hadamard type for permanents, 2006) bounds a permanent of order D by
// D! / D^(D/2) times the product of the rows' lengths: it is at most
//     orient: c |d_1| ... |d_D|,    in_ball: c (D+1) max |d_i| |d_1| ... |d_(D+1)|,    c = D! / D^(D/2).
// `magnitude` is that bound. It holds for every minor and partial sum too, as far as no |d_i| is below 1.
// All this is without underflow. Admitting only lengths within 2^(+-480/ceil(factors/2)) keeps each product of lengths
// in the bound above 2^-960; at most 1,000 roundings below 2^-1074, each multiplied by no more than the lengths that
// its minor lacks, add less than 2^-100 of the bound. Overflow cannot occur.
#pragma once
#include "numerics/minors.hpp"
#include "numerics/square_root.hpp"
#include "predicates/frame.hpp"

namespace netmesh {

struct FloatResult {
    double determinant;
    double magnitude;  // 0: nothing is known
};

constexpr double permanent_constants[7] = {1, 1, 1, 1.15471, 1.5, 2.14664, 3.33334};  // rounded up

// 1.001 covers the second order and the rounding of the magnitude itself.
constexpr double magnitude_factor(int dim, bool lifted) {
    return (lifted ? permanent_constants[dim] * (dim + 1) : permanent_constants[dim]) * 1.001;
}
// more: roundings of a product beyond those above.
constexpr double error_factor(int dim, bool lifted, int more = 0) {
    int roundings = 1 + more;
    for (int k = 2; k <= dim; ++k) roundings += k + 1;
    if (lifted) roundings += 2 * dim + 3;
    return roundings * 1.1102230246251565e-16 * 1.001;
}

template <int D, bool lifted> struct FloatBounds {
    // Lengths in the magnitude: one a row and, with a lift, the largest once more.
    static constexpr int factors = lifted ? D + 2 : D;
    static constexpr double range() {
        double r = 1;
        for (int i = 0; i < 960 / ((factors + 1) / 2); ++i) r *= 2;
        return r;
    }
    static constexpr double length_squared_max = range();
    static constexpr double length_squared_min = 1 / range();
};

// With the last of the points as base. minors, if not null: what multiplies the lifts, minors[D - i] for row i.
template <int D, bool lifted> FloatResult float_stage(const double* const* points, double* minors) {
    using Bounds = FloatBounds<D, lifted>;
    constexpr int n = frame_rows(D, lifted);
    double a[n][n], half[2] = {1, 1}, longest = 0;
    bool admitted = true;
    for (int i = 0; i < n; ++i) {
        double s = 0;
        for (int c = 0; c < D; ++c) {
            const double d = points[i][c] - points[n][c];
            a[i][c] = d;
            s += d * d;
        }
        if constexpr (lifted) a[i][D] = s;
        half[i & 1] *= s;
        longest = s > longest ? s : longest;
        admitted &= s >= Bounds::length_squared_min;
        admitted &= s <= Bounds::length_squared_max;
    }
    if constexpr (lifted) half[n & 1] *= longest;
    if (!admitted) return {0, 0};
    double determinant;
    if constexpr (lifted) {
        minors_of_order<D>(a, minors);
        Minors<n, n>::all(a, minors, &determinant);
    } else {
        minors_of_order<n>(a, &determinant);
    }
    constexpr double factor = magnitude_factor(D, lifted);
    return {determinant, square_root(half[0]) * square_root(half[1]) * factor};
}

// x * 2^k for |k| <= 2044, in two exact steps unless it underflows.
inline double scale(double x, int k) { return x * power_of_two(k / 2) * power_of_two(k - k / 2); }

// With the frame's base, each row divided by its size, so that no range is too wide: an entry or a lift that underflows
// is too small to matter by far. The rows must be neither zero nor infinite. A function of its own, as its frame is
// large and exact stages are called where it would stand.
template <class Dim, class Lifted>
[[gnu::noinline]] FloatResult float_stage_scaled(const Frame& frame, Dim dim, Lifted lifted) {
    const int n = frame_rows(dim, lifted), widest = frame.widest(n);
    double column[frame_rows_max][minor_rows_max], product = 1, highest = 0;
    for (int i = 0; i < n; ++i) {
        double s = 0;
        for (int c = 0; c < dim; ++c) {
            const double d = scale(frame.row[i][c] - frame.base[c], -frame.exponent[i]);
            column[c][i] = d;
            s += d * d;  // in [1, 4 D)
        }
        if (lifted) {
            const int fall = widest - frame.exponent[i];
            const double lift = scale(s, fall < 2000 ? -fall : -2000);
            column[dim][i] = lift;
            highest = lift > highest ? lift : highest;
        }
        product *= s;
    }
    double magnitude = square_root(product) * magnitude_factor(dim, lifted);
    if (lifted) magnitude *= highest;  // a lift over its row's length is at most the lift
    double level[2][widest_level(minor_rows_max)];
    return {*minors_of_columns<2, minor_rows_max>(n, n, column, column[0], level), magnitude};
}

}  // namespace netmesh
