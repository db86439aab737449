// The link of a vertex, as far as it can be told without listing its simplices: which part of it is lower, in how many
// pieces, and whether anything can be born or die at the vertex at all. Needs only which link vertices are adjacent, as
// bits, and how many link cells have how many lower vertices.
//
// The lower link L and the upper link U are complementary in the sphere S^(D-1), so the reduced Betti numbers satisfy
// b_i(L) = b_(D-2-i)(U). With both in one piece b_0(L) = b_(D-2)(L) = 0. For D = 3 nothing is left; for D = 4 only
// b_1(L) is, and the Euler characteristic tells it. Simplices of L are counted through the link cells: all of the top
// dimension, half of the occurrences one dimension below, and for D = 4 edges by adjacency.
#pragma once
#include <cstdint>

#include "homology/lower_star/triangulated_ball.hpp"
#include "numerics/bits.hpp"

namespace netmesh {

template <int D> class Link {
public:
    static std::size_t labels_max(const TriangulatedBall<D>& ball) {
        return std::size_t{ball.degree_max} + 2 * ball.dim() + 2;
    }
    // What a small link is asked for needs no more than adjacency in these dimensions (surfaces are walked around
    // instead).
    static bool tells_all(DimensionOf<D> dim) { return dim == 3 || dim == 4; }

    explicit Link(DimensionOf<D> dim) : dim_(dim) {}

    // vertices: scratch [labels_max]. False when the link has more vertices than a ball's can have.
    bool read(const TriangulatedBall<D>& ball, VertexId v, std::uint32_t* vertices);

    // The same for bound() alone, of a vertex that is not on the hull.
    void count(const TriangulatedBall<D>& ball, VertexId v);

    // Whether the link has at most 63 vertices, so that parts() and counts are known.
    bool small() const { return label_count_ <= 64; }
    // The link vertex of lowest (highest) rank if it is lower (upper) than v, otherwise none; may be `outside`.
    std::uint32_t lowest() const { return lowest_; }
    std::uint32_t highest() const { return highest_; }

    // Number of pieces of the lower (upper) part; next_piece() takes their lowest vertices one by one out of what is
    // left.
    std::uint32_t lower_pieces() { return count_pieces(lower_, &lower_edges_); }
    std::uint32_t upper_pieces() {
        std::uint32_t edges;
        return count_pieces(upper_, &edges);
    }
    std::uint64_t lower_set() const { return lower_; }
    std::uint32_t next_piece(const TriangulatedBall<D>& ball, const std::uint32_t* vertices, std::uint64_t* left) const;

    // Simplices of the lower star by dimension, counts[D+1]; small links of D <= 4 only, after lower_pieces().
    void count_simplices(std::uint32_t* counts) const;
    // At least as many as the lower star has simplices.
    std::uint64_t bound() const { return simplices_bound<D>(dim_, lower_count_, with_lower_); }

private:
    std::uint64_t piece_of(std::uint64_t seed, std::uint64_t within, std::uint64_t* edges) const;
    std::uint32_t count_pieces(std::uint64_t set, std::uint32_t* edges) const;
    std::uint32_t label(const TriangulatedBall<D>& ball, std::uint32_t u, std::uint32_t r, std::uint32_t* vertices);
    void add_cell(std::uint64_t mask, const std::uint32_t* slots) {
        if (!tells_all(dim_)) return;
        for (std::uint32_t j = 0; j < dim_; ++j) adjacent_[slots[j] >> 1 & 63] |= mask;
    }

    const DimensionOf<D> dim_;
    std::uint64_t adjacent_[64];  // by label; bit i: the cells of this label have label i too. Label 0 is outside
    std::uint64_t lower_, upper_;
    std::uint32_t label_count_, lower_count_, lower_edges_;
    std::uint32_t lowest_, highest_, lowest_rank_, highest_rank_;
    std::uint32_t with_lower_[DimensionOf<D>::most + 1];  // link cells with so many lower vertices
};

template <int D>
std::uint32_t Link<D>::label(const TriangulatedBall<D>& ball, std::uint32_t u, std::uint32_t r,
                             std::uint32_t* vertices) {
    const std::uint32_t n = label_count_++;
    const std::uint32_t ru = ball.rank[u];
    const std::uint32_t low = ru < r ? 1 : 0;
    vertices[n] = u;
    adjacent_[n & 63] = 0;
    (low != 0 ? lower_ : upper_) |= std::uint64_t{1} << (n & 63);
    lower_count_ += low;
    if (low != 0 && ru <= lowest_rank_) {
        lowest_rank_ = ru;
        lowest_ = u;
    }
    if (low == 0 && ru >= highest_rank_) {
        highest_rank_ = ru;
        highest_ = u;
    }
    return ball.slot[u] = 2 * n + low;
}

template <int D> bool Link<D>::read(const TriangulatedBall<D>& ball, VertexId v, std::uint32_t* vertices) {
    constexpr std::uint32_t ahead = 16;
    const std::uint32_t r = ball.rank[v];
    const bool hull = (ball.flags[v] & TriangulatedBall<D>::on_hull) != 0;
    const std::size_t label_limit = labels_max(ball);
    label_count_ = 1;
    lower_count_ = 0;
    lower_ = 0;
    upper_ = hull ? 1 : 0;
    adjacent_[0] = 0;
    lowest_ = highest_ = none;
    lowest_rank_ = none;
    highest_rank_ = 0;
    for (std::uint32_t k = 0; k <= dim_; ++k) with_lower_[k] = 0;
    bool sound = true;
    for (std::uint32_t t = ball.begin[v]; t < ball.begin[v + 1]; ++t) {
        ball.prefetch(t + ahead);
        const CellId c = ball.incidence[t].cell();
        const std::uint32_t i = ball.incidence[t].position();
        const VertexId* p = ball.complex.vertices(c);
        std::uint32_t s[DimensionOf<D>::most];
        std::uint32_t k = 0;
        std::uint64_t mask = 0;
        if (label_count_ + dim_ > label_limit) {
            sound = false;
            break;
        }
        for (std::uint32_t j = 0; j < dim_; ++j) {
            const std::uint32_t u = p[j + (j >= i ? 1 : 0)];
            s[j] = ball.slot[u];
            if (s[j] == 0) s[j] = label(ball, u, r, vertices);
            k += s[j] & 1;
            mask |= std::uint64_t{1} << (s[j] >> 1 & 63);
        }
        ++with_lower_[k];
        add_cell(mask, s);
        if (!hull) continue;
        for (std::uint32_t j = 0; j < dim_; ++j) {
            if (ball.complex.facet_beyond(c, j + (j >= i ? 1 : 0)) != none) continue;
            const std::uint64_t cone = (mask & ~(std::uint64_t{1} << (s[j] >> 1 & 63))) | 1;
            const std::uint32_t kept = s[j];
            s[j] = 0;
            ++with_lower_[k - (kept & 1)];
            add_cell(cone, s);
            s[j] = kept;
        }
    }
    if (hull) highest_ = ball.outside;
    for (std::uint32_t n = 1; n < label_count_; ++n) ball.slot[vertices[n]] = 0;
    return sound;
}

// A vertex of the link sphere is in at least D of its cells.
template <int D> void Link<D>::count(const TriangulatedBall<D>& ball, VertexId v) {
    const std::uint32_t r = ball.rank[v];
    lower_count_ = 0;
    for (std::uint32_t k = 0; k <= dim_; ++k) with_lower_[k] = 0;
    for (std::uint32_t t = ball.begin[v]; t < ball.begin[v + 1]; ++t) {
        ball.prefetch(t + 16);
        const VertexId* p = ball.complex.vertices(ball.incidence[t].cell());
        std::uint32_t k = 0;
        for (std::uint32_t j = 0; j <= dim_; ++j) k += ball.rank[p[j]] < r ? 1 : 0;
        ++with_lower_[k];
        lower_count_ += k;
    }
    lower_count_ /= dim_;
}

// The piece of `within` that holds the label set `seed`; adds its number of edges, counted from both ends, to *edges.
template <int D> std::uint64_t Link<D>::piece_of(std::uint64_t seed, std::uint64_t within, std::uint64_t* edges) const {
    std::uint64_t piece = seed;
    for (std::uint64_t front = seed; front != 0;) {
        const std::uint64_t next = adjacent_[lowest_bit(front)] & within;
        *edges += count_bits(next) - 1;
        front = (front & (front - 1)) | (next & ~piece);
        piece |= next;
    }
    return piece;
}

template <int D> std::uint32_t Link<D>::count_pieces(std::uint64_t set, std::uint32_t* edges) const {
    std::uint32_t pieces = 0;
    std::uint64_t ends = 0;
    for (std::uint64_t left = set; left != 0; ++pieces) left &= ~piece_of(left & (~left + 1), set, &ends);
    *edges = static_cast<std::uint32_t>(ends / 2);
    return pieces;
}

template <int D>
std::uint32_t Link<D>::next_piece(const TriangulatedBall<D>& ball, const std::uint32_t* vertices,
                                  std::uint64_t* left) const {
    std::uint64_t ignored = 0;
    const std::uint64_t piece = piece_of(*left & (~*left + 1), *left, &ignored);
    *left &= ~piece;
    std::uint32_t best = vertices[lowest_bit(piece)];
    for (std::uint64_t rest = piece; rest != 0; rest &= rest - 1) {
        const std::uint32_t u = vertices[lowest_bit(rest)];
        if (ball.rank[u] < ball.rank[best]) best = u;
    }
    return best;
}

template <int D> void Link<D>::count_simplices(std::uint32_t* counts) const {
    NETMESH_ASSERT(tells_all(dim_));  // the counts of higher links need more than adjacency
    counts[0] = 1;
    counts[1] = lower_count_;
    counts[2] = lower_edges_;
    counts[dim_] = with_lower_[dim_];
    counts[dim_ - 1] = (dim_ * with_lower_[dim_] + with_lower_[dim_ - 1]) / 2;
}

}  // namespace netmesh
