// Explicit filtrations against known homology and the textbook reduction.
#include <doctest/doctest.h>

#include <random>

#include "block.hpp"
#include "complexes.hpp"
#include "oracle.hpp"

using namespace netmesh;
using oracle::Simplex;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<std::uint32_t> betti(const std::vector<Simplex>& maximal) {
    const auto f = oracle::filter(oracle::all_faces(maximal), [](const Simplex& s) { return double(s.size()); });
    const oracle::Explicit e(f);
    Block block(1 << 20);
    Monitor monitor;
    PairList out;
    REQUIRE(persist_homology(e.complex, {e.complex.dimension, true}, {block.arena, monitor}, &out) == Status::ok);
    CHECK(oracle::same(oracle::diagram(f, e.complex.dimension, true), out));
    block.arena.release_low(0);
    REQUIRE(persist_cohomology(e.complex, {e.complex.dimension, true}, {block.arena, monitor}, &out) == Status::ok);
    CHECK(oracle::same(oracle::diagram(f, e.complex.dimension, true), out));
    std::vector<std::uint32_t> b(e.complex.dimension + 1);
    for (std::uint64_t i = 0; i < out.count; ++i) {
        if (out.pairs[i].death == infinity) ++b[out.pairs[i].degree];
    }
    return b;
}

}  // namespace

TEST_CASE("Betti numbers over Z/2 of known complexes") {
    using B = std::vector<std::uint32_t>;
    CHECK(betti({{0}}) == B{1});
    CHECK(betti({{0}, {1}, {2}}) == B{3});
    CHECK(betti({{0, 1}, {1, 2}, {0, 2}}) == B{1, 1});
    CHECK(betti({{0, 1, 2, 3, 4, 5, 6, 7}}) == B{1, 0, 0, 0, 0, 0, 0, 0});
    for (std::uint32_t d = 1; d <= 6; ++d) {
        B expected(d + 1);
        expected[0] = expected[d] = 1;
        CHECK(betti(sphere(d)) == expected);
    }
    CHECK(betti(glued_square(5, false)) == B{1, 2, 1});
    CHECK(betti(glued_square(5, true)) == B{1, 2, 1});  // Klein bottle
    CHECK(betti(projective_plane) == B{1, 1, 1});
}

TEST_CASE("a diagram by hand: a square that closes, then fills") {
    const std::map<Simplex, double> value = {{{0}, 0.},    {{1}, 0.},       {{2}, 1.},      {{3}, 1.},
                                             {{0, 1}, 1.}, {{1, 2}, 2.},    {{2, 3}, 3.},   {{0, 3}, 4.},
                                             {{0, 2}, 5.}, {{0, 1, 2}, 6.}, {{0, 2, 3}, 7.}};
    std::vector<Simplex> simplices;
    for (const auto& entry : value) simplices.push_back(entry.first);
    const oracle::Explicit e(oracle::filter(simplices, [&](const Simplex& s) { return value.at(s); }));
    Block block(1 << 16);
    Monitor monitor;
    PairList out;
    REQUIRE(persist_homology(e.complex, {2, false}, {block.arena, monitor}, &out) == Status::ok);
    const std::vector<Pair> expected = {{0, 1, 0, 0}, {0, infinity, 0, 0}, {1, 2, 0, 0},
                                        {1, 3, 0, 0}, {4, 7, 1, 0},        {5, 6, 1, 0}};
    CHECK(oracle::same(expected, out));
}

TEST_CASE("random filtrations equal the textbook reduction") {
    std::mt19937 random(7);
    Block block(1 << 22);
    for (int round = 0; round < 60; ++round) {
        const std::uint32_t dimension = 1 + random() % 5;
        const auto f = random_filtration(random, 6 + random() % 10, dimension, 1 + random() % 30, 1 + random() % 40);
        const oracle::Explicit e(f);
        for (std::uint32_t degree = 0; degree <= dimension + 1; ++degree) {
            for (const bool keep : {false, true}) {
                const std::size_t low = block.arena.low_mark(), high = block.arena.high_mark();
                Monitor monitor;
                PairList out;
                REQUIRE(persist_homology(e.complex, {degree, keep}, {block.arena, monitor}, &out) == Status::ok);
                CHECK(oracle::same(oracle::diagram(f, degree, keep), out));
                CHECK(block.arena.high_mark() == high);
                CHECK(out.count > 0);
                CHECK(block.arena.low_mark() == block.arena.offset_of(out.pairs + out.count));
                block.arena.release_low(low);
                REQUIRE(persist_cohomology(e.complex, {degree, keep}, {block.arena, monitor}, &out) == Status::ok);
                CHECK(oracle::same(oracle::diagram(f, degree, keep), out));
                CHECK(block.arena.high_mark() == high);
                block.arena.release_low(low);
            }
        }
    }
}

TEST_CASE("every arena size gives the diagram or out_of_memory") {
    std::mt19937 random(11);
    const auto f = random_filtration(random, 14, 4, 40, 1000);
    const oracle::Explicit e(f);
    const auto expected = oracle::diagram(f, 4, false);
    bool fitted = false;
    for (std::size_t bytes = 0; bytes < 60000; bytes += 16) {
        Block block(bytes);
        Monitor monitor;
        PairList out;
        const Status status = persist_homology(e.complex, {4, false}, {block.arena, monitor}, &out);
        if (status == Status::ok) {
            fitted = true;
            REQUIRE(oracle::same(expected, out));
        } else {
            REQUIRE(status == Status::out_of_memory);
            REQUIRE(!fitted);
            REQUIRE(block.arena.bytes_used() == 0);
            REQUIRE(block.arena.bytes_wanted() > bytes);
        }
    }
    CHECK(fitted);
}
