// Points and vectors of D doubles, D known to the compiler or an argument; or either, where templates are made for
// both. Sums run in the order of the coordinates, which is part of every result.
#pragma once
#include "numerics/real.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

template <int D> inline double dot(const double* a, const double* b) {
    double sum = 0;
    for (int k = 0; k < D; ++k) sum += a[k] * b[k];
    return sum;
}

template <int D> inline double distance2(const double* a, const double* b) {
    double d2 = 0;
    for (int k = 0; k < D; ++k) {
        const double d = a[k] - b[k];
        d2 += d * d;
    }
    return d2;
}

template <int D> inline double distance(const double* a, const double* b) { return square_root(distance2<D>(a, b)); }

template <int D> inline void copy(const double* from, double* to) {
    for (int k = 0; k < D; ++k) to[k] = from[k];
}

inline double dot(int dim, const double* a, const double* b) {
    double sum = 0;
    for (int k = 0; k < dim; ++k) sum += a[k] * b[k];
    return sum;
}

inline double distance2(int dim, const double* a, const double* b) {
    double d2 = 0;
    for (int k = 0; k < dim; ++k) {
        const double d = a[k] - b[k];
        d2 += d * d;
    }
    return d2;
}

inline double distance(int dim, const double* a, const double* b) { return square_root(distance2(dim, a, b)); }

inline void copy(int dim, const double* from, double* to) {
    for (int k = 0; k < dim; ++k) to[k] = from[k];
}

template <> double dot<any_dimension>(const double*, const double*) = delete;
template <> double distance2<any_dimension>(const double*, const double*) = delete;
template <> double distance<any_dimension>(const double*, const double*) = delete;
template <> void copy<any_dimension>(const double*, double*) = delete;

// dim is D, unless that is any_dimension.
template <int D> inline double dot(int dim, const double* a, const double* b) {
    if constexpr (D == any_dimension)
        return dot(dim, a, b);
    else
        return dot<D>(a, b);
}
template <int D> inline double distance2(int dim, const double* a, const double* b) {
    if constexpr (D == any_dimension)
        return distance2(dim, a, b);
    else
        return distance2<D>(a, b);
}
template <int D> inline double distance(int dim, const double* a, const double* b) {
    return square_root(distance2<D>(dim, a, b));
}
template <int D> inline void copy(int dim, const double* from, double* to) {
    if constexpr (D == any_dimension)
        copy(dim, from, to);
    else
        copy<D>(from, to);
}

}  // namespace netmesh
