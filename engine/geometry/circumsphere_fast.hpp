// The float stage of circumsphere.hpp: several simplices at a time, without branches, since pivots cannot be foreseen.
#pragma once
#include "geometry/circumsphere.hpp"
#include "numerics/lanes.hpp"
#include "numerics/real.hpp"
#include "predicates/weights.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

// With e_i the edge vectors and c = vertex 0 + z: e_i . z = |e_i|^2 / 2. Gram-Schmidt turns the rows e_i into
// orthogonal q_j and the right-hand sides with them, so that z = sum of (b_j / n_j) q_j with n_j = |q_j|^2; going back
// through the triangle of coefficients gives beta.
//
// What the errors are. u = 2^-53, l_i = |e_i|, R = |z|, M the rows e_i / l_i, P^2 = product of l_j^2 / n_j = 1 /
// volume. P <= 2^12, so that terms of second order are below 1/50 of those of the first; 21/20 is put in for them. The
// least singular value of M is at least 1 / (sqrt(e) P): M M^T has the trace K and the determinant 1 / P^2, and K-1
// numbers of sum at most K have a product of at most (K / (K-1))^(K-1) < e.
// Pivoting makes |r| <= |e_i| / |q_j| <= 1 for the coefficients r of row i, e_i as it then is; lengths do not grow.
//  1. Rows. A step changes row i by at most 2 u l_i besides what it should do, the first difference by u l_i. So
//     e_i + F_i = sum of r_ij q_j with |F_i| <= 2 K u l_i; and b_i + g_i = sum of r_ij b_j with
//     |g_i| <= (D + 2 + 2 K) u l_i R, since b_i = l_i^2 / 2 <= l_i R.
//  2. Angles. r is off by (2 D + 2) u |e_i| / |q_j|, so row i after its step is at right angles to q_j up to
//     (2 D + 4) u l_i |q_j|; later steps add 2 u l_i |q_j| and what q_m, m > j, is off itself. With l_i / |q_i| for the
//     length of row i, and each sum at most doubling: cosines of q_i and q_j are at most
//     w = (2 D + 2 K + 4) 2^(K-2) u P.
//  3. Centre. Let x' in the span of the q have q_j . x' = b_j. By 1, |M (x' - z)| <= sqrt(K) (D + 2 + 4 K) u R, and x'
//     leaves the span of the e_i by no more than 2 K sqrt(K) u R sqrt(e) P: |x' - z| <= sqrt(e K) (D + 2 + 6 K) u P R.
//     x'' = sum of y_j q_j, y_j = b_j / n_j, differs from x' by (K-1) w R + (D + 2) sqrt(K) u R, and its sum as
//     computed, x, from x'' by K u times the sum of |y_j| |q_j|, which is at most 1.01 sqrt(K) R.
//  4. beta. Going back leaves residuals of 2 (K-1) u (R + (K-1) Z) in each of K rows, Z = max |beta_i| l_i. So sum of
//     (computed - beta_i) e_i is at most L = max(R, Z) times u times
//         (K-1) w / u + sqrt(e K) (D + 2 + 6 K) P + (D + 2) sqrt(K) + 2 K^3,
//     and |computed - beta_i| l_i is at most sqrt(e) P times that: beta_error P^2 L. beta_0 = 1 - sum of beta_i is off
//     by K / min l_i times as much, and K + 2 roundings, which the 21/20 covers. |x - z| is below a P L as well, a P L
//     being the bound on that sum, as K sqrt(K) < 2 K^3.
//  5. Radius. For any x and weights b_i
//         |x|^2 + sum of b_i e_i . (e_i - 2 x) = R^2 + |x - z|^2 - 2 (x - z) . sum of (b_i - beta_i) e_i,
//     as e_i . e_i = 2 e_i . z and the sum of beta_i e_i is z. What differs from R^2 is of second order: with 3 and 4
//     at most 3 a^2 P^2 L^2. The products e_i . (e_i - 2 x) themselves are at most 2 l_i |x - z|: rounding them, and
//     their sum, costs (K + 2) K u 2 Z a P L < a^2 P^2 L^2, as a > 2 K (K + 2) u. Both: 4 a^2 P^2 L^2, and 5 for 4.
//  6. Its digits. Let m be the sum of |2 x_d|, which is between 2 R and 2 sqrt(D) R up to a factor of 1.01.
//     Coordinates of e_i and of 2 x are cut by adding 1.05 2^27 m, and taking it away: at multiples of a q between
//     1.04 2^-26 m and 1.05 2^-25 m, of which another one may be twice as large. |e_i| and |e_i - 2 x| are at most
//     2 R, less than 2^26 q, so by Cauchy products of upper parts, and sums of them, are below 2^53 q^2: exact. The
//     rest of a product, upper part times lower and lower times whole, is at most q sqrt(D) (|e_i| + |e_i - 2 x| /
//     2 + q) < 1.6 sqrt(D) q m and takes D + 5 <= 2 D + 3 roundings: it is off by (2 D + 3) 1.7 sqrt(D) u 2^-25 m^2
//     at most, times |b_i|; and |2 x|^2, with the sum of all, by no more.
//  7. A closer look, where that is not enough. Products are computed exactly, but for terms of third order, and
//     summed in twice the digits, so that each e_i . (e_i - 2 x) is off by 32 D u^2 l_i 2 R at most; times |b_i|,
//     |b_i| l_i <= 1.01 Z, all are off by less than 65 D K u^2 L^2 < 2^-94 L^2. They are -2 e_i . (x - z): so what
//     of x - z is in the span of the e_i is at most sqrt(e) P times the root of the sum of their squares over 4
//     l_i^2, and as much of the next digits, which the 2^-94 has room for. What is not, where K < D, is at most (2
//     K sqrt(e K) P + K sqrt(K)) 1.05 u R, by 1 and the sum of 3. The sum of (b_i - beta_i) e_i is x - z and what x
//     is beside the sum of the b_i e_i, which is computed to (K + 2) (K + 1) u L. With X for |x - z|^2 and Y for
//     twice the sum of squares of the other two, 5 is off by 4 X + Y at most, and by the rounding of products as
//     they are.
// Sizes within 2^+-200 and P <= 2^12 keep what underflows below 2^-300 of all this.
//
// With weights w the centre c = vertex 0 + z has equal powers |c - v_i|^2 - w_i: e_i . z = b_i = (l_i^2 + d_i) / 2 with
// d_i = w_0 - w_i, and |z|^2 - w_0 is looked for. What changes:
//  1. |b_i| is l_i R at most still, but l_i^2 is no longer below 2 R l_i, and |d_i| is up to l_i^2 + 2 l_i R. With
//     d_i three roundings off b_i is off by ((D + 5) l_i / 2 + 4 R) u l_i, so
//     |g_i| <= (D + 7 + 2 K) u l_i L, L = max(R, Z, all l_i): D + 7 for D + 2 in 3, and this L in all that follows.
//  5. e_i . (e_i - 2 x) + d_i takes the place of e_i . (e_i - 2 x).
//  6. m is the sum of |2 x_d| and the longest l_i, so that |e_i| and |e_i - 2 x| are at most m as before. d_i is known
//     to 24 u^2 L^2 as two digits; its upper one is added to the sum of upper products, which rounds what is below
//     q sqrt(D) m, and so twice more: 2 D + 8 for 2 D + 3. Then w_0 is subtracted, of which two digits are exact, and
//     sums of two digits lose 4 u^2 (|z|^2 + |w_0|) at most.
// 7 is left to the exact stage.
struct CircumsphereBounds {
    double centre_error, beta_error, digit_error;  // a, beta_error and the factor of m^2 in 6
    double off_span, off_sum;                      // squares of the factors of P L and L in 7
    static constexpr double volume_min = 0x1p-24;
    // sqrt(e K) and sqrt(K), rounded up.
    static constexpr double root_ek[7] = {0, 1.65, 2.34, 2.86, 3.30, 3.69, 4.04},
                            root_k[7] = {0, 1, 1.42, 1.74, 2, 2.24, 2.45};

    constexpr CircumsphereBounds(int k, int dim, bool weighted = false)
        : centre_error(0), beta_error(0), digit_error(0), off_span(0), off_sum(0) {
        const double angles = (k - 1.0) * (2 * dim + 2 * k + 4) * (1 << k) / 4;  // (K-1) w / u P
        const double centre = root_ek[k] * (dim + (weighted ? 7 : 2) + 6 * k);
        centre_error = 1.05 * unit_roundoff * (angles + centre + (dim + 2) * root_k[k] + 2 * k * k * k);
        beta_error = 1.65 * centre_error;
        const double leave = k < dim ? 1.05 * unit_roundoff * (2 * k * root_ek[k] + k * root_k[k]) : 0;
        off_span = leave * leave;
        off_sum = (k + 2.0) * (k + 1) * unit_roundoff * (k + 2) * (k + 1) * unit_roundoff;
        digit_error = (2 * dim + (weighted ? 8 : 3)) * 1.7 * root_k[dim] * unit_roundoff * 0x1p-25;
    }
};

// Coordinate d of vertex i of each simplex.
template <class Lanes> inline Lanes coordinate_of(const double* const* const* point, std::uint32_t i, std::uint32_t d) {
    Lanes x = {};
    for (int lane = 0; lane < lane_count<Lanes>; ++lane) set_lane(x, lane, point[lane][i][d]);
    return x;
}

// 7 of the head, of x doubled and the b_i, not often: for all k and dim. spread: P^2, largest: L^2.
template <class Lanes>
[[gnu::noinline]] NearestRoot<Lanes> closer_look(std::uint32_t k, std::uint32_t dim, const double* const* const* point,
                                                 const Lanes* doubled, const Lanes* weight, Lanes spread,
                                                 Lanes largest) {
    const CircumsphereBounds bounds(static_cast<int>(k), static_cast<int>(dim));
    Lanes high = {}, low = {}, residual = {}, rounding = {}, gap = {};
    for (std::uint32_t d = 0; d < dim; ++d) {
        const TwoLanes<Lanes> term = exact_square(doubled[d]), sum = exact_sum(high, term.high);
        high = sum.high;
        low += sum.low + term.low;
    }
    high = high / 4;
    low = low / 4;
    for (std::uint32_t i = 0; i < k; ++i) {
        Lanes top = {}, rest = {}, length = {};
        for (std::uint32_t d = 0; d < dim; ++d) {
            const TwoLanes<Lanes> edge = exact_difference(coordinate_of<Lanes>(point, i + 1, d),
                                                          coordinate_of<Lanes>(point, 0, d)),
                                  away = exact_difference(edge.high, doubled[d]),
                                  term = exact_product(edge.high, away.high), sum = exact_sum(top, term.high);
            top = sum.high;
            rest += sum.low + (term.low + (edge.high * (away.low + edge.low) + edge.low * away.high));
            length += edge.high * edge.high;
        }
        const Lanes product_with = top + rest, most = lanes_absolute(product_with);
        low += weight[i] * product_with;
        residual += most * most / length;
        rounding += lanes_absolute(weight[i]) * most;
    }
    for (std::uint32_t d = 0; d < dim; ++d) {
        Lanes beside = doubled[d] / 2;
        for (std::uint32_t i = 0; i < k; ++i)
            beside -= weight[i] * (coordinate_of<Lanes>(point, i + 1, d) - coordinate_of<Lanes>(point, 0, d));
        gap += beside * beside;
    }
    const TwoLanes<Lanes> square = exact_sum(high, low);
    const Lanes apart = 0.75 * spread * residual + (1.05 * bounds.off_span * spread + 0x1p-94) * largest;
    return nearest_root(square.high, square.low,
                        1.05 * (4 * apart + 2 * gap + 2 * bounds.off_sum * largest) +
                            rounding * ((k + 2) * k * unit_roundoff));
}

template <class Lanes>
[[gnu::always_inline]] inline Certainty certainty_of(std::uint32_t k, const NearestRoot<Lanes>& nearest, Lanes first,
                                                     const Lanes* weight, LaneMask<Lanes> sure, LaneMask<Lanes> signs,
                                                     Circumsphere* out) {
    Certainty certain = {0, 0};
    for (int i = 0; i < lane_count<Lanes>; ++i) {
        std::uint32_t within = lane(first, i) < 0;
        for (std::uint32_t j = 0; j < k; ++j) within |= static_cast<std::uint32_t>(lane(weight[j], i) < 0) << (j + 1);
        out[i] = {lane(nearest.root, i), within};
        certain.within |= static_cast<std::uint32_t>(mask_lane(signs, i) & 1) << i;
        certain.radius |= static_cast<std::uint32_t>(mask_lane(nearest.known & sure, i) & 1) << i;
    }
    return certain;
}

// With weights: the weight of vertex i less that of vertex j, and the weight of vertex 0, in two digits.
template <class Lanes>
inline TwoLanes<Lanes> weight_difference(const double* const* const* point, std::uint32_t i, std::uint32_t j,
                                         std::uint32_t dim, bool are_radii) {
    const Lanes a = coordinate_of<Lanes>(point, i, dim), b = coordinate_of<Lanes>(point, j, dim);
    const TwoLanes<Lanes> less = exact_difference(a, b);
    if (!are_radii) return less;
    const TwoLanes<Lanes> more = exact_sum(a, b), product = exact_product(less.high, more.high);
    return {product.high, product.low + (less.high * more.low + less.low * more.high)};
}
template <class Lanes>
inline TwoLanes<Lanes> first_weight(const double* const* const* point, std::uint32_t dim, bool are_radii) {
    const Lanes number = coordinate_of<Lanes>(point, 0, dim);
    return are_radii ? exact_square(number) : TwoLanes<Lanes>{number, Lanes{}};
}

// The signed root of high + low, or the number itself, to the nearest double; high is the sum rounded.
template <class Lanes> inline NearestRoot<Lanes> nearest_power(Lanes high, Lanes low, Lanes slack, bool squares) {
    const LaneMask<Lanes> negative = below(high, Lanes{});
    high = select(negative, -high, high);
    low = select(negative, -low, low);
    NearestRoot<Lanes> nearest;
    if (squares) {
        // Half a unit below a power of two is half as much; what is nearer to the middle is left open.
        const LaneMask<Lanes> exponent = lane_bits(all_lanes<Lanes>(__builtin_huge_val()));
        const Lanes power = lanes_of<Lanes>(lane_bits(high) & exponent);
        nearest = {high, below(lanes_absolute(low) + 1.01 * slack, power * 0x1.fffp-55)};
        nearest.known |= below(lanes_absolute(low) + 1.01 * slack, power * 0x1.fffp-54) & ~same(high, power);
    } else {
        nearest = nearest_root(high, low, slack);
    }
    nearest.root = select(negative, -nearest.root, nearest.root);
    return nearest;
}

// lane_count<Lanes> simplices of K+1 points in R^D, 2 <= K <= D. Where a bit of the result is set, `within` or the
// radius of that simplex is right. Not certain: simplices that are flat for the precision, sizes far from 1, a beta_i
// too close to 0 to tell its sign, a radius too close to the middle between two doubles.
// With weights 1 <= K <= D, and in place of the radius the power, or its signed root.
template <class Lanes, int K, int D, class W = NoWeights>
inline Certainty circumspheres_fast(DimensionOf<K> k, DimensionOf<D> dim, const double* const* const* point,
                                    Circumsphere* out, const W& weights = W(), bool squares = false) {
    using Mask = LaneMask<Lanes>;
    constexpr int k_max = DimensionOf<K>::most, dim_max = DimensionOf<D>::most;
    constexpr double size_min = 0x1p-200, size_max = 0x1p200;
    const CircumsphereBounds bounds(static_cast<int>(std::uint32_t{k}), static_cast<int>(std::uint32_t{dim}), W::has);
    Lanes e[k_max][dim_max], b[k_max], n[k_max], whole[k_max], r[k_max][k_max], y[k_max], at[k_max];
    Mask sure = ~Mask{};
    Lanes whole_max = {};
    static_cast<void>(whole_max);
    static_cast<void>(weights);
    static_cast<void>(squares);
    Lanes whole_min = all_lanes<Lanes>(size_max), product = all_lanes<Lanes>(1), radius_squared = {};
    for (std::uint32_t d = 0; d < dim; ++d) {
        const Lanes base = coordinate_of<Lanes>(point, 0, d);
        for (std::uint32_t i = 0; i < k; ++i) e[i][d] = coordinate_of<Lanes>(point, i + 1, d) - base;
    }
    for (std::uint32_t i = 0; i < k; ++i) {
        n[i] = e[i][0] * e[i][0];
        for (std::uint32_t d = 1; d < dim; ++d) n[i] += e[i][d] * e[i][d];
        whole[i] = n[i];
        sure &= below(all_lanes<Lanes>(size_min), n[i]) & below(n[i], all_lanes<Lanes>(size_max));
        whole_min = select(below(n[i], whole_min), n[i], whole_min);
        b[i] = n[i] / 2;
        if constexpr (W::has) {
            const Lanes first = coordinate_of<Lanes>(point, 0, dim), other = coordinate_of<Lanes>(point, i + 1, dim);
            const Lanes less = weights.are_radii ? (first - other) * (first + other) : first - other;
            sure &= below(lanes_absolute(less), all_lanes<Lanes>(size_max));
            b[i] = (n[i] + less) / 2;
            whole_max = select(below(whole_max, n[i]), n[i], whole_max);
        }
        at[i] = all_lanes<Lanes>(i);
    }
    for (std::uint32_t j = 0; j < k; ++j) {
        Mask exceeds[k_max], later = {};
        Lanes most = n[j];
        for (std::uint32_t i = j + 1; i < k; ++i) {
            exceeds[i] = below(most, n[i]);
            most = select(exceeds[i], n[i], most);
        }
        for (std::uint32_t i = k - 1; i > j; --i) {
            const Mask is_pivot = exceeds[i] & ~later;
            later |= exceeds[i];
            for (std::uint32_t d = 0; d < dim; ++d) swap_where(is_pivot, e[j][d], e[i][d]);
            for (std::uint32_t m = 0; m < j; ++m) swap_where(is_pivot, r[m][j], r[m][i]);
            swap_where(is_pivot, b[j], b[i]);
            swap_where(is_pivot, n[j], n[i]);
            swap_where(is_pivot, whole[j], whole[i]);
            swap_where(is_pivot, at[j], at[i]);
        }
        const Lanes inverse = 1 / n[j];
        product *= n[j] / whole[j];
        y[j] = b[j] * inverse;
        radius_squared += b[j] * y[j];
        for (std::uint32_t i = j + 1; i < k; ++i) {
            Lanes c = e[i][0] * e[j][0];
            for (std::uint32_t d = 1; d < dim; ++d) c += e[i][d] * e[j][d];
            c *= inverse;
            r[j][i] = c;
            for (std::uint32_t d = 0; d < dim; ++d) e[i][d] -= c * e[j][d];
            b[i] -= c * b[j];
            n[i] = e[i][0] * e[i][0];
            for (std::uint32_t d = 1; d < dim; ++d) n[i] += e[i][d] * e[i][d];
        }
    }
    sure &= below(all_lanes<Lanes>(CircumsphereBounds::volume_min), product);
    const Lanes spread = 1 / product;  // P^2

    Lanes centre[dim_max];
    for (std::uint32_t d = 0; d < dim; ++d) {
        centre[d] = y[0] * e[0][d];
        for (std::uint32_t j = 1; j < k; ++j) centre[d] += y[j] * e[j][d];
    }
    Lanes first = all_lanes<Lanes>(1), largest = radius_squared, smallest = all_lanes<Lanes>(size_max);
    if constexpr (W::has) largest = select(below(largest, whole_max), whole_max, largest);
    Lanes weight[k_max] = {};  // beta of vertex i + 1
    for (std::uint32_t j = k; j-- > 0;) {
        Lanes beta = y[j];
        for (std::uint32_t i = j + 1; i < k; ++i) beta -= r[j][i] * y[i];
        y[j] = beta;
        first -= beta;
        const Lanes length_squared = beta * beta * whole[j];
        largest = select(below(largest, length_squared), length_squared, largest);
        smallest = select(below(length_squared, smallest), length_squared, smallest);
        for (std::uint32_t i = 0; i < k; ++i) weight[i] = weight[i] + only(same(at[j], all_lanes<Lanes>(i)), beta);
    }
    const Lanes error = bounds.beta_error * spread, slack = error * error * largest;
    const Mask signs = sure & below(slack, smallest) & below(slack * (k * k), first * first * whole_min);

    // From here on with 2 x, cut at multiples of q as edges are.
    Lanes upper[dim_max], size = {};
    for (std::uint32_t d = 0; d < dim; ++d) {
        centre[d] = centre[d] + centre[d];
        size += lanes_absolute(centre[d]);
    }
    if constexpr (W::has) size += lanes_root(whole_max);
    const Lanes cut = size * (1.05 * 0x1p27);
    Lanes high = {}, low = {}, weight_sum = all_lanes<Lanes>(1);
    for (std::uint32_t d = 0; d < dim; ++d) {
        upper[d] = (centre[d] + cut) - cut;
        high += upper[d] * upper[d];
        low += (centre[d] - upper[d]) * (centre[d] + upper[d]);
    }
    high = high / 4;
    low = low / 4;
    for (std::uint32_t i = 0; i < k; ++i) {
        Lanes top = {}, rest = {};
        for (std::uint32_t d = 0; d < dim; ++d) {
            const TwoLanes<Lanes> edge =
                exact_difference(coordinate_of<Lanes>(point, i + 1, d), coordinate_of<Lanes>(point, 0, d));
            const Lanes above = (edge.high + cut) - cut, below_it = (edge.high - above) + edge.low;
            const Lanes away = above - upper[d], away_below = below_it - (centre[d] - upper[d]);
            top += above * away;
            rest += above * away_below + below_it * (away + away_below);
        }
        if constexpr (W::has) {
            const TwoLanes<Lanes> less = weight_difference<Lanes>(point, 0, i + 1, dim, weights.are_radii);
            top = top + less.high;
            rest += less.low;
        }
        low += weight[i] * (top + rest);
        weight_sum += lanes_absolute(weight[i]);
    }
    TwoLanes<Lanes> square = exact_sum(high, low);
    if constexpr (W::has) {
        const TwoLanes<Lanes> own = first_weight<Lanes>(point, dim, weights.are_radii),
                              less = exact_difference(square.high, own.high),
                              power = exact_sum(less.high, less.low + (square.low - own.low));
        const Lanes bound = largest * (5 * bounds.centre_error * bounds.centre_error * spread) +
                            size * size * weight_sum * bounds.digit_error +
                            0x1p-99 * (lanes_absolute(square.high) + lanes_absolute(own.high));
        sure &= below(lanes_absolute(own.high), all_lanes<Lanes>(size_max));
        const NearestRoot<Lanes> nearest = nearest_power(power.high, power.low, bound, squares);
        return certainty_of<Lanes>(k, nearest, first, weight, sure, signs, out);
    }
    NearestRoot<Lanes> nearest = nearest_root(square.high, square.low,
                                              largest * (5 * bounds.centre_error * bounds.centre_error * spread) +
                                                  size * size * weight_sum * bounds.digit_error);
    if (any_lane<Lanes>(sure & ~nearest.known))
        nearest = closer_look<Lanes>(k, dim, point, centre, weight, spread, largest);
    return certainty_of<Lanes>(k, nearest, first, weight, sure, signs, out);
}

// Where size counts there is one stage for all k and dim.
#ifdef __OPTIMIZE_SIZE__
constexpr bool circumsphere_is_shared = true;
#else
constexpr bool circumsphere_is_shared = false;
#endif

}  // namespace netmesh
