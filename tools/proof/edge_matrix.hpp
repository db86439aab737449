// A sum of coboundaries of edges in a dense graph, as the edges that are in it: a symmetric matrix of bits over the
// vertices. A triangle is in the sum if an odd number of its edges is in that set, so an addition flips two bits, where
// a heap takes in as many triangles as there are vertices.
#pragma once
#include <cstdint>
#include <vector>

#include "tools/proof/rips_cliques.hpp"

namespace netmesh::tool {

class EdgeMatrix {
public:
    explicit EdgeMatrix(const RipsCliques& cliques) : cliques_(cliques), n_(cliques.vertices()) {
        const std::uint64_t joined = 2 * std::uint64_t{cliques.edge_count()} / n_;
        if (joined < n_ / 16) return;
        many_ = 2 + n_ * std::size_t{n_} / (64 * (joined + 1));
    }
    // After so many additions the matrix is smaller than a heap.
    std::size_t many() const { return many_; }

    // The empty sum.
    void open() {
        words_ = (n_ + 63) / 64;
        bits_.assign(std::size_t{n_} * words_, 0);
        degree_.assign(n_, 0);
        if (!rank_.empty()) return;
        rank_.assign(std::size_t{n_} * n_, UINT32_MAX);
        for (std::uint32_t e = 0; e < cliques_.edge_count(); e++) {
            const RipsEdge& edge = cliques_.edge(e);
            rank_[std::size_t{edge.larger} * n_ + edge.smaller] = e;
            rank_[std::size_t{edge.smaller} * n_ + edge.larger] = e;
        }
    }
    void toggle(RipsCliques::Key edge) {
        const auto rank = static_cast<std::uint32_t>(edge);
        flip(cliques_.edge(rank).larger, cliques_.edge(rank).smaller);
        flip(cliques_.edge(rank).smaller, cliques_.edge(rank).larger);
    }
    // The first triangle, where none has an earlier last edge than this one.
    RipsCliques::Key first(RipsCliques::Key triangle) const {
        for (std::uint32_t rank = cliques_.last_edge(triangle, 2); rank < cliques_.edge_count(); rank++) {
            const std::uint32_t a = cliques_.edge(rank).smaller, b = cliques_.edge(rank).larger;
            if ((degree_[a] | degree_[b]) == 0) continue;
            const std::uint64_t *const at_a = &bits_[a * words_], *const at_b = &bits_[b * words_];
            const std::uint64_t both = (at_a[b / 64] >> b % 64 & 1) != 0 ? ~std::uint64_t{0} : 0;
            for (std::size_t i = 0; i < words_; i++)
                for (std::uint64_t odd = at_a[i] ^ at_b[i] ^ both; odd != 0; odd &= odd - 1) {
                    const auto w = static_cast<std::uint32_t>(64 * i) + lowest_bit(odd);
                    if (w >= n_) break;
                    if (rank_[std::size_t{a} * n_ + w] < rank && rank_[std::size_t{b} * n_ + w] < rank)
                        return cliques_.key_of(rank, &w, 1);
                }
        }
        return RipsCliques::no_key;
    }
    // The edges that were added an odd number of times, by rank.
    void list(std::vector<RipsCliques::Key>* ranks) const {
        for (std::uint32_t e = 0; e < cliques_.edge_count(); e++) {
            const RipsEdge& edge = cliques_.edge(e);
            if ((bits_[edge.larger * words_ + edge.smaller / 64] >> edge.smaller % 64 & 1) != 0) ranks->push_back(e);
        }
    }

private:
    static std::uint32_t lowest_bit(std::uint64_t word) {
        std::uint32_t at = 0;
        for (std::uint32_t half = 32; half > 0; half /= 2)
            if ((word & ((std::uint64_t{1} << half) - 1)) == 0) word >>= half, at += half;
        return at;
    }
    void flip(std::uint32_t v, std::uint32_t w) {
        std::uint64_t& word = bits_[v * words_ + w / 64];
        word ^= std::uint64_t{1} << w % 64;
        degree_[v] += (word >> w % 64 & 1) != 0 ? 1u : UINT32_MAX;
    }

    const RipsCliques& cliques_;
    std::uint32_t n_;
    std::size_t words_ = 0, many_ = SIZE_MAX;
    std::vector<std::uint64_t> bits_;    // [n][words_]
    std::vector<std::uint32_t> degree_;  // bits in each row
    std::vector<std::uint32_t> rank_;    // [n][n] of edges, UINT32_MAX where there is none
};

}  // namespace netmesh::tool
