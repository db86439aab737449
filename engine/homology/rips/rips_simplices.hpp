// Simplices of a Rips complex as numbers. Edges are ranked; a simplex of dimension d >= 1 is its last edge and its d -
// 1 other vertices:
//
//   key = rank of the last edge << shift | index of the others
//   index of a < b < c .. = C(a, 1) + C(b, 2) + C(c, 3) ..
//
// Keys of one dimension are in the order of a filtration. Of the cofaces with the same last edge the first has the
// smallest vertex added; of the facets with it the last has the smallest other vertex left out. Where each is the
// other's they are a pair of the diagram, of length zero (an apparent pair), and that is seen from the edges alone.
#pragma once
#include <cstddef>
#include <cstdint>

#include "homology/rips/rips.hpp"
#include "memory/arena.hpp"
#include "numerics/bits.hpp"

namespace netmesh {

constexpr std::uint64_t no_key = ~std::uint64_t{0};

// The edges at a vertex, by the vertex at their other end: ranks of all, `none` where there is no edge, or those that
// there are, ascending.
struct RipsRow {
    struct Joined {
        std::uint32_t vertex, rank;
    };
    const std::uint32_t* table;
    const Joined *begin, *end;

    // Of vertices that are asked for in ascending order: *at is begin at first.
    std::uint32_t rank_of(std::uint32_t w, const Joined** at) const {
        if (table != nullptr) return table[w];
        while (*at != end && (*at)->vertex < w) ++*at;
        return *at != end && (*at)->vertex == w ? (*at)->rank : none;
    }
    std::uint32_t rank_of(std::uint32_t w) const {
        if (table != nullptr) return table[w];
        const Joined *low = begin, *high = end;
        while (low != high) {
            const Joined* const middle = low + (high - low) / 2;
            if (middle->vertex < w)
                low = middle + 1;
            else
                high = middle;
        }
        return low != end && low->vertex == w ? low->rank : none;
    }
};

struct RipsSimplex {
    static constexpr std::uint32_t vertices_max = 32;
    std::uint64_t key;
    std::uint32_t last_edge;             // rank
    std::uint32_t count;                 // vertices
    std::uint32_t vertex[vertices_max];  // ascending
    std::uint32_t other[vertices_max];   // [count - 2], those that are not of the last edge, ascending
};

class RipsSimplices {
public:
    // Ranks the graph's edges, for simplices of up to `others` vertices besides their last edge; of 0 the edges are put
    // in order and nothing else is told. Takes the place of the graph, and what it takes at both ends stays. False: out
    // of memory.
    bool open(const RipsGraph& graph, std::uint32_t others, Arena& arena);

    std::uint32_t vertices() const { return n_; }
    std::uint32_t edges() const { return edges_; }
    std::uint32_t larger_end(std::uint32_t edge) const { return has_lists() ? larger_[edge] : ends_[edge] >> 16; }
    std::uint32_t smaller_end(std::uint32_t edge) const { return has_lists() ? ends_[edge] : ends_[edge] & 0xFFFF; }
    // Whether edges are listed at vertices.
    bool has_lists() const { return larger_ != nullptr; }
    // When an edge enters.
    double value(std::uint32_t edge) const {
        if (has_lists()) return value_[edge];
        const std::uint64_t up_to_here = ~std::uint64_t{0} >> (63 - (edge & 63));
        return value_[values_before_[edge >> 6] + count_bits(is_new_[edge >> 6] & up_to_here) - 1];
    }
    std::uint32_t edge_of(std::uint64_t key) const { return static_cast<std::uint32_t>(key >> shift_); }
    RipsRow row(std::uint32_t v) const {
        if (!has_lists()) return {rank_ + std::size_t{v} * n_, nullptr, nullptr};
        return {nullptr, joined_ + joined_begin_[v], joined_ + joined_begin_[v + 1]};
    }
    // What it costs to visit the rows of these vertices, in units of some 16 vertices.
    std::uint32_t cost_of(const std::uint32_t* vertex, std::uint32_t count) const {
        if (!has_lists()) return n_ / 16;  // of all rows together
        std::size_t sum = 0;
        for (std::uint32_t i = 0; i < count; ++i) sum += joined_begin_[vertex[i] + 1] - joined_begin_[vertex[i]];
        return static_cast<std::uint32_t>(sum / 16);
    }
    // Calls f(w, rank, far) for vertices w < end that are joined to all of these, the last of the edges having this
    // rank, below `before`: far() tells from which of them. Stops and returns false when f does.
    template <class F>
    bool each_joined(const std::uint32_t* vertex, std::uint32_t count, std::uint32_t before, std::uint32_t end,
                     F f) const {
        return has_lists() ? each_in_lists(vertex, count, before, end, f)
                           : each_in_table(vertex, count, before, end, f);
    }
    // Whether both ends of an edge are joined to some vertex by earlier edges.
    bool is_last_of_triangle(std::uint32_t edge) const;
    // The key of a last edge and other vertices, ascending.
    std::uint64_t key_of(std::uint32_t edge, const std::uint32_t* other, std::uint32_t others) const {
        std::uint64_t index = 0;
        for (std::uint32_t i = 0; i < others; ++i) index += choose(other[i], i + 1);
        return std::uint64_t{edge} << shift_ | index;
    }
    void read(std::uint64_t key, std::uint32_t dimension, RipsSimplex* s) const;
    // The facet that makes an apparent pair with s, no_key if none does. s has three vertices at least.
    std::uint64_t apparent_facet(const RipsSimplex& s) const;
    // The first coface with the same last edge, no_key if there is none.
    std::uint64_t first_coface(const RipsSimplex& s) const;
    // Calls f(key) for every coface; stops and returns false when f does.
    template <class F> bool each_coface(const RipsSimplex& s, F f) const;

private:
    static constexpr std::uint32_t block = 64;

    std::uint64_t choose(std::uint32_t a, std::uint32_t k) const {
        return k == 1 ? a : choose_[std::size_t{k} * n_ + a];
    }
    // Ranks by which the vertices [begin, begin + block) are joined to all of these, the last one of each.
    void latest(const std::uint32_t* vertex, std::uint32_t count, std::uint32_t begin, std::uint32_t* rank) const;
    template <class F>
    bool each_in_table(const std::uint32_t* vertex, std::uint32_t count, std::uint32_t before, std::uint32_t end,
                       F f) const;
    template <class F>
    bool each_in_lists(const std::uint32_t* vertex, std::uint32_t count, std::uint32_t before, std::uint32_t end,
                       F f) const;
    // The first vertex before `end` that is joined to all of these by edges before `edge`; `none` if there is none.
    std::uint32_t first_joined(const std::uint32_t* vertex, std::uint32_t count, std::uint32_t edge,
                               std::uint32_t end) const;
    bool open_table(const RipsGraph& graph, std::uint32_t others, Arena& arena);
    bool open_lists(const RipsGraph& graph, std::uint32_t others, Arena& arena);
    void join(const RipsGraph& graph, const std::uint32_t* rank_at, Arena& arena);
    bool keep_distinct_values(const RipsGraph& graph, Arena& arena);
    void choose_all(std::uint32_t others, const Arena& arena);

    std::uint32_t n_ = 0, edges_ = 0, shift_ = 0;
    double* value_ = nullptr;                 // distinct ones, ascending; with lists of each edge
    std::uint64_t* is_new_ = nullptr;         // of 64 edges each, those whose value is not that of the edge before
    std::uint32_t* values_before_ = nullptr;  // of 64 edges each, how many values the edges before have
    const std::uint32_t* ends_ = nullptr;
    std::uint32_t* rank_ = nullptr;  // [n][n]
    // With lists: of edges; then of vertices, [n + 1].
    std::uint32_t *larger_ = nullptr, *joined_begin_ = nullptr;
    RipsRow::Joined* joined_ = nullptr;  // [2 edges]
    std::uint64_t* choose_ = nullptr;    // [others + 1][n]
};

inline void RipsSimplices::latest(const std::uint32_t* vertex, std::uint32_t count, std::uint32_t begin,
                                  std::uint32_t* rank) const {
    const std::uint32_t size = n_ - begin < block ? n_ - begin : block;
    const std::uint32_t* const first = rank_ + std::size_t{vertex[0]} * n_ + begin;
    for (std::uint32_t i = 0; i < size; ++i) rank[i] = first[i];
    for (std::uint32_t r = 1; r < count; ++r) {
        const std::uint32_t* const row = rank_ + std::size_t{vertex[r]} * n_ + begin;
        for (std::uint32_t i = 0; i < size; ++i) rank[i] = row[i] > rank[i] ? row[i] : rank[i];
    }
}

template <class F>
bool RipsSimplices::each_in_table(const std::uint32_t* vertex, std::uint32_t count, std::uint32_t before,
                                  std::uint32_t end, F f) const {
    std::uint32_t rank[block];
    for (std::uint32_t begin = 0; begin < end; begin += block) {
        latest(vertex, count, begin, rank);
        for (std::uint32_t w = begin; w < end && w < begin + block; ++w) {
            const std::uint32_t edge = rank[w - begin];
            const auto far = [&] {
                std::uint32_t at = 0;
                while (rank_[std::size_t{vertex[at]} * n_ + w] != edge) ++at;
                return at;
            };
            if (edge < before && !f(w, edge, far)) return false;
        }
    }
    return true;
}

template <class F>
bool RipsSimplices::each_in_lists(const std::uint32_t* vertex, std::uint32_t count, std::uint32_t before,
                                  std::uint32_t end, F f) const {
    if (count == 2) {  // the most frequent by far; of these the one that is behind goes on, or both
        const RipsRow first = row(vertex[0]), second = row(vertex[1]);
        const RipsRow::Joined *a = first.begin, *b = second.begin;
        while (a != first.end && b != second.end) {
            const RipsRow::Joined here = *a, there = *b;
            a += here.vertex <= there.vertex;
            b += there.vertex <= here.vertex;
            if (here.vertex != there.vertex) continue;
            if (here.vertex >= end) break;
            const bool is_second = there.rank > here.rank;
            const std::uint32_t latest = is_second ? there.rank : here.rank;
            const auto far = [is_second] { return std::uint32_t{is_second}; };
            if (latest < before && !f(here.vertex, latest, far)) return false;
        }
        return true;
    }
    const RipsRow::Joined* at[RipsSimplex::vertices_max];
    for (std::uint32_t r = 0; r < count; ++r) at[r] = row(vertex[r]).begin;
    for (std::uint32_t w = 0, r = 0, latest = 0; w < end;) {
        const RipsRow::Joined*& next = at[r];
        const RipsRow::Joined* const last = row(vertex[r]).end;
        while (next != last && next->vertex < w) ++next;
        if (next == last) return true;
        if (next->vertex > w || next->rank >= before) {
            w = next->vertex > w ? next->vertex : w + 1;
            r = latest = 0;
            continue;
        }
        latest = next->rank > latest ? next->rank : latest;
        if (++r < count) continue;
        const auto far = [&] {
            std::uint32_t which = 0;
            while (at[which]->rank != latest) ++which;
            return which;
        };
        if (!f(w, latest, far)) return false;
        ++w;
        r = latest = 0;
    }
    return true;
}

template <class F> bool RipsSimplices::each_coface(const RipsSimplex& s, F f) const {
    const std::uint32_t others = s.count - 2;
    // Index of the others with one more, of which so many are smaller; index of all vertices but one.
    std::uint64_t with[RipsSimplex::vertices_max], without[RipsSimplex::vertices_max];
    with[0] = without[0] = 0;
    for (std::uint32_t i = 0; i < others; ++i) with[0] += choose(s.other[i], i + 2);
    for (std::uint32_t i = 0; i < others; ++i)
        with[i + 1] = with[i] - choose(s.other[i], i + 2) + choose(s.other[i], i + 1);
    for (std::uint32_t i = 1; i < s.count; ++i) without[0] += choose(s.vertex[i], i);
    for (std::uint32_t i = 1; i < s.count; ++i)
        without[i] = without[i - 1] - choose(s.vertex[i], i) + choose(s.vertex[i - 1], i);
    std::uint32_t smaller = 0;
    return each_joined(s.vertex, s.count, none, n_, [&](std::uint32_t w, std::uint32_t edge, auto far) {
        while (smaller < others && s.other[smaller] < w) ++smaller;
        if (edge < s.last_edge)
            return f(std::uint64_t{s.last_edge} << shift_ | (with[smaller] + choose(w, smaller + 1)));
        return f(std::uint64_t{edge} << shift_ | without[far()]);
    });
}

}  // namespace netmesh
