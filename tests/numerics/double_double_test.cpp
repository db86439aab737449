#include "numerics/double_double.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>

#include "complex/triangulations.hpp"

using namespace netmesh;
using netmesh_test::Random;

namespace {

DoubleDouble random_number(Random& random) {
    const double high = (random.unit() - 0.5) * std::ldexp(1.0, static_cast<int>(random.below(40)) - 20);
    return quick_two_sum(high, high * (random.unit() - 0.5) * 0x1p-53);
}

double relative(DoubleDouble difference, DoubleDouble to) { return std::fabs(difference.high / to.high); }

}  // namespace

TEST_CASE("products and sums of two doubles are exact") {
    Random random;
    for (int i = 0; i < 20000; ++i) {
        const auto a = static_cast<std::int64_t>(random.bits() >> random.below(40) >> 11);
        const auto b = static_cast<std::int64_t>(random.bits() >> random.below(40) >> 11);
        const DoubleDouble p = exact_product(static_cast<double>(a), static_cast<double>(b));
        CHECK(std::fabs(p.low) <= std::fabs(p.high) * 0x1p-53);
        // Both sides modulo 2^64; the high part is an integer of at most 106 bits.
        const auto high = static_cast<std::uint64_t>(std::fmod(p.high, 0x1p64));
        const auto low = static_cast<std::uint64_t>(static_cast<std::int64_t>(p.low));
        CHECK(high + low == static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b));
        const DoubleDouble s = exact_sum(static_cast<double>(a) * 0x1p40, static_cast<double>(b));
        CHECK(s.high == static_cast<double>(a) * 0x1p40 + static_cast<double>(b));
        const double rest = (s.high - static_cast<double>(a) * 0x1p40);
        CHECK(s.low == static_cast<double>(b) - rest);
    }
}

TEST_CASE("the field laws hold to about 2^-100") {
    Random random;
    for (int i = 0; i < 20000; ++i) {
        const DoubleDouble a = random_number(random), b = random_number(random), c = random_number(random);
        if (std::fabs(a.high) < 0x1p-30 || std::fabs(b.high) < 0x1p-30 || std::fabs(c.high) < 0x1p-30) continue;
        CHECK(relative(a / b * b - a, a) < 0x1p-98);
        CHECK(relative((a * b) * c - a * (b * c), a * b * c) < 0x1p-99);
        const DoubleDouble left = a * (b + c), right = a * b + a * c;
        const double size = std::fabs(a.high) * (std::fabs(b.high) + std::fabs(c.high));
        CHECK(std::fabs((left - right).high) < size * 0x1p-99);
        CHECK(relative((a + b) - b - a, {std::fabs(a.high) + std::fabs(b.high), 0}) < 0x1p-99);
    }
}

TEST_CASE("square roots of squares come back") {
    Random random;
    for (int i = 0; i < 20000; ++i) {
        const double a = random.unit() + 0x1p-40;
        CHECK(square_root(exact_product(a, a)) == a);
    }
    CHECK(square_root({0, 0}) == 0);
    CHECK(square_root({2, 0}) == 1.4142135623730951);
}
