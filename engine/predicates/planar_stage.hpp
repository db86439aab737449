// The plane's first stage: its permanents are cheap enough to bound the errors of the determinants themselves.
//
// With u = 2^-53 a product of differences carries 3 roundings, a term of the lifted determinant at most 10 (J.
// Shewchuk, Adaptive precision floating-point arithmetic and fast robust geometric predicates, 1997), and 4 u and 11 u
// cover the bound's own. With lifts up to 2^240 what underflows adds less than 2^-800. Overflow makes the bound
// infinite or NaN, which decides nothing.
#pragma once
#include "numerics/real.hpp"

namespace netmesh {

// The sign, or 0 when this stage is not sure. points[2], points[3]: the base.
template <bool lifted> inline int planar_stage(const double* const* p);

template <> inline int planar_stage<false>(const double* const* p) {
    const double left = (p[0][0] - p[2][0]) * (p[1][1] - p[2][1]), right = (p[0][1] - p[2][1]) * (p[1][0] - p[2][0]);
    const double value = left - right;
    const double error = 4 * unit_roundoff * (__builtin_fabs(left) + __builtin_fabs(right)) + 0x1p-960;
    return (value > error) - (value < -error);
}

template <> inline int planar_stage<true>(const double* const* p) {
    const double ax = p[0][0] - p[3][0], ay = p[0][1] - p[3][1], a = ax * ax + ay * ay;
    const double bx = p[1][0] - p[3][0], by = p[1][1] - p[3][1], b = bx * bx + by * by;
    const double cx = p[2][0] - p[3][0], cy = p[2][1] - p[3][1], c = cx * cx + cy * cy;
    if (!(a < 0x1p240 && b < 0x1p240 && c < 0x1p240)) return 0;
    const double bc = bx * cy, cb = cx * by, ca = cx * ay, ac = ax * cy, ab = ax * by, ba = bx * ay;
    const double value = a * (bc - cb) + b * (ca - ac) + c * (ab - ba);
    const double permanent = a * (__builtin_fabs(bc) + __builtin_fabs(cb)) +
                             b * (__builtin_fabs(ca) + __builtin_fabs(ac)) +
                             c * (__builtin_fabs(ab) + __builtin_fabs(ba));
    const double error = 11 * unit_roundoff * permanent + 0x1p-790;
    return (value > error) - (value < -error);
}

}  // namespace netmesh
