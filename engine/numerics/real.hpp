// Constants and operations on doubles, none of which calls a library.
#pragma once
#include "numerics/bits.hpp"
#include "numerics/square_root.hpp"

// What the compiler says about its arithmetic; netmesh_init looks at what the processor does.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__) ||                               \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "netmesh: exact predicates need arithmetic without -ffast-math"
#endif
#if __SIZEOF_DOUBLE__ != 8 || defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ < 0 || __FLT_EVAL_METHOD__ == 2)
#error "netmesh: doubles must have 64 bits and be computed as such (on i386: -msse2 -mfpmath=sse)"
#endif

namespace netmesh {

inline bool is_finite(double x) { return (bits_of(x) & 0x7FF0000000000000u) != 0x7FF0000000000000u; }
inline double absolute(double x) { return x < 0 ? -x : x; }

// The next larger double, x finite.
inline double next_up(double x) { return double_of_bits(bits_of(x + 0.0) + (x < 0 ? ~std::uint64_t{0} : 1)); }

constexpr double infinity = __builtin_huge_val();
constexpr double unit_roundoff = 0x1p-53;

}  // namespace netmesh
