// Cycles as the sweep over lower stars finds them. A column that has dropped nothing is a cycle; a component of the
// superlevel set, as a set of cells, has one for its boundary.
#pragma once
#include "homology/bit_set.hpp"
#include "homology/cycles/cycle_writer.hpp"
#include "homology/lower_star/front.hpp"
#include "homology/lower_star/star.hpp"
#include "vocabulary/monitor.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

template <int D> class StarCycles {
public:
    StarCycles(const TriangulatedBall<D>& ball, const Star<D>& star, const Front& front, CycleWriter* writer,
               Monitor& monitor)
        : ball_(ball), star_(star), front_(front), writer_(writer), monitor_(monitor) {}

    // Takes 4 bytes and a bit for each cell from the arena's high end. False: out of memory.
    bool reserve(Arena& arena) {
        const std::uint32_t cells = ball_.complex.cell_count;
        piece_ = arena.take_high<CellId>(cells);
        std::uint64_t* const words = arena.take_high<std::uint64_t>(BitSet::words_needed(cells));
        if (piece_ == nullptr || words == nullptr) return false;
        inside_.adopt(words, cells);
        return true;
    }

    // The cycle that column c is, which has just taken its pivot in the star of v. False: out of memory.
    bool write_column(std::uint32_t c, VertexId v, std::uint32_t* handle);
    // The boundary of the cells that are joined to `cell` by facets later than critical facet i of the star of v.
    // out_of_memory, cancelled.
    Status write_piece(CellId cell, std::uint32_t i, VertexId v, std::uint32_t* handle);

private:
    bool is_later(CellId cell, std::uint32_t j, VertexId v, std::uint32_t position) const;
    Status collect(CellId cell, VertexId v, std::uint32_t position);
    template <class F> void each_boundary_facet(F f) const;

    const TriangulatedBall<D>& ball_;
    const Star<D>& star_;
    const Front& front_;
    CycleWriter* writer_;
    Monitor& monitor_;
    BitSet inside_;  // cells
    CellId* piece_ = nullptr;
    std::uint32_t piece_count_ = 0;
};

template <int D> [[gnu::cold]] bool StarCycles<D>::write_column(std::uint32_t c, VertexId v, std::uint32_t* handle) {
    const std::uint32_t n = front_.dimension(c);
    const Run here = front_.local(c), below = front_.below(c);
    std::uint32_t* out = writer_->append(std::uint64_t{here.count} + below.count, n - 1, handle);
    if (out == nullptr) return false;
    for (auto at = front_.begin(here); at.left > 0; front_.advance(&at)) {
        std::uint32_t i = star_.at(*front_.entry(at, 1));
        *out++ = v;
        for (std::uint32_t j = 1; j < n; ++j, i = star_.parent(i)) *out++ = star_.vertex(star_.label(i));
    }
    for (auto at = front_.begin(below); at.left > 0; front_.advance(&at)) {
        for (std::uint32_t j = 0; j < n; ++j) *out++ = ball_.order[front_.entry(at, n)[j]];
    }
    return true;
}

// Whether the facet opposite vertex j of the cell comes after that position in the star of v.
template <int D> bool StarCycles<D>::is_later(CellId cell, std::uint32_t j, VertexId v, std::uint32_t position) const {
    const VertexId* const p = ball_.complex.vertices(cell);
    const std::uint32_t r = ball_.rank[v];
    std::uint32_t labels[DimensionOf<D>::most] = {}, count = 0;
    for (std::uint32_t i = 0; i <= ball_.dim(); ++i) {
        if (i == j) continue;
        if (ball_.rank[p[i]] > r) return true;
        if (p[i] != v) labels[count++] = ball_.slot[p[i]];
    }
    if (count == ball_.dim()) return false;  // v is not among them
    return star_.position(star_.simplex_of_any_order(labels, count)) > position;
}

template <int D> Status StarCycles<D>::collect(CellId cell, VertexId v, std::uint32_t position) {
    piece_count_ = 0;
    inside_.insert(cell);
    piece_[piece_count_++] = cell;
    for (std::uint32_t at = 0; at < piece_count_; ++at) {
        if (monitor_.advance(ball_.rank[v], 1)) return Status::cancelled;
        for (std::uint32_t j = 0; j <= ball_.dim(); ++j) {
            const CellId next = ball_.complex.neighbour(piece_[at], j);
            if (next == none || inside_.has(next) || !is_later(piece_[at], j, v, position)) continue;
            inside_.insert(next);
            piece_[piece_count_++] = next;
        }
    }
    return Status::ok;
}

template <int D> template <class F> void StarCycles<D>::each_boundary_facet(F f) const {
    for (std::uint32_t at = 0; at < piece_count_; ++at) {
        for (std::uint32_t j = 0; j <= ball_.dim(); ++j) {
            const CellId next = ball_.complex.neighbour(piece_[at], j);
            if (next == none || !inside_.has(next)) f(ball_.complex.vertices(piece_[at]), j);
        }
    }
}

template <int D>
[[gnu::cold]] Status StarCycles<D>::write_piece(CellId cell, std::uint32_t i, VertexId v, std::uint32_t* handle) {
    const Status status = collect(cell, v, star_.position(i));
    if (status != Status::ok) return status;
    std::uint64_t count = 0;
    each_boundary_facet([&count](const VertexId*, std::uint32_t) { ++count; });
    std::uint32_t* out = writer_->append(count, ball_.dim() - 1, handle);
    if (out == nullptr) return Status::out_of_memory;
    each_boundary_facet([&out, this](const VertexId* p, std::uint32_t opposite) {
        for (std::uint32_t j = 0; j <= ball_.dim(); ++j) {
            if (j != opposite) *out++ = p[j];
        }
    });
    for (std::uint32_t at = 0; at < piece_count_; ++at) inside_.erase(piece_[at]);
    return Status::ok;
}

}  // namespace netmesh
