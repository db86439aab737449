// Budget mode: the best ratio that fits in the block, on a ladder of ratios that does not depend on the block.
//
// Steps of 8, 4, 2 and 1 rungs, each step taken when what it leads to fits. What a block reaches by a step of 8 a
// larger one reaches too, as it is no matter of the block whether a rung is tried; if it reaches more, it is ahead by
// more than the steps of 4, 2 and 1 can make up for together; and so on down. So more memory never gives a coarser
// rung.
#pragma once
#include "mesh/mesh_request.hpp"
#include "numerics/real.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// Rungs of ratios: rung 0 is the coarsest, eight rungs halve what is above 1. With scales of interest the ladder is of
// their ratio, and the coarsest is asked of everything else.
class RatioLadder {
public:
    static constexpr int rungs_a_halving = 8;

    // from, to: scales of interest, 0 for none.
    RatioLadder(double coarsest, double from, double to) : coarsest_(coarsest), from_(from), to_(to) {}

    bool has(int rung) const {
        const double ratio = ratio_of(rung);
        return is_focused() ? ratio > 1 + 0x1p-10 : is_certifiable(ratio);
    }
    RatioGoal goal(int rung) const {
        if (!is_focused()) return {ratio_of(rung), 0, 0, 0};
        if (rung == 0) return {coarsest_, 0, 0, 0};
        return {coarsest_, ratio_of(rung), from_, to_};
    }

private:
    bool is_focused() const { return from_ != 0 || to_ != 0; }
    // A ratio that refinement by the certificate can reach.
    static bool is_certifiable(double ratio) { return ratio > 1 && ratio * ratio > 2 && ratio < 0x1p100; }
    // By square roots alone.
    double ratio_of(int rung) const {
        const double eighth = square_root(square_root(square_root(0.5)));
        double excess = coarsest_ - 1;
        for (; rung >= rungs_a_halving; rung -= rungs_a_halving) excess *= 0.5;
        for (; rung > 0; --rung) excess *= eighth;
        return 1 + excess;
    }

    double coarsest_, from_, to_;
};

// climb(goal) makes the result of a goal in place of the one before, or says why not: a Status, of which out_of_memory
// ends a step. Costs about seven results. Without ok there is no result: not even the coarsest fits, or what climb
// says.
template <class Climb> Status fit(const RatioLadder& ladder, Climb&& climb) {
    Status status = climb(ladder.goal(0));
    if (status != Status::ok) return status;
    int reached = 0, held = 0;  // held: the rung whose result there is, -1 for none
    for (int step = RatioLadder::rungs_a_halving; step > 0; step /= 2) {
        for (bool fits = true; fits && ladder.has(reached + step);) {
            status = climb(ladder.goal(reached + step));
            fits = status == Status::ok;
            if (!fits && status != Status::out_of_memory) return status;
            held = fits ? reached += step : -1;
            if (step < RatioLadder::rungs_a_halving) break;  // the next one is known not to fit
        }
    }
    return held == reached ? Status::ok : climb(ladder.goal(reached));
}

}  // namespace netmesh
