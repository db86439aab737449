// Intervals of cells and the clamp, on numbers whose answers stand here.
#include "certificate/certificate.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace netmesh;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// What `exact` becomes when it is rounded down twice, as a difference and as a bound.
bool is_just_below(double x, double exact) { return x < exact && x > exact * (1 - 0x1p-38); }

}  // namespace

TEST_CASE("the distance to the inputs on a cell is at least d - R and d / 2, rounded down") {
    CHECK(is_just_below(least_distance(3, 1), 2));
    CHECK(is_just_below(least_distance(3, 2), 1.5));
    CHECK(is_just_below(least_distance(3, infinity), 1.5));
    CHECK(is_just_below(least_distance_unbounded(3), 1.5));
    // Refinement takes the numbers as they are.
    CHECK(least_distance(3, 1, 1) == 2);
    CHECK(least_distance(3, 2, 1) == 1.5);
    CHECK(least_distance_unbounded(3, 1) == 1.5);
}

TEST_CASE("intervals of inputs, of Steiner vertices and of unbounded cells") {
    const Interval input = input_interval(3, 2);
    CHECK(is_just_below(input.lo, 1.5));
    CHECK(input.hi == 2);
    const Interval steiner = steiner_interval(3, 1, 3.5);
    CHECK(is_just_below(steiner.lo, 2));
    CHECK(steiner.hi == 3.5);
    const Interval unbounded = unbounded_interval(3);
    CHECK(is_just_below(unbounded.lo, 1.5));
    CHECK(unbounded.hi == infinity);
}

TEST_CASE("what is cut lies at the cut or below, also where an end is no number") {
    for (const Interval i : {Interval{1, 2}, Interval{1, infinity}, Interval{5, 6}, Interval{not_a_number, 2},
                             Interval{1, not_a_number}}) {
        const Interval c = cut_at(3, i);
        CHECK(c.lo <= 3);
        CHECK(c.hi <= 3);
        if (i.lo <= 3) CHECK(c.lo == i.lo);
        if (i.hi <= 3) CHECK(c.hi == i.hi);
    }
    CHECK(cut_at(3, {1, not_a_number}).hi == 3);
}

TEST_CASE("clamped values reach the best ratio, own values what they prove") {
    // The widest interval decides: sqrt(9 / 1). 2 stays, 8.5 is above 3 * 1 and comes down, 0.1 is below 6 / 3 and goes
    // up.
    const std::vector<Interval> intervals = {{1, 9}, {1, 9}, {4, 6}};
    const std::vector<double> own = {3, 8.5, 0.1};
    for (const FilterValues values : {FilterValues::certified, FilterValues::thesis}) {
        std::vector<double> value = own;
        std::vector<Interval> seen(3);
        const Certificate certificate = clamp_values(
            3, 10, values, [&](VertexId v) { return intervals[v]; }, value.data(), seen.data());
        CHECK(certificate.ratio_best == doctest::Approx(3).epsilon(1e-11));
        CHECK(certificate.ratio_best > 3);
        CHECK(certificate.from == 0);
        if (values == FilterValues::certified) {
            CHECK(value[0] == doctest::Approx(3).epsilon(1e-11));
            CHECK(value[1] == doctest::Approx(3).epsilon(1e-11));
            CHECK(value[2] == doctest::Approx(2).epsilon(1e-11));
            CHECK(certificate.ratio == doctest::Approx(3).epsilon(1e-11));
        } else {
            CHECK(value == own);
            CHECK(certificate.ratio == doctest::Approx(60).epsilon(1e-11));
        }
        CHECK(certificate.ratio >= 3);
        for (int v = 0; v < 3; ++v) CHECK(seen[v].hi == intervals[v].hi);
    }
}

TEST_CASE("own values are cut, and an interval from 0 has no ratio") {
    std::vector<double> value = {7, 0};
    const std::vector<Interval> intervals = {{2, 4}, {0, 4}};
    const Certificate certificate = clamp_values(
        2, 4, FilterValues::certified, [&](VertexId v) { return intervals[v]; }, value.data(), nullptr);
    CHECK(value[0] == 4);
    CHECK(certificate.ratio == infinity);
    CHECK(certificate.ratio_best == infinity);
}
