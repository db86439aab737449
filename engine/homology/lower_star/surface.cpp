#include "homology/lower_star/surface.hpp"

#include "homology/rank.hpp"
#include "memory/prefetch.hpp"
#include "numerics/sort.hpp"

namespace netmesh {

// To the next cell around v. False at the hull.
bool Surface::advance(VertexId v, Corner* corner) const {
    const FacetId facet = complex_.facet_beyond(corner->cell, corner->from);
    if (facet == none) return false;
    const CellId next = facet.cell();
    const std::uint32_t to = facet.position();
    const VertexId* p = complex_.vertices(next);
    const std::uint32_t other = to == 0 ? 1 : 0;
    corner->from = p[other] == v ? 3 - to - other : other;
    corner->to = to;
    corner->cell = next;
    return true;
}

// A piece of the link ends: unless its best vertex is that of the whole circle, which is joined anyway, it gets a join.
bool Surface::end_run(const Circle& circle, JoinList* joins) const {
    if (joins == nullptr || circle.run_best == circle.lowest || circle.run_best == circle.highest) return true;
    if (!circle.last_lower && !with_loops_) return true;
    return joins->add(circle.rank, circle.run_best);
}

bool Surface::add_link_vertex(Circle* circle, std::uint32_t u, JoinList* joins) const {
    const bool lower = u != outside() && rank_[u] < circle->rank;
    if (circle->seen++ == 0) {
        circle->first_lower = circle->last_lower = lower;
        circle->run_best = u;
    }
    if (lower) ++circle->lower_vertices;
    if (lower != circle->last_lower) {
        if (!end_run(*circle, joins)) return false;
        ++circle->changes;
        circle->run_best = u;
        circle->last_lower = lower;
    }
    if (lower ? is_after(circle->run_best, u) : is_after(u, circle->run_best)) circle->run_best = u;
    if (joins != nullptr) return true;  // the second walk knows the best of all
    if (lower && (circle->lowest == none || is_after(circle->lowest, u))) circle->lowest = u;
    if (!lower && (circle->highest == none || is_after(u, circle->highest))) circle->highest = u;
    return true;
}

// Around the circle's vertex from *corner, which becomes the last one. `open`: from one end of the hull to the other,
// else *closed says whether the walk came back or ended at the hull. The first walk has no joins. False: out of memory.
bool Surface::walk(Circle* circle, Corner* corner, bool open, JoinList* joins, bool* closed) const {
    const CellId first = corner->cell;
    if (open) {  // takes no memory: the piece of `outside` gets no join
        add_link_vertex(circle, outside(), joins);
        add_link_vertex(circle, complex_.vertices(first)[corner->from], joins);
    }
    for (*closed = false; !*closed;) {
        if (!add_link_vertex(circle, complex_.vertices(corner->cell)[corner->to], joins)) return false;
        if (!advance(circle->vertex, corner)) break;
        *closed = corner->cell == first;
    }
    if (!end_run(*circle, joins)) return false;
    if (circle->first_lower != circle->last_lower) ++circle->changes;
    return true;
}

bool Surface::read_link(VertexId v, CellId cell, JoinList& joins) {
    const VertexId* p = complex_.vertices(cell);
    const std::uint32_t at = p[0] == v ? 0 : p[1] == v ? 1 : 2;
    Corner start = {cell, at == 0 ? 1u : 0u, at == 2 ? 1u : 2u};
    const Circle unseen = {v, rank_[v], 0, 0, 0, none, none, none, false, false};
    Circle circle = unseen;
    Corner corner = start;
    bool closed;
    walk(&circle, &corner, false, nullptr, &closed);
    const bool open = !closed;
    if (open) {
        start = {corner.cell, corner.to, corner.from};
        corner = start;
        circle = unseen;
        walk(&circle, &corner, true, nullptr, &closed);
    }
    below_[v] = circle.lowest;
    above_[v] = circle.highest == none ? v : circle.highest;
    if (circle.changes > 2) {
        Circle again = unseen;
        again.lowest = circle.lowest;
        again.highest = circle.highest;
        if (!walk(&again, &start, open, &joins, &closed)) return false;
    }
    return add_zero_pairs(circle);
}

// The edges of a lower star are one with the vertex, a critical one for each further piece, and one for each triangle
// but the last of a maximum.
bool Surface::add_zero_pairs(const Circle& circle) {
    if (!writer_.keeps_zero() || circle.lower_vertices == 0) return true;
    const double value = value_[circle.vertex];
    const std::uint32_t critical = circle.changes > 2 ? circle.changes / 2 - 1 : 0;
    for (std::uint32_t i = 1 + critical; i < circle.lower_vertices; ++i) {
        if (!writer_.add(value, value, 1)) return false;
    }
    return true;
}

// What is known of the vertices of a cell that read_cell comes to soon.
inline void Surface::prefetch_vertices(CellId c) const {
    if (complex_.cell_count - c <= ahead) return;
    const VertexId* const p = complex_.vertices(CellId(c + ahead));
    for (int i = 0; i < 3; ++i) prefetch(rank_ + p[i]), prefetch(above_ + p[i]), prefetch(below_ + p[i]);
}

// The cells where a walk goes first that begins in a cell soon to come, and what a later one is asked for that.
inline void Surface::prefetch_walks(CellId c) const {
    if (complex_.cell_count - c <= 2 * ahead) return;
    const CellId soon(c + ahead), later(c + 2 * ahead);
    for (int i = 0; i < 3; ++i) {
        prefetch(above_ + complex_.vertices(later)[i]);
        if (above_[complex_.vertices(soon)[i]] < walk_to_come) continue;
        for (std::uint32_t j = 0; j < 3; ++j) {
            const FacetId facet = complex_.facet_beyond(soon, j);
            if (facet != none) prefetch(complex_.vertices(facet.cell()));
        }
    }
}

// What the cell says of the links of its vertices.
void Surface::read_cell(CellId c) {
    const VertexId* const p = complex_.vertices(c);
    std::uint64_t by_rank[3];
    for (int i = 0; i < 3; ++i) by_rank[i] = std::uint64_t{rank_[p[i]]} << 32 | p[i];
    sort_small<3>(by_rank);
    const auto first = static_cast<std::uint32_t>(by_rank[0]), middle = static_cast<std::uint32_t>(by_rank[1]),
               last = static_cast<std::uint32_t>(by_rank[2]);
    const std::uint32_t crossings = above_[middle] & walk_to_come;
    above_[first] = (above_[first] & walk_to_come) | last;
    above_[middle] = (crossings == walk_to_come ? crossings : crossings + crossing) | last;
    below_[last] = below_[middle] = first;
    for (std::uint32_t i = 0; i < 3; ++i) {
        if (complex_.facet_beyond(c, i) != none) continue;
        ++hull_edges_;
        above_[p[(i + 1) % 3]] |= walk_to_come;
        above_[p[(i + 2) % 3]] |= walk_to_come;
    }
}

bool Surface::reserve() {
    const std::uint32_t n = complex_.vertex_count;
    order_ = arena_.take_high<std::uint32_t>(n);
    rank_ = arena_.take_high<std::uint32_t>(n);
    if (order_ == nullptr || rank_ == nullptr || !rank_vertices(value_, n, arena_, order_, rank_)) return false;
    below_ = arena_.take_high<std::uint32_t>(n);
    above_ = arena_.take_high<std::uint32_t>(std::size_t{n} + 1);
    return below_ != nullptr && above_ != nullptr;
}

Status Surface::run() {
    const std::uint32_t n = complex_.vertex_count, cells = complex_.cell_count;
    if (n > cells + 2) return Status::invalid_argument;
    if (!reserve()) return Status::out_of_memory;
    // Pairs of zero length are counted by walks, too.
    const std::uint32_t unseen = writer_.keeps_zero() ? walk_to_come : 0;
    arena_.each(n, 3, [this, unseen](std::uint64_t v) {
        below_[v] = none;
        above_[v] = unseen | static_cast<std::uint32_t>(v);
    });
    arena_.each(cells, 40, [this](std::uint64_t c) {
        const CellId cell(static_cast<std::uint32_t>(c));
        prefetch_vertices(cell);
        read_cell(cell);
    });
    for (std::uint32_t v = 0; v < n; ++v) {
        arena_.step(v, 4);
        if (below_[v] == none && (above_[v] & ~walk_to_come) == v) return Status::invalid_argument;
    }
    monitor_.begin(NETMESH_STAGE_GRADIENT, cells);
    JoinList joins(arena_);
    for (CellId c(0); c < cells;)
        for (const std::uint64_t piece = arena_.piece(c, cells, 15); c < piece; ++c) {
            prefetch_walks(c);
            for (int i = 0; i < 3; ++i) {
                const VertexId v = complex_.vertices(c)[i];
                if (above_[v] < walk_to_come) continue;
                if (!read_link(v, c, joins)) return Status::out_of_memory;
                if (monitor_.advance(c)) return Status::cancelled;
            }
        }
    if (arena_.has_stopped()) return Status::cancelled;
    arena_.each(n, 2, [this](std::uint64_t v) { above_[v] &= ~walk_to_come; });
    above_[outside()] = outside();
    joins.sort_by_rank();
    const VertexOrder vertices = {value_, order_, n, zero_born_count_};
    const JoinList* const lists[] = {&joins};
    if (!join_sublevel(vertices, below_, lists, 1, rank_, writer_)) return Status::out_of_memory;
    if (with_loops_ && !join_superlevel(vertices, rank_, above_, joins, 1, writer_)) return Status::out_of_memory;
    return Status::ok;
}

}  // namespace netmesh
