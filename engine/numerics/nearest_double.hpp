// The double nearest to a number that can be compared with the midpoints between doubles, ties to even.
#pragma once
#include "numerics/bits.hpp"
#include "numerics/real.hpp"

namespace netmesh {

// x 2^e for x between 1/4 and 8, rounded; the largest double for what is above it.
inline double scaled_by(double x, int e) {
    constexpr double largest = 0x1.fffffffffffffp1023;
    if (e > 1030) return largest;
    for (; e > 1000; e -= 1000) x *= 0x1p1000;
    for (; e < -1000 && x > 0; e += 1000) x *= 0x1p-1000;
    if (x > 0) x *= power_of_two(e < -1000 ? 0 : e);
    return x < infinity ? x : largest;
}

// The midpoint between a finite x >= 0 and the next double above, in units of which the double is even: x + unit_above
// / 2. Above the largest double that unit goes on as below it.
inline double unit_above(double x) {
    const std::uint64_t exponent = bits_of(x) >> 52;
    return exponent > 52 ? double_of_bits((exponent - 52) << 52)
                         : double_of_bits(std::uint64_t{1} << (exponent > 0 ? exponent - 1 : 0));
}

// x: some units in the last place from the number at most, finite, >= 0. sign_over(y): the sign of the number less the
// midpoint above the finite y >= 0. Infinite beyond the largest double.
template <class SignOver> inline double nearest_double(double x, SignOver sign_over) {
    std::uint64_t bits = bits_of(x);
    for (;;) {
        const int sign = sign_over(double_of_bits(bits));
        if (sign < 0 || (sign == 0 && (bits & 1) == 0)) break;
        ++bits;
        if (bits == bits_of(infinity)) return infinity;
        if (sign == 0) return double_of_bits(bits);
    }
    if (bits != bits_of(x)) return double_of_bits(bits);
    for (; bits > 0; --bits) {
        const int sign = sign_over(double_of_bits(bits - 1));
        if (sign > 0 || (sign == 0 && (bits & 1) == 0)) break;
    }
    return double_of_bits(bits);
}

}  // namespace netmesh
