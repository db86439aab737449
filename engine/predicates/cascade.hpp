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
#include "predicates/exact_stage.hpp"
#include "predicates/float_stage.hpp"
#include "predicates/integer_stage.hpp"
#include "predicates/planar_stage.hpp"
#include "predicates/predicates.hpp"

namespace netmesh {

enum PredicateStage : int { stage_float = 1, stage_integer = 2, stage_exact = 3, stage_tie = 4 };

struct Decision {
    Sign sign;
    PredicateStage stage;
};

inline Decision decide(int sign, bool negate, PredicateStage stage) {
    return {static_cast<Sign>(negate ? -sign : sign), stage};
}

inline int sign_of(double x) { return (x > 0) - (x < 0); }

// The quantum certificate: when all coordinates are multiples of 2^quantum and the magnitude is below 2^53 quanta (of
// the determinant), every number on the way is an integer below 2^53 in its own quanta, a double, and nothing was
// rounded. Zero is certain then as well. (No row is zero, so the magnitude bounds what is on the way too; it is above
// 2^-960 if it is not 0, so that no quantum is below the least double.)
template <int D, bool lifted> bool is_exact(const FloatResult& result, int quantum) {
    constexpr int degree = lifted ? D + 2 : D;
    return result.magnitude > 0 && exponent_of(result.magnitude) < 53 + quantum * degree;
}

// The same for the least quantum that will do, without looking for the quantum itself. Adding and subtracting 1.5 *
// 2^52 quanta rounds a coordinate below 2^51 quanta to a multiple of the quantum.
template <int D, bool lifted> bool is_exact_at_once(const double* const* points, double magnitude) {
    constexpr int degree = lifted ? D + 2 : D;
    static_assert(degree >= 2, "a quantum between -563 and 486");
    if (!(magnitude > 0)) return false;
    const int quantum = (exponent_of(magnitude) - 53 + 4096 * degree) / degree - 4096 + 1;
    const double shift = 1.5 * power_of_two(52 + quantum);
    double remainders = 0, sizes = 0;
    for (int i = 0; i < Frame<D, lifted>::points; ++i)
        for (int c = 0; c < D; ++c) {
            const double x = points[i][c];
            remainders += __builtin_fabs((x + shift) - shift - x);
            sizes += __builtin_fabs(x);
        }
    return remainders == 0 && sizes < power_of_two(51 + quantum);
}

// Bits of the largest coordinate of a row in quanta. The lift wants one quantum, without it each column has its own:
// units may differ by axis.
template <int D, bool lifted> int difference_bits(const Frame<D, lifted>& frame, int row, const int (&quantum)[D]) {
    if constexpr (lifted) return frame.exponent[row] + 1 - quantum[0];
    int bits = 0;
    for (int c = 0; c < D; ++c) {
        const int k = exponent_of(__builtin_fabs(frame.row[row][c] - frame.base[c])) + 1 - quantum[c];
        bits = k > bits ? k : bits;
    }
    return bits;
}

// What the float stage with the last point as base could not decide.
template <int D, bool lifted>
[[gnu::noinline]] Decision decide_undecided(const double* const* points, const FloatResult& first) {
    using Set = Frame<D, lifted>;
    int quantum[D], least = 1024;
    for (int c = 0; c < D; ++c) {
        quantum[c] = 1024;
        for (int i = 0; i < Set::points; ++i) {
            const int k = quantum_of(points[i][c]);
            quantum[c] = k < quantum[c] ? k : quantum[c];
        }
        least = quantum[c] < least ? quantum[c] : least;
    }
    if (is_exact<D, lifted>(first, least)) return decide(sign_of(first.determinant), (D & 1) != 0, stage_float);

    const Set frame = best_frame<D, lifted>(points);
    for (int i = 0; i < Set::rows; ++i)
        if (frame.exponent[i] == exponent_of_zero) return decide(0, false, stage_float);
    if (frame.widest() <= 1023 && (first.magnitude == 0 || frame.gain > 2)) {
        const FloatResult second = float_stage_scaled<D, lifted>(frame);
        const double error = second.magnitude * FloatBounds<D, lifted>::error_factor;
        if (__builtin_fabs(second.determinant) > error)
            return decide(sign_of(second.determinant), frame.negate, stage_float);
    }

    if constexpr (lifted)
        for (int& k : quantum) k = least;
    int row_bits_max = 0, bits = ExactBounds<D, lifted>::hadamard_bits();
    for (int i = 0; i < Set::rows; ++i) {
        const int row_bits = difference_bits<D, lifted>(frame, i, quantum);
        row_bits_max = row_bits > row_bits_max ? row_bits : row_bits_max;
        bits += row_bits;
    }
    if (row_bits_max <= integer_stage_bits)
        return decide(integer_stage<D, lifted>(frame, quantum), frame.negate, stage_integer);
    if (lifted) bits += row_bits_max;
    return decide(exact_stage<D, lifted>(frame, quantum, bits), frame.negate, stage_exact);
}

template <int D, bool lifted> bool is_sure(const FloatResult& result) {
    return __builtin_fabs(result.determinant) > result.magnitude * FloatBounds<D, lifted>::error_factor;
}

// points: D+1.
template <int D> Decision decide_orient(const double* const* points) {
    if constexpr (D == 2) {
        const int sign = planar_stage<false>(points);
        if (sign != 0) return decide(sign, false, stage_float);
    }
    const FloatResult first = float_stage<D, false>(points, nullptr);
    if (is_sure<D, false>(first) || is_exact_at_once<D, false>(points, first.magnitude))
        return decide(sign_of(first.determinant), (D & 1) != 0, stage_float);
    return decide_undecided<D, false>(points, first);
}

// points: D+2, q last. *minors_exact: minors[D - i] is exactly the determinant of the rows (x - q) of all points but i
// (and q).
template <int D> Decision decide_in_ball(const double* const* points, double* minors, bool* minors_exact) {
    *minors_exact = false;
    if constexpr (D == 2) {
        const int sign = planar_stage<true>(points);
        if (sign != 0) return decide(sign, false, stage_float);
    }
    const FloatResult first = float_stage<D, true>(points, minors);
    if (is_sure<D, true>(first)) return decide(sign_of(first.determinant), (D & 1) != 0, stage_float);
    if (is_exact_at_once<D, true>(points, first.magnitude)) {
        *minors_exact = true;
        return decide(sign_of(first.determinant), (D & 1) != 0, stage_float);
    }
    return decide_undecided<D, true>(points, first);
}

}  // namespace netmesh
