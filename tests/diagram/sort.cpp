#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "diagram/sort.hpp"
#include "numerics/sort.hpp"

using netmesh::Pair;

namespace {

bool equal(const Pair& a, const Pair& b) { return a.birth == b.birth && a.death == b.death && a.degree == b.degree; }

void check(std::vector<Pair> pairs) {
    auto expected = pairs;
    std::sort(expected.begin(), expected.end(), netmesh::before);
    netmesh::sort_pairs(pairs.data(), pairs.size());
    CHECK(std::equal(pairs.begin(), pairs.end(), expected.begin(), equal));
}

}  // namespace

TEST_CASE("pairs are sorted by degree, then birth, then death") {
    std::vector<Pair> pairs = {
        {1, 2, 1, 0}, {0, 3, 1, 0}, {0, 2, 1, 0}, {5, std::numeric_limits<double>::infinity(), 0, 0}, {5, 6, 0, 0}};
    netmesh::sort_pairs(pairs.data(), pairs.size());
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
            std::sort(pairs.begin(), pairs.end(), netmesh::before);
            check(pairs);
            std::reverse(pairs.begin(), pairs.end());
            check(pairs);
        }
    }
}

TEST_CASE("heapsort, which takes over where quicksort degenerates") {
    std::mt19937 random(4);
    const auto less = [](unsigned a, unsigned b) { return a < b; };
    for (const std::size_t count : {0, 1, 2, 3, 10, 1001}) {
        std::vector<unsigned> items(count);
        for (unsigned& item : items) item = random() % 500;
        netmesh::heap_sort(items.data(), items.size(), less);
        CHECK(std::is_sorted(items.begin(), items.end()));
    }
    // An order of comparisons that makes median-of-three split badly again and again.
    std::vector<unsigned> items(20000);
    for (unsigned i = 0; i < items.size(); ++i) items[i] = i % 2 == 0 ? i : 20000 - i;
    netmesh::sort(items.data(), items.size(), less);
    CHECK(std::is_sorted(items.begin(), items.end()));
}
