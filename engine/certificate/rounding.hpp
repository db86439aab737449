// How far certificates are rounded outwards. Every bound of this folder and of engine/filtration uses these numbers and
// no others.
//
// Let u = 2^-53; an operation on doubles multiplies its exact result by 1 + e, |e| <= u. Meshes admit coordinates up to
// 2^500 and distances from 2^-500 on, so that squares neither overflow nor lose digits by underflow.
//
// `up` and `down`, for results whose terms do not cancel:
//   - The distance of two points in D <= 6 dimensions: a squared difference is off by 3 u, the sum of D of them by
//     (D + 2) u <= 8 u, its root by half of that and one rounding more, 5 u.
//   - The radius of a circumscribed ball with the bound on its centre's error: 5 u, a product and a sum, 7 u.
//   - d - R where it is more than d / 2, so R < d / 2: R is an upper bound already, 5 u of d are 10 u of the
//     difference, with its own rounding 11 u.
//   - The root mean square of k distances has its own bound, see function_filter.cpp.
//   - Quotients of bounds and their roots: 2 u.
// One rounding more for the multiplication by `up` or `down` itself: 12 u is the most that they have to cover. They are
// 2^13 u away from 1, so that longer formulas need no new constant; a ratio of 2 is reported 2e-12 too large for that.
//
// `sum_slack`, for sums of products that may cancel, times the sum of the terms' magnitudes (tighten_cell_bounds.cpp):
//   - w.q - h for a half-space: D + 1 roundings in w.q, D + 3 in h, the largest of such sums over its length; w itself
//     has the length 1 within (D + 6) u. Together at most (3 D + 10) u <= 28 u.
//   - |y|^2 - 2 y.m + s, m and s weighted means after up to 8 steps of three roundings each: D + 2 in |y|^2, D + 26 in
//     2 y.m, D + 26 in s, which has D + 2 of its own, and two sums: at most (3 D + 58) u <= 76 u.
// 2^-44 is 512 u.
#pragma once

namespace netmesh {

constexpr double up = 1 + 0x1p-40, down = 1 - 0x1p-40;
constexpr double sum_slack = 0x1p-44;

}  // namespace netmesh
