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
void RipsSimplices::choose_all(std::uint32_t others) {
    for (std::uint32_t a = 0; a < n_; ++a) choose_[a] = 1;
    for (std::uint32_t k = 1; k <= others; ++k) {
        std::uint64_t* const row = choose_ + std::size_t{k} * n_;
        const std::uint64_t* const before = row - n_;
        row[0] = 0;
        for (std::uint32_t a = 1; a < n_; ++a) row[a] = row[a - 1] + before[a - 1];
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

bool RipsSimplices::open(const RipsGraph& graph, std::uint32_t others, Arena& arena) {
    NETMESH_ASSERT(arena.offset_of(graph.ends + graph.edge_count) == arena.low_mark());
    n_ = graph.vertices;
    edges_ = graph.edge_count;
    shift_ = index_bits(n_, others);
    if (!sort_labelled(graph.value, graph.ends, edges_, arena)) return false;
    if (!keep_distinct_values(graph, arena)) return false;
    if (others == 0) return true;
    rank_ = arena.take_low<std::uint32_t>(std::size_t{n_} * n_);
    choose_ = arena.take_high<std::uint64_t>((std::size_t{others} + 1) * n_);
    if (rank_ == nullptr || choose_ == nullptr) return false;
    arena.each(std::uint64_t{n_} * n_, 1, [this](std::uint64_t i) { rank_[i] = none; });
    for (std::uint32_t e = 0; e < edges_;)
        for (const std::uint64_t piece = arena.piece(e, edges_, 20); e < piece; ++e) {
            rank_[std::size_t{larger_end(e)} * n_ + smaller_end(e)] = e;
            rank_[std::size_t{smaller_end(e)} * n_ + larger_end(e)] = e;
        }
    choose_all(others);
    return true;
}

void RipsSimplices::read(std::uint64_t key, std::uint32_t dimension, RipsSimplex* s) const {
    s->key = key;
    s->last_edge = edge_of(key);
    s->count = dimension + 1;
    std::uint64_t index = key & ((std::uint64_t{1} << shift_) - 1);
    std::uint32_t before = n_;
    for (std::uint32_t k = dimension - 1; k >= 1; --k) {  // the largest a < before with C(a, k) <= index
        std::uint32_t low = 0, high = before;
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
        s->row[i] = row(s->vertex[i]);
    }
}

// The first vertex before `end` that is joined to all rows by edges before `edge`; `none` if there is none.
std::uint32_t RipsSimplices::first_joined(const std::uint32_t* const* rows, std::uint32_t count, std::uint32_t edge,
                                          std::uint32_t end) const {
    std::uint32_t rank[block];
    for (std::uint32_t begin = 0; begin < end; begin += block) {
        latest(rows, count, begin, rank);
        for (std::uint32_t w = begin; w < end && w < begin + block; ++w) {
            if (rank[w - begin] < edge) return w;
        }
    }
    return none;
}

std::uint64_t RipsSimplices::apparent_facet(const RipsSimplex& s) const {
    const std::uint32_t* rows[RipsSimplex::vertices_max] = {};
    std::uint32_t count = 0;
    for (std::uint32_t i = 0; i < s.count; ++i) {
        if (s.vertex[i] != s.other[0]) rows[count++] = s.row[i];
    }
    if (first_joined(rows, count, s.last_edge, s.other[0]) != none) return no_key;
    return key_of(s.last_edge, s.other + 1, s.count - 3);
}

std::uint64_t RipsSimplices::first_coface(const RipsSimplex& s) const {
    const std::uint32_t w = first_joined(s.row, s.count, s.last_edge, n_);
    if (w == none) return no_key;
    std::uint32_t other[RipsSimplex::vertices_max], count = 0, i = 0;
    for (; i < s.count - 2 && s.other[i] < w; ++i) other[count++] = s.other[i];
    other[count++] = w;
    for (; i < s.count - 2; ++i) other[count++] = s.other[i];
    return key_of(s.last_edge, other, count);
}

}  // namespace netmesh
