// Sorting by comparisons.
#include "numerics/sort.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

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
