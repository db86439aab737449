// The predicates in GMP integers: the slow and obvious form.
#pragma once
#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace oracle {

using Point = std::vector<double>;
using Matrix = std::vector<std::vector<mpz_class>>;

// All coordinates times one power of two that makes them integers.
inline Matrix integers(const std::vector<Point>& points) {
    int least = 1024;
    for (const Point& p : points)
        for (double x : p) {
            int e;
            if (x != 0) {
                std::frexp(x, &e);
                least = std::min(least, e - 53);
            }
        }
    Matrix result;
    for (const Point& p : points) {
        result.emplace_back();
        for (double x : p) {
            int e;
            const double m = std::frexp(x, &e);
            mpz_class z(std::ldexp(m, 53));
            if (x != 0) z <<= e - 53 - least;
            result.back().push_back(z);
        }
    }
    return result;
}

// Bareiss: fraction-free elimination.
inline mpz_class determinant(Matrix a) {
    const std::size_t n = a.size();
    mpz_class previous = 1;
    int sign = 1;
    for (std::size_t k = 0; k + 1 < n; ++k) {
        std::size_t pivot = k;
        while (pivot < n && a[pivot][k] == 0) ++pivot;
        if (pivot == n) return 0;
        if (pivot != k) {
            std::swap(a[pivot], a[k]);
            sign = -sign;
        }
        for (std::size_t i = k + 1; i < n; ++i)
            for (std::size_t j = k + 1; j < n; ++j) {
                mpz_class v = a[i][j] * a[k][k] - a[i][k] * a[k][j];
                mpz_divexact(a[i][j].get_mpz_t(), v.get_mpz_t(), previous.get_mpz_t());
            }
        previous = a[k][k];
    }
    return sign * a[n - 1][n - 1];
}

inline mpz_class orient_integer(const Matrix& x) {
    Matrix rows;
    for (std::size_t i = 1; i < x.size(); ++i) {
        rows.emplace_back();
        for (std::size_t c = 0; c < x[0].size(); ++c) rows.back().push_back(x[i][c] - x[0][c]);
    }
    return determinant(rows);
}

inline int orient(const std::vector<Point>& points) { return sgn(orient_integer(integers(points))); }

// x: D+2 rows with the lift as last coordinate. Positive when the last point is below the hyperplane through the others
// and these are positively oriented: shear that hyperplane to height 0, and the determinant is orient of the others
// times the height of the last point.
inline int below_lifted(const Matrix& x) { return -sgn(orient_integer(x)); }

// weights: added to the lifts; may be empty. Units: quanta squared over 2^weight_shift.
inline int in_ball(const std::vector<Point>& points, const std::vector<mpz_class>& weights = {}, int weight_shift = 0) {
    Matrix x = integers(points);
    for (std::size_t i = 0; i < x.size(); ++i) {
        mpz_class lift = 0;
        for (const mpz_class& c : x[i]) lift += c * c;
        lift <<= weight_shift;
        if (!weights.empty()) lift += weights[i];
        x[i].push_back(lift);
    }
    return below_lifted(x);
}

}  // namespace oracle
