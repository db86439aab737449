// Budget mode: the best certificate that fits in the block, on a ladder of ratios, or of errors, that does not depend
// on the block.
//
// Rungs are climbed one by one, those left out that are reached already, until one does not fit; what certifies most is
// kept. The results seen do not depend on the block but for their number: what is next is a matter of the results
// before. So a larger block sees all that a smaller one sees, and never certifies less. Finer meshes may certify less
// than coarser ones, which is why the last rung is not always the best.
//
// Sizes of meshes grow by 2^(D/8) or more from rung to rung where cells are small, so all rungs together cost about
// 1 / (1 - 2^(-D/8)) times the last: 6.3 in the plane, 4.4 in space, 3.4 in R^4; the one that does not fit and a return
// to the best one come on top.
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

    // What was certified of rung 0; this ladder does not depend on it.
    void begin_at(double) {}
    // A status that says that a rung cannot be had, nor any after it, whatever the block.
    static bool ends_with(Status) { return false; }
    bool has(int rung) const {
        const double ratio = ratio_of(rung);
        return is_focused() ? ratio > 1 + 0x1p-10 : is_certifiable(ratio);
    }
    RatioGoal goal(int rung) const {
        if (!is_focused()) return {ratio_of(rung), 0, 0, 0};
        if (rung == 0) return {coarsest_, 0, 0, 0};
        return {coarsest_, ratio_of(rung), from_, to_};
    }

    // What rung asks for, of the scales of interest if there are any.
    double ratio_of(int rung) const { return 1 + lowered(coarsest_ - 1, rung); }
    double bound_of(int rung) const { return ratio_of(rung); }
    // By square roots alone.
    static double lowered(double x, int rung) {
        const double eighth = square_root(square_root(square_root(0.5)));
        for (; rung >= rungs_a_halving; rung -= rungs_a_halving) x *= 0.5;
        for (; rung > 0; --rung) x *= eighth;
        return x;
    }

private:
    bool is_focused() const { return from_ != 0 || to_ != 0; }
    static bool is_certifiable(double ratio) { return ratio >= ratio_least && ratio < 0x1p100; }
    double coarsest_, from_, to_;
};

// Rungs of additive errors of a function's diagram, steps as above: rung 0 asks for nothing, and what it certifies
// begins the ladder.
class ErrorLadder {
public:
    void begin_at(double certified) { coarsest_ = certified; }
    static bool ends_with(Status status) {
        return status == Status::invalid_argument;
    }  // below what coordinates resolve
    // Down to 2^-32: what is finer is below what coordinates resolve where cells are a hundredth of the domain wide.
    bool has(int rung) const {
        return rung == 0 || (coarsest_ > 0 && coarsest_ < infinity && rung <= 32 * RatioLadder::rungs_a_halving);
    }
    // 0: nothing is asked.
    double goal(int rung) const { return rung == 0 ? 0 : bound_of(rung); }
    double bound_of(int rung) const { return RatioLadder::lowered(coarsest_, rung); }

private:
    double coarsest_ = 0;
};

// What came of a rung.
struct Climbed {
    double reached = 0;    // the least bound of the ladder that the mesh is known to keep
    double certified = 0;  // what counts: the ratio or error that its diagram certifies, may be infinite
};

// climb(goal, &climbed) makes the result of a goal in place of the one before, or says why not: a Status, of which
// out_of_memory ends the climb. Without ok there is no result: not even the coarsest fits, or what climb says.
template <class Ladder, class Climb> Status fit(Ladder ladder, Climb&& climb) {
    int best = -1, held = -1;  // the rung that certifies most, the one whose result there is; -1: none
    double certified = 0;
    for (int rung = 0; ladder.has(rung);) {
        Climbed climbed;
        const Status status = climb(ladder.goal(rung), &climbed);
        held = status == Status::ok ? rung : -1;
        if (status == Status::out_of_memory || (best >= 0 && ladder.ends_with(status))) break;
        if (status != Status::ok) return status;
        if (rung == 0) ladder.begin_at(climbed.certified);
        if (best < 0 || climbed.certified < certified || !(certified < infinity)) {
            best = rung;
            certified = climbed.certified;
        }
        do ++rung;
        while (ladder.has(rung) && ladder.bound_of(rung) >= climbed.reached);
    }
    if (best < 0) return Status::out_of_memory;
    Climbed again;
    return held == best ? Status::ok : climb(ladder.goal(best), &again);
}

}  // namespace netmesh
