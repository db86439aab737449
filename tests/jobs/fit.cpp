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

struct Rung {
    bool fits = true;
    double certified = 1;
    double reached = infinity;
};

struct Run {
    Status status;
    int held;                // the rung whose result there is, -1: none
    std::vector<int> tried;  // rungs, in the order in which results were made or tried
};

Run climb(const RatioLadder& ladder, const std::vector<Rung>& rungs) {
    Run out = {Status::ok, -1, {}};
    out.status = fit(ladder, [&](const RatioGoal& goal, Climbed* climbed) {
        const int rung = rung_of(ladder, goal.ratio);
        REQUIRE(rung >= 0);
        out.tried.push_back(rung);
        const Rung& here = rungs[static_cast<std::size_t>(rung)];
        out.held = here.fits ? rung : -1;  // the result before is gone either way
        *climbed = {here.reached, here.certified};
        return here.fits ? Status::ok : Status::out_of_memory;
    });
    return out;
}

std::vector<Rung> rungs_of(const RatioLadder& ladder) {
    std::vector<Rung> rungs;
    for (int rung = 0; ladder.has(rung); ++rung) rungs.push_back({true, ladder.goal(rung).ratio, infinity});
    return rungs;
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

TEST_CASE("where finer rungs certify more, the finest that fits is held") {
    const RatioLadder ladder(1e20, 0, 0);
    std::vector<Rung> rungs = rungs_of(ladder);
    const int count = static_cast<int>(rungs.size());
    REQUIRE(count > 200);
    for (int finest = count - 1; finest >= -1; --finest) {
        CAPTURE(finest);
        if (finest + 1 < count) rungs[static_cast<std::size_t>(finest + 1)].fits = false;
        const Run out = climb(ladder, rungs);
        CHECK(out.status == (finest < 0 ? Status::out_of_memory : Status::ok));
        CHECK(out.held == finest);
        const int again = finest >= 0 && finest + 1 < count ? 1 : 0, refused = finest + 1 < count ? 1 : 0;
        CHECK(static_cast<int>(out.tried.size()) == finest + 1 + refused + again);
    }
}

TEST_CASE("where no ratio is finite the finest that fits is held, and none of them takes the place of a finite one") {
    const RatioLadder ladder(40, 0, 0);
    std::vector<Rung> rungs = rungs_of(ladder);
    for (Rung& rung : rungs) rung.certified = infinity;
    rungs[20].fits = false;
    CHECK(climb(ladder, rungs).held == 19);
    rungs[7].certified = 5;
    CHECK(climb(ladder, rungs).held == 7);
    rungs[3].certified = 5;
    CHECK(climb(ladder, rungs).held == 3);
    rungs[11].certified = 4;
    CHECK(climb(ladder, rungs).held == 11);
}

TEST_CASE("rungs that are reached already are left out") {
    const RatioLadder ladder(40, 0, 0);
    std::vector<Rung> rungs = rungs_of(ladder);
    for (Rung& rung : rungs) rung.reached = 0.5 * (1 + rung.certified);  // eight rungs on
    const Run out = climb(ladder, rungs);
    for (std::size_t i = 1; i < out.tried.size(); ++i) {
        const int before = out.tried[i - 1], gap = out.tried[i] - before;
        CAPTURE(before);
        CHECK((gap == 8 || gap == 9));
        CHECK(ladder.goal(out.tried[i]).ratio < rungs[static_cast<std::size_t>(before)].reached);
        CHECK(ladder.goal(out.tried[i] - 1).ratio >= rungs[static_cast<std::size_t>(before)].reached);
    }
    CHECK(out.tried.size() > 3);
}

// What does not fit may be followed by what does, and finer meshes may certify less: neither makes a block of more
// bytes certify less.
TEST_CASE("a larger block never certifies less") {
    const RatioLadder ladder(40, 0, 0);
    std::vector<Rung> rungs = rungs_of(ladder);
    inputs::Random random(3);
    int returned = 0, last_held = 0;
    for (int round = 0; round < 300; ++round) {
        std::vector<std::uint64_t> bytes;
        for (std::size_t rung = 0; rung < rungs.size(); ++rung) {
            bytes.push_back(rung * 4 + random.below(60));
            rungs[rung].certified = 1 + (ladder.goal(static_cast<int>(rung)).ratio - 1) * (0.3 + random.uniform());
            if (round % 3 == 0 || (round % 3 == 1 && random.below(3) == 0)) rungs[rung].certified = infinity;
            rungs[rung].reached = round % 2 == 0 ? infinity : rungs[rung].certified;
        }
        double last = 0;
        for (std::uint64_t block = 0; block < rungs.size() * 4 + 60; ++block) {
            for (std::size_t rung = 0; rung < rungs.size(); ++rung) rungs[rung].fits = bytes[rung] <= block;
            const Run out = climb(ladder, rungs);
            CHECK((out.status == Status::ok) == (bytes[0] <= block));
            if (out.status != Status::ok) continue;
            REQUIRE(out.held >= 0);
            const double certified = rungs[static_cast<std::size_t>(out.held)].certified;
            CHECK((last == 0 || certified <= last));
            if (round % 3 == 0) CHECK(out.held >= last_held);
            // The best of all that was seen.
            for (const int rung : out.tried) {
                const Rung& seen = rungs[static_cast<std::size_t>(rung)];
                CHECK((!seen.fits || seen.certified >= certified));
            }
            returned += out.tried.back() == out.held ? 1 : 0;
            last = certified;
            last_held = out.held;
        }
        last_held = 0;
    }
    CHECK(returned > 1000);
}

TEST_CASE("what is not a lack of memory ends the climb") {
    const RatioLadder ladder(5, 0, 0);
    for (int stop = 0; stop < 4; ++stop) {
        int jobs = 0;
        CHECK(fit(ladder, [&](const RatioGoal&, Climbed* climbed) {
                  *climbed = {infinity, 2};
                  return jobs++ == stop ? Status::cancelled : Status::ok;
              }) == Status::cancelled);
        CHECK(jobs == stop + 1);
    }
}

TEST_CASE("the ladder of errors: from what the first mesh certifies, in steps of an eighth of a halving") {
    // Meshes certify a share of what they are asked for; the block holds `rungs` of them.
    const auto climb = [](double first, double share, int rungs, Status end, std::vector<double>* asked) {
        return fit(ErrorLadder(), [=](double error, Climbed* climbed) {
            if (static_cast<int>(asked->size()) >= rungs) return end;
            asked->push_back(error);
            climbed->certified = climbed->reached = error > 0 ? share * error : first;
            return Status::ok;
        });
    };
    std::vector<double> asked;
    CHECK(climb(0.7, 0.99, 20, Status::invalid_argument, &asked) == Status::invalid_argument);  // nor the best again
    REQUIRE(asked.size() == 20);
    CHECK(asked[0] == 0);
    for (std::size_t i = 1; i < asked.size(); ++i)
        CHECK(asked[i] == doctest::Approx(0.7 * std::exp2(-static_cast<double>(i) / 8)).epsilon(1e-12));
    // What is reached is left out: a mesh that is twice as good as asked for spares seven or eight rungs.
    asked.clear();
    climb(0.7, 0.5, 6, Status::out_of_memory, &asked);
    for (std::size_t i = 2; i < asked.size(); ++i) {
        CHECK(asked[i] < 0.51 * asked[i - 1]);
        CHECK(asked[i] > 0.45 * asked[i - 1]);
    }
    // Down to 2^-32; what is exact or without a bound is not refined.
    asked.clear();
    CHECK(climb(1, 1, 1000, Status::internal, &asked) == Status::ok);
    CHECK(asked.size() == 257);
    CHECK(asked.back() == 0x1p-32);
    for (const double first : {0.0, static_cast<double>(infinity)}) {
        asked.clear();
        CHECK(climb(first, 1, 1000, Status::internal, &asked) == Status::ok);
        CHECK(asked.size() == 1);
    }
    // A size that coordinates do not resolve ends the climb, as a lack of memory does; the best is made again.
    int made = 0;
    double held = -1;
    CHECK(fit(ErrorLadder(), [&](double error, Climbed* climbed) {
              if (error > 0 && error < 0.3) return Status::invalid_argument;
              ++made;
              held = error;
              climbed->certified = climbed->reached = error > 0 ? error : 1;
              return Status::ok;
          }) == Status::ok);
    CHECK(held > 0.3);
    CHECK(held < 0.3 * 1.1);
    CHECK(made > 13);
}
