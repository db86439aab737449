// The two questions that every triangulation asks, answered exactly for all finite doubles.
//
// Cost: 10 to 200 ns while floating point decides, below a microsecond or a few when differences of
// coordinates have to be taken as integers of 61 bits, below a millisecond over the whole range of doubles. At most
// 8 KiB of stack, no other memory. Integer and IEEE double arithmetic only: the same answers on every target.
#pragma once
#include <cstdint>

#include "vocabulary/ids.hpp"

namespace netmesh {

enum class Sign : int { negative = -1, zero = 0, positive = 1 };

// What callers report to Monitor: of a test that doubles do not decide, of a step of a walk by exact signs.
constexpr std::uint32_t undecided_units = 20, exact_step_units = 10;

// Calls by the stage that decided: cached, float, integer, exact, tie. Same numbering as netmesh_predicate_stage.
struct PredicateCounts {
    std::uint64_t calls[5];
};

// Sign of det(p1-p0, ..., pD-p0). p: D+1 pointers to D finite doubles.
template <int D> Sign orient(const double* const* p, PredicateCounts& counts);

// orient<k> of k+1 points in R^D when only their coordinates axes[0..k) are looked at, 1 <= k <= D.
Sign orient_projected(int k, const double* const* p, const int* axes, PredicateCounts& counts);

// Where q lies: positive strictly inside the ball that cell circumscribes, negative outside, zero on the sphere.
// cell: D+1 points, positively oriented (for negatively oriented ones the sign is the opposite).
template <int D> Sign in_ball(const double* const* cell, const double* q, PredicateCounts& counts);

// in_ball with ties broken by index: never zero when cell is positively oriented. ids[0..D] and q_id: distinct.
// The answers are those for generic weights that depend on the index only, so all of them together describe one regular
// triangulation, and every point is a vertex of it.
template <int D>
Sign in_ball_perturbed(const double* const* cell, const VertexId* ids, const double* q, VertexId q_id,
                       PredicateCounts& counts);

}  // namespace netmesh
