// Distances of points as Rips and Cech complexes measure them.
#pragma once
#include <cstddef>
#include <cstdint>

#include "filtration/circumsphere.hpp"
#include "include/netmesh.h"
#include "numerics/vector.hpp"

namespace netmesh {

// Half the distance of two points of more coordinates than a circumsphere has, where squares are out of range: what is
// squared is brought to sizes between 2^-256 and 2^256, and the root back, both by powers of two.
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

// Half the distance of two points.
[[gnu::noinline, gnu::cold]] inline double precise_half_distance(int dim, const double* a, const double* b) {
    if (dim > NETMESH_DIM_MAX) return scaled_half_distance(dim, a, b);
    const double* const point[] = {a, b};
    return circumsphere_precise(point, 1, dim).radius;
}
[[gnu::always_inline]] inline double half_distance(int dim, const double* a, const double* b) {
    const double squared = distance2(dim, a, b);
    if (squared > 0x1p-900 && squared < 0x1p1000) return square_root(squared) / 2;
    return precise_half_distance(dim, a, b);
}
template <int D> double half_distance(const double* a, const double* b) { return half_distance(D, a, b); }

// A bound on the relative error of half distances from `least` to `most`. A squared length has dim + 2 roundings, the
// root halves them and adds one. Lengths whose squares are out of range are computed in twice the digits: that adds a
// few 2^-98 and at most two roundings, the last perhaps to a denormal number. The largest double stands for all lengths
// above it, so there is no bound for it. Of more coordinates than NETMESH_DIM_MAX they are scaled instead, and both
// bounds add up. least > most: there are no distances.
inline double half_distance_error(int dim, double least, double most) {
    double error = 1.01 * unit_roundoff * (dim / 2.0 + 2);
    const double ends[] = {least, most};
    for (const double half : ends) {
        if ((half > 0x1p-450 && half < 0x1p499) || !(least <= most)) continue;
        const double here = half >= 0x1.fffffffffffffp1023 ? infinity : 0x1p-51 + 0x1p-1073 / half;
        if (dim > NETMESH_DIM_MAX)
            error += here;
        else if (here > error)
            error = here;
    }
    return error;
}

// Half the least distance within which some point has all others.
inline double cone_radius(int dim, const double* coordinates, std::uint32_t n) {
    const std::size_t row = static_cast<std::size_t>(dim);
    double least = infinity;
    for (std::uint32_t i = 0; i < n; ++i) {
        double most = 0;
        for (std::uint32_t j = 0; j < n && most < least; ++j) {
            const double half = half_distance(dim, coordinates + i * row, coordinates + j * row);
            if (j != i && half > most) most = half;
        }
        if (most < least) least = most;
    }
    return least;
}

}  // namespace netmesh
