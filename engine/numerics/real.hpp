// Constants and operations on doubles, none of which calls a library.
#pragma once
#include "numerics/bits.hpp"

namespace netmesh {

inline bool is_finite(double x) { return (bits_of(x) & 0x7FF0000000000000u) != 0x7FF0000000000000u; }
inline double absolute(double x) { return x < 0 ? -x : x; }
inline double square_root(double x) { return __builtin_sqrt(x); }

constexpr double infinity = __builtin_huge_val();
constexpr double unit_roundoff = 0x1p-53;

}  // namespace netmesh
