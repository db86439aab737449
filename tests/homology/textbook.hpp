// Diagrams and cycles of a lower-star filtration against the textbook reduction.
#pragma once
#include <doctest/doctest.h>

#include "boundaries.hpp"
#include "common/block.hpp"
#include "homology/cycles/cycles.hpp"

namespace textbook {

// In all degrees, with and without pairs of zero length. f: the filtration with every simplex.
template <int D>
void check_diagrams(const netmesh::LowerStarFiltration<D>& filtration, const oracle::Filtered& f, Block& block) {
    const auto complete = oracle::diagram(f, D - 1, true);
    for (std::uint32_t degree = 0; degree <= D; ++degree) {
        for (const bool keep : {false, true}) {
            std::vector<netmesh::Pair> expected;
            for (const netmesh::Pair& p : complete) {
                if (p.degree <= degree && (keep || p.birth != p.death)) expected.push_back(p);
            }
            const std::size_t low = block.arena.low_mark(), high = block.arena.high_mark();
            netmesh::Monitor monitor;
            netmesh::CountedPairs diagram;
            REQUIRE(netmesh::persist_lower_star<D>(filtration, {degree, keep}, {block.arena, monitor}, &diagram) ==
                    netmesh::Status::ok);
            const netmesh::PairList& out = diagram.pairs;
            CHECK(diagram.simplices == f.simplices.size());
            REQUIRE(oracle::same(expected, out));
            CHECK(block.arena.high_mark() == high);
            CHECK(out.count > 0);
            CHECK(block.arena.low_mark() == block.arena.offset_of(out.pairs + out.count));
            block.arena.release_low(low);
        }
    }
}

// The simplices of a cycle as positions in the filtration, ascending.
inline oracle::Column chain_of(const oracle::Boundaries& boundaries, const netmesh::Cycle& cycle,
                               std::uint32_t degree) {
    oracle::Column chain;
    for (std::uint32_t i = 0; i < cycle.count; ++i) {
        const std::uint32_t* const vertices = cycle.simplices + std::size_t{i} * (degree + 1);
        oracle::Simplex s(vertices, vertices + degree + 1);
        std::sort(s.begin(), s.end());
        chain.push_back(boundaries.index(s));
    }
    std::sort(chain.begin(), chain.end());
    CHECK(std::adjacent_find(chain.begin(), chain.end()) == chain.end());
    return chain;
}

// Each cycle is one, is born and dies with its pair.
template <int D>
void check_cycles(const netmesh::LowerStarFiltration<D>& filtration, const oracle::Filtered& f, Block& block) {
    const oracle::Boundaries boundaries(f);
    for (std::uint32_t degree = 0; degree <= D; ++degree) {
        CAPTURE(degree);
        const auto expected = oracle::diagram(f, std::min<std::uint32_t>(degree, D - 1), false);
        const std::size_t low = block.arena.low_mark(), high = block.arena.high_mark();
        netmesh::Monitor monitor;
        netmesh::Representatives found = {};
        REQUIRE(netmesh::lower_star_cycles<D>(filtration, degree, expected.size(), {block.arena, monitor}, &found) ==
                netmesh::Status::ok);
        const netmesh::PairList& out = found.pairs;
        REQUIRE(oracle::same(expected, out));
        CHECK(block.arena.high_mark() == high);
        for (std::uint64_t i = 0; i < out.count; ++i) {
            CAPTURE(i);
            const netmesh::Pair& pair = out.pairs[i];
            const auto chain =
                chain_of(boundaries, netmesh::lower_star_cycle(found.store, block.arena, pair), pair.degree);
            REQUIRE(!chain.empty());
            if (pair.degree == 0) CHECK(chain.size() == (pair.death == __builtin_inf() ? 1 : 2));
            if (pair.degree > 0) CHECK(boundaries.boundary(chain).empty());
            CHECK(f.values[chain.back()] == pair.birth);
            CHECK(boundaries.death(chain) == pair.death);
        }
        block.arena.release_low(low);
    }
}

}  // namespace textbook
