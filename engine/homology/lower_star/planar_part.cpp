#include "homology/lower_star/planar_part.hpp"

#ifndef __OPTIMIZE_SIZE__  // see unites_planar_edges

#include "homology/rank.hpp"
#include "homology/union_find.hpp"

namespace netmesh {

// Which edges of cell c are in the part and no earlier cell's: bit i for the one opposite vertex i.
std::uint8_t PlanarPart::edges_of(CellId c) const {
    const VertexId* const p = complex_.vertices(c);
    const bool in = has(c);
    std::uint8_t edges = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
        const FacetId facet = complex_.facet_beyond(c, i);
        if (facet != none) {
            const bool other_in = has(facet.cell());
            if (other_in == in ? facet.cell() < c : other_in) continue;
        }
        const std::uint32_t a = p[(i + 1) % 3], b = p[(i + 2) % 3];
        const std::uint32_t edge[] = {a < b ? a : b, a < b ? b : a};
        if (in || part_.faces.contains(edge, 2)) edges = static_cast<std::uint8_t>(edges | 1u << i);
    }
    return edges;
}

template <class Act> void PlanarPart::each_edge(CellId c, Act&& act) const {
    const std::uint8_t edges = edges_[c];
    if (edges == 0) return;
    const VertexId* const p = complex_.vertices(c);
    const std::uint32_t rank[3] = {rank_[p[0]], rank_[p[1]], rank_[p[2]]};
    for (std::uint32_t i = 0; i < 3; ++i) {
        if ((edges >> i & 1) == 0) continue;
        const std::uint32_t a = rank[(i + 1) % 3], b = rank[(i + 2) % 3];
        act(a > b ? a : b, a > b ? b : a);
    }
}

bool PlanarPart::reserve() {
    const std::uint32_t n = complex_.vertex_count;
    order_ = arena_.take_high<std::uint32_t>(n);
    rank_ = arena_.take_high<std::uint32_t>(n);
    if (order_ == nullptr || rank_ == nullptr || !rank_vertices(value_, n, arena_, order_, rank_)) return false;
    parent_ = arena_.take_high<std::uint32_t>(std::size_t{n} + 1);
    begin_ = arena_.take_high<std::uint32_t>(std::size_t{n} + 1);
    flags_ = arena_.take_high<std::uint8_t>(n);
    edges_ = arena_.take_high<std::uint8_t>(complex_.cell_count);
    return parent_ != nullptr && begin_ != nullptr && flags_ != nullptr && edges_ != nullptr;
}

// Counts simplices and edges, and tells which vertices are joined to `outside`. invalid_argument: a vertex is in no
// cell; internal: the part is not closed.
Status PlanarPart::read_vertices() {
    const std::uint32_t n = complex_.vertex_count, cells = complex_.cell_count;
    arena_.each(n, 5, [this](std::uint64_t v) {
        const std::uint8_t part = part_.vertex[v];
        flags_[v] = part == VertexPart::whole ? 0 : is_joined;
        simplex_count_ += part == VertexPart::absent ? 0 : 1;
    });
    std::uint64_t edges = 0;
    bool is_closed = true;
    arena_.each(cells, 120, [&](std::uint64_t k) {
        const CellId c(static_cast<std::uint32_t>(k));
        const VertexId* const p = complex_.vertices(c);
        for (std::uint32_t i = 0; i < 3; ++i) {
            flags_[p[i]] |= is_seen;
            if (complex_.facet_beyond(c, i) != none) continue;
            flags_[p[(i + 1) % 3]] |= is_joined;
            flags_[p[(i + 2) % 3]] |= is_joined;
        }
        simplex_count_ += has(c) ? 1 : 0;
        edges_[c] = edges_of(c);
        each_edge(c, [&](std::uint32_t later, std::uint32_t earlier) {
            ++edges;
            is_closed = is_closed && is_in(order_[later]) && is_in(order_[earlier]);
        });
    });
    simplex_count_ += edges;
    for (std::uint32_t v = 0; v < n; ++v) {
        arena_.step(v, 4);
        if ((flags_[v] & is_seen) == 0) return Status::invalid_argument;
    }
    if (!is_closed) return Status::internal;
    end_ = arena_.take_high<std::uint32_t>(static_cast<std::size_t>(edges));
    return end_ == nullptr ? Status::out_of_memory : Status::ok;
}

void PlanarPart::list_edges(bool by_later) {
    const std::uint32_t n = complex_.vertex_count, cells = complex_.cell_count;
    arena_.each(n + std::uint64_t{1}, 2, [this](std::uint64_t r) { begin_[r] = 0; });
    arena_.each(cells, 40, [this, by_later](std::uint64_t c) {
        each_edge(CellId(static_cast<std::uint32_t>(c)),
                  [&](std::uint32_t later, std::uint32_t earlier) { ++begin_[by_later ? later : earlier]; });
    });
    std::uint32_t sum = 0;
    arena_.each(n + std::uint64_t{1}, 4, [&](std::uint64_t r) { begin_[r] = sum += begin_[r]; });
    arena_.each(cells, 50, [this, by_later](std::uint64_t c) {  // from the ends of the lists down
        each_edge(CellId(static_cast<std::uint32_t>(c)), [&](std::uint32_t later, std::uint32_t earlier) {
            end_[--begin_[by_later ? later : earlier]] = by_later ? earlier : later;
        });
    });
}

bool PlanarPart::join_upwards() {
    const std::uint32_t n = complex_.vertex_count;
    const auto is_older = [this](std::uint32_t x, std::uint32_t y) {
        const std::uint32_t v = order_[x], w = order_[y];
        return birth(v) < birth(w) || (birth(v) == birth(w) && v < w);
    };
    for (std::uint32_t r = 0; r < n; ++r) {
        arena_.step(r, 100);
        parent_[r] = r;
        for (std::uint32_t e = begin_[r]; e < begin_[r + 1]; ++e) {
            std::uint32_t older = r, younger = end_[e];
            if (unite(parent_, older, younger, is_older) && !writer_.add(birth(order_[younger]), value_[order_[r]], 0))
                return false;
        }
    }
    for (std::uint32_t r = 0; r < n; ++r) {
        arena_.step(r, 10);
        const std::uint32_t v = order_[r];
        if (parent_[r] == r && is_in(v) && !writer_.add_essential(birth(v), 0)) return false;
    }
    return true;
}

bool PlanarPart::join_downwards() {
    const std::uint32_t outside = complex_.vertex_count;
    const auto is_older = [](std::uint32_t x, std::uint32_t y) { return x > y; };
    parent_[outside] = outside;
    for (std::uint32_t r = outside; r-- > 0;) {
        arena_.step(r, 100);
        const std::uint32_t v = order_[r];
        parent_[r] = (flags_[v] & is_joined) != 0 ? outside : r;
        for (std::uint32_t e = begin_[r]; e < begin_[r + 1]; ++e) {
            std::uint32_t older = r, younger = end_[e];
            if (unite(parent_, older, younger, is_older) && younger != r &&
                !writer_.add(value_[v], value_[order_[younger]], 1))
                return false;
        }
    }
    return true;
}

Status PlanarPart::run() {
    if (!reserve()) return Status::out_of_memory;
    monitor_.begin(NETMESH_STAGE_GRADIENT, complex_.cell_count);
    const Status status = read_vertices();
    if (status != Status::ok) return status;
    list_edges(true);
    if (arena_.has_stopped()) return Status::cancelled;
    if (!join_upwards()) return Status::out_of_memory;
    if (with_loops_) {
        list_edges(false);
        if (arena_.has_stopped()) return Status::cancelled;
        if (!join_downwards()) return Status::out_of_memory;
    }
    return arena_.has_stopped() ? Status::cancelled : Status::ok;
}

}  // namespace netmesh

#endif
