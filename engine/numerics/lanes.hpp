// The same steps on one double or on several at a time, to the same bits: code written once for both, without branches.
//
// Lanes is double, or a vector of doubles. A mask has for each lane all bits or none.
#pragma once
#include <cstdint>

#include "numerics/square_root.hpp"

namespace netmesh {

using DoublePair = double __attribute__((vector_size(16)));
using PairMask = std::int64_t __attribute__((vector_size(16)));

template <class Lanes> struct LaneTraits;
template <> struct LaneTraits<double> { using Mask = std::int64_t; };
template <> struct LaneTraits<DoublePair> { using Mask = PairMask; };
template <class Lanes> using LaneMask = typename LaneTraits<Lanes>::Mask;
template <class Lanes> constexpr int lane_count = static_cast<int>(sizeof(Lanes) / sizeof(double));

template <class Lanes> inline LaneMask<Lanes> lane_bits(Lanes a) {
    LaneMask<Lanes> bits;
    static_assert(sizeof bits == sizeof a, "a mask has the lanes of its numbers");
    __builtin_memcpy(&bits, &a, sizeof bits);
    return bits;
}
template <class Lanes> inline Lanes lanes_of(LaneMask<Lanes> bits) {
    Lanes a;
    __builtin_memcpy(&a, &bits, sizeof a);
    return a;
}
template <class Lanes> inline Lanes all_lanes(double x) { return x - Lanes{}; }

template <class Lanes> inline double lane(Lanes a, int i) { return a[i]; }
inline double lane(double a, int) { return a; }
template <class Lanes> inline void set_lane(Lanes& a, int i, double x) { a[i] = x; }
inline void set_lane(double& a, int, double x) { a = x; }
template <class Mask> inline std::int64_t mask_lane(Mask a, int i) { return a[i]; }
inline std::int64_t mask_lane(std::int64_t a, int) { return a; }

template <class Lanes> inline LaneMask<Lanes> below(Lanes a, Lanes b) { return a < b; }
inline std::int64_t below(double a, double b) { return -static_cast<std::int64_t>(a < b); }
template <class Lanes> inline LaneMask<Lanes> same(Lanes a, Lanes b) { return a == b; }
inline std::int64_t same(double a, double b) { return -static_cast<std::int64_t>(a == b); }

template <class Lanes> inline bool any_lane(LaneMask<Lanes> a) {
    std::int64_t any = 0;
    for (int i = 0; i < lane_count<Lanes>; ++i) any |= mask_lane(a, i);
    return any != 0;
}

template <class Lanes> inline Lanes select(LaneMask<Lanes> where, Lanes a, Lanes b) {
    return lanes_of<Lanes>((lane_bits(a) & where) | (lane_bits(b) & ~where));
}
// a where the mask is set, else 0.
template <class Lanes> inline Lanes only(LaneMask<Lanes> where, Lanes a) {
    return lanes_of<Lanes>(lane_bits(a) & where);
}
template <class Lanes> inline void swap_where(LaneMask<Lanes> where, Lanes& a, Lanes& b) {
    const LaneMask<Lanes> differ = (lane_bits(a) ^ lane_bits(b)) & where;
    a = lanes_of<Lanes>(lane_bits(a) ^ differ);
    b = lanes_of<Lanes>(lane_bits(b) ^ differ);
}
template <class Lanes> inline Lanes lanes_absolute(Lanes a) {
    return lanes_of<Lanes>(lane_bits(a) & ~lane_bits(all_lanes<Lanes>(-0.0)));
}
template <class Lanes> inline Lanes lanes_root(Lanes a) {
    for (int i = 0; i < lane_count<Lanes>; ++i) set_lane(a, i, square_root(lane(a, i)));
    return a;
}

// The sum of both exactly, high being their sum rounded. Dekker 1971, Knuth TAOCP 2. Products as long as they and their
// last digits are in the range of doubles: a product of 2^-960 or more, or one that a bound of 2^-1000 does not see.
template <class Lanes> struct TwoLanes { Lanes high, low; };
template <class Lanes> inline TwoLanes<Lanes> exact_sum(Lanes a, Lanes b) {
    const Lanes s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
}
template <class Lanes> inline TwoLanes<Lanes> exact_difference(Lanes a, Lanes b) { return exact_sum(a, -b); }

template <class Lanes> inline TwoLanes<Lanes> split_in_halves(Lanes a) {
    const Lanes s = 134217729.0 * a, high = s - (s - a);
    return {high, a - high};
}
template <class Lanes> inline TwoLanes<Lanes> exact_product(Lanes a, Lanes b) {
    const Lanes p = a * b;
    const TwoLanes<Lanes> x = split_in_halves(a), y = split_in_halves(b);
    return {p, ((x.high * y.high - p) + x.high * y.low + x.low * y.high) + x.low * y.low};
}
template <class Lanes> inline TwoLanes<Lanes> exact_square(Lanes a) { return exact_product(a, a); }

// The double nearest to the root of high + low + error, |error| <= slack, where `known`; slack has to be 2^-100 high at
// least. high + low rounded is high, which is between 2^-900 and 2^900.
//
// With s the root of high rounded and h half a unit in its last place: high is within 2 s h + h^2 of s^2, |low| <= 2 s
// h, so the root of the sum is between s - 3 h and s + 3 h, and nearest is s or a neighbour of it. The midpoint above s
// has the square s^2 + 2 s h + h^2, h^2 <= 2^-106 s^2. Below a power of two a unit is half as large; there high - s^2
// >= - s h, as the root of high was rounded to s, and |low| <= s h / 2.
template <class Lanes> struct NearestRoot {
    Lanes root;
    LaneMask<Lanes> known;
};
template <class Lanes> inline NearestRoot<Lanes> nearest_root(Lanes high, Lanes low, Lanes slack) {
    const Lanes s = lanes_root(high);
    const TwoLanes<Lanes> square = exact_square(s);
    const Lanes rest = ((high - square.high) - square.low) + low;  // of the sum over s^2
    const LaneMask<Lanes> exponent = lane_bits(all_lanes<Lanes>(__builtin_huge_val()));
    const Lanes power = lanes_of<Lanes>(lane_bits(s) & exponent);
    const LaneMask<Lanes> is_power = same(s, power);
    const Lanes unit_above = power * 0x1p-52, unit_below = select(is_power, power * 0x1p-53, unit_above);
    const Lanes above = s * unit_above, below_s = s * unit_below;
    const Lanes spread = slack + high * 0x1p-102;
    const LaneMask<Lanes> up = below(above + spread, rest), down = below(rest, -below_s - spread);
    const LaneMask<Lanes> stay = below(rest, above - spread) & below(spread - below_s, rest);
    return {s + only(up, unit_above) - only(down, unit_below), up | down | stay};
}

}  // namespace netmesh
