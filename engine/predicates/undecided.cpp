#include "predicates/undecided.hpp"

#include "predicates/exact_stage.hpp"

#ifndef __OPTIMIZE_SIZE__
#include "predicates/integer_stage.hpp"
#endif

namespace netmesh {

#ifdef __OPTIMIZE_SIZE__

// Where size counts residues answer at once, about the last point: the other stages would save time and nothing else.
// Few digits take few primes.
Decision decide_undecided(int dim, bool lifted, const double* const* points, const FloatResult&) {
    const int rows = frame_rows(dim, lifted);
    int least = 1024;
    for (int i = 0; i <= rows; ++i)
        for (int c = 0; c < dim; ++c) {
            const int k = quantum_of(points[i][c]);
            least = k < least ? k : least;
        }
    Frame frame;
    frame.base = points[rows];
    int quantum[dimension_most()], row_bits_max = 0, bits = hadamard_bits(dim, lifted);
    for (int c = 0; c < dim; ++c) quantum[c] = least;
    for (int i = 0; i < rows; ++i) {
        frame.row[i] = points[i];
        const int exponent = difference_exponent(dim, points[i], frame.base);
        if (exponent == exponent_of_zero) return decide(0, false, stage_exact);
        const int row_bits = exponent + 1 - least;
        row_bits_max = row_bits > row_bits_max ? row_bits : row_bits_max;
        bits += row_bits;
    }
    bits += lifted ? row_bits_max : 0;
    return decide(exact_stage(frame, dim, lifted, quantum, bits), (dim & 1) != 0, stage_exact);
}

#else

namespace {

// The quantum certificate: when all coordinates are multiples of 2^quantum and the magnitude is below 2^53 quanta (of
// the determinant), every number on the way is an integer below 2^53 in its own quanta, a double, and nothing was
// rounded. Zero is certain then as well. (No row is zero, so the magnitude bounds what is on the way too; it is above
// 2^-960 if it is not 0, so that no quantum is below the least double.)
bool is_exact(int dim, bool lifted, const FloatResult& result, int quantum) {
    const int degree = lifted ? dim + 2 : dim;
    return result.magnitude > 0 && exponent_of(result.magnitude) < 53 + quantum * degree;
}

// Bits of the largest coordinate of a row in quanta. The lift wants one quantum, without it each column has its own:
// units may differ by axis.
template <class Dim> int difference_bits(const Frame& frame, Dim dim, bool lifted, int row, const int* quantum) {
    if (lifted) return frame.exponent[row] + 1 - quantum[0];
    int bits = 0;
    for (int c = 0; c < dim; ++c) {
        const int k = exponent_of(__builtin_fabs(frame.row[row][c] - frame.base[c])) + 1 - quantum[c];
        bits = k > bits ? k : bits;
    }
    return bits;
}

template <class Dim, class Lifted>
Decision decide_in_stages(Dim dim, Lifted lifted, const double* const* points, const FloatResult& first) {
    const int rows = frame_rows(dim, lifted);
    int quantum[dimension_most()], least = 1024;
    for (int c = 0; c < dim; ++c) {
        quantum[c] = 1024;
        for (int i = 0; i <= rows; ++i) {
            const int k = quantum_of(points[i][c]);
            quantum[c] = k < quantum[c] ? k : quantum[c];
        }
        least = quantum[c] < least ? quantum[c] : least;
    }
    if (is_exact(dim, lifted, first, least)) return decide(sign_of(first.determinant), (dim & 1) != 0, stage_float);

    const Frame frame = best_frame(dim, lifted, points);
    for (int i = 0; i < rows; ++i)
        if (frame.exponent[i] == exponent_of_zero) return decide(0, false, stage_float);
    if (frame.widest(rows) <= 1023 && (first.magnitude == 0 || frame.gain > 2)) {
        const FloatResult second = float_stage_scaled(frame, dim, lifted);
        const double error = second.magnitude * error_factor(dim, lifted);
        if (__builtin_fabs(second.determinant) > error)
            return decide(sign_of(second.determinant), frame.negate, stage_float);
    }

    if (lifted)
        for (int c = 0; c < dim; ++c) quantum[c] = least;
    int row_bits_max = 0, bits = hadamard_bits(dim, lifted);
    for (int i = 0; i < rows; ++i) {
        const int row_bits = difference_bits(frame, dim, lifted, i, quantum);
        row_bits_max = row_bits > row_bits_max ? row_bits : row_bits_max;
        bits += row_bits;
    }
    if (row_bits_max <= integer_stage_bits)
        return decide(integer_stage(frame, dim, lifted, quantum), frame.negate, stage_integer);
    if (lifted) bits += row_bits_max;
    return decide(exact_stage(frame, dim, lifted, quantum, bits), frame.negate, stage_exact);
}

}  // namespace

Decision decide_undecided(int dim, bool lifted, const double* const* points, const FloatResult& first) {
    // Surfaces and grids in space put most of their questions here: sizes known when compiling save a third of the
    // time.
    constexpr std::integral_constant<bool, true> in_ball{};
    if constexpr (serves_dimension(3))
        if (dim == 3 && lifted) return decide_in_stages(Dimension<3>{}, in_ball, points, first);
    if constexpr (serves_dimension(2))
        if (dim == 2 && lifted) return decide_in_stages(Dimension<2>{}, in_ball, points, first);
    return decide_in_stages(dim, lifted, points, first);
}

#endif

}  // namespace netmesh
