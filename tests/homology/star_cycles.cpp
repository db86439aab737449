// Cycles of lower-star filtrations against the textbook reduction: each is one, is born and dies with its pair, and no
// cycle is a sum of others up to what has died before.
#include <doctest/doctest.h>

#include "boundaries.hpp"
#include "common/block.hpp"
#include "grid.hpp"
#include "homology/cycles/cycles.hpp"
#include "served.hpp"

using namespace netmesh;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <int D>
Status run(const grid::Ball<D>& ball, const std::vector<double>& value, std::uint32_t zero_born, std::uint32_t degree,
           std::uint64_t pairs, Block& block, Representatives* out) {
    Monitor monitor;
    return served::lower_star_cycles<D>({ball.view(), value.data(), zero_born}, degree, pairs, {block.arena, monitor},
                                        out);
}

// The simplices of a cycle as positions in the filtration, ascending.
oracle::Column chain_of(const oracle::Boundaries& boundaries, const Cycle& cycle, std::uint32_t degree) {
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

template <int D>
void check(const grid::Ball<D>& ball, const std::vector<double>& value, std::uint32_t zero_born, Block& block) {
    const auto f = oracle::lower_star(oracle::all_faces(ball.cells()), value, zero_born);
    const oracle::Boundaries boundaries(f);
    for (std::uint32_t degree = 0; degree <= D; ++degree) {
        CAPTURE(degree);
        const auto expected = oracle::diagram(f, std::min<std::uint32_t>(degree, D - 1), false);
        const std::size_t low = block.arena.low_mark(), high = block.arena.high_mark();
        Representatives found = {};
        REQUIRE(run(ball, value, zero_born, degree, expected.size(), block, &found) == Status::ok);
        const PairList& out = found.pairs;
        REQUIRE(oracle::same(expected, out));
        CHECK(block.arena.high_mark() == high);
        for (std::uint64_t i = 0; i < out.count; ++i) {
            CAPTURE(i);
            const Pair& pair = out.pairs[i];
            const auto chain = chain_of(boundaries, lower_star_cycle(found.store, block.arena, pair), pair.degree);
            REQUIRE(!chain.empty());
            if (pair.degree == 0) CHECK(chain.size() == (pair.death == infinity ? 1 : 2));
            if (pair.degree > 0) CHECK(boundaries.boundary(chain).empty());
            CHECK(f.values[chain.back()] == pair.birth);
            CHECK(boundaries.death(chain) == pair.death);
        }
        block.arena.release_low(low);
    }
}

template <int D> void check_values(const grid::Ball<D>& ball, std::mt19937& random) {
    if (!serves_dimension(D)) return;
    Block block(std::size_t{16} << 20);
    std::vector<double> value(ball.vertex_count);
    for (const std::uint32_t levels : {0u, 3u, 20u}) {
        for (double& t : value) t = levels == 0 ? double(random()) / 4294967296.0 : double(random() % levels);
        check<D>(ball, value, 0, block);
        check<D>(ball, value, ball.vertex_count / 2, block);
    }
}

}  // namespace

TEST_CASE("cycles on grids") {
    std::mt19937 random(31);
    check_values<2>(grid::link<2>({{0, 1, 2}}, 3), random);
    check_values<6>(grid::link<6>({{0, 1, 2, 3, 4, 5, 6}}, 7), random);
    check_values<2>(grid::freudenthal<2>({12, 9}, random), random);
    check_values<3>(grid::freudenthal<3>({5, 4, 4}, random), random);
    check_values<4>(grid::freudenthal<4>({2, 2, 3, 2}, random), random);
    check_values<5>(grid::freudenthal<5>({2, 1, 1, 1, 1}, random), random);
}
TEST_CASE("cycles on balls with vertices of very different degrees") {
    std::mt19937 random(32);
    for (int round = 0; round < 4; ++round) {
        check_values<2>(grid::irregular<2>(80, random), random);
        check_values<3>(grid::irregular<3>(60, random), random);
        check_values<4>(grid::irregular<4>(25, random), random);
        check_values<5>(grid::irregular<5>(12, random), random);
        check_values<6>(grid::irregular<6>(5, random), random);
    }
}
TEST_CASE("every arena size gives the cycles or out_of_memory") {
    if (!serves_dimension(4)) return;
    std::mt19937 random(33);
    const auto ball = grid::freudenthal<4>({2, 2, 2, 2}, random);
    std::vector<double> value(ball.vertex_count);
    for (double& t : value) t = double(random() % 1000);
    const auto f = oracle::lower_star(oracle::all_faces(ball.cells()), value, 0);
    const auto expected = oracle::diagram(f, 3, false);
    bool enough = false;
    std::size_t bytes = 0;
    for (; !enough; bytes += 1 << 12) {
        Block block(bytes);
        Representatives found;
        const Status status = run(ball, value, 0, 3, expected.size(), block, &found);
        enough = status == Status::ok;
        if (enough) {
            CHECK(oracle::same(expected, found.pairs));
        } else {
            REQUIRE(status == Status::out_of_memory);
            CHECK(block.arena.bytes_used() == 0);
        }
    }
    CHECK(bytes > std::size_t{1} << 14);
}
