// Delaunay triangulation of a point set: the job from points to compact cells.
#pragma once
#include <cstddef>
#include <cstdint>

#include "delaunay/kernel.hpp"
#include "numerics/input_rows.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {

// What a job says about its input; `row` counts in the caller's array.
struct InputReport {
    std::uint64_t rows;
    std::uint64_t duplicates;
    std::uint64_t fingerprint;   // of the values in order
    std::uint64_t row_a, row_b;  // culprits of not_finite, out_of_range, too_close
};

// Copies points[n][store.dim] into fresh vertices (store.open_vertices), with -0.0 made 0, origin = row, cell = none
// and marker input; finds and removes exact duplicates and leaves the insertion order of what remains in
// order[0..vertex_count), which is taken at the low end. out_of_memory, not_finite (row_a), invalid_argument when n is
// 0 or above 2^28.
Status take_input(AnyStore& store, const InputRows& points, std::size_t n, std::uint64_t seed, Monitor& monitor,
                  InputReport* input, std::uint32_t** order);
template <int D>
Status take_input(Store<D>& store, const InputRows& points, std::size_t n, std::uint64_t seed, Monitor& monitor,
                  InputReport* input, std::uint32_t** order) {
    AnyStore any(store);
    const Status status = take_input(any, points, n, seed, monitor, input, order);
    store.locate_arrays();
    return status;
}

// The numbers of points with weights (predicates/weights.hpp), one for each row.
struct WeightRows {
    InputRows rows;
    bool are_radii;
    const std::uint32_t* index =
        nullptr;  // by row: that of predicates/weights.hpp; null: the row. No equal points then
};

// What a job says about points that are hidden: not equal to another one, and in no cell.
struct HiddenPoints {
    std::uint32_t count;
    std::uint32_t* rows;  // [count], ascending, at the high end, below the vertices
    bool has_negative;    // invalid_argument: the radius of row_a
    bool has_weight;      // not_finite: it is the number of row_a, not a coordinate
};

// What a triangulation may cost before it is given up. Work is cells made; a conflict that the cached ball does not
// decide counts for several of them, and so does a tie.
struct Allowance {
    double work_each;            // for each point inserted
    double by_hard, by_tie;      // what a conflict counts for
    std::uint64_t cells_max;     // at one time
    bool is_spent;               // set by triangulate, as all below: it was given up
    bool is_dear;                // for its work, not for its cells at one time
    std::uint64_t points_tried;  // inserted until then, or all
    std::uint64_t cells_made;
};

// Triangulates points[n][D]. ok, flat (fewer than D+1 affinely independent points), out_of_memory, cancelled, and what
// take_input says. Unless there is no first cell yet, the store is left compact and a Delaunay triangulation of what
// was inserted; vertices not inserted have cell `none`. In the plane cells have no balls before recompute_balls
// (sphere.hpp) makes them. With an allowance that is spent: cancelled, and the store is of no use.
template <int D>
Status triangulate(Store<D>& store, const InputRows& points, std::size_t n, std::uint64_t seed, Monitor& monitor,
                   InputReport* input, Allowance* allowance = nullptr);

// The same with weights: the regular triangulation. Of equal points the one with the largest weight stays, the first of
// these. What is hidden is no vertex of the store; the others are in the order of their rows, and each has the number
// of its weight as its nearest2, behind its coordinates. Points not inserted are no hidden ones. Nothing depends on the
// order of insertion. invalid_argument: a radius is negative.
template <int D>
Status triangulate_weighted(Store<D>& store, const InputRows& points, std::size_t n, const WeightRows& weights,
                            std::uint64_t seed, Monitor& monitor, InputReport* input, HiddenPoints* hidden);

}  // namespace netmesh
