// Numbers of about 106 bits: the unevaluated sum of two doubles, high == high + low rounded. No FMA is used or needed.
// Relative error of +, -, * below 2^-102, of / below 2^-100, as long as nothing overflows or underflows: magnitudes
// (and those of products) between 2^-900 and 2^990 are safe. Dekker 1971, Knuth TAOCP 2, Joldes et al. 2017.
#pragma once
#include "numerics/lanes.hpp"

namespace netmesh {

using DoubleDouble = TwoLanes<double>;

// Requires |a| >= |b| or a == 0.
inline DoubleDouble quick_two_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
}

inline DoubleDouble operator-(DoubleDouble a) { return {-a.high, -a.low}; }

inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    DoubleDouble s = exact_sum(a.high, b.high);
    const DoubleDouble t = exact_sum(a.low, b.low);
    s = quick_two_sum(s.high, s.low + t.high);
    return quick_two_sum(s.high, s.low + t.low);
}

inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }

inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble p = exact_product(a.high, b.high);
    return quick_two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double q = a.high / b.high;
    const DoubleDouble r = a - b * DoubleDouble{q, 0};
    const double q2 = r.high / b.high;
    const DoubleDouble r2 = r - b * DoubleDouble{q2, 0};
    const DoubleDouble s = quick_two_sum(q, q2);
    return s + DoubleDouble{r2.high / b.high, 0};
}

// The same number times a power of two, exactly.
inline DoubleDouble scaled(DoubleDouble a, double power_of_two) {
    return {a.high * power_of_two, a.low * power_of_two};
}

// sqrt(a), a >= 0, rounded to double: almost always the nearest.
inline double square_root(DoubleDouble a) {
    if (!(a.high > 0)) return 0;
    const double s = square_root(a.high);
    const DoubleDouble rest = a - exact_product(s, s);
    return s + rest.high / (2 * s);
}

}  // namespace netmesh
