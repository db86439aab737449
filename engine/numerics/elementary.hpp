// Elementary functions by + - * / alone: the same numbers on every platform, within a few units in the last place.
#pragma once
#include "numerics/real.hpp"

namespace netmesh {

// ln x, x positive and finite.
inline double logarithm(double x) {
    int exponent = 0;
    if (x < 0x1p-1000) {
        x *= 0x1p100;
        exponent = -100;
    }
    const int shift = static_cast<int>(bits_of(x) >> 52) - 1023;
    double m = x * power_of_two(-(shift / 2)) * power_of_two(-(shift - shift / 2));
    exponent += shift;
    if (m > 1.4142135623730951) {
        m *= 0.5;
        ++exponent;
    }
    // m in [sqrt(1/2), sqrt(2)]: 2 artanh((m - 1) / (m + 1)).
    const double z = (m - 1) / (m + 1), z2 = z * z;
    double sum = 0;
    for (int k = 23; k >= 1; k -= 2) sum = sum * z2 + 1.0 / k;
    return 2 * z * sum + exponent * 0.6931471805599453;
}

// arcsin x, 0 <= x <= 1/2.
inline double arcsine(double x) {
    double term = x, sum = 0;
    for (int k = 0; k < 30; ++k) {
        sum += term / (2 * k + 1);
        term *= x * x * (2 * k + 1) / (2 * k + 2);
    }
    return sum;
}

// x^n, n >= 0; +infinity where it overflows.
inline double power(double x, int n) {
    double p = 1;
    for (int k = 0; k < n; ++k) p *= x;
    return p;
}

// Volume of the unit ball in R^d, d = 0..6.
inline double unit_ball_volume(int d) {
    static constexpr double volume[] = {
        1, 2, 3.141592653589793, 4.188790204786391, 4.934802200544679, 5.263789013914325, 5.167712780049970};
    return volume[d];
}

}  // namespace netmesh
