#include "homology/rips/rips_simplices.hpp"

#include "memory/arena.hpp"
#include "numerics/bits.hpp"
#include "numerics/value_order.hpp"

namespace netmesh {
namespace {

std::uint32_t bit_width(std::uint64_t x) { return x == 0 ? 0 : highest_bit(x) + 1; }

// BitSet of the largest index of so many vertices or fewer; 64 when they are too many.
std::uint32_t index_bits(std::uint32_t n, std::uint32_t others) {
    std::uint64_t choose = 1, most = 1;
    for (std::uint32_t k = 1; k <= others && k <= n; ++k) {
        if (choose > (std::uint64_t{1} << 46)) return 64;
        choose = choose * (n - k + 1) / k;
        if (choose > most) most = choose;
    }
    return bit_width(most);
}

}  // namespace

bool rips_has_numbers(const RipsGraph& graph, std::uint32_t max_degree) {
    return graph.vertices <= RipsGraph::vertices_max && max_degree + 2 <= RipsSimplex::vertices_max &&
           bit_width(graph.edge_count) + index_bits(graph.vertices, max_degree) <= 63;
}

// The numbers C(a, k), a < n, k <= others.
void RipsSimplices::choose_all(std::uint32_t others, const Arena& arena) {
    arena.each(n_, 1, [this](std::uint64_t a) { choose_[a] = 1; });
    for (std::uint32_t k = 1; k <= others; ++k) {
        std::uint64_t* const row = choose_ + std::size_t{k} * n_;
        const std::uint64_t* const before = row - n_;
        row[0] = 0;
        arena.each(n_ - 1, 2, [row, before](std::uint64_t a) { row[a + 1] = row[a] + before[a]; });
    }
}

// Of edges in order of value. Equal values become one, and the ends move down behind what is left: distances are often
// rounded, and then most of these bytes are free.
bool RipsSimplices::keep_distinct_values(const RipsGraph& graph, Arena& arena) {
    const std::size_t words = (std::size_t{edges_} + 63) / 64;
    is_new_ = arena.take_high<std::uint64_t>(words);
    values_before_ = arena.take_high<std::uint32_t>(words);
    if (is_new_ == nullptr || values_before_ == nullptr) return false;
    value_ = graph.value;
    std::uint32_t count = 0;
    arena.each(edges_, 10, [&](std::uint64_t e) {
        if (e % 64 == 0) {
            is_new_[e / 64] = 0;
            values_before_[e / 64] = count;
        }
        const double value = graph.value[e];
        if (count > 0 && value_[count - 1] == value) return;
        is_new_[e / 64] |= std::uint64_t{1} << (e % 64);
        value_[count++] = value;
    });
    arena.release_low(arena.offset_of(value_ + count));
    std::uint32_t* const ends = arena.take_low<std::uint32_t>(edges_);
    if (ends == nullptr) return false;
    move_bytes(ends, graph.ends, sizeof *ends * std::size_t{edges_}, arena);
    ends_ = ends;
    return true;
}

bool RipsSimplices::open_table(const RipsGraph& graph, std::uint32_t others, Arena& arena) {
    if (!sort_labelled(graph.value, graph.ends, edges_, arena)) return false;
    if (!keep_distinct_values(graph, arena)) return false;
    if (others == 0) return true;
    rank_ = arena.take_low<std::uint32_t>(std::size_t{n_} * n_);
    if (rank_ == nullptr) return false;
    arena.each(std::uint64_t{n_} * n_, 1, [this](std::uint64_t i) { rank_[i] = none; });
    arena.each(edges_, 20, [this](std::uint64_t at) {
        const auto e = static_cast<std::uint32_t>(at);
        rank_[std::size_t{larger_end(e)} * n_ + smaller_end(e)] = e;
        rank_[std::size_t{smaller_end(e)} * n_ + larger_end(e)] = e;
    });
    return true;
}

// Edges are places in the graph's order first, and ranks then.
bool RipsSimplices::open_lists(const RipsGraph& graph, std::uint32_t others, Arena& arena) {
    larger_ = arena.take_low<std::uint32_t>(edges_);
    if (larger_ == nullptr) return false;
    arena.each(edges_, 1, [this](std::uint64_t e) { larger_[e] = static_cast<std::uint32_t>(e); });
    if (!sort_labelled(graph.value, larger_, edges_, arena)) return false;
    value_ = graph.value;
    ends_ = graph.ends;
    if (others > 0) {
        joined_begin_ = arena.take_low<std::uint32_t>(std::size_t{n_} + 2);
        joined_ = arena.take_low<RipsRow::Joined>(2 * std::size_t{edges_});
    }
    const HighScope scope(arena);
    std::uint32_t* const rank_at = arena.take_high<std::uint32_t>(edges_);
    std::uint32_t* const smaller = others > 0 ? graph.ends : arena.take_high<std::uint32_t>(edges_);
    if (rank_at == nullptr || smaller == nullptr || (others > 0 && (joined_begin_ == nullptr || joined_ == nullptr)))
        return false;
    arena.each(edges_, 4, [this, rank_at](std::uint64_t r) { rank_at[larger_[r]] = static_cast<std::uint32_t>(r); });
    if (others > 0) join(graph, rank_at, arena);
    arena.each(n_, 2, [&](std::uint64_t v) {
        const RipsRow::Joined* at = others > 0 ? joined_ + joined_begin_[v] : nullptr;
        for (std::uint32_t e = graph.begin[v]; e < graph.begin[v + 1]; ++e) {
            arena.step(e, 8);
            larger_[rank_at[e]] = static_cast<std::uint32_t>(v);
            smaller[rank_at[e]] = at != nullptr ? (at++)->vertex : graph.ends[e];
        }
    });
    if (others == 0) move_bytes(graph.ends, smaller, sizeof *smaller * std::size_t{edges_}, arena);
    return true;
}

// Lists at vertices: at each the smaller ones come first, as edges are in order of the larger end.
void RipsSimplices::join(const RipsGraph& graph, const std::uint32_t* rank_at, Arena& arena) {
    std::uint32_t* const begin = joined_begin_ + 1;  // of each vertex, where its next one goes
    arena.each(std::uint64_t{n_} + 1, 1, [begin](std::uint64_t v) { begin[v] = 0; });
    arena.each(edges_, 3, [&](std::uint64_t e) { ++begin[graph.ends[e] + 1]; });
    arena.each(n_, 3, [&](std::uint64_t v) { begin[v + 1] += begin[v] + (graph.begin[v + 1] - graph.begin[v]); });
    joined_begin_[0] = 0;
    arena.each(n_, 2, [&](std::uint64_t at) {
        const auto v = static_cast<std::uint32_t>(at);
        for (std::uint32_t e = graph.begin[v]; e < graph.begin[v + 1]; ++e) {
            arena.step(e, 10);
            const std::uint32_t smaller = graph.ends[e];
            joined_[begin[v]++] = {smaller, rank_at[e]};
            joined_[begin[smaller]++] = {v, rank_at[e]};
        }
    });
}

bool RipsSimplices::open(const RipsGraph& graph, std::uint32_t others, Arena& arena) {
    NETMESH_ASSERT(arena.offset_of(graph.ends + graph.edge_count) == arena.low_mark());
    n_ = graph.vertices;
    edges_ = graph.edge_count;
    shift_ = index_bits(n_, others);
    if (!(graph.begin != nullptr ? open_lists(graph, others, arena) : open_table(graph, others, arena))) return false;
    if (others == 0) return true;
    choose_ = arena.take_high<std::uint64_t>((std::size_t{others} + 1) * n_);
    if (choose_ == nullptr) return false;
    choose_all(others, arena);
    return true;
}

void RipsSimplices::read(std::uint64_t key, std::uint32_t dimension, RipsSimplex* s) const {
    s->key = key;
    s->last_edge = edge_of(key);
    s->count = dimension + 1;
    std::uint64_t index = key & ((std::uint64_t{1} << shift_) - 1);
    std::uint32_t before = n_;
    for (std::uint32_t k = dimension - 1; k >= 1; --k) {  // the largest a < before with C(a, k) <= index
        std::uint32_t low = k == 1 ? static_cast<std::uint32_t>(index) : 0, high = k == 1 ? low : before;
        while (high - low > 1) {
            const std::uint32_t middle = low + (high - low) / 2;
            (choose(middle, k) <= index ? low : high) = middle;
        }
        s->other[k - 1] = before = low;
        index -= choose(low, k);
    }
    const std::uint32_t ends[2] = {smaller_end(s->last_edge), larger_end(s->last_edge)};
    for (std::uint32_t i = 0, a = 0, b = 0; i <= dimension; ++i) {
        const bool from_ends = b < 2 && (a == dimension - 1 || ends[b] < s->other[a]);
        s->vertex[i] = from_ends ? ends[b++] : s->other[a++];
    }
}

std::uint32_t RipsSimplices::first_joined(const std::uint32_t* vertex, std::uint32_t count, std::uint32_t edge,
                                          std::uint32_t end) const {
    std::uint32_t first = none;
    each_joined(vertex, count, edge, end, [&first](std::uint32_t w, std::uint32_t, auto) {
        first = w;
        return false;
    });
    return first;
}

bool RipsSimplices::is_last_of_triangle(std::uint32_t edge) const {
    const std::uint32_t ends[] = {smaller_end(edge), larger_end(edge)};
    if (has_lists()) return first_joined(ends, 2, edge, n_) != none;
    const std::uint32_t *const a = row(ends[0]).table, *const b = row(ends[1]).table;
    std::uint32_t w = 0;
    while (w < n_ && (a[w] >= edge || b[w] >= edge)) ++w;
    return w < n_;
}

std::uint64_t RipsSimplices::apparent_facet(const RipsSimplex& s) const {
    std::uint32_t facet[RipsSimplex::vertices_max];
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < s.count; ++i) {
        if (s.vertex[i] != s.other[0]) facet[count++] = s.vertex[i];
    }
    if (first_joined(facet, count, s.last_edge, s.other[0]) != none) return no_key;
    return key_of(s.last_edge, s.other + 1, s.count - 3);
}

std::uint64_t RipsSimplices::first_coface(const RipsSimplex& s) const {
    const std::uint32_t w = first_joined(s.vertex, s.count, s.last_edge, n_);
    if (w == none) return no_key;
    std::uint32_t other[RipsSimplex::vertices_max], count = 0, i = 0;
    for (; i < s.count - 2 && s.other[i] < w; ++i) other[count++] = s.other[i];
    other[count++] = w;
    for (; i < s.count - 2; ++i) other[count++] = s.other[i];
    return key_of(s.last_edge, other, count);
}

}  // namespace netmesh
