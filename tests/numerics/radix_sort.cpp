#include "numerics/radix_sort.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "common/inputs.hpp"

TEST_CASE("radix sort is the stable sort") {
    inputs::Random random(5);
    netmesh::Arena nobody;  // watches
    for (const std::size_t n : {0u, 1u, 2u, 48u, 49u, 1000u, 20000u})
        for (const std::uint64_t mask :
             {~std::uint64_t{0}, std::uint64_t{0xFF00FF00FF}, std::uint64_t{3}, std::uint64_t{0}}) {
            std::vector<std::uint64_t> keys(n), spare_keys(n);
            std::vector<std::uint32_t> items(n), spare_items(n);
            for (std::size_t i = 0; i < n; ++i) {
                keys[i] = random.bits() & mask;
                items[i] = static_cast<std::uint32_t>(i);
            }
            std::vector<std::pair<std::uint64_t, std::uint32_t>> expected;
            for (std::size_t i = 0; i < n; ++i) expected.push_back({keys[i], items[i]});
            std::stable_sort(expected.begin(), expected.end(), [](auto& a, auto& b) { return a.first < b.first; });
            netmesh::radix_sort(keys.data(), items.data(), spare_keys.data(), spare_items.data(), n, nobody);
            for (std::size_t i = 0; i < n; ++i) {
                REQUIRE(keys[i] == expected[i].first);
                REQUIRE(items[i] == expected[i].second);
            }
        }
}
