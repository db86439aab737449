// A column of triangles at work, as the edges whose cofaces were added: a symmetric matrix of bits over the vertices. A
// triangle is in the sum if an odd number of its edges is in that set, so the next pivot is found by adding two rows of
// bits for each edge that may be the triangle's last one. Additions cost a bit an edge, where a heap of cofaces
// (key_heap.hpp) visits the rows of its ends and grows; so a heap is for fewer additions than make it as large as the
// matrix: of complete graphs one in 64 vertices.
#pragma once
#include <cstddef>
#include <cstdint>

#include "homology/rips/rips_simplices.hpp"
#include "memory/arena.hpp"
#include "numerics/bits.hpp"

namespace netmesh {

class EdgeSum {
public:
    explicit EdgeSum(const RipsSimplices& simplices) : simplices_(simplices) {}

    // So many additions make a heap as large as the matrix, an edge having as many cofaces as vertices have edges.
    std::uint64_t additions_of_a_heap() const {
        const std::uint64_t n = simplices_.vertices(), joined = 2 * std::uint64_t{simplices_.edges()} / n;
        return 1 + (joined + 1 >= n ? n / 64 : n * n / (64 * (joined + 1)));
    }

    // The empty sum. Takes 8 * vertices * (vertices / 64 + 1) + 4 * vertices bytes at the low end. False: out of
    // memory.
    bool open(Arena& arena) {
        const std::uint32_t n = simplices_.vertices();
        words_ = (n + 63) / 64;
        bits_ = arena.take_low<std::uint64_t>(std::size_t{n} * words_);
        degree_ = arena.take_low<std::uint32_t>(n);
        if (bits_ == nullptr || degree_ == nullptr) return false;
        arena.each(std::uint64_t{n} * words_, 1, [this](std::uint64_t i) { bits_[i] = 0; });
        arena.each(n, 1, [this](std::uint64_t v) { degree_[v] = 0; });
        return true;
    }
    // Adds the cofaces of an edge, by its rank.
    void toggle(std::uint32_t edge) {
        const std::uint32_t a = simplices_.smaller_end(edge), b = simplices_.larger_end(edge);
        flip(a, b);
        flip(b, a);
    }
    // The key of the first triangle whose last edge is in [begin, end), by ranks; no_key if there is none.
    std::uint64_t first(std::uint32_t begin, std::uint32_t end) const {
        const std::uint32_t n = simplices_.vertices();
        for (std::uint32_t e = begin; e < end; ++e) {
            const std::uint32_t a = simplices_.smaller_end(e), b = simplices_.larger_end(e);
            if ((degree_[a] | degree_[b]) == 0) continue;
            const RipsRow to_a = simplices_.row(a), to_b = simplices_.row(b);
            const std::uint64_t *const at_a = row(a), *const at_b = row(b);
            const std::uint64_t both = has(a, b) ? ~std::uint64_t{0} : 0;
            for (std::uint32_t i = 0; i < words_; ++i)
                for (std::uint64_t odd = at_a[i] ^ at_b[i] ^ both; odd != 0; odd &= odd - 1) {
                    const std::uint32_t w = 64 * i + lowest_bit(odd);
                    if (w >= n) break;
                    if (to_a.rank_of(w) < e && to_b.rank_of(w) < e) return simplices_.key_of(e, &w, 1);
                }
        }
        return no_key;
    }
    // Calls f(rank of the edge) for the edges of the set from vertex v to smaller ones; stops and returns false when f
    // does.
    template <class F> bool each_edge(std::uint32_t v, F f) const {
        const std::uint64_t* const bits = row(v);
        for (std::uint32_t i = 0; 64 * i < v; ++i)
            for (std::uint64_t rest = bits[i]; rest != 0; rest &= rest - 1) {
                const std::uint32_t w = 64 * i + lowest_bit(rest);
                if (w >= v) break;
                if (!f(simplices_.row(v).rank_of(w))) return false;
            }
        return true;
    }

private:
    const std::uint64_t* row(std::uint32_t v) const { return bits_ + std::size_t{v} * words_; }
    bool has(std::uint32_t v, std::uint32_t w) const { return (row(v)[w >> 6] >> (w & 63) & 1) != 0; }
    void flip(std::uint32_t v, std::uint32_t w) {
        bits_[std::size_t{v} * words_ + (w >> 6)] ^= std::uint64_t{1} << (w & 63);
        degree_[v] += has(v, w) ? 1 : ~std::uint32_t{0};
    }

    const RipsSimplices& simplices_;
    std::uint64_t* bits_ = nullptr;    // [vertices][words_]
    std::uint32_t* degree_ = nullptr;  // [vertices], bits in the row
    std::uint32_t words_ = 0;
};

}  // namespace netmesh
