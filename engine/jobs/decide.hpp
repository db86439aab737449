// Scales of interest chosen from diagrams: a mesh is refined where bars are undecided.
//
// Of a diagram with bounds a bar is undecided when it is not certified to exist, and its bounds do not exclude that the
// true one lives longer than `longer_than` times its birth, L below. Scales are taken from above: a mesh of the scale s
// has s^-D as many vertices, and classes that die late are those of the whole shape.
//
// Why scales near a bar decide it, and which: let cells across s, those with lo < s < hi, have hi <= R^2 lo. A class
// born by s / R^2 is then there in the cells with hi <= s, which cover the sublevel set at s / R^2, and one that dies
// after R^2 s is not dead yet in those with lo <= s. So L = R^4 decides, with one scale s, all that live longer than L
// around it. Most are decided long before: R begins with the root of L, with which (c(a)^2 <= L, see bar_bounds.hpp)
// what is as short as bars of noise are is excluded first. Of all that live longer than L and die at `reach` at most
// the shortest crosses reach / root(L): from there on scales are of interest, all of them, so that what no diagram has
// shown yet shows or is excluded. Where bars are seen they are gone to at once: nothing is refined for scales below.
//
// How far R has to go: let all cells that matter to scales from `from` on keep R, and let a bar (b, d) that is not
// certified to exist be undecided up to `reach`. Then d <= psi(phi(b)) <= R max(from, R b), and reach = phi(d) <= R^2
// max(from, R b). With R^4 < L and from <= reach / L^(3/4), which is less than reach / R^3, so R b > from and reach <=
// R^3 b: b is above from, its true birth b / R at least, and L < reach / (b / R) <= R^4. So it is not for Steiner cells
// that such a bar is undecided but for those of inputs, of which a mesh is asked nothing but its ratio everywhere.
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
// which is certified to exist. At least undecided_reach: here classes without any bar count as well.
double decided_from(const DecisionView& view);

// Goals, one after the other, by what comes of the one before. Each lowers the scales of interest, or their ratio where
// those that matter are of interest already, or the ratio everywhere where that is not the reason either; by enough
// that meshes grow as on a ladder (fit.hpp).
class FocusPath {
public:
    FocusPath(double coarsest, double longer_than)
        : goal_{coarsest, 0, 0, 0}, root_(square_root(longer_than)),
          least_(1 + (square_root(root_) - 1) * (1 - 0x1p-4)) {}

    const RatioGoal& goal() const { return goal_; }
    // reach: of undecided bars; top: no cell's lo is above. False: nothing is left to refine, or not by any ratio.
    bool go_on(double reach, double top) {
        if (!(reach > 0 && is_finite(reach))) return false;
        const bool is_least = goal_.focus > 0 && !(goal_.focus > least_);
        const double step = square_root(square_root(0.5)),
                     wanted = reach / (is_least ? root_ * square_root(root_) : root_);
        goal_.to = reach > top ? reach : top;
        if (!(goal_.focus > 0)) {
            const double below = 1 + (goal_.ratio - 1) * square_root(0.5);
            goal_.focus = root_ < below ? root_ : below;
            goal_.from = wanted;
        } else if (wanted < goal_.from) {
            goal_.from = wanted < goal_.from * step ? wanted : goal_.from * step;
        } else if (!is_least) {
            const double next = 1 + (goal_.focus - 1) * step;
            goal_.focus = next > least_ ? next : least_;
        } else {
            goal_.ratio = 1 + (goal_.ratio - 1) * step;
        }
        return goal_.focus > 1 + 0x1p-10 && goal_.focus < goal_.ratio && goal_.ratio * goal_.ratio > 2 + 0x1p-10 &&
               goal_.from > 0 && goal_.from < goal_.to;
    }

private:
    RatioGoal goal_;
    const double root_, least_;  // of L; just below the fourth root of L
};

// What came of a goal.
struct Decided {
    double reach = 0, from = 0;  // undecided_reach, decided_from
    double top = 0;              // the radius at which functions are cut
    std::uint64_t certain = 0;   // bars

    bool better_than(const Decided& o) const {
        if (!(reach > 0) || !(o.reach > 0)) return !(reach > 0) && o.reach > 0;
        return from < o.from || (from == o.from && certain > o.certain);
    }
};

// climb(goal, &decided) as in fit.hpp. Kept is the result that has no undecided bar, or else is decided from the lowest
// scale on, of equal ones the one with more certain bars: not what reaches least far, as coarse meshes hide most. Goals
// do not depend on the block but for their number: a larger one sees all that a smaller one sees, and decides no less.
// Without ok there is no result: not even the coarsest fits, or what climb says.
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
        if (!found || made.better_than(most)) {
            best = goal;
            most = made;
            found = held = true;
        }
        if (!path.go_on(made.reach, made.top)) break;
    }
    if (!found) return Status::out_of_memory;
    Decided again;
    return held ? Status::ok : climb(best, &again);
}

}  // namespace netmesh
