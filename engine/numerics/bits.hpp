// Doubles as bit patterns.
#pragma once
#include <cstdint>

namespace netmesh {

inline std::uint64_t bits_of(double x) {
    std::uint64_t b;
    __builtin_memcpy(&b, &x, sizeof b);
    return b;
}

inline double double_of(std::uint64_t b) {
    double x;
    __builtin_memcpy(&x, &b, sizeof x);
    return x;
}

inline bool is_finite(double x) { return (bits_of(x) & 0x7FF0000000000000u) != 0x7FF0000000000000u; }

// floor(log2 |x|) for normal x; -1023 for zero and denormals.
inline int exponent_of(double x) { return static_cast<int>((bits_of(x) >> 52) & 0x7FFu) - 1023; }

inline double absolute(double x) { return x < 0 ? -x : x; }
inline double square_root(double x) { return __builtin_sqrt(x); }

constexpr double infinity = __builtin_huge_val();
constexpr double unit_roundoff = 0x1p-53;

}  // namespace netmesh
