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

struct RipsSimplex {
    static constexpr std::uint32_t vertices_max = 32;
    std::uint64_t key;
    std::uint32_t last_edge;                 // rank
    std::uint32_t count;                     // vertices
    std::uint32_t vertex[vertices_max];      // ascending
    std::uint32_t other[vertices_max];       // [count - 2], those that are not of the last edge, ascending
    const std::uint32_t* row[vertices_max];  // [count], ranks of the edges from vertex[i] to every vertex
};

class RipsSimplices {
public:
    // Ranks the graph's edges, for simplices of up to `others` vertices besides their last edge; of 0 the edges are put
    // in order and nothing else is told. Takes the place of the graph, and what it takes at both ends stays. False: out
    // of memory.
    bool open(const RipsGraph& graph, std::uint32_t others, Arena& arena);

    std::uint32_t vertices() const { return n_; }
    std::uint32_t edges() const { return edges_; }
    std::uint32_t larger_end(std::uint32_t edge) const { return ends_[edge] >> 16; }
    std::uint32_t smaller_end(std::uint32_t edge) const { return ends_[edge] & 0xFFFF; }
    // When an edge enters.
    double value(std::uint32_t edge) const {
        const std::uint64_t up_to_here = ~std::uint64_t{0} >> (63 - (edge & 63));
        return value_[values_before_[edge >> 6] + count_bits(is_new_[edge >> 6] & up_to_here) - 1];
    }
    std::uint32_t edge_of(std::uint64_t key) const { return static_cast<std::uint32_t>(key >> shift_); }
    // Ranks of the edges from v to every vertex; `none` where there is no edge.
    const std::uint32_t* row(std::uint32_t v) const { return rank_ + std::size_t{v} * n_; }
    // Whether both ends of an edge are joined to some vertex by earlier edges.
    bool is_last_of_triangle(std::uint32_t edge) const {
        const std::uint32_t *const a = row(smaller_end(edge)), *const b = row(larger_end(edge));
        std::uint32_t w = 0;
        while (w < n_ && (a[w] >= edge || b[w] >= edge)) ++w;
        return w < n_;
    }
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

    std::uint64_t choose(std::uint32_t a, std::uint32_t k) const { return choose_[std::size_t{k} * n_ + a]; }
    // Ranks by which the vertices [begin, begin + block) are joined to all rows, the last one of each.
    void latest(const std::uint32_t* const* rows, std::uint32_t count, std::uint32_t begin, std::uint32_t* rank) const;
    std::uint32_t first_joined(const std::uint32_t* const* rows, std::uint32_t count, std::uint32_t edge,
                               std::uint32_t end) const;
    bool keep_distinct_values(const RipsGraph& graph, Arena& arena);
    void choose_all(std::uint32_t others);

    std::uint32_t n_ = 0, edges_ = 0, shift_ = 0;
    double* value_ = nullptr;                 // distinct ones, ascending
    std::uint64_t* is_new_ = nullptr;         // of 64 edges each, those whose value is not that of the edge before
    std::uint32_t* values_before_ = nullptr;  // of 64 edges each, how many values the edges before have
    const std::uint32_t* ends_ = nullptr;
    std::uint32_t* rank_ = nullptr;    // [n][n]
    std::uint64_t* choose_ = nullptr;  // [others + 1][n]
};

inline void RipsSimplices::latest(const std::uint32_t* const* rows, std::uint32_t count, std::uint32_t begin,
                                  std::uint32_t* rank) const {
    const std::uint32_t size = n_ - begin < block ? n_ - begin : block;
    for (std::uint32_t i = 0; i < size; ++i) rank[i] = rows[0][begin + i];
    for (std::uint32_t r = 1; r < count; ++r) {
        const std::uint32_t* const row = rows[r] + begin;
        for (std::uint32_t i = 0; i < size; ++i) rank[i] = row[i] > rank[i] ? row[i] : rank[i];
    }
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
    std::uint32_t smaller = 0, rank[block];
    for (std::uint32_t begin = 0; begin < n_; begin += block) {
        latest(s.row, s.count, begin, rank);
        for (std::uint32_t w = begin; w < n_ && w < begin + block; ++w) {
            const std::uint32_t edge = rank[w - begin];
            while (smaller < others && s.other[smaller] < w) ++smaller;
            if (edge == none) continue;
            std::uint64_t key;
            if (edge < s.last_edge) {
                key = std::uint64_t{s.last_edge} << shift_ | (with[smaller] + choose(w, smaller + 1));
            } else {
                std::uint32_t far = 0;
                while (s.row[far][w] != edge) ++far;
                key = std::uint64_t{edge} << shift_ | without[far];
            }
            if (!f(key)) return false;
        }
    }
    return true;
}

}  // namespace netmesh
