// The tree that points are cut by. Node 1 is all of them; the points of node i are, in the order of the tree, first
// those of node 2 i and then those of 2 i + 1, halves of them. So where a node's points stand depends on how many there
// are alone, and which node contains which on their numbers alone.
#pragma once
#include <cstdint>

#include "numerics/bits.hpp"

namespace netmesh {

using PieceNode = std::uint32_t;
constexpr PieceNode root_piece = 1, no_piece = 0;

// How far below node 1.
inline std::uint32_t depth_of(PieceNode node) { return highest_bit(node); }
inline bool is_below(PieceNode node, PieceNode above) {
    const std::uint32_t depth = depth_of(node), limit = depth_of(above);
    return depth >= limit && node >> (depth - limit) == above;
}
// The deepest node that contains both.
inline PieceNode common_piece(PieceNode a, PieceNode b) {
    const std::uint32_t depth_a = depth_of(a), depth_b = depth_of(b);
    if (depth_a > depth_b) a >>= depth_a - depth_b;
    if (depth_b > depth_a) b >>= depth_b - depth_a;
    const std::uint32_t differ = a ^ b;
    return differ == 0 ? a : a >> (highest_bit(differ) + 1);
}

// Which node follows where each comes before those below it, down to `levels`; no_piece: none.
inline PieceNode next_piece(PieceNode node, std::uint32_t levels) {
    if (depth_of(node) < levels) return 2 * node;
    while ((node & 1u) != 0) node /= 2;
    return node == no_piece ? node : node + 1;
}

// Positions [first, last) in the order of the tree.
struct PieceRange {
    std::uint32_t first, last;
    std::uint32_t count() const { return last - first; }
};
inline PieceRange range_of(PieceNode node, std::uint32_t points) {
    PieceRange range = {0, points};
    for (std::uint32_t bit = depth_of(node); bit-- > 0;) {
        const std::uint32_t middle = range.first + range.count() / 2;
        (node >> bit & 1u) != 0 ? range.first = middle : range.last = middle;
    }
    return range;
}
// The node so deep that has this position.
inline PieceNode piece_at(std::uint32_t position, std::uint32_t depth, std::uint32_t points) {
    PieceRange range = {0, points};
    PieceNode node = root_piece;
    for (; depth > 0; --depth) {
        const std::uint32_t middle = range.first + range.count() / 2;
        const bool second = position >= middle;
        second ? range.first = middle : range.last = middle;
        node = node << 1 | static_cast<PieceNode>(second);
    }
    return node;
}

// Points are asked for by as many as a lowest node has at most.
constexpr std::uint32_t piece_points_most = 16;
// The depth of the lowest nodes, which have boxes like all others: at least that of `pieces`, a power of 2.
inline std::uint32_t piece_levels(std::uint32_t points, std::uint32_t pieces) {
    std::uint32_t levels = depth_of(pieces);
    while ((points - 1) >> levels >= piece_points_most) ++levels;
    return levels;
}

}  // namespace netmesh
