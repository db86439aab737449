// The canonical order of diagrams, and their short form.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "common/block.hpp"
#include "diagram/pair.hpp"
#include "numerics/sort.hpp"

using netmesh::CanonicalOrder;
using netmesh::Pair;

namespace {

bool equal(const Pair& a, const Pair& b) { return a.birth == b.birth && a.death == b.death && a.degree == b.degree; }

void check(std::vector<Pair> pairs) {
    auto expected = pairs;
    std::sort(expected.begin(), expected.end(), CanonicalOrder{});
    netmesh::sort(pairs.data(), pairs.size(), CanonicalOrder{});
    CHECK(std::equal(pairs.begin(), pairs.end(), expected.begin(), equal));
}

}  // namespace

TEST_CASE("pairs are sorted by degree, then birth, then death") {
    std::vector<Pair> pairs = {
        {1, 2, 1, 0}, {0, 3, 1, 0}, {0, 2, 1, 0}, {5, std::numeric_limits<double>::infinity(), 0, 0}, {5, 6, 0, 0}};
    netmesh::sort(pairs.data(), pairs.size(), CanonicalOrder{});
    CHECK(equal(pairs[0], {5, 6, 0, 0}));
    CHECK(equal(pairs[1], {5, std::numeric_limits<double>::infinity(), 0, 0}));
    CHECK(equal(pairs[2], {0, 2, 1, 0}));
    CHECK(equal(pairs[3], {0, 3, 1, 0}));
    CHECK(equal(pairs[4], {1, 2, 1, 0}));
}

TEST_CASE("any number of pairs, any number of ties") {
    std::mt19937 random(3);
    check({});
    for (const std::size_t count : {1, 2, 3, 24, 25, 26, 100, 1000, 5000}) {
        for (const unsigned levels : {1u, 2u, 10u, 1000000u}) {
            std::vector<Pair> pairs(count);
            for (Pair& p : pairs)
                p = {double(random() % levels), double(random() % levels), std::uint32_t(random() % 3), 0};
            check(pairs);
            std::sort(pairs.begin(), pairs.end(), CanonicalOrder{});
            check(pairs);
            std::reverse(pairs.begin(), pairs.end());
            check(pairs);
        }
    }
}

// In any numbers of pairs of each degree, none among them.
TEST_CASE("short pairs are the same pairs without cycles, in two thirds of the memory") {
    constexpr std::uint32_t degrees = netmesh::dimension_most();
    std::mt19937 random(3);
    for (int trial = 0; trial < 200; ++trial) {
        Block block(1 << 14);
        std::vector<Pair> pairs;
        for (std::uint32_t degree = 0; degree < degrees; ++degree) {
            for (std::uint32_t count = random() % 4; count > 0; --count)
                pairs.push_back({double(random() % 9), 9 + double(random() % 9), degree, 0});
        }
        REQUIRE(block.arena.take_low<std::uint64_t>(netmesh::BarList::counts) != nullptr);
        const netmesh::PairList list = {block.arena.take_low<Pair>(pairs.size()), pairs.size()};
        const std::size_t at = block.arena.offset_of(list.pairs);
        std::copy(pairs.begin(), pairs.end(), list.pairs);
        const netmesh::BarList plain = {list.pairs, list.count};
        for (std::size_t i = 0; i < pairs.size(); ++i) REQUIRE(equal(plain[i], pairs[i]));
        netmesh::shorten_pairs(list, block.arena);
        const netmesh::BarList bars = {list.pairs, list.count, true};
        REQUIRE(block.arena.low_mark() == at + 16 * pairs.size());
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            REQUIRE(equal(bars[i], pairs[i]));
            REQUIRE(bars[i].cycle == 0);
        }
    }
}
