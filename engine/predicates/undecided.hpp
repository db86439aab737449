// Signs that the float stage about the last point left open, for any dimension: one piece of code for all, as it is
// seldom run.
#pragma once
#include "predicates/float_stage.hpp"
#include "predicates/predicates.hpp"

namespace netmesh {

enum PredicateStage : int { stage_float = 1, stage_integer = 2, stage_exact = 3, stage_tie = 4 };

struct Decision {
    Sign sign;
    PredicateStage stage;
};

inline Decision decide(int sign, bool negate, PredicateStage stage) {
    return {static_cast<Sign>(negate ? -sign : sign), stage};
}

inline int sign_of(double x) { return (x > 0) - (x < 0); }

// lifted: in_ball of dim+2 points, the questioned one last, else orient of dim+1. first: what the float stage found.
// The sign is 0 for a tie only.
Decision decide_undecided(int dim, bool lifted, const double* const* points, const FloatResult& first);

}  // namespace netmesh
