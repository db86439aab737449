// Points with periods: one of each, in one place, and as many copies as a triangulation needs.
#pragma once
#include <cstddef>
#include <cstdint>

#include "delaunay/triangulate.hpp"
#include "memory/work.hpp"
#include "periods/lattice.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

struct PeriodicInput {
    InputRows points;
    std::size_t count;
    const WeightRows* weights;  // null: none
    const double* vectors;      // [vectors][D]
    int vector_count;
};

// What is said of them.
struct PeriodicReport {
    InputReport input;
    int culprit;           // invalid_argument, lattice: which vector
    bool has_bad_lattice;  // not finite, or dependent on those before
    bool has_negative;     // invalid_argument: the radius of row_a
    bool has_weight;       // not_finite: it is the number of row_a, not a coordinate
    double moved;          // the farthest that a coordinate was moved
    std::uint64_t copies;  // beside the points, that were triangulated
};

// Different points, no two of them copies of one another, near the origin. Rows have D coordinates and a weight, or 0.
// All coordinates, and those of all copies that anyone needs, are doubles: multiples of a power of two.
struct PeriodicPoints {
    Lattice lattice;  // reduced
    std::uint32_t count;
    double* x;                                       // [count][D + 1], along a curve in space
    std::uint32_t* row;                              // [count], of the input
    double far[Lattice::most];                       // Lattice::find_far
    double low[Lattice::most], high[Lattice::most];  // places of all points in each direction, e[j] . x
};

// Reads, moves and sorts the points. They are left at the arena's low end. invalid_argument, not_finite, out_of_range
// (row_a: a point is some hundred periods away), out_of_memory.
template <int D>
Status take_periodic_points(const PeriodicInput& input, const Work& work, PeriodicPoints* out, PeriodicReport* report);

// The points, and behind them all copies within a margin, by direction, of the box that holds the points.
struct Copies {
    std::uint32_t count;   // with the points themselves
    double* x;             // [count][D + 1]
    std::uint32_t* index;  // [count], row of the input: ties are broken by it
    std::uint32_t* own;    // [count - points], of which point
    std::int64_t* shift;   // [count - points], by which translation: whole multiples of b[j], times 2^(10 j)

    std::uint32_t point_of(std::uint32_t v, std::uint32_t points) const { return v < points ? v : own[v - points]; }
    std::int64_t shift_of(std::uint32_t v, std::uint32_t points) const { return v < points ? 0 : shift[v - points]; }
};
// At the arena's low end. out_of_memory.
template <int D> Status make_copies(const PeriodicPoints& points, const double* margin, const Work& work, Copies* out);

// Translations in terms of what was given.
struct GivenTranslations {
    Lattice lattice;                                // as it was reduced, before anything was moved
    double of_given[Lattice::most][Lattice::most];  // Lattice::open
};
// Requires vectors that take_periodic_points has taken.
void find_given(const PeriodicInput& input, int dimension, GivenTranslations* out);
// Copy v, of point i by `shift` (Copies; 0: the point itself): at what the input's row has, plus the sum of times[j]
// given vectors j. False: that are 2^30 or more.
template <int D>
bool translations_of(const PeriodicInput& input, const GivenTranslations& given, const PeriodicPoints& points,
                     std::uint32_t i, std::int64_t shift, std::int32_t* times);

}  // namespace netmesh
