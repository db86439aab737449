// A lower star in space as its link tells it: L and U are the lower and the upper part of the link of v, a sphere.
//
// A column is a cycle of edges. In the star of its last vertex v it has edges to an even number of vertices of L. Where
// each piece of L has an even number of these, ways in L join them two by two and take the place of the edges: with v
// they span triangles of the star. Otherwise the column is no boundary before v, and the pieces with an odd number of
// its ends are its rows.
//
// Let v join the superlevel sets by one vertex for each piece of U. A piece whose component comes to v's for the first
// time ends that component or v's, a class of degree 2. Where it was v's already, a closed way leads from v through the
// piece and above v back by an earlier one, and the edges of L around the piece are a cycle with which it is linked:
// that one begins a column. The cycles of all such pieces are independent of those that bound below v, which are sums
// over all pieces of one component, and there are as many as v ends classes of degree 1.
#pragma once
#include <cstdint>

#include "homology/lower_star/triangulated_ball.hpp"
#include "memory/prefetch.hpp"
#include "numerics/bits.hpp"

namespace netmesh {

// Parts are sets of labels, bits 1 to 63; lower and upper vertices have labels each for themselves. Upper label 0 is
// `outside`.
class SpaceStar {
public:
    // Whether there are labels enough. T triangles of a sphere have T/2 + 2 vertices, those of a disc at most T + 2.
    static bool is_small(const TriangulatedBall<3>& ball, VertexId v) {
        const bool hull = (ball.flags[v] & TriangulatedBall<3>::on_hull) != 0;
        return ball.begin[v + 1] - ball.begin[v] <= (hull ? 61u : 122u);
    }

    // Reads L of a vertex whose star is small. False when the numbers of vertices and cells are not those of a ball.
    // Until close() there are labels in ball.slot. needed: the end of the incidences that are read now or soon.
    bool open(const TriangulatedBall<3>& ball, VertexId v, std::uint32_t needed);
    void close(const TriangulatedBall<3>& ball, VertexId v) const {
        ball.slot[v] = 0;
        for (std::uint32_t i = 0; i < seen_count_; ++i) ball.slot[seen_[i]] = 0;
    }

    std::uint32_t lower_count() const { return lower_count_; }
    std::uint64_t lower_set() const { return (std::uint64_t{2} << lower_count_) - 2; }
    std::uint32_t lower_vertex(std::uint32_t label) const { return lower_vertex_[label]; }
    // Of a lower neighbour; 0: of none.
    std::uint32_t lower_label(const TriangulatedBall<3>& ball, std::uint32_t u) const {
        return ball.slot[u] < upper ? ball.slot[u] : 0;
    }
    std::uint32_t lower_edges() const { return lower_edges_; }
    std::uint32_t lower_triangles() const { return lower_triangles_; }
    // Pieces of L, and as labels. By duality the Euler characteristic of L tells the number of those of U.
    std::uint32_t lower_pieces() const { return piece_count_; }
    std::uint64_t lower_piece(std::uint32_t i) const { return piece_[i]; }
    std::uint32_t upper_pieces() const { return piece_count_ + 1 + lower_edges_ - lower_count_ - lower_triangles_; }
    // An upper neighbour, none if there is none; `outside` at the hull.
    std::uint32_t upper_neighbour() const { return upper_neighbour_; }

    // The lower pieces that have an odd number of these ends, as bits.
    std::uint64_t odd_pieces(std::uint64_t ends) const;
    // add(a, b) for each edge of L, by vertices, of ways that join these ends, an even number in each piece.
    template <class Add> void join(std::uint64_t ends, Add add) const;

    // Reads U, too.
    void open_upper(const TriangulatedBall<3>& ball, VertexId v);
    std::uint64_t upper_set() const { return upper_set_; }
    std::uint32_t upper_vertex(std::uint32_t label) const { return upper_vertex_[label]; }
    std::uint64_t upper_piece_of(std::uint32_t label) const {
        return piece_of(std::uint64_t{1} << label, upper_set_, upper_adjacent_);
    }
    // add(a, b) for each edge of L, by vertices, of the cycle around a piece of U without `outside`.
    template <class Add>
    void surround(const TriangulatedBall<3>& ball, VertexId v, std::uint64_t upper_piece, Add add) const;

private:
    static constexpr std::uint32_t upper = 64;  // and more: no lower vertex. Then less 64 it is its upper label, or 0
    std::uint32_t label(const TriangulatedBall<3>& ball, std::uint32_t u, std::uint32_t r);
    std::uint32_t read_hull(const TriangulatedBall<3>& ball, VertexId v, std::uint32_t* ends) const;
    static std::uint64_t piece_of(std::uint64_t seed, std::uint64_t part, const std::uint64_t* adjacent) {
        std::uint64_t piece = seed;
        for (std::uint64_t front = seed; front != 0;) {
            const std::uint64_t next = adjacent[lowest_bit(front)] & part & ~piece;
            front = (front & (front - 1)) | next;
            piece |= next;
        }
        return piece;
    }

    bool is_ball_;
    std::uint32_t seen_count_, lower_count_, lower_edges_, lower_triangles_, piece_count_, upper_neighbour_;
    std::uint32_t seen_[64], lower_vertex_[64], upper_vertex_[64];
    std::uint64_t lower_adjacent_[64], upper_adjacent_[64], piece_[64], upper_set_;
};

// First sight of a neighbour.
inline std::uint32_t SpaceStar::label(const TriangulatedBall<3>& ball, std::uint32_t u, std::uint32_t r) {
    if (seen_count_ == 63) {
        is_ball_ = false;
        return upper;
    }
    const std::uint32_t is_lower = ball.rank[u] < r ? 1 : 0, n = lower_count_ + 1;
    seen_[seen_count_++] = u;
    lower_vertex_[n] = u;
    lower_adjacent_[n] = 0;
    lower_count_ += is_lower;
    upper_neighbour_ = is_lower != 0 ? upper_neighbour_ : u;
    return ball.slot[u] = is_lower != 0 ? n : upper;
}

inline bool SpaceStar::open(const TriangulatedBall<3>& ball, VertexId v, std::uint32_t needed) {
    const std::uint32_t r = ball.rank[v];
    is_ball_ = true;
    seen_count_ = lower_count_ = piece_count_ = 0;
    upper_neighbour_ = none;
    lower_adjacent_[0] = 0;
    ball.slot[v] = upper;
    const std::uint32_t last = needed - 1;
    std::uint32_t with_upper[5] = {};  // cells with so many vertices that are not lower
    for (std::uint32_t t = ball.begin[v]; t < ball.begin[v + 1]; ++t) {
        ball.prefetch(t + 40 < last ? t + 40 : last);
        const VertexId* const q = ball.complex.vertices(ball.incidence[t + 12 < last ? t + 12 : last].cell());
        for (std::uint32_t j = 0; j < 4; ++j) prefetch(ball.slot + q[j]), prefetch(ball.rank + q[j]);
        const VertexId* const p = ball.complex.vertices(ball.incidence[t].cell());
        std::uint32_t slot[4], uppers = 0;
        std::uint64_t labels = 0;  // bit 0 is of no meaning
        for (std::uint32_t j = 0; j < 4; ++j) {
            slot[j] = ball.slot[p[j]];
            if (slot[j] == 0) slot[j] = label(ball, p[j], r);
            labels |= std::uint64_t{1} << (slot[j] & 63);
            uppers += slot[j] >> 6;
        }
        for (std::uint32_t j = 0; j < 4; ++j) lower_adjacent_[slot[j] & 63] |= labels;
        ++with_upper[uppers];
    }
    std::uint32_t ends = 3 * with_upper[1] + with_upper[2];  // of edges in triangles, twice for each
    // By Euler's formula a sphere of T triangles has T/2 + 2 vertices, a disc with h edges around it (T + h)/2 + 1.
    std::uint32_t twice = ball.begin[v + 1] - ball.begin[v] + 4;
    if ((ball.flags[v] & TriangulatedBall<3>::on_hull) != 0) {
        upper_neighbour_ = ball.outside;
        twice += read_hull(ball, v, &ends) - 2;
    }
    if (!is_ball_ || 2 * seen_count_ != twice) return false;
    lower_edges_ = ends / 2;
    lower_triangles_ = with_upper[1];
    for (std::uint64_t left = lower_set(); left != 0; left &= ~piece_[piece_count_++])
        piece_[piece_count_] = piece_of(left & (~left + 1), left, lower_adjacent_);
    return true;
}

// The number of edges of the link at the hull. One in L is in a triangle with `outside`, too.
inline std::uint32_t SpaceStar::read_hull(const TriangulatedBall<3>& ball, VertexId v, std::uint32_t* ends) const {
    std::uint32_t edges = 0;
    for (std::uint32_t t = ball.begin[v]; t < ball.begin[v + 1]; ++t) {
        const CellId c = ball.incidence[t].cell();
        const VertexId* const p = ball.complex.vertices(c);
        std::uint32_t is_lower[4], lower = 0;
        for (std::uint32_t j = 0; j < 4; ++j) lower += is_lower[j] = ball.slot[p[j]] < upper ? 1 : 0;
        for (std::uint32_t j = 0; j < 4; ++j) {
            if (p[j] == v || ball.complex.facet_beyond(c, j) != none) continue;
            ++edges;
            *ends += lower - is_lower[j] == 2 ? 1 : 0;
        }
    }
    return edges;
}

inline std::uint64_t SpaceStar::odd_pieces(std::uint64_t ends) const {
    std::uint64_t odd = 0;
    for (std::uint32_t i = 0; i < piece_count_; ++i) odd |= std::uint64_t{count_bits(ends & piece_[i]) & 1} << i;
    return odd;
}

// From one of the ends on, the edges of a tree of short ways that have an odd number of ends behind them.
template <class Add> void SpaceStar::join(std::uint64_t ends, Add add) const {
    for (std::uint32_t i = 0; ends != 0; ++i) {
        std::uint64_t here = ends & piece_[i];
        if (here == 0) continue;
        ends &= ~here;
        std::uint8_t order[64], parent[64];
        std::uint64_t seen = here & (~here + 1);
        std::uint32_t count = 1;
        order[0] = static_cast<std::uint8_t>(lowest_bit(seen));
        for (std::uint32_t k = 0; (here & ~seen) != 0; ++k) {
            std::uint64_t next = lower_adjacent_[order[k]] & piece_[i] & ~seen;
            seen |= next;
            for (; next != 0; next &= next - 1) {
                order[count] = static_cast<std::uint8_t>(lowest_bit(next));
                parent[order[count++]] = order[k];
            }
        }
        while (count > 1) {
            const std::uint32_t a = order[--count], b = parent[a];
            if ((here >> a & 1) == 0) continue;
            add(lower_vertex_[a], lower_vertex_[b]);
            here ^= std::uint64_t{1} << b;
        }
    }
}

inline void SpaceStar::open_upper(const TriangulatedBall<3>& ball, VertexId v) {
    std::uint32_t count = 0;
    upper_set_ = (ball.flags[v] & TriangulatedBall<3>::on_hull) != 0 ? 1 : 0;
    upper_vertex_[0] = ball.outside;
    upper_adjacent_[0] = 0;
    for (std::uint32_t t = ball.begin[v]; t < ball.begin[v + 1]; ++t) {
        const CellId c = ball.incidence[t].cell();
        const VertexId* const p = ball.complex.vertices(c);
        std::uint64_t labels[4] = {}, all = 0;
        for (std::uint32_t j = 0; j < 4; ++j) {
            std::uint32_t& slot = ball.slot[p[j]];
            if (slot < upper || p[j] == v) continue;
            if (slot == upper) {
                slot = upper + ++count;
                upper_vertex_[count] = p[j];
                upper_adjacent_[count] = 0;
                upper_set_ |= std::uint64_t{1} << count;
            }
            labels[j] = std::uint64_t{1} << (slot - upper);
            all |= labels[j];
        }
        for (std::uint64_t left = all; left != 0; left &= left - 1) upper_adjacent_[lowest_bit(left)] |= all;
        for (std::uint32_t j = 0; (upper_set_ & 1) != 0 && j < 4; ++j) {  // beyond a facet at the hull is `outside`
            if (p[j] == v || ball.complex.facet_beyond(c, j) != none) continue;
            upper_adjacent_[0] |= all & ~labels[j];
            for (std::uint64_t left = all & ~labels[j]; left != 0; left &= left - 1)
                upper_adjacent_[lowest_bit(left)] |= 1;
        }
    }
}

template <class Add>
void SpaceStar::surround(const TriangulatedBall<3>& ball, VertexId v, std::uint64_t upper_piece, Add add) const {
    std::uint64_t edges[64];  // of each label to larger ones
    for (std::uint32_t a = 1; a <= lower_count_; ++a) edges[a] = 0;
    for (std::uint32_t t = ball.begin[v]; t < ball.begin[v + 1]; ++t) {
        const VertexId* const p = ball.complex.vertices(ball.incidence[t].cell());
        std::uint64_t lower = 0, uppers = 0;
        for (std::uint32_t j = 0; j < 4; ++j) {
            const std::uint32_t slot = ball.slot[p[j]];
            if (p[j] != v) (slot < upper ? lower : uppers) |= std::uint64_t{1} << (slot & 63);
        }
        if ((uppers & upper_piece) == 0 || (lower & (lower - 1)) == 0) continue;  // two lower ones and one of the piece
        edges[lowest_bit(lower)] ^= lower & (lower - 1);
    }
    for (std::uint32_t a = 1; a <= lower_count_; ++a)
        for (; edges[a] != 0; edges[a] &= edges[a] - 1) add(lower_vertex_[a], lower_vertex_[lowest_bit(edges[a])]);
}

}  // namespace netmesh
