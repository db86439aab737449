// Numbers of twice the digits of a long double, for what plain ones lose where points are nearly dependent.
#pragma once
#include <cfloat>
#include <cmath>
#include <type_traits>

namespace netmesh::tool {

// A long double of two doubles does not add as the proofs below ask for.
using Half = std::conditional_t<LDBL_MANT_DIG == 64 || LDBL_MANT_DIG == 113, long double, double>;
constexpr int half_digits = std::is_same_v<Half, double> ? DBL_MANT_DIG : LDBL_MANT_DIG;

// high + low, |low| <= ulp(high) / 2.
struct Wide {
    Half high = 0, low = 0;
};

// Share by which a sum, difference, product or quotient is off: less than 16 u^2, u = 2^-half_digits (Joldes, Muller,
// Popescu: Tight and rigorous error bounds for basic building blocks of double-word arithmetic, 2017).
inline Half wide_error() { return std::ldexp(Half{1}, 4 - 2 * half_digits); }

// a + b and a * b with nothing lost (Knuth; Dekker).
inline Wide exact_sum(Half a, Half b) {
    const Half sum = a + b, other = sum - a;
    return {sum, (a - (sum - other)) + (b - other)};
}
inline Wide exact_product(Half a, Half b) {
    const Half factor = std::ldexp(Half{1}, (half_digits + 1) / 2) + 1;
    const Half ta = factor * a, tb = factor * b;
    const Half ah = ta - (ta - a), al = a - ah, bh = tb - (tb - b), bl = b - bh;
    const Half product = a * b;
    return {product, ((ah * bh - product) + ah * bl + al * bh) + al * bl};
}

inline Wide operator-(const Wide& a) { return {-a.high, -a.low}; }
inline Wide operator+(const Wide& a, const Wide& b) {
    const Wide s = exact_sum(a.high, b.high), t = exact_sum(a.low, b.low);
    const Wide v = exact_sum(s.high, s.low + t.high);
    return exact_sum(v.high, v.low + t.low);
}
inline Wide operator-(const Wide& a, const Wide& b) { return a + -b; }
inline Wide operator*(const Wide& a, const Wide& b) {
    const Wide p = exact_product(a.high, b.high);
    return exact_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}
inline Wide operator/(const Wide& a, const Wide& b) {
    const Half first = a.high / b.high;
    const Wide rest = a - Wide{first, 0} * b;
    const Half second = rest.high / b.high;
    const Wide last = rest - Wide{second, 0} * b;
    return exact_sum(first, second) + Wide{last.high / b.high, 0};
}

}  // namespace netmesh::tool
