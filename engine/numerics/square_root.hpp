// Square roots of doubles, correctly rounded, without a library.
#pragma once
#include <cstdint>

// Where errno is kept, compilers call a library for negative numbers unless a declaration says that nothing is written.
#ifndef __NO_MATH_ERRNO__
#define NETMESH_SQUARE_ROOT sqrt
extern "C" double sqrt(double) noexcept __attribute__((const));
#else
#define NETMESH_SQUARE_ROOT __builtin_sqrt
#endif

namespace netmesh {

// In integers alone, for processors without a unit for doubles. Digit by digit, two bits of the radicand for one of the
// root: 54 steps.
inline double integer_square_root(double x) {
    std::uint64_t bits;
    __builtin_memcpy(&bits, &x, sizeof bits);
    constexpr std::uint64_t hidden = std::uint64_t{1} << 52, infinity = std::uint64_t{0x7FF} << 52;
    if ((bits << 1) == 0 || bits == infinity) return x;
    if (bits > infinity) return __builtin_nan("");  // below zero, or not a number
    std::uint64_t mantissa = bits & (hidden - 1);
    int exponent = static_cast<int>(bits >> 52);
    if (exponent == 0) {
        for (exponent = 1; mantissa < hidden; --exponent) mantissa <<= 1;
    } else {
        mantissa |= hidden;
    }
    exponent -= 1023;
    if (exponent & 1) {
        mantissa <<= 1;
        --exponent;
    }
    std::uint64_t root = 0, rest = 0;
    for (int i = 0; i < 54; ++i) {
        rest = rest << 2 | (mantissa >> 52 & 3);
        mantissa = mantissa << 2 & ((std::uint64_t{1} << 54) - 1);
        const std::uint64_t trial = root << 2 | 1;
        root <<= 1;
        if (rest >= trial) {
            rest -= trial;
            root |= 1;
        }
    }
    // The last bit is a half; a root is never exactly halfway between two doubles.
    const std::uint64_t rounded = (root >> 1) + (root & 1);
    bits = rounded - hidden + (static_cast<std::uint64_t>(exponent / 2 + 1023) << 52);
    __builtin_memcpy(&x, &bits, sizeof x);
    return x;
}

#if defined(__arm__) && !(defined(__ARM_FP) && (__ARM_FP & 8)) ||                                                      \
    defined(__riscv) && !(defined(__riscv_flen) && __riscv_flen >= 64)
inline double square_root(double x) { return integer_square_root(x); }
#else
inline double square_root(double x) { return NETMESH_SQUARE_ROOT(x); }
#endif

}  // namespace netmesh

#undef NETMESH_SQUARE_ROOT
