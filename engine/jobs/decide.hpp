// Scales of interest chosen from diagrams: a mesh is refined where bars are undecided.
//
// Of a diagram with bounds a bar is undecided when it is not surely real, and its bounds do not exclude that the true
// one lives longer than `longer_than` times its birth, L below. Scales are taken from above: a mesh of the scale s has
// s^-D as many vertices, and classes that die late are those of the whole shape.
//
// Why scales near a bar decide it, and which: let cells across s, those with lo < s < hi, have hi <= R^2 lo. A class
// born by s / R^2 is then there in the cells with hi <= s, which cover the sublevel set at s / R^2, and one that dies
// after R^2 s is not dead yet in those with lo <= s. So L = R^4 decides, with one scale s, all that live longer than L
// around it. Most are decided long before: R begins with the root of L, with which (c(a)^2 <= L, see bar_bounds.hpp)
// what is as short as bars of noise are is excluded first. Of all that live longer than L and die at `reach` at most
// the shortest crosses reach / root(L): from there on scales are of interest.
#pragma once
#include "certificate/rounding.hpp"
#include "jobs/bar_bounds.hpp"
#include "mesh/mesh_request.hpp"
#include "numerics/real.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

inline bool is_undecided(const BarBounds& bar, double longer_than) {
    return bar.certain == 0 && !(bar.death_high <= longer_than * bar.birth_low * down);
}

// bounds[bars] and steps[step_count] as bound_bars leaves them.
struct DecisionView {
    const BarBounds* bounds;
    std::uint64_t bars;
    const ScaleStep* steps;
    std::uint64_t step_count;
    double longer_than;
};

// Up to here undecided bars reach, the largest death_high; 0: there is none.
double undecided_reach(const DecisionView& view);

// True classes that live longer than longer_than times their birth and die after this each have a bar of their own,
// which surely is real. At least undecided_reach: here classes without any bar count as well.
double decided_from(const DecisionView& view);

// Goals, one after the other, by what comes of the one before. Each lowers the scales of interest, or their ratio where
// those that matter are of interest already, by enough that meshes grow as on a ladder (fit.hpp).
class FocusPath {
public:
    FocusPath(double coarsest, double longer_than) : goal_{coarsest, 0, 0, 0}, root_(square_root(longer_than)) {}

    const RatioGoal& goal() const { return goal_; }
    // False: nothing is left to refine, or not by any ratio.
    bool go_on(double reach) {
        if (!(reach > 0 && is_finite(reach))) return false;
        const double step = square_root(square_root(0.5)), wanted = reach / root_;
        if (reach > goal_.to) goal_.to = reach;
        if (!(goal_.focus > 0)) {
            const double below = 1 + (goal_.ratio - 1) * square_root(0.5);
            goal_.focus = root_ < below ? root_ : below;
            goal_.from = wanted;
        } else if (wanted < goal_.from) {
            goal_.from = wanted < goal_.from * step ? wanted : goal_.from * step;
        } else {
            goal_.focus = 1 + (goal_.focus - 1) * step;
        }
        return goal_.focus > 1 + 0x1p-10 && goal_.from > 0 && goal_.from < goal_.to;
    }

private:
    RatioGoal goal_;
    const double root_;
};

// What came of a goal.
struct Decided {
    double reach = 0;           // see undecided_reach
    std::uint64_t certain = 0;  // bars
};

// climb(goal, &decided) as in fit.hpp. Kept is the result whose undecided bars reach least far, of equal ones the one
// with more certain bars. Goals do not depend on the block but for their number: a larger one sees all that a smaller
// one sees, and decides no less. Without ok there is no result: not even the coarsest fits, or what climb says.
template <class Climb> Status decide(FocusPath path, Climb&& climb) {
    RatioGoal best = {};
    Decided most;
    bool found = false, held = false;
    for (;;) {
        Decided made;
        const RatioGoal goal = path.goal();
        const Status status = climb(goal, &made);
        held = false;
        // A full block ends it, and scales that coordinates do not resolve.
        if (status == Status::out_of_memory || (status == Status::invalid_argument && found)) break;
        if (status != Status::ok) return status;
        if (!found || made.reach < most.reach || (made.reach == most.reach && made.certain > most.certain)) {
            best = goal;
            most = made;
            found = held = true;
        }
        if (!path.go_on(made.reach)) break;
    }
    if (!found) return Status::out_of_memory;
    Decided again;
    return held ? Status::ok : climb(best, &again);
}

}  // namespace netmesh
