// When two values that move on straight lines meet, and which of two such meetings is the earlier one: exactly.
#pragma once
#include "numerics/product_sum.hpp"
#include "numerics/real.hpp"

namespace netmesh {

// A value on its way, any finite numbers.
struct MovingValue {
    double from, to;
};

// Of a that is not above b at first and not below it in the end, with p = b.from - a.from and q = a.to - b.to, not both
// 0: they meet at t = p / (p + q), a number in [0, 1].
struct Crossing {
    MovingValue a, b;
};

inline bool are_equal(const Crossing& x, const Crossing& y) {
    return x.a.from == y.a.from && x.b.from == y.b.from && x.a.to == y.a.to && x.b.to == y.b.to;
}

// t with an error of at most 2^-50 t + 2^-1072: p and q are rounded once each, and exact where they are subnormal,
// their sum and the quotient once more, which makes (1 + u)^2 / (1 - u)^2, u = 2^-53, and half a unit of a subnormal
// quotient. An eighth of each value is taken where p + q overflows: that costs p less than 2^-1073, and p + q is above
// 2^1020.
inline double time_of(const Crossing& c) {
    double p = c.b.from - c.a.from, q = c.a.to - c.b.to;
    if (!(p + q < infinity)) {
        p = 0.125 * c.b.from - 0.125 * c.a.from;
        q = 0.125 * c.a.to - 0.125 * c.b.to;
    }
    return p / (p + q);
}

// A crossing whose time_of is above this is surely later than one whose time_of is s: above 2 s the difference is more
// than s, else the errors of both are below 3 * 2^-50 s + 2^-1071.
inline double may_equal(double s) { return s + (0x1p-47 * s + 0x1p-1069); }

// The sign of p_x q_y - p_y q_x.
[[gnu::cold, gnu::noinline]] inline int compare_products(const Crossing& x, const Crossing& y) {
    ProductSum sum;
    sum.add(x.b.from, y.a.to);
    sum.subtract(x.b.from, y.b.to);
    sum.subtract(x.a.from, y.a.to);
    sum.add(x.a.from, y.b.to);
    sum.subtract(y.b.from, x.a.to);
    sum.add(y.b.from, x.b.to);
    sum.add(y.a.from, x.a.to);
    sum.subtract(y.a.from, x.b.to);
    return sum.sign();
}

// The sign of the time of x less that of y. Most times that need the question are equal: those of the simplices of two
// stars, 0 where values begin equal and 1 where they end so.
inline int compare_times(const Crossing& x, const Crossing& y) {
    if (are_equal(x, y)) return 0;
    const bool x_at_0 = x.a.from == x.b.from, y_at_0 = y.a.from == y.b.from;
    if (x_at_0 || y_at_0) return y_at_0 - x_at_0;
    const bool x_at_1 = x.a.to == x.b.to, y_at_1 = y.a.to == y.b.to;
    if (x_at_1 || y_at_1) return x_at_1 - y_at_1;
    return compare_products(x, y);
}

}  // namespace netmesh
