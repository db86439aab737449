// The order of the tree, and boxes about the points of its nodes.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/work.hpp"
#include "numerics/input_rows.hpp"
#include "pieces/node.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

struct SplitPoints {
    std::uint32_t* order;  // [count] rows, those of equal points but the first left out
    double* boxes;         // [2^(levels + 1) - 1][2][dim], of nodes 1, 2, ..: least coordinates, then greatest
    std::uint32_t count;
    std::uint32_t levels;
    std::uint64_t fingerprint;
    std::uint64_t culprit;  // of not_finite
};

// order and boxes are left at the arena's low end, everything else is given back; without ok all. Nodes are halved at
// the median of the longest side of their box; where coordinates are equal the others decide, then rows. It depends on
// the points alone. Memory: about 8 D + 32 bytes a point. O(n log n). not_finite, out_of_memory, cancelled;
// invalid_argument: there are fewer different points than pieces.
Status split_points(const InputRows& points, std::uint32_t n, int dim, std::uint32_t pieces, const Work& work,
                    SplitPoints* out);
// Leaves what it took.
template <int D>
Status split_points(const InputRows& points, std::uint32_t n, std::uint32_t pieces, const Work& work, SplitPoints* out);

}  // namespace netmesh
