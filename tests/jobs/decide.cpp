// Which bars are undecided, where goals go from there, and which result is kept, with jobs that are told what comes of
// a goal.
#include "jobs/decide.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace netmesh;

namespace {

BarBounds bar(double birth_low, double death_high, bool certain = false) {
    return {birth_low, 0, 0, death_high, 0, certain ? 1u : 0u, 0};
}

DecisionView view(const std::vector<BarBounds>& bars, const std::vector<ScaleStep>& steps, double longer_than) {
    return {bars.data(), bars.size(), steps.data(), steps.size(), longer_than};
}

struct Told {
    Status status = Status::ok;
    double from = 1;
    std::uint64_t certain = 0;
    double reach = 1;
};

struct Run {
    Status status;
    std::vector<RatioGoal> tried;  // the last of them is held, where status is ok
};

// What is told for the n-th goal; from the last on the same.
Run climb(const std::vector<Told>& told, double coarsest = 2.25, double longer_than = 1.5) {
    Run out = {Status::ok, {}};
    std::vector<RatioGoal> fresh;
    out.status = decide(FocusPath(coarsest, longer_than), [&](const RatioGoal& goal, Decided* decided) {
        std::size_t at = 0;  // a goal that comes again ends as it did
        while (at < fresh.size() && (fresh[at].focus != goal.focus || fresh[at].from != goal.from)) ++at;
        if (at == fresh.size()) fresh.push_back(goal);
        out.tried.push_back(goal);
        const Told& here = told[at < told.size() ? at : told.size() - 1];
        *decided = {here.reach, here.from, 2, here.certain};
        return here.status;
    });
    return out;
}

bool same(const RatioGoal& a, const RatioGoal& b) {
    return a.ratio == b.ratio && a.focus == b.focus && a.from == b.from && a.to == b.to;
}

}  // namespace

TEST_CASE("a bar is undecided until it is certified to exist, or short") {
    CHECK(is_undecided(bar(1, 1.6), 1.5));
    CHECK_FALSE(is_undecided(bar(1, 1.6, true), 1.5));
    CHECK_FALSE(is_undecided(bar(1, 1.4), 1.5));
    CHECK(is_undecided(bar(1, 1.5), 1.5));  // as near as rounding: not surely shorter
    CHECK(is_undecided(bar(0, 1e-300), 1e300));
    CHECK(is_undecided(bar(1, infinity), 1e300));
    CHECK(undecided_reach(view({bar(1, 1.4), bar(1, 9, true)}, {}, 1.5)) == 0);
    CHECK(undecided_reach(view({bar(1, 2), bar(2, 4), bar(1, 3), bar(7, 8)}, {}, 1.5)) == 4);
}

TEST_CASE("classes without a bar count as far as the curve leaves them room") {
    // Beyond 1 all is exact; before, classes from 0.5 to 0.9 may be missed.
    const std::vector<ScaleStep> steps = {
        {0.6, 0.5, 0.9, 0.9, 1.4, 0}, {1, 1, 1, 1, 1, 0}, {1.1, infinity, 1, 1.1, 1, 0}};
    CHECK(decided_from(view({}, steps, 1.2)) == 1);  // 0.95, say, stands for 0.5 at least: dies before the next step
    CHECK(decided_from(view({}, steps, 1.9)) == 1);
    CHECK(decided_from(view({}, steps, 1.97)) == 0);  // c^2 = 1.96
    CHECK(decided_from(view({bar(1, 2)}, steps, 1.97)) == 2);
    CHECK(decided_from(view({bar(1, 2)}, steps, 2.1)) == 0);
    // Values from `high` on are exact where `low` is above the step: nothing between 0.9 and 1.
    const std::vector<ScaleStep> gap = {{0.6, 1, 0.9, 0.9, 1.4, 0}, {1, infinity, 1, 1, 1, 0}};
    CHECK(decided_from(view({}, gap, 1.2)) == 0.9);
    CHECK(decided_from(view({}, gap, 1.49)) == 0.9);
    CHECK(decided_from(view({}, gap, 1.51)) == 0);
    // A class that was born before the step.
    const std::vector<ScaleStep> before = {{0.6, 0.5, 0.9, 0.9, 1.4, 0}, {0.8, infinity, 0.8, 0.8, 1, 0}};
    CHECK(decided_from(view({}, before, 1.6)) == 0.9);
    CHECK(decided_from(view({}, before, 1.81)) == 0);
    // One ratio at all scales, as of filters without bounds of cells.
    CHECK(decided_from(view({}, {{0, 0, infinity, infinity, 1.5, 0}}, 2)) == infinity);
    CHECK(decided_from(view({}, {{0, 0, infinity, infinity, 1.5, 0}}, 2.26)) == 0);
}

TEST_CASE("scales of interest go down to what is undecided, then their ratio does") {
    FocusPath path(2.25, 1.5);
    CHECK(same(path.goal(), {2.25, 0, 0, 0}));
    REQUIRE(path.go_on(1, 1));
    CHECK(path.goal().ratio == 2.25);
    CHECK(path.goal().focus == doctest::Approx(std::sqrt(1.5)).epsilon(1e-12));
    CHECK(path.goal().from == doctest::Approx(1 / std::sqrt(1.5)).epsilon(1e-12));
    CHECK(path.goal().to == 1);
    CHECK(climb({{Status::ok}, {Status::out_of_memory}}).tried[1].to == 2);
    const double step = std::sqrt(std::sqrt(0.5)), focus = path.goal().focus, from = path.goal().from;
    REQUIRE(path.go_on(0.5, 1));  // far below: as far as that
    CHECK(path.goal().from == doctest::Approx(0.5 / std::sqrt(1.5)).epsilon(1e-12));
    REQUIRE(path.go_on(0.49, 1));  // hardly below: by a whole step
    CHECK(path.goal().from == doctest::Approx(0.5 / std::sqrt(1.5) * step).epsilon(1e-12));
    CHECK(path.goal().focus == focus);
    CHECK(path.goal().to == 1);
    const double lowest = path.goal().from;
    REQUIRE(path.go_on(2, 1));  // of interest already, but for the end
    CHECK(path.goal().from == lowest);
    CHECK(path.goal().to == 2);
    CHECK(path.goal().focus == doctest::Approx(1 + (focus - 1) * step).epsilon(1e-12));
    CHECK(lowest < from);
    CHECK_FALSE(path.go_on(0, 1));
    CHECK_FALSE(path.go_on(infinity, 1));
    // A ratio that is asked for everywhere already is of no use.
    FocusPath long_ones(1.5, 100);
    REQUIRE(long_ones.go_on(1, 1));
    CHECK(long_ones.goal().focus == doctest::Approx(1 + 0.5 * std::sqrt(0.5)).epsilon(1e-12));
    // With the fourth root of L and scales a little lower no Steiner cell is in the way: then the ratio everywhere
    // falls, as far as it may.
    FocusPath stuck(4, 1.5);
    REQUIRE(stuck.go_on(1, 1));
    RatioGoal last = stuck.goal();
    int of_focus = 0, of_from = 0, of_ratio = 0;
    while (stuck.go_on(1, 1)) {
        const RatioGoal now = stuck.goal();
        CHECK((now.focus < last.focus) + (now.from < last.from) + (now.ratio < last.ratio) == 1);
        of_focus += now.focus < last.focus;
        of_from += now.from < last.from;
        of_ratio += now.ratio < last.ratio;
        CHECK((of_from == 0 || last.focus < std::pow(1.5, 0.25)));
        CHECK((of_ratio == 0 || now.from < std::pow(1.5, -0.75) * (1 + 1e-12)));
        last = now;
    }
    CHECK(of_focus == 5);
    CHECK(last.focus > std::pow(1.5, 0.25) - 0.01);
    CHECK(of_from == 1);
    CHECK(of_ratio > 8);
    CHECK(last.ratio > std::sqrt(2));
    CHECK(last.ratio < 1.55);
    CHECK_FALSE(FocusPath(4, 1.0001).go_on(1, 1));
}

TEST_CASE("what is decided from the lowest scale is kept, of equal results that with more certain bars") {
    const Told full = {Status::out_of_memory};
    const auto kept = [&](const std::vector<Told>& told) {
        const Run run = climb(told);
        CHECK(run.status == Status::ok);
        for (std::size_t at = 0; at + 1 < run.tried.size(); ++at)
            if (same(run.tried[at], run.tried.back())) return static_cast<int>(at);
        return static_cast<int>(run.tried.size()) - 1;
    };
    const Told all = {Status::ok, 5, 0, 0};  // whatever is hidden
    CHECK(kept({all}) == 0);
    CHECK(climb({all}).tried.size() == 1);
    CHECK(kept({{Status::ok, 1}, full}) == 0);
    CHECK(kept({{Status::ok, 1}, {Status::ok, 0.5}, full}) == 1);
    CHECK(kept({{Status::ok, 1}, {Status::ok, 0.5}, {Status::ok, 0.7, 9}, full}) == 1);
    CHECK(kept({{Status::ok, 1, 3}, {Status::ok, 1, 4}, {Status::ok, 1, 4}, full}) == 1);
    CHECK(kept({{Status::ok, 1}, {Status::ok, 0.5}, all}) == 2);
    CHECK(climb({{Status::ok, 1}, {Status::ok, 0.5}, all}).tried.size() == 3);           // nothing is made again
    CHECK(climb({{Status::ok, 1}, {Status::ok, 0.5}, full}).tried.size() == 4);          // the second one is
    CHECK(kept({{Status::ok, 1}, {Status::ok, 0.5}, {Status::invalid_argument}}) == 1);  // scales not resolved
    CHECK(climb({full}).status == Status::out_of_memory);
    CHECK(climb({{Status::invalid_argument}}).status == Status::invalid_argument);
    CHECK(climb({{Status::ok, 1}, {Status::cancelled}}).status == Status::cancelled);
}
