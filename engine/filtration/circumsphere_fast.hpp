// The float stage of circumsphere.hpp.
#pragma once
#include "filtration/circumsphere.hpp"

namespace netmesh {

// As dot of numerics/vector.hpp, without the sum's first addition to 0, which shows in this place.
template <int D> inline double inner_product(const double* a, const double* b) {
    double s = a[0] * b[0];
    for (int d = 1; d < D; ++d) s += a[d] * b[d];
    return s;
}

// With e_i the edge vectors and c = vertex 0 + x: e_i . x = |e_i|^2 / 2. Gram-Schmidt turns the rows e_i into
// orthogonal q_j and the right-hand sides with them, so that x = sum of (b_j / n_j) q_j with n_j = |q_j|^2; going back
// through the triangle of coefficients gives beta.
template <int K, int D> inline bool circumsphere_fast(const double* const* point, Circumsphere* out) {
    constexpr double size_min = 0x1p-200, size_max = 0x1p200;
    constexpr double unit = 0x1p-50;       // error of beta over the squared condition: far above what is seen
    constexpr double error_max = 0x1p-26;  // radii are then seen to be good to 2^-38
    double e[K][D], b[K], n[K], whole[K], r[K][K];
    int at[K];
    double whole_min = size_max, product = 1;
    for (int i = 0; i < K; ++i) {
        for (int d = 0; d < D; ++d) e[i][d] = point[i + 1][d] - point[0][d];
        n[i] = whole[i] = inner_product<D>(e[i], e[i]);
        if (!(n[i] > size_min && n[i] < size_max)) return false;
        if (n[i] < whole_min) whole_min = n[i];
        b[i] = n[i] / 2;
        at[i] = i;
    }
    double radius_squared = 0, y[K];
    for (int j = 0; j < K; ++j) {
        int pivot = j;
        for (int i = j + 1; i < K; ++i)
            if (n[i] > n[pivot]) pivot = i;
        if (pivot != j) {
            for (int d = 0; d < D; ++d) {
                const double t = e[j][d];
                e[j][d] = e[pivot][d];
                e[pivot][d] = t;
            }
            for (int i = 0; i < j; ++i) {
                const double t = r[i][j];
                r[i][j] = r[i][pivot];
                r[i][pivot] = t;
            }
            const double tb = b[j], tn = n[j], tw = whole[j];
            const int ta = at[j];
            b[j] = b[pivot], n[j] = n[pivot], whole[j] = whole[pivot], at[j] = at[pivot];
            b[pivot] = tb, n[pivot] = tn, whole[pivot] = tw, at[pivot] = ta;
        }
        const double inverse = 1 / n[j];
        product *= n[j] / whole[j];
        y[j] = b[j] * inverse;
        radius_squared += b[j] * y[j];
        for (int i = j + 1; i < K; ++i) {
            const double c = inner_product<D>(e[i], e[j]) * inverse;
            r[j][i] = c;
            for (int d = 0; d < D; ++d) e[i][d] -= c * e[j][d];
            b[i] -= c * b[j];
            n[i] = inner_product<D>(e[i], e[i]);
        }
    }
    const double error = unit / product;
    if (!(error <= error_max)) return false;

    double first = 1, largest = radius_squared, smallest = size_max;
    std::uint32_t within = 0;
    for (int j = K - 1; j >= 0; --j) {
        double beta = y[j];
        for (int i = j + 1; i < K; ++i) beta -= r[j][i] * y[i];
        y[j] = beta;
        first -= beta;
        const double length_squared = beta * beta * whole[j];
        if (length_squared > largest) largest = length_squared;
        if (length_squared < smallest) smallest = length_squared;
        if (beta < 0) within |= 2u << at[j];
    }
    if (first < 0) within |= 1u;
    const double slack = error * error * largest;
    if (!(smallest > slack && first * first * whole_min > slack * (K * K))) return false;
    out->radius = __builtin_sqrt(radius_squared);
    out->within = within;
    return true;
}

}  // namespace netmesh
