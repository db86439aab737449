// Intervals that surely contain the exact result, in ordinary doubles.
//
// An operation rounded to nearest is off by at most 2^-53 of its result r, or 2^-1075 where it underflows. Each end is
// moved by 2^-51 |r| + 2^-1074; the move itself is rounded, by at most 2^-53 |r| (1 + 2^-51), so more than 2^-52 |r| of
// it is left. What overflows or is no number becomes the whole line.
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

namespace referee {

struct Interval {
    double lo = 0, hi = 0;
    Interval() = default;
    Interval(double exact) : lo(exact), hi(exact) {}
    Interval(double low, double high) : lo(low), hi(high) {}
    double middle() const { return 0.5 * lo + 0.5 * hi; }
    bool surely_above(double x) const { return lo > x; }
    bool surely_below(double x) const { return hi < x; }
};

inline Interval whole_line() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}
inline double moved(double r) { return std::fabs(r) * 0x1p-51 + 0x1p-1074; }
inline Interval widened(double low, double high) {
    const double lo = low - moved(low), hi = high + moved(high);
    return lo <= hi && std::isfinite(lo) && std::isfinite(hi) ? Interval(lo, hi) : whole_line();
}

inline Interval operator+(Interval a, Interval b) { return widened(a.lo + b.lo, a.hi + b.hi); }
inline Interval operator-(Interval a, Interval b) { return widened(a.lo - b.hi, a.hi - b.lo); }
inline Interval operator-(Interval a) { return {-a.hi, -a.lo}; }
inline Interval operator*(Interval a, Interval b) {
    const double p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
    if (!std::isfinite(p + q + r + s)) return whole_line();  // one is not finite, or nearly so
    return widened(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}
inline Interval operator/(Interval a, Interval b) {
    if (!(b.lo > 0 || b.hi < 0)) return whole_line();
    const double p = a.lo / b.lo, q = a.lo / b.hi, r = a.hi / b.lo, s = a.hi / b.hi;
    if (!std::isfinite(p + q + r + s)) return whole_line();
    return widened(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}
inline Interval square(Interval a) {
    const Interval s = a * a;
    return s.lo < 0 ? Interval(0, s.hi) : s;
}
// Of what is known not to be negative.
inline Interval root(Interval a) {
    const double low = std::sqrt(std::fmax(a.lo, 0)), high = std::sqrt(std::fmax(a.hi, 0));
    const Interval s = widened(low, high);
    return s.lo < 0 ? Interval(0, s.hi) : s;
}
// Times 2^e: exact, or off by less than the least double.
inline Interval scaled(Interval a, int e) {
    const double lo = std::ldexp(a.lo, e) - 0x1p-1074, hi = std::ldexp(a.hi, e) + 0x1p-1074;
    return std::isfinite(lo) && std::isfinite(hi) ? Interval(lo, hi) : whole_line();
}

}  // namespace referee
