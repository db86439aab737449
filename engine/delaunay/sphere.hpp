// Circumscribed balls in floating point, each with a proven bound on the error of its centre.
//
// Why a bound on the centre is enough. For a ball (c, r^2) whose true centre is c*, with |c - c*| <= error * r, the
// function f(q) = (|q-c|^2 - r^2) - (|q-c*|^2 - r*^2) is affine, has gradient 2(c* - c), and vanishes at the vertex from
// which r^2 was measured. So |f(q)| <= 2 |q - v| error r <= error (|q-c|^2 + 3 r^2): power() decides the sign of the true
// power of q whenever it is larger than that plus the rounding of its own evaluation.
#pragma once
#include <cstdint>

#include "delaunay/store.hpp"

namespace netmesh {

// Computed power |q - centre|^2 - radius2 of q, and in *bound what its error cannot exceed (NaN or infinite when nothing
// is known). A caller compares with > and < so that NaN decides nothing.
template <int D> inline double power(const Cell<D>& cell, const double* q, double* bound) {
    double d2 = 0;
    for (int i = 0; i < D; ++i) {
        const double d = q[i] - cell.centre[i];
        d2 += d * d;
    }
    *bound = (static_cast<double>(cell.error) + (D + 8) * unit_roundoff) * (d2 + 3 * cell.radius2) + 0x1p-960;
    return d2 - cell.radius2;
}

// The ball through D+1 points by solving for its centre; error is +infinity when no bound could be proven.
template <int D> void solve_sphere(const double* const* p, Cell<D>& cell);

// The ball through q and the facet shared by `inside` (conflicts with q) and `outside` (does not): it belongs to the
// pencil spanned by the two balls, so its centre is a convex combination of theirs. Returns false when the bound so
// obtained is above error_max; then nothing is written. No square system is solved: O(D).
template <int D>
bool pencil_sphere(const Cell<D>& inside, const Cell<D>& outside, const double* q, double error_max, Cell<D>& cell);

}  // namespace netmesh
