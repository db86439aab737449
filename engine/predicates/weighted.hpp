// In-ball tests of points with weights, exact for all finite numbers.
#pragma once
#include "predicates/predicates.hpp"

namespace netmesh {

// Which point has less power at the centre that has equal powers of all points of the cell: positive when q has less
// than they, negative when it has more. Points have D coordinates and the number that weights.hpp says. cell:
// positively oriented. Never zero: ties are broken by index, as in_ball_perturbed does. Points of one index are copies
// of one another, all different and of one weight, as in a lattice: no tie is left among them either. All answers
// together describe one regular triangulation; a point that is in conflict with no cell of it is hidden. Cost: some
// microseconds, below a millisecond over the whole range of doubles. At most 8 KiB of stack.
template <int D>
Sign in_power_perturbed(const double* const* cell, const VertexId* ids, const double* q, VertexId q_id, bool are_radii,
                        PredicateCounts& counts);

}  // namespace netmesh
