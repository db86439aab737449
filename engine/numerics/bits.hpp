// Doubles taken apart, bits counted.
//
// Leading and trailing zeros are counted by the instruction; where a target has none the compiler calls its own routine
// (__clzdi2, __ctzdi2). Exponents of doubles and population counts go without, so that nothing else is called anywhere.
#pragma once
#include <cstdint>

namespace netmesh {

inline std::uint64_t bits_of(double x) {
    std::uint64_t b;
    static_assert(sizeof b == sizeof x, "doubles have 64 bits");
    __builtin_memcpy(&b, &x, sizeof b);
    return b;
}

inline double double_of_bits(std::uint64_t b) {
    double x;
    __builtin_memcpy(&x, &b, sizeof x);
    return x;
}

// 2^k, k in [-1022, 1023].
inline double power_of_two(int k) { return double_of_bits(static_cast<std::uint64_t>(k + 1023) << 52); }

// x finite: x = (-1)^negative * mantissa * 2^exponent, mantissa < 2^53, exponent in [-1074, 971].
struct Decoded {
    std::uint64_t mantissa;
    int exponent;
    bool negative;
};

inline Decoded decode(double x) {
    const std::uint64_t b = bits_of(x);
    const int biased = static_cast<int>((b >> 52) & 0x7FF);
    const std::uint64_t fraction = b & ((std::uint64_t{1} << 52) - 1);
    const std::uint64_t hidden = static_cast<std::uint64_t>(biased != 0) << 52;
    return {fraction | hidden, biased - 1075 + (biased == 0), (b >> 63) != 0};
}

// floor(log2 m), 0 < m <= 2^53.
inline int log2_floor(std::uint64_t m) {
    return static_cast<int>(bits_of(static_cast<double>(static_cast<std::int64_t>(m))) >> 52) - 1023;
}

// Positions of the lowest and highest set bit of x != 0; how many bits are set.
inline std::uint32_t lowest_bit(std::uint64_t x) { return static_cast<std::uint32_t>(__builtin_ctzll(x)); }
inline std::uint32_t highest_bit(std::uint64_t x) { return 63u - static_cast<std::uint32_t>(__builtin_clzll(x)); }
inline std::uint32_t count_bits(std::uint64_t x) {
    x -= x >> 1 & 0x5555555555555555u;
    x = (x & 0x3333333333333333u) + (x >> 2 & 0x3333333333333333u);
    x = (x + (x >> 4)) & 0x0F0F0F0F0F0F0F0Fu;
    return static_cast<std::uint32_t>(x * 0x0101010101010101u >> 56);
}

constexpr int exponent_of_zero = -4096;  // below every exponent of a finite double

// floor(log2 x) for x > 0, 1024 for infinity, exponent_of_zero for 0. Not for NaN or negative x.
inline int exponent_of(double x) {
    const std::uint64_t b = bits_of(x);
    const int biased = static_cast<int>(b >> 52);
    if (biased != 0) return biased - 1023;
    return b == 0 ? exponent_of_zero : log2_floor(b) - 1074;
}

// Largest k such that the finite x is a multiple of 2^k; 1024 (more than for any other x) for 0.
inline int quantum_of(double x) {
    const Decoded d = decode(x);
    if (d.mantissa == 0) return 1024;
    return d.exponent + static_cast<int>(lowest_bit(d.mantissa));
}

}  // namespace netmesh
