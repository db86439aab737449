// One sign from the first stage that is sure of it, in this order:
//
//   1. float about the last point, in the plane with a bound of its own before
//   2. the same number, when the quantum certificate shows that nothing was rounded: 0 is certain then as well
//   3. float about the point that is nearest to the others (frame.hpp), its rows scaled
//   4. integers of limited width, when differences of coordinates fit them
//   5. integers as wide as it takes
//
// An exact 0 is left to the caller: predicates.cpp breaks ties by index.
#pragma once
#include "predicates/float_stage.hpp"
#include "predicates/planar_stage.hpp"
#include "predicates/undecided.hpp"

namespace netmesh {

// The quantum certificate (undecided.cpp) for the least quantum that will do, without looking for the quantum itself.
// Adding and subtracting 1.5 * 2^52 quanta rounds a coordinate below 2^51 quanta to a multiple of the quantum.
template <int D, bool lifted> bool is_exact_at_once(const double* const* points, double magnitude) {
    constexpr int degree = lifted ? D + 2 : D;
    static_assert(degree >= 2, "a quantum between -563 and 486");
    if (!(magnitude > 0)) return false;
    const int quantum = (exponent_of(magnitude) - 53 + 4096 * degree) / degree - 4096 + 1;
    const double shift = 1.5 * power_of_two(52 + quantum);
    double remainders = 0, sizes = 0;
    for (int i = 0; i <= frame_rows(D, lifted); ++i)
        for (int c = 0; c < D; ++c) {
            const double x = points[i][c];
            remainders += __builtin_fabs((x + shift) - shift - x);
            sizes += __builtin_fabs(x);
        }
    return remainders == 0 && sizes < power_of_two(51 + quantum);
}

template <int D, bool lifted> bool is_sure(const FloatResult& result) {
    constexpr double factor = error_factor(D, lifted);
    return __builtin_fabs(result.determinant) > result.magnitude * factor;
}

#ifdef __OPTIMIZE_SIZE__
constexpr bool takes_few_stages = true;  // 3, and in the plane 1, before 5: see undecided.cpp
#else
constexpr bool takes_few_stages = false;
#endif

// points: D+1.
template <int D> Decision decide_orient(const double* const* points) {
    FloatResult first = {0, 0};
    if constexpr (D == 2) {
        const int sign = planar_stage<false>(points);
        if (sign != 0) return decide(sign, false, stage_float);
    }
    if constexpr (D != 2 || !takes_few_stages) {
        first = float_stage<D, false>(points, nullptr);
        if (is_sure<D, false>(first) || (!takes_few_stages && is_exact_at_once<D, false>(points, first.magnitude)))
            return decide(sign_of(first.determinant), (D & 1) != 0, stage_float);
    }
    return decide_undecided(D, false, points, first);
}

// points: D+2, q last. *minors_exact: minors[D - i] is exactly the determinant of the rows (x - q) of all points but i
// (and q).
template <int D> Decision decide_in_ball(const double* const* points, double* minors, bool* minors_exact) {
    FloatResult first = {0, 0};
    *minors_exact = false;
    if constexpr (D == 2) {
        const int sign = planar_stage<true>(points);
        if (sign != 0) return decide(sign, false, stage_float);
    }
    if constexpr (D != 2 || !takes_few_stages) {
        first = float_stage<D, true>(points, minors);
        if (is_sure<D, true>(first)) return decide(sign_of(first.determinant), (D & 1) != 0, stage_float);
        if (!takes_few_stages && is_exact_at_once<D, true>(points, first.magnitude)) {
            *minors_exact = true;
            return decide(sign_of(first.determinant), (D & 1) != 0, stage_float);
        }
    }
    return decide_undecided(D, true, points, first);
}

}  // namespace netmesh
