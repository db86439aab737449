// Distances of points as Rips, Cech and alpha complexes measure them: half of the true one, rounded to the nearest
// double, ties to even.
#pragma once
#include <cstddef>
#include <cstdint>

#include "numerics/lanes.hpp"
#include "numerics/nearest_double.hpp"
#include "numerics/product_sum.hpp"
#include "numerics/vector.hpp"

namespace netmesh {

// In units in the last place a few off, whatever the sizes: what is squared is brought to sizes between 2^-256 and
// 2^256, and the root back, both by powers of two. At most the largest double.
[[gnu::noinline, gnu::cold]] inline double scaled_half_distance(int dim, const double* a, const double* b) {
    double most = 0;  // of half differences, which do not overflow
    for (int k = 0; k < dim; ++k) {
        const double d = absolute(a[k] / 2 - b[k] / 2);
        if (d > most) most = d;
    }
    if (most == 0) {  // differences that cannot be halved
        for (int k = 0; k < dim; ++k) {
            const double d = absolute(a[k] - b[k]);
            if (d > most) most = d;
        }
        if (most == 0) return 0;
    }
    double up = 1, down = 1;
    for (; most * up < 0x1p-256; up *= 0x1p128, down *= 0x1p-128) {
    }
    for (; most * up >= 0x1p256; up *= 0x1p-128, down *= 0x1p128) {
    }
    double sum = 0;
    for (int k = 0; k < dim; ++k) {
        const double d = up >= 1 ? (a[k] - b[k]) * up : a[k] * up - b[k] * up;
        sum += d * d;
    }
    const double half = square_root(sum) / 2 * down;
    return half < infinity ? half : 0x1.fffffffffffffp1023;
}

// Any finite points of up to 65,536 coordinates. With u the unit above x the midpoint is x + u / 2, and half of the
// distance is above it where the squared distance is above (2 x + u)^2.
[[gnu::noinline, gnu::cold]] inline double exact_half_distance(int dim, const double* a, const double* b) {
    int apart = 0;
    double along = 0;
    for (int k = 0; k < dim; ++k)
        if (a[k] != b[k]) {
            ++apart;
            along = absolute(a[k] - b[k]);
        }
    if (apart == 0) return 0;
    if (apart == 1 && along >= 0x1p-1021 && along < infinity) return along / 2;
    return nearest_double(scaled_half_distance(dim, a, b), [=](double x) {
        ProductSum sum;
        for (int k = 0; k < dim; ++k) {
            sum.add(a[k], a[k]);
            sum.add(b[k], b[k]);
            sum.subtract(a[k], b[k]);
            sum.subtract(a[k], b[k]);
        }
        const double unit = unit_above(x);
        sum.subtract(unit, unit);
        for (int i = 0; i < 4; ++i) {
            sum.subtract(x, x);
            sum.subtract(x, unit);
        }
        return sum.sign();
    });
}

// difference(d): b[d] - a[d] of as many pairs of points, as sums of two doubles. Of them half the distance each, in
// out, and bit i of the result where that is certain. The sum of dim squares is taken less the squares of the low
// parts: it is off by less than (8 dim + 16) dim u^2 of itself, u = 2^-53, and the root has to tell more.
template <class Lanes, class Difference>
inline std::uint32_t half_distances_fast(std::uint32_t dim, Difference difference, double* out) {
    Lanes high = {}, low = {};
    for (std::uint32_t d = 0; d < dim; ++d) {
        const TwoLanes<Lanes> edge = difference(d), square = exact_square(edge.high),
                              sum = exact_sum(high, square.high);
        high = sum.high;
        low += sum.low + (square.low + (edge.high + edge.high) * edge.low);
    }
    const TwoLanes<Lanes> sum = exact_sum(high, low);
    const double terms = dim;
    const NearestRoot<Lanes> nearest =
        nearest_root(sum.high, sum.low, sum.high * ((8 * terms + 16) * terms * 0x1p-106 + 0x1p-100));
    const LaneMask<Lanes> known =
        nearest.known & below(all_lanes<Lanes>(0x1p-800), sum.high) & below(sum.high, all_lanes<Lanes>(0x1p800));
    std::uint32_t certain = 0;
    for (int i = 0; i < lane_count<Lanes>; ++i) {
        out[i] = lane(nearest.root, i) / 2;
        certain |= static_cast<std::uint32_t>(mask_lane(known, i) & 1) << i;
    }
    return certain;
}

// Half the distance of two points. dim <= 65,536.
[[gnu::always_inline]] inline double half_distance(int dim, const double* a, const double* b) {
    double half;
    const auto difference = [=](std::uint32_t d) { return exact_difference(b[d], a[d]); };
    if (half_distances_fast<double>(static_cast<std::uint32_t>(dim), difference, &half) != 0) return half;
    return exact_half_distance(dim, a, b);
}
template <int D> double half_distance(const double* a, const double* b) { return half_distance(D, a, b); }

// What a squared distance that is off by (dim + 3) u says of the rounded half of the distance, for comparisons. False:
// perhaps. A share of (dim + 8) 2^-52 leaves more than a unit in the last place of the half.
inline bool surely_above(int dim, double squared, double half) {
    const double share = (dim + 8) * 0x1p-52;
    return squared > 0x1p-900 && squared < 0x1p1000 && squared * (1 - share) > 4 * half * half;
}
inline bool surely_below(int dim, double squared, double half) {
    const double share = (dim + 8) * 0x1p-52;
    return squared > 0x1p-900 && squared < 0x1p1000 && squared * (1 + share) < 4 * half * half;
}

// Half the least distance within which some point has all others. Distances are rounded to nearest only where they may
// be the largest of their point.
template <int D> double cone_radius(int dim, const double* coordinates, std::uint32_t n) {
    const std::size_t row = static_cast<std::size_t>(dim);
    double least = infinity;
    for (std::uint32_t i = 0; i < n; ++i) {
        const double* const a = coordinates + i * row;
        double squared = 0, most = 0;
        for (std::uint32_t j = 0; j < n && !surely_above(dim, squared, least); ++j) {
            const double d2 = distance2<D>(dim, a, coordinates + j * row);
            if (d2 > squared) squared = d2;
        }
        if (surely_above(dim, squared, least)) continue;
        const double less = square_root(squared) / 2 * (1 - (dim + 8) * 0x1p-51);
        for (std::uint32_t j = 0; j < n && most < least; ++j) {
            const double* const b = coordinates + j * row;
            if (j == i || surely_below(dim, distance2<D>(dim, a, b), less)) continue;
            const double half = half_distance(dim, a, b);
            if (half > most) most = half;
        }
        if (most < least) least = most;
    }
    return least;
}

}  // namespace netmesh
