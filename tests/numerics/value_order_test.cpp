#include "numerics/value_order.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "complex/triangulations.hpp"
#include "memory/prefetch.hpp"

using namespace netmesh;
using namespace netmesh_test;

namespace {

void check_sort(const std::vector<double>& value) {
    Block block(1 << 16);
    std::vector<std::uint32_t> expected(value.size()), position(value.size());
    std::iota(expected.begin(), expected.end(), 0u);
    std::stable_sort(expected.begin(), expected.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return value[a] < value[b]; });
    std::vector<double> sorted = value;
    REQUIRE(sort_values(sorted.data(), position.data(), static_cast<std::uint32_t>(value.size()), block.arena));
    CHECK(position == expected);
    CHECK(std::is_sorted(sorted.begin(), sorted.end()));
    CHECK(block.arena.bytes_used() == 0);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < value.size(); ++i) differ += sorted[i] != value[expected[i]];
    CHECK(differ == 0);
}

template <class F> std::vector<double> values(std::size_t n, F f) {
    std::vector<double> v(n);
    for (double& x : v) x = f();
    return v;
}

}  // namespace

TEST_CASE("values are sorted as by a stable sort") {
    Random random;
    for (std::size_t n : {0u, 1u, 2u, 39u, 40u, 41u, 257u, 5000u, 200000u}) {
        CAPTURE(n);
        check_sort(values(n, [&] { return random.unit(); }));
        check_sort(values(n, [&] { return 0.0; }));
        check_sort(values(n, [&] { return random.unit() - 0.5; }));
        check_sort(values(n, [&] { return -1 - static_cast<double>(random.below(3)); }));
        check_sort(values(n, [&] { return static_cast<double>(random.below(3)); }));
        check_sort(values(n, [&] { return std::ldexp(random.unit(), static_cast<int>(random.below(2000)) - 1000); }));
        check_sort(values(n, [&] { return 1 + random.below(1000) * 0x1p-52; }));
        check_sort(values(n, [&] { return random.below(2) == 0 ? 0x1p-1074 * random.below(9) : 1e300; }));
    }
    check_sort({1, std::numeric_limits<double>::infinity(), 0, std::numeric_limits<double>::infinity()});
}

TEST_CASE("what is listed is sorted as by a stable sort") {
    Random random;
    for (std::uint32_t n : {0u, 1u, 50u, 3000u, 100000u}) {
        for (const std::uint32_t kind : {0u, 1u, 2u, 3u}) {
            CAPTURE(n);
            CAPTURE(kind);
            const std::vector<double> value = values(n, [&] {
                if (kind == 0) return random.unit();
                if (kind == 1) return static_cast<double>(random.below(3));
                if (kind == 2) return std::ldexp(random.unit(), static_cast<int>(random.below(2000)) - 1000);
                return 1 + random.below(1000) * 0x1p-52;
            });
            std::vector<std::uint32_t> expected, label(n);
            std::vector<bool> listed(n);
            for (std::uint32_t i = 0; i < n; ++i) {
                listed[i] = kind == 0 || random.below(3) > 0;
                if (listed[i]) expected.push_back(i);
            }
            std::stable_sort(expected.begin(), expected.end(),
                             [&](std::uint32_t a, std::uint32_t b) { return value[a] < value[b]; });
            std::vector<double> sorted(n);
            Block block(1 << 17);
            const auto is_listed = [&](std::uint32_t i) { return bool(listed[i]); };
            REQUIRE(sort_listed(value.data(), n, is_listed, sorted.data(), label.data(), block.arena));
            CHECK(block.arena.bytes_used() == 0);
            label.resize(expected.size());
            CHECK(label == expected);
            std::size_t differ = 0;
            for (std::size_t i = 0; i < expected.size(); ++i) differ += sorted[i] != value[expected[i]];
            CHECK(differ == 0);
            Block small(256);
            if (n > 0 && jumps_matter)
                CHECK(!sort_listed(value.data(), n, is_listed, sorted.data(), label.data(), small.arena));
        }
    }
}

TEST_CASE("sorted and reversed sequences") {
    std::vector<double> up(10000);
    for (std::size_t i = 0; i < up.size(); ++i) up[i] = std::sqrt(static_cast<double>(i));
    check_sort(up);
    std::reverse(up.begin(), up.end());
    check_sort(up);
}

TEST_CASE("without scratch nothing happens") {
    Block block(1024);
    std::vector<double> value = {3, 2, 1};
    std::vector<std::uint32_t> position = {7, 7, 7};
    CHECK(!sort_values(value.data(), position.data(), 3, block.arena));
    CHECK(value == std::vector<double>{3, 2, 1});
    CHECK(position == std::vector<std::uint32_t>{7, 7, 7});
    CHECK(block.arena.bytes_used() == 0);
}
