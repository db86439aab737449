// Bounds of bars and the certificate by scale against phi, psi and psi^- as they are defined, vertex by vertex.
#include "jobs/bar_bounds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "common/block.hpp"
#include "common/inputs.hpp"

using namespace netmesh;

namespace {

struct Filter {
    std::vector<double> t;
    std::vector<Interval> interval;

    double phi(double b) const {
        double most = b;
        for (std::size_t v = 0; v < t.size(); ++v)
            if (t[v] <= b) most = std::max(most, interval[v].hi);
        return most;
    }
    double psi(double a) const {
        double most = a;
        for (std::size_t v = 0; v < t.size(); ++v)
            if (interval[v].lo <= a) most = std::max(most, t[v]);
        return most;
    }
    // The least x with psi(x) >= a; psi rises by steps at the lo of vertices, and is x otherwise.
    double psi_inverse(double a) const {
        double least = a;
        for (const Interval& i : interval)
            if (i.lo < least && psi(i.lo) >= a) least = i.lo;
        return least;
    }
    double ratio(double a) const {
        return a == 0 ? 1 : std::max(phi(a) / a, psi_inverse(a) > 0 ? a / psi_inverse(a) : HUGE_VAL);
    }
    // Where anything changes, one double before and after, and in between.
    std::set<double> scales(inputs::Random& random) const {
        std::set<double> scales = {0};
        for (std::size_t v = 0; v < t.size(); ++v)
            for (const double a : {t[v], interval[v].lo, interval[v].hi})
                scales.insert({a, std::max(std::nextafter(a, 0), 0.0), std::nextafter(a, HUGE_VAL)});
        for (int i = 0; i < 30; ++i)
            scales.insert(std::ldexp(1 + random.uniform(), static_cast<int>(random.below(12)) - 8));
        return scales;
    }
};

// Numbers of few digits, so that many are equal; some values and lo are 0 where asked for.
Filter coarse_filter(inputs::Random& random, bool with_zeros) {
    Filter filter;
    const auto number = [&] {
        return std::ldexp(1 + static_cast<double>(random.below(16)) / 16, static_cast<int>(random.below(8)) - 6);
    };
    for (std::uint64_t left = 1 + random.below(24); left > 0; --left) {
        double lo = number(), hi = number() * 2;
        if (hi < lo) std::swap(lo, hi);
        double t = random.below(4) == 0 ? number() : lo + (hi - lo) * static_cast<double>(random.below(5)) / 4;
        if (with_zeros && random.below(4) == 0) t = 0;
        if (with_zeros && random.below(6) == 0) lo = 0;
        filter.t.push_back(t);
        filter.interval.push_back({lo, hi});
    }
    return filter;
}

// Many values within one step of the curve.
Filter fine_filter(inputs::Random& random) {
    Filter filter;
    const double above = 1 + random.uniform(), below = random.uniform();
    for (int i = 0; i < 40; ++i) {
        const double t = 1 + random.uniform() / 2;
        filter.t.push_back(t);
        filter.interval.push_back({t * (1 - below * random.uniform()), t * (1 + above * random.uniform())});
    }
    return filter;
}

void compare(const Filter& filter, inputs::Random& random) {
    const std::set<double> scales = filter.scales(random);
    std::vector<Pair> pairs;
    for (const double a : scales) pairs.push_back({a, 2 * a, 0, 0});
    std::vector<BarBounds> bounds(pairs.size());
    Block block(std::size_t{1} << 20);
    ScaleCurve curve;
    REQUIRE(bound_by_scale({filter.t.data(), filter.interval.data(), static_cast<std::uint32_t>(filter.t.size())},
                           {pairs.data(), pairs.size()}, {}, block.arena, bounds.data(), &curve) == Status::ok);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const BarBounds& b = bounds[i];
        CHECK(b.birth_low == filter.psi_inverse(pairs[i].birth));
        CHECK(b.birth_high == filter.phi(pairs[i].birth));
        CHECK(b.death_low == filter.psi_inverse(pairs[i].death));
        CHECK(b.death_high == filter.phi(pairs[i].death));
        CHECK(b.certain_after == filter.psi(filter.phi(pairs[i].birth)));
    }
    const double growth = 1 + 1.0 / 16;
    for (std::uint64_t i = 0; i < curve.count; ++i) {
        const ScaleStep& step = curve.steps[i];
        const double next = i + 1 < curve.count ? curve.steps[i + 1].from : HUGE_VAL;
        CHECK(step.from < next);
        double ratio = 1;
        for (auto a = scales.lower_bound(step.from); a != scales.end() && *a < next; ++a) {
            CHECK(filter.psi_inverse(*a) >= std::min(step.low, *a));
            CHECK(filter.phi(*a) <= std::max(step.high, *a));
            const double reach = filter.psi(filter.phi(*a));
            CHECK(reach <= std::max(step.reach, *a));
            // Nor are they much wider than need be.
            CHECK(filter.psi_inverse(*a) <= std::min(step.low, *a) * growth);
            CHECK(filter.phi(*a) * growth >= std::max(step.high, *a));
            CHECK(reach * growth >= std::max(step.reach, *a));
            ratio = std::max(ratio, filter.ratio(*a));
        }
        CHECK(ratio <= step.ratio);
        CHECK(ratio * (1 + 1e-9) >= step.ratio);
    }
    for (const double a : scales)
        if (curve.count > 0 && a < curve.steps[0].from) CHECK(filter.ratio(a) == 1);
}

}  // namespace

TEST_CASE("bounds by scale are phi and psi^-, the curve holds them") {
    inputs::Random random(41);
    for (int i = 0; i < 300; ++i) {
        CAPTURE(i);
        compare(i % 3 == 2 ? fine_filter(random) : coarse_filter(random, i % 3 == 0), random);
    }
}

namespace {

// Of any sign, in eighths and sixteenths, so that many are equal and all sums exact. The values lie in their intervals.
Filter signed_filter(inputs::Random& random, double* error) {
    Filter filter;
    *error = 0;
    const double range = std::ldexp(1, static_cast<int>(random.below(5)));
    for (std::uint64_t left = 1 + random.below(40); left > 0; --left) {
        const double t = range * (static_cast<double>(random.below(33)) - 16) / 8;
        const double below = static_cast<double>(random.below(9)) / 16,
                     above = static_cast<double>(random.below(9)) / 16;
        const bool is_exact = random.below(3) == 0;
        filter.t.push_back(t);
        filter.interval.push_back({is_exact ? t : t - below, is_exact ? t : t + above});
        if (!is_exact) *error = std::max({*error, below, above});
    }
    return filter;
}

}  // namespace

TEST_CASE(
    "bounds by differences are phi and psi^- of any sign, the shift at a that of cells that have a in their interval") {
    inputs::Random random(43);
    int below_all = 0, steps = 0;
    for (int i = 0; i < 400; ++i) {
        CAPTURE(i);
        double error;
        const Filter filter = signed_filter(random, &error);
        if (!(error > 0)) continue;
        std::set<double> scales = {0};
        for (std::size_t v = 0; v < filter.t.size(); ++v)
            for (const double a : {filter.t[v], filter.interval[v].lo, filter.interval[v].hi})
                scales.insert({a, std::nextafter(a, -HUGE_VAL), std::nextafter(a, HUGE_VAL), a + 1.0 / 32});
        std::vector<Pair> pairs;
        for (const double a : scales) pairs.push_back({a, a + 1, 0, 0});
        std::vector<BarBounds> bounds(pairs.size());
        Block block(std::size_t{1} << 20);
        ScaleCurve curve;
        const FilterBounds given = {filter.t.data(), filter.interval.data(),
                                    static_cast<std::uint32_t>(filter.t.size())};
        REQUIRE(bound_by_scale(given, {pairs.data(), pairs.size()}, {error}, block.arena, bounds.data(), &curve) ==
                Status::ok);
        for (std::size_t p = 0; p < pairs.size(); ++p) {
            const BarBounds& b = bounds[p];
            const double birth = pairs[p].birth, death = pairs[p].death;
            CHECK(b.birth_low == filter.psi_inverse(birth));
            CHECK(b.birth_high == filter.phi(birth));
            CHECK(b.death_low == filter.psi_inverse(death));
            CHECK(b.death_high == filter.phi(death));
            CHECK(b.certain_after == filter.psi(filter.phi(birth)));
            CHECK(b.certain == (death > b.certain_after));
            double here = 0;
            for (std::size_t v = 0; v < filter.t.size(); ++v) {
                const Interval cell = filter.interval[v];
                if (cell.lo <= birth && birth <= cell.hi)
                    here = std::max({here, cell.hi - filter.t[v], filter.t[v] - cell.lo});
            }
            CHECK(b.birth_high - birth <= here);
            CHECK(birth - b.birth_low <= here);
            CHECK(b.certain_after - birth <= 2 * error);
            below_all += birth < 0 && b.birth_high < 0;
        }
        steps += static_cast<int>(curve.count);
        for (std::uint64_t s = 0; s < curve.count; ++s) {
            const ScaleStep& step = curve.steps[s];
            const double next = s + 1 < curve.count ? curve.steps[s + 1].from : HUGE_VAL, grown = error / 16;
            CHECK(step.from < next);
            double shift = 0, ratio = 1;
            for (auto a = scales.lower_bound(step.from); a != scales.end() && *a < next; ++a) {
                const double low = filter.psi_inverse(*a), high = filter.phi(*a), reach = filter.psi(high);
                CHECK(low >= std::min(step.low, *a));
                CHECK(high <= std::max(step.high, *a));
                CHECK(reach <= std::max(step.reach, *a));
                CHECK(low <= std::min(step.low, *a) + grown);
                CHECK(high + grown >= std::max(step.high, *a));
                CHECK(reach + grown >= std::max(step.reach, *a));
                shift = std::max({shift, high - *a, *a - low});
                if (*a > 0) ratio = std::max({ratio, high / *a, low > 0 ? *a / low : HUGE_VAL});
            }
            CHECK(shift <= step.error);
            CHECK(shift * (1 + 1e-9) + 1e-12 >= step.error);
            CHECK(step.error <= error * (1 + 1e-9));
            CHECK(ratio <= step.ratio);
        }
        for (const double a : scales)
            if (a < curve.steps[0].from) CHECK((filter.phi(a) == a && filter.psi_inverse(a) == a));
    }
    CHECK(below_all > 1000);
    CHECK(steps > 1000);
}

// Why a bar is not real for being longer than twice the shift at its birth.
TEST_CASE("by differences a bar exists for certain when it dies after psi(phi(birth)), not after twice its shift") {
    const double t[] = {0, 6};
    const Interval interval[] = {{0, 1}, {1, 6}};
    const Pair bar = {0, 5, 0, 0};
    Block block(std::size_t{1} << 16);
    ScaleCurve curve;
    BarBounds bounds;
    REQUIRE(bound_by_scale({t, interval, 2}, {&bar, 1}, {5}, block.arena, &bounds, &curve) == Status::ok);
    CHECK(bounds.birth_high == 1);
    CHECK(bounds.birth_low == 0);
    CHECK(bounds.certain_after == 6);
    CHECK(bounds.certain == 0);
}

TEST_CASE("bounds by one ratio") {
    Block block(std::size_t{1} << 16);
    ScaleCurve curve;
    BarBounds bounds;
    const Pair pair = {2, 3, 1, 0};
    REQUIRE(bound_by_ratio({1.5, 0}, {&pair, 1}, block.arena, &bounds, &curve) == Status::ok);
    REQUIRE(curve.count == 1);
    CHECK(curve.steps[0].from == 0);
    CHECK(curve.steps[0].ratio == 1.5);
    CHECK(bounds.birth_high == 3);
    CHECK(bounds.death_low == 2);
    CHECK(bounds.certain_after == 4.5);
}

TEST_CASE("bounds of true ends that are rounded to nearest") {
    Block block(std::size_t{1} << 16);
    ScaleCurve curve;
    const double next = std::nextafter(2.0, 3.0), least = 0x1p-1074, most = std::numeric_limits<double>::max();
    const Pair pairs[] = {{0, 2, 0, 0},     {2, next, 1, 0},     {2, 2, 1, 0},
                          {0, least, 1, 0}, {3, infinity, 0, 0}, {3, most, 1, 0}};
    BarBounds bounds[6];
    REQUIRE(bound_by_ratio({1, true}, {pairs, 6}, block.arena, bounds, &curve) == Status::ok);
    CHECK(curve.count == 0);
    for (int i = 0; i < 6; ++i) {
        CAPTURE(i);
        const bool vertex = i == 0;
        CHECK(bounds[i].birth_low == std::max(0.0, std::nextafter(pairs[i].birth, 0.0)));
        CHECK(bounds[i].birth_high == (vertex ? 0 : std::nextafter(pairs[i].birth, infinity)));
        CHECK(bounds[i].death_low == (pairs[i].death < infinity ? std::nextafter(pairs[i].death, 0.0) : infinity));
        CHECK(bounds[i].death_high == std::nextafter(pairs[i].death, infinity));
        CHECK(bounds[i].certain == (pairs[i].birth < pairs[i].death));
        CHECK(bounds[i].certain_after >= bounds[i].birth_high);
    }
    // With a ratio: the factor twice, and a unit in the last place each time.
    const Pair scaled[] = {{2, 2.4, 1, 0}, {2, 2.5, 1, 0}};
    REQUIRE(bound_by_ratio({1.1, true}, {scaled, 2}, block.arena, bounds, &curve) == Status::ok);
    CHECK(bounds[0].certain == 0);
    CHECK(bounds[1].certain == 1);
    CHECK(bounds[1].birth_low < 2 / 1.1);
    CHECK(bounds[1].birth_low > 2 / 1.1 * (1 - 1e-14));
    CHECK(bounds[1].death_high > 2.5 * 1.1);
    CHECK(bounds[1].death_high < 2.5 * 1.1 * (1 + 1e-14));
}

TEST_CASE("bounds by an additive error, with values of any sign") {
    Block block(std::size_t{1} << 16);
    ScaleCurve curve;
    const Pair pairs[] = {{-3, -1.75, 0, 0}, {-3, infinity, 0, 0}, {-2, -1.25, 1, 0}, {0, 1, 1, 0}, {0, 0.9, 1, 0}};
    BarBounds bounds[5];
    REQUIRE(bound_by_ratio({infinity, false, 0.5}, {pairs, 5}, block.arena, bounds, &curve) == Status::ok);
    const auto around = [](double x, double low, double high) {
        return low <= x - 0.5 && high >= x + 0.5 && high - low < 1 + 1e-9;
    };
    for (int i = 0; i < 5; ++i) {
        CAPTURE(i);
        CHECK(around(pairs[i].birth, bounds[i].birth_low, bounds[i].birth_high));
        if (pairs[i].death < infinity) CHECK(around(pairs[i].death, bounds[i].death_low, bounds[i].death_high));
        CHECK(bounds[i].certain_after > pairs[i].birth + 1);
        CHECK(bounds[i].certain_after < pairs[i].birth + 1 + 1e-9);
    }
    CHECK(bounds[1].death_low == infinity);
    CHECK(bounds[1].death_high == infinity);
    // Longer than 2 e; the bar from 0 to 1 is as long, and a bar born at 0 is not exact.
    const std::uint32_t certain[] = {1, 1, 0, 0, 0};
    for (int i = 0; i < 5; ++i) CHECK(bounds[i].certain == certain[i]);
    REQUIRE(curve.count == 1);
    CHECK(curve.steps[0].from == -3);
    CHECK(curve.steps[0].low == -infinity);

    // The ratio where it says more.
    const Pair low = {0.125, 8, 0, 0};
    REQUIRE(bound_by_ratio({2, 0, 0.5}, {&low, 1}, block.arena, bounds, &curve) == Status::ok);
    CHECK(bounds[0].birth_low == 0.0625);
    CHECK(bounds[0].birth_high == 0.25);
    CHECK(around(8, bounds[0].death_low, bounds[0].death_high));
    CHECK(bounds[0].certain_after == 0.5);
    CHECK(bounds[0].certain == 1);
}
