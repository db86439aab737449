// Points and vectors of D doubles, D known to the compiler or an argument. Sums run in the order of the coordinates,
// which is part of every result.
#pragma once
#include "numerics/real.hpp"

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

}  // namespace netmesh
