// Weights of points. A point with a weight w has the power |x - p|^2 - w at x; its weight, or a radius r that stands
// for the weight r^2, is the number behind its coordinates: D + 1 numbers at the start of each record.
#pragma once
#include <cstdint>

#include "vocabulary/ids.hpp"

namespace netmesh {

// What templates take where points have no weights: nothing of weights is in them then.
struct NoWeights {
    static constexpr bool has = false;
};

// Adding one number to all weights changes no power but by that number. So the largest weight counts as 0, and each
// point has a height >= 0, what its weight is less than the largest: as if it stood that far squared beside the space
// in which the centres of balls are. All that is known of powers of points in that space holds of it.
struct Weights {
    static constexpr bool has = true;
    double top = 0;  // the largest number
    bool are_radii = false;
    // By vertex: the index by which ties are broken; null: its own. With periods copies of a point share one.
    const std::uint32_t* index = nullptr;

    VertexId index_of(VertexId v) const { return index == nullptr ? v : VertexId(index[v]); }
    // Of numbers a and b, at most three roundings off: the weight of a less that of b.
    double difference(double a, double b) const { return are_radii ? (a - b) * (a + b) : a - b; }
    double height(double number) const { return difference(top, number); }
};

}  // namespace netmesh
