// float_stage.hpp with weights: the lift of row i is |d_i|^2 + w_i, w_i what the weight of its point is less than that
// of the base.
//
// Relative to A_i = |d_i|^2 + |w_i|, a product in a lift carries at most D + 3 roundings: w_i has three, and one is the
// sum's. That is one more than without weights. In the permanent's bound A_i / |d_i| takes the place of |d_i| in lifts:
//     c (D+1) max (A_i / |d_i|) |d_1| ... |d_(D+1)|.
// These ratios are not below the lengths, and are kept in the same range, so what underflows is as little. A weight
// that overflows makes its ratio infinite or NaN, which is not in that range.
#pragma once
#include "predicates/float_stage.hpp"
#include "predicates/weights.hpp"

namespace netmesh {

// The sign of the determinant about the last of D+2 points, or 0 when this stage is not sure. Behind the coordinates
// of a point stands its number.
template <int D> int power_stage(const double* const* points, const Weights& weights) {
    using Bounds = FloatBounds<D, true>;
    constexpr int n = D + 1;
    double a[n][n], half[2] = {1, 1}, widest = 0;
    bool admitted = true;
    for (int i = 0; i < n; ++i) {
        double s = 0;
        for (int c = 0; c < D; ++c) {
            const double d = points[i][c] - points[n][c];
            a[i][c] = d;
            s += d * d;
        }
        const double less = weights.difference(points[n][D], points[i][D]), sum = s + __builtin_fabs(less);
        const double ratio2 = sum * sum / s;
        a[i][D] = s + less;
        half[i & 1] *= s;
        widest = ratio2 > widest ? ratio2 : widest;
        admitted &= s >= Bounds::length_squared_min;
        admitted &= s <= Bounds::length_squared_max;
        admitted &= ratio2 <= Bounds::length_squared_max;
    }
    half[n & 1] *= widest;
    if (!admitted) return 0;
    double determinant;
    if constexpr (D > 4)  // small code; from there on the loops are long
        minors_by_loops(n, n, a[0], &determinant);
    else
        minors_of_order<n>(a, &determinant);
    constexpr double factor = magnitude_factor(D, true) * error_factor(D, true, 1);
    const double error = square_root(half[0]) * square_root(half[1]) * factor;
    return (determinant > error) - (determinant < -error);
}

}  // namespace netmesh
