// The determinant that both predicates are, as points and a base.
//
// With D+1 points, orient has the rows (x, 1); with D+2 points, in_ball has the rows (x, |x|^2, 1). Subtracting one
// point, the base, from all others leaves a square matrix of differences: D rows, or D+1 rows whose last column, the
// lift, is the sum of squares of the others. If the base is the last point then for either predicate
//     answer = (-1)^D * sign of the determinant,
// (orient: D transpositions bring the last point to the front. in_ball: on a line, D = 1, with p0 < q < p1 the
// determinant (p0-q)(p1-q)(p1-p0) is negative, and each dimension more changes the sign.) Another base is brought to
// the end by transpositions first.
#pragma once
#include "numerics/bits.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

constexpr int frame_rows(int dim, bool lifted) { return lifted ? dim + 1 : dim; }
constexpr int frame_rows_max = dimension_most() + 1;

// Sizes come beside a frame, dim as an int or a Dimension<D>, lifted as a bool or as a type that is one: constants make
// loops this short faster, variables serve all dimensions with one piece of code.
struct Frame {
    const double* row[frame_rows_max];
    const double* base;
    int exponent[frame_rows_max];  // exponent_of the largest coordinate of the difference, below 2^(exponent+1)
    bool negate;                   // the answer is the negated sign of the determinant
    int gain;                      // how many bits shorter the product of distances is than about the last point

    int widest(int rows) const {
        int e = exponent[0];
        for (int i = 1; i < rows; ++i) e = exponent[i] > e ? exponent[i] : e;
        return e;
    }
};

// Exponent of the largest coordinate of a - b. Rounding does not carry a difference past a power of two, it may
// bring it up to one.
template <class Dim> int difference_exponent(Dim dim, const double* a, const double* b) {
    double largest = 0;
    for (int c = 0; c < dim; ++c) {
        const double d = __builtin_fabs(a[c] - b[c]);
        largest = d > largest ? d : largest;
    }
    return exponent_of(largest);
}

// The frame whose base has the least product of (largest coordinate) distances to the other points.
template <class Dim, class Lifted> Frame best_frame(Dim dim, Lifted lifted, const double* const* points) {
    const int n = frame_rows(dim, lifted) + 1;
    int exponent[frame_rows_max + 1][frame_rows_max + 1], sum[frame_rows_max + 1] = {};
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < i; ++j) {
            const int e = difference_exponent(dim, points[i], points[j]);
            exponent[i][j] = exponent[j][i] = e;
            sum[i] += e;
            sum[j] += e;
        }
    int best = n - 1;
    for (int i = n - 2; i >= 0; --i) best = sum[i] < sum[best] ? i : best;
    Frame frame;
    frame.base = points[best];
    frame.gain = sum[n - 1] - sum[best];
    frame.negate = ((dim + n - 1 - best) & 1) != 0;
    for (int r = 0; r < n - 1; ++r) {
        const int i = r + (r >= best);
        frame.row[r] = points[i];
        frame.exponent[r] = exponent[best][i];
    }
    return frame;
}

}  // namespace netmesh
