// The float stage of circumsphere.hpp.
#pragma once
#include "filtration/circumsphere.hpp"
#include "numerics/double_pair.hpp"
#include "numerics/real.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

// As dot of numerics/vector.hpp, without the sum's first addition to 0, which shows in this place.
template <int D> inline double inner_product(DimensionOf<D> dim, const double* a, const double* b) {
    double s = a[0] * b[0];
    for (std::uint32_t d = 1; d < dim; ++d) s += a[d] * b[d];
    return s;
}

// With e_i the edge vectors and c = vertex 0 + x: e_i . x = |e_i|^2 / 2. Gram-Schmidt turns the rows e_i into
// orthogonal q_j and the right-hand sides with them, so that x = sum of (b_j / n_j) q_j with n_j = |q_j|^2; going back
// through the triangle of coefficients gives beta.
//
// What the errors are. u = 2^-53, l_i = |e_i|, R = |x|, M the rows e_i / l_i, P^2 = product of l_j^2 / n_j = 1 /
// volume. P <= 2^12, so that terms of second order are below 1/50 of those of the first; 21/20 is put in for them. The
// least singular value of M is at least 1 / (sqrt(e) P): M M^T has the trace K and the determinant 1 / P^2, and K-1
// numbers of sum at most K have a product of at most (K / (K-1))^(K-1) < e.
// Pivoting makes |r| <= |e_i| / |q_j| <= 1 for the coefficients r of row i, e_i as it then is; lengths do not grow.
//  1. Rows. A step changes row i by at most 2 u l_i besides what it should do, the first difference by u l_i. So
//  exactly
//     e_i + F_i = sum of r_ij q_j with |F_i| <= 2 K u l_i; and b_i + g_i = sum of r_ij b_j with
//     |g_i| <= (D + 2 + 2 K) u l_i R, since b_i = l_i^2 / 2 <= l_i R.
//  2. Angles. r is off by (2 D + 2) u |e_i| / |q_j|, so row i after its step is at right angles to q_j up to
//     (2 D + 4) u l_i |q_j|; later steps add 2 u l_i |q_j| and what q_m, m > j, is off itself. With l_i / |q_i| for the
//     length of row i, and each sum at most doubling: cosines of q_i and q_j are at most
//     w = (2 D + 2 K + 4) 2^(K-2) u P.
//  3. Radius. Let x' in the span of the q have q_j . x' = b_j. By 1, |M (x' - x)| <= sqrt(K) (D + 2 + 4 K) u R, and x'
//     leaves the span of the e_i by no more than 2 K sqrt(K) u R sqrt(e) P: |x' - x| <= sqrt(e K) (D + 2 + 6 K) u P R.
//     |x'|^2 and the sum of b_j^2 / n_j differ by (K-1) w, and D + K + 4 roundings; the root halves them and adds one.
//     Radius: sqrt(e K) (D + 2 + 6 K) P + (K-1) w / 2u + (D + K + 6) / 2 times u R at most.
//  4. beta. x'' = sum of y_j q_j differs from x' by (K-1) w R + (D + 2) sqrt(K) u R. Going back leaves residuals of
//     2 (K-1) u (R + (K-1) Z) in each of K rows, Z = max |beta_i| l_i. So sum of (computed - beta_i) e_i is at most
//     L = max(R, Z) times u times
//         (K-1) w / u + sqrt(e K) (D + 2 + 6 K) P + (D + 2) sqrt(K) + 2 K^3,
//     and |computed - beta_i| l_i is at most sqrt(e) P times that: beta_error P^2 L. beta_0 = 1 - sum of beta_i is off
//     by K / min l_i times as much, and K + 2 roundings, which the 21/20 covers.
// Sizes within 2^+-200 and P <= 2^12 keep what underflows below 2^-300 of all this.
struct CircumsphereBounds {
    double radius_error, beta_error;
    static constexpr double volume_min = 0x1p-24;

    double radius_error_of(double volume) const { return radius_error / square_root(volume) * 1.01; }
    constexpr CircumsphereBounds(int k, int dim) : radius_error(0), beta_error(0) {
        constexpr double root_ek[7] = {0, 1.65, 2.34, 2.86, 3.30, 3.69, 4.04};  // sqrt(e K), rounded up
        constexpr double root_k[7] = {0, 1, 1.42, 1.74, 2, 2.24, 2.45};
        const double angles = (k - 1.0) * (2 * dim + 2 * k + 4) * (1 << k) / 4;  // (K-1) w / u P
        const double centre = root_ek[k] * (dim + 2 + 6 * k);
        radius_error = 1.05 * unit_roundoff * (centre + angles / 2 + (dim + k + 6) / 2.0);
        beta_error = 1.05 * unit_roundoff * 1.65 * (angles + centre + (dim + 2) * root_k[k] + 2 * k * k * k);
    }
};
template <int K, int D> constexpr CircumsphereBounds circumsphere_bounds{K, D};

template <int K, int D> inline double radius_error(double volume) {
    return circumsphere_bounds<K, D>.radius_error_of(volume);
}
inline double radius_error(std::uint32_t k, std::uint32_t dim, double volume) {
    return CircumsphereBounds(static_cast<int>(k), static_cast<int>(dim)).radius_error_of(volume);
}

template <int K, int D>
inline bool circumsphere_in_doubles(DimensionOf<K> k, DimensionOf<D> dim, double beta_error, const double* const* point,
                                    Circumsphere* out) {
    constexpr double size_min = 0x1p-200, size_max = 0x1p200;
    constexpr int k_max = DimensionOf<K>::most, dim_max = DimensionOf<D>::most;
    double e[k_max][dim_max], b[k_max], n[k_max], whole[k_max], r[k_max][k_max];
    std::uint32_t at[k_max];
    double whole_min = size_max, product = 1;
    for (std::uint32_t i = 0; i < k; ++i) {
        for (std::uint32_t d = 0; d < dim; ++d) e[i][d] = point[i + 1][d] - point[0][d];
        n[i] = whole[i] = inner_product<D>(dim, e[i], e[i]);
        if (!(n[i] > size_min && n[i] < size_max)) return false;
        if (n[i] < whole_min) whole_min = n[i];
        b[i] = n[i] / 2;
        at[i] = i;
    }
    double radius_squared = 0, y[k_max];
    for (std::uint32_t j = 0; j < k; ++j) {
        std::uint32_t pivot = j;
        for (std::uint32_t i = j + 1; i < k; ++i)
            if (n[i] > n[pivot]) pivot = i;
        if (pivot != j) {
            for (std::uint32_t d = 0; d < dim; ++d) {
                const double t = e[j][d];
                e[j][d] = e[pivot][d];
                e[pivot][d] = t;
            }
            for (std::uint32_t i = 0; i < j; ++i) {
                const double t = r[i][j];
                r[i][j] = r[i][pivot];
                r[i][pivot] = t;
            }
            const double tb = b[j], tn = n[j], tw = whole[j];
            const std::uint32_t ta = at[j];
            b[j] = b[pivot], n[j] = n[pivot], whole[j] = whole[pivot], at[j] = at[pivot];
            b[pivot] = tb, n[pivot] = tn, whole[pivot] = tw, at[pivot] = ta;
        }
        const double inverse = 1 / n[j];
        product *= n[j] / whole[j];
        y[j] = b[j] * inverse;
        radius_squared += b[j] * y[j];
        for (std::uint32_t i = j + 1; i < k; ++i) {
            const double c = inner_product<D>(dim, e[i], e[j]) * inverse;
            r[j][i] = c;
            for (std::uint32_t d = 0; d < dim; ++d) e[i][d] -= c * e[j][d];
            b[i] -= c * b[j];
            n[i] = inner_product<D>(dim, e[i], e[i]);
        }
    }
    if (!(product >= CircumsphereBounds::volume_min)) return false;
    const double error = beta_error / product;

    double first = 1, largest = radius_squared, smallest = size_max;
    std::uint32_t within = 0;
    for (std::uint32_t j = k; j-- > 0;) {
        double beta = y[j];
        for (std::uint32_t i = j + 1; i < k; ++i) beta -= r[j][i] * y[i];
        y[j] = beta;
        first -= beta;
        const double length_squared = beta * beta * whole[j];
        if (length_squared > largest) largest = length_squared;
        if (length_squared < smallest) smallest = length_squared;
        if (beta < 0) within |= 2u << at[j];
    }
    if (first < 0) within |= 1u;
    const double slack = error * error * largest;
    if (!(smallest > slack && first * first * whole_min > slack * (k * k))) return false;
    out->radius = square_root(radius_squared);
    out->within = within;
    out->volume = product;
    return true;
}

template <int K, int D> inline bool circumsphere_fast(const double* const* point, Circumsphere* out) {
    return circumsphere_in_doubles<K, D>(K, D, circumsphere_bounds<K, D>.beta_error, point, out);
}

// Two simplices at a time, without a branch: pivots cannot be foreseen. The same steps as above, so the same bits, for
// those that are certain; bit i of the result is set when out[i] is.
template <int K, int D>
inline std::uint32_t circumspheres_fast(const double* const (*point)[K + 1], Circumsphere* out) {
    constexpr double size_min = 0x1p-200, size_max = 0x1p200;
    DoublePair e[K][D], b[K], n[K], whole[K], r[K][K], y[K];
    PairMask at[K], sure = {-1, -1};
    DoublePair whole_min = {size_max, size_max}, product = {1, 1}, radius_squared = {0, 0};
    for (int i = 0; i < K; ++i) {
        for (int d = 0; d < D; ++d)
            e[i][d] = DoublePair{point[0][i + 1][d], point[1][i + 1][d]} - DoublePair{point[0][0][d], point[1][0][d]};
        n[i] = e[i][0] * e[i][0];
        for (int d = 1; d < D; ++d) n[i] += e[i][d] * e[i][d];
        whole[i] = n[i];
        sure &= (n[i] > size_min) & (n[i] < size_max);
        whole_min = select(n[i] < whole_min, n[i], whole_min);
        b[i] = n[i] / 2;
        at[i] = PairMask{2 << i, 2 << i};
    }
    for (int j = 0; j < K; ++j) {
        PairMask exceeds[K], later = {0, 0};
        DoublePair most = n[j];
        for (int i = j + 1; i < K; ++i) {
            exceeds[i] = n[i] > most;
            most = select(exceeds[i], n[i], most);
        }
        for (int i = K - 1; i > j; --i) {
            const PairMask is_pivot = exceeds[i] & ~later;
            later |= exceeds[i];
            for (int d = 0; d < D; ++d) swap_where(is_pivot, e[j][d], e[i][d]);
            for (int m = 0; m < j; ++m) swap_where(is_pivot, r[m][j], r[m][i]);
            swap_where(is_pivot, b[j], b[i]);
            swap_where(is_pivot, n[j], n[i]);
            swap_where(is_pivot, whole[j], whole[i]);
            swap_where(is_pivot, at[j], at[i]);
        }
        const DoublePair inverse = 1 / n[j];
        product *= n[j] / whole[j];
        y[j] = b[j] * inverse;
        radius_squared += b[j] * y[j];
        for (int i = j + 1; i < K; ++i) {
            DoublePair c = e[i][0] * e[j][0];
            for (int d = 1; d < D; ++d) c += e[i][d] * e[j][d];
            c *= inverse;
            r[j][i] = c;
            for (int d = 0; d < D; ++d) e[i][d] -= c * e[j][d];
            b[i] -= c * b[j];
            n[i] = e[i][0] * e[i][0];
            for (int d = 1; d < D; ++d) n[i] += e[i][d] * e[i][d];
        }
    }
    sure &= product >= CircumsphereBounds::volume_min;
    const DoublePair error = circumsphere_bounds<K, D>.beta_error / product;

    DoublePair first = {1, 1}, largest = radius_squared, smallest = {size_max, size_max};
    PairMask within = {0, 0};
    for (int j = K - 1; j >= 0; --j) {
        DoublePair beta = y[j];
        for (int i = j + 1; i < K; ++i) beta -= r[j][i] * y[i];
        y[j] = beta;
        first -= beta;
        const DoublePair length_squared = beta * beta * whole[j];
        largest = select(length_squared > largest, length_squared, largest);
        smallest = select(length_squared < smallest, length_squared, smallest);
        within |= at[j] & (beta < 0);
    }
    within |= PairMask{1, 1} & (first < 0);
    const DoublePair slack = error * error * largest;
    sure &= (smallest > slack) & (first * first * whole_min > slack * (K * K));
    for (int lane = 0; lane < 2; ++lane)
        out[lane] = {square_root(radius_squared[lane]), static_cast<std::uint32_t>(within[lane]), product[lane]};
    return static_cast<std::uint32_t>((sure[0] & 1) | (sure[1] & 2));
}

// The same for all k and dim. Where size counts it is the only one.
#ifdef __OPTIMIZE_SIZE__
constexpr bool circumsphere_is_shared = true;
#else
constexpr bool circumsphere_is_shared = false;
#endif
inline bool circumsphere_fast(std::uint32_t k, std::uint32_t dim, const double* const* point, Circumsphere* out) {
    const CircumsphereBounds bounds(static_cast<int>(k), static_cast<int>(dim));
    return circumsphere_in_doubles<any_dimension, any_dimension>(k, dim, bounds.beta_error, point, out);
}

}  // namespace netmesh
