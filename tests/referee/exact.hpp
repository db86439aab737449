// Exact rationals, and what vectors and systems of equations need of both kinds of numbers.
#pragma once
#include <gmpxx.h>

#include <array>

#include "interval.hpp"

namespace referee {

constexpr int dim_max = 6;
using Rational = mpq_class;
using Point = std::array<double, dim_max>;
template <class T> using Vector = std::array<T, dim_max>;

inline Rational square(const Rational& a) { return a * a; }
inline Rational exact(double x) { return Rational(x); }

// The sign where it is known: -1, 0 or 1; 2 where it is not.
inline int sign_of(const Rational& a) { return sgn(a); }
inline int sign_of(const Interval& a) { return a.lo > 0 ? 1 : a.hi < 0 ? -1 : a.lo == 0 && a.hi == 0 ? 0 : 2; }

// Of p + r sqrt(q), q >= 0.
inline int sign_with_root(const Rational& p, const Rational& r, const Rational& q) {
    const int first = sgn(p), second = sgn(q) == 0 ? 0 : sgn(r);
    if (second == 0 || first == second) return first == 0 ? second : first;
    if (first == 0) return second;
    const Rational difference = p * p - r * r * q;
    return sgn(difference) == 0 ? 0 : sgn(difference) > 0 ? first : second;
}
inline int sign_with_root(const Interval& p, const Interval& r, const Interval& q) { return sign_of(p + r * root(q)); }

template <class T> T dot(const Vector<T>& a, const Vector<T>& b, int dim) {
    T sum = a[0] * b[0];
    for (int k = 1; k < dim; k++) sum = sum + a[k] * b[k];
    return sum;
}
template <class T> T norm2(const Vector<T>& a, int dim) {
    T sum = square(a[0]);
    for (int k = 1; k < dim; k++) sum = sum + square(a[k]);
    return sum;
}

inline double magnitude(const Interval& a) {
    const double m = std::fabs(a.middle());
    return m >= 0 ? m : 0;
}
inline double magnitude(const Rational& a) { return sgn(a) == 0 ? 0 : 1; }

template <class T> using Matrix = std::array<Vector<T>, dim_max>;

// x of m x = b for n equations, by elimination; false when a pivot is, or may be, zero.
template <class T> bool solve(Matrix<T> m, Vector<T> b, int n, Vector<T>* x) {
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++)
            if (magnitude(m[i][k]) > magnitude(m[best][k])) best = i;
        std::swap(m[k], m[best]);
        std::swap(b[k], b[best]);
        const int sign = sign_of(m[k][k]);
        if (sign != 1 && sign != -1) return false;
        for (int i = k + 1; i < n; i++) {
            const T factor = m[i][k] / m[k][k];
            for (int j = k + 1; j < n; j++) m[i][j] = m[i][j] - factor * m[k][j];
            b[i] = b[i] - factor * b[k];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n; j++) b[k] = b[k] - m[k][j] * (*x)[j];
        (*x)[k] = b[k] / m[k][k];
    }
    return true;
}

// Sign of the determinant; 2 where it is not known.
template <class T> int determinant_sign(Matrix<T> m, int n) {
    int sign = 1;
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++)
            if (magnitude(m[i][k]) > magnitude(m[best][k])) best = i;
        if (best != k) {
            std::swap(m[k], m[best]);
            sign = -sign;
        }
        const int pivot = sign_of(m[k][k]);
        if (pivot == 2) return 2;
        if (pivot == 0) {
            // A rational column without a pivot is zero from here on; of an interval's others nothing is known.
            for (int i = k + 1; i < n; i++)
                if (sign_of(m[i][k]) != 0) return 2;
            return 0;
        }
        sign *= pivot;
        for (int i = k + 1; i < n; i++) {
            const T factor = m[i][k] / m[k][k];
            for (int j = k + 1; j < n; j++) m[i][j] = m[i][j] - factor * m[k][j];
        }
    }
    return sign;
}

// b - a in either kind of number.
template <class T> Vector<T> difference(const Point& a, const Point& b, int dim) {
    Vector<T> d;
    for (int k = 0; k < dim; k++) d[k] = T(b[k]) - T(a[k]);
    return d;
}

// Sign of |a - b| - r, exactly.
inline int compare_distance(const Point& a, const Point& b, int dim, double r) {
    const int guess = sign_of(norm2<Interval>(difference<Interval>(a, b, dim), dim) - square(Interval(r)));
    if (guess != 2) return guess;
    return sign_of(Rational(norm2<Rational>(difference<Rational>(a, b, dim), dim) - square(exact(r))));
}

inline double distance(const Point& a, const Point& b, int dim) {
    double sum = 0;
    for (int k = 0; k < dim; k++) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(sum);
}

}  // namespace referee
