// Times at which values meet: against whole numbers, and against what is known of numbers that those do not hold.
#include "homology/vineyard/crossing.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

using namespace netmesh;

namespace {

int sign_of(std::int64_t x) { return (x > 0) - (x < 0); }

// By the doubles' times as far as those decide, as the vineyard does.
int order(const Crossing& x, const Crossing& y) {
    const double s = time_of(x), t = time_of(y);
    return t > may_equal(s) ? -1 : s > may_equal(t) ? 1 : compare_times(x, y);
}

void check(const Crossing& x, const Crossing& y, int expected) {
    CHECK(order(x, y) == expected);
    CHECK(order(y, x) == -expected);
    CHECK(compare_times(x, y) == expected);
    CHECK(compare_times(y, x) == -expected);
    CHECK(compare_products(x, y) == expected);
}

}  // namespace

TEST_CASE("sums of products: signs against whole numbers, of all magnitudes") {
    std::mt19937_64 random(41);
    for (int run = 0; run < 20000; ++run) {
        const int bits = 1 + static_cast<int>(random() % 29);
        const auto draw = [&] { return static_cast<std::int64_t>(random() >> (64 - bits)) - (1 << (bits - 1)); };
        ProductSum sum;
        std::int64_t expected = 0;
        const int x_exponent = static_cast<int>(random() % 1900) - 1000,
                  y_exponent = static_cast<int>(random() % 1900) - 1000;
        for (int i = 0; i < 8; ++i) {
            const std::int64_t x = draw(), y = draw();
            const double sx = std::ldexp(double(x), x_exponent), sy = std::ldexp(double(y), y_exponent);
            i % 2 == 0 ? sum.add(sx, sy) : sum.subtract(sx, sy);
            expected += i % 2 == 0 ? x * y : -x * y;
        }
        CHECK(sum.sign() == sign_of(expected));
    }
    const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
    ProductSum sum;
    CHECK(sum.sign() == 0);
    for (int i = 0; i < 1000; ++i) sum.add(most, most);
    sum.subtract(least, least);
    CHECK(sum.sign() == 1);
    for (int i = 0; i < 1000; ++i) sum.subtract(most, most);
    CHECK(sum.sign() == -1);
    sum.add(-least, -least);
    CHECK(sum.sign() == 0);
    sum.add(-least, least);
    CHECK(sum.sign() == -1);
}

TEST_CASE("the order of crossings against whole numbers") {
    std::mt19937 random(42);
    int equal = 0;
    for (int run = 0; run < 50000; ++run) {
        const std::uint32_t levels = run % 2 == 0 ? 8 : 1u << 29;
        const auto draw = [&](Crossing* c, std::int64_t* p, std::int64_t* q) {
            do {
                std::int64_t v[4];
                for (std::int64_t& x : v) x = random() % levels;
                *c = {{double(v[0]), double(v[1])}, {double(v[2]), double(v[3])}};
                *p = v[2] - v[0];
                *q = v[1] - v[3];
            } while (*p < 0 || *q < 0 || (*p == 0 && *q == 0));
        };
        Crossing x, y;
        std::int64_t px, qx, py, qy;
        draw(&x, &px, &qx);
        draw(&y, &py, &qy);
        const int expected = sign_of(px * qy - py * qx);
        equal += expected == 0;
        check(x, y, expected);
    }
    CHECK(equal > 500);
}

// The same lines times a power of two meet at the same time; it is later when p grows by a unit in the last place, and
// earlier when q does.
TEST_CASE("the order of crossings that differ by one unit in the last place") {
    std::mt19937_64 random(43);
    for (int run = 0; run < 20000; ++run) {
        const auto draw = [&] { return std::ldexp(double(random() >> 11), static_cast<int>(random() % 40) - 20); };
        Crossing x = {{draw(), draw()}, {draw(), draw()}};
        if (x.a.from > x.b.from) std::swap(x.a.from, x.b.from);
        if (x.a.to < x.b.to) std::swap(x.a.to, x.b.to);
        if (x.a.from == x.b.from || x.a.to == x.b.to) continue;
        const int exponent = static_cast<int>(random() % 1800) - 900;
        const auto scaled = [&](double v) { return std::ldexp(v, exponent); };
        Crossing y = {{scaled(x.a.from), scaled(x.a.to)}, {scaled(x.b.from), scaled(x.b.to)}};
        check(x, y, 0);
        Crossing later = y, earlier = y;
        later.b.from = std::nextafter(later.b.from, HUGE_VAL);
        earlier.a.to = std::nextafter(earlier.a.to, HUGE_VAL);
        check(x, later, -1);
        check(x, earlier, 1);
    }
    const double most = std::numeric_limits<double>::max(), least = std::numeric_limits<double>::denorm_min();
    const Crossing widest = {{-most, most}, {most, -most}}, narrow = {{0, least}, {least, 0}};
    check(widest, narrow, 0);
    CHECK(time_of(widest) == 0.5);
    const Crossing early = {{0, most}, {least, -most}}, late = {{-most, least}, {most, 0}};
    check(early, late, -1);
    check({{0, most}, {0, 0}}, early, -1);
    check({{0, 3}, {1, 3}}, late, 1);
}
