// The ladder of ratios, and what a block reaches on it, with jobs that are told what fits.
#include "jobs/fit.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "common/inputs.hpp"

using namespace netmesh;

namespace {

// The rung whose goal this is, counted from the coarsest.
int rung_of(const RatioLadder& ladder, double ratio) {
    for (int rung = 0; ladder.has(rung); ++rung)
        if (ladder.goal(rung).ratio == ratio) return rung;
    return -1;
}

struct Climbed {
    Status status;
    int held;  // the rung whose result there is, -1: none
    int jobs;  // how many results were made or tried
};

// fits[rung]: whether the result of that rung fits in the block.
Climbed climb(const RatioLadder& ladder, const std::vector<bool>& fits) {
    Climbed out = {Status::ok, -1, 0};
    out.status = fit(ladder, [&](const RatioGoal& goal) {
        const int rung = rung_of(ladder, goal.ratio);
        REQUIRE(rung >= 0);
        ++out.jobs;
        const bool room = fits[static_cast<std::size_t>(rung)];
        out.held = room ? rung : -1;  // the result before is gone either way
        return room ? Status::ok : Status::out_of_memory;
    });
    return out;
}

}  // namespace

TEST_CASE("eight rungs halve what a ratio is above 1, in equal steps") {
    for (const double coarsest : {1.5, 2.25, 5.0, 1e20}) {
        const RatioLadder ladder(coarsest, 0, 0);
        CHECK(ladder.goal(0).ratio == coarsest);
        for (int rung = 0; ladder.has(rung + 1); ++rung) {
            CAPTURE(rung);
            const double excess = (coarsest - 1) * std::pow(0.5, (rung + 1) / 8.0);
            CHECK(ladder.goal(rung + 1).ratio - 1 == doctest::Approx(excess).epsilon(1e-12));
        }
    }
    const RatioLadder focused(2.25, 0.1, 0.2);
    CHECK(focused.goal(0).focus == 0);
    for (int rung = 1; rung < 30; ++rung) {
        CHECK(focused.goal(rung).ratio == 2.25);
        CHECK(focused.goal(rung).focus - 1 == doctest::Approx(1.25 * std::pow(0.5, rung / 8.0)).epsilon(1e-12));
    }
}

TEST_CASE("a block holds the finest rung that fits in it") {
    const RatioLadder ladder(1e20, 0, 0);
    int rungs = 0;
    while (ladder.has(rungs)) ++rungs;
    REQUIRE(rungs > 200);
    for (int finest = -1; finest < rungs; ++finest) {
        CAPTURE(finest);
        std::vector<bool> fits;
        for (int rung = 0; rung < rungs; ++rung) fits.push_back(rung <= finest);
        const Climbed out = climb(ladder, fits);
        CHECK(out.status == (finest < 0 ? Status::out_of_memory : Status::ok));
        CHECK(out.held == finest);
        CHECK(out.jobs <= 7 + finest / 8);
    }
}

// What does not fit may be followed by what does: finer meshes are not larger in every case.
TEST_CASE("a larger block never holds a coarser rung") {
    const RatioLadder ladder(40, 0, 0);
    int rungs = 0;
    while (ladder.has(rungs)) ++rungs;
    inputs::Random random(3);
    for (int round = 0; round < 200; ++round) {
        std::vector<std::uint64_t> bytes;
        for (int rung = 0; rung < rungs; ++rung)
            bytes.push_back(static_cast<std::uint64_t>(rung) * 4 + random.below(60));
        int last = -1;
        for (std::uint64_t block = 0; block < static_cast<std::uint64_t>(rungs) * 4 + 60; ++block) {
            std::vector<bool> fits;
            for (const std::uint64_t b : bytes) fits.push_back(b <= block);
            const Climbed out = climb(ladder, fits);
            CHECK((out.status == Status::ok) == (bytes[0] <= block));
            if (out.status != Status::ok) continue;
            CHECK(out.held >= last);
            CHECK(out.held >= 0);
            last = out.held;
        }
    }
}

TEST_CASE("what is not a lack of memory ends the climb") {
    const RatioLadder ladder(5, 0, 0);
    for (int stop = 0; stop < 4; ++stop) {
        int jobs = 0;
        CHECK(fit(ladder, [&](const RatioGoal&) { return jobs++ == stop ? Status::cancelled : Status::ok; }) ==
              Status::cancelled);
        CHECK(jobs == stop + 1);
    }
}
