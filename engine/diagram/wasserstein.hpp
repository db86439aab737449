// Wasserstein distances between persistence diagrams, with potentials that bound them from below.
#pragma once
#include <cstddef>
#include <cstdint>

#include "diagram/pair_view.hpp"
#include "diagram/transport_cost.hpp"
#include "include/netmesh/distance.h"
#include "vocabulary/monitor.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

struct WassersteinRequest {
    PairView a, b;
    std::uint32_t degree;  // or NETMESH_ALL_DEGREES
    std::uint32_t order;   // 1 to Power::order_max
    double relative_error;
    void* scratch;  // 16-byte aligned
    std::size_t scratch_bytes;
    // For one degree, each may be null: see netmesh_wasserstein_request.
    std::uint32_t* mates_a;
    double *potentials_a, *potentials_b;
};

constexpr double relative_error_min = 0x1p-30;

// Bytes of scratch for diagrams of so many pairs, SIZE_MAX when that does not fit.
std::size_t wasserstein_bytes(std::uint64_t count_a, std::uint64_t count_b);

// What the result means, and which pairs are admitted: netmesh_wasserstein in netmesh/wasserstein.h.
//
// A matching of the points off the diagonals costs sum c(a, b) over its pairs plus what the others' ways to the
// diagonal cost. Potentials f of the points with f(a) + f(b) <= c(a, b), and none above the cost of the way to the
// diagonal, sum up to no more than any matching costs (duality of transport). Both are found by auctions (Bertsekas):
// first the points of a bid for those of b, whose potentials go down; then the points of b that were left, and whose
// potentials are below their way to the diagonal, bid for those of a. Each bid keeps f(a) + f(b) <= c(a, b) + step,
// with equality for matched points, so matching and potentials are within (count_a + count_b) step of one another. The
// step becomes smaller from round to round, starting from the potentials of the round before. The best matching of all
// rounds is kept. A round's potentials and the best matching bound the distance; when the bounds are within the
// relative error of one another, that is the end, and nothing else is.
//
// Auctions are about costs in whole numbers, c' = floor(2^grid c), and 2^59 or more, the ceiling, for what costs as
// much as the best matching so far or more. Nothing is rounded in an auction, then, and as a step is at least 1, each
// bid lowers a potential, which is never below -2^61: it ends. A ceiling changes no optimum, as no matching with such a
// cost is better than the best; so potentials are never far larger than what is sought.
//
// A round with step 1 is the last, or finds a matching that costs less than half of the best so far, for whose grid the
// step is larger. For n = count_a + count_b < 2^26 let S be the sum of the potentials and M the round's matching, whose
// cost in whole numbers is at most S + n. Either it has a cost at the ceiling, C: then the best matching so far costs
// C, at most S + n. Or M costs less than S + 2n in the grid's unit, and what is best now at most that. If that is C / 2
// or more, n is at most 2^-32 of it, and the bounds are within 2^-31 of one another as sums, and roundings within 2^-45
// more, which is less than the least relative error, 2^-30, on roots of any order p. Were they not, internal is what
// comes of it. Rounds are at most 60 and twice log2 of how many times the first matching costs what the best does.
//
// Sums of costs and of potentials are within a few roundings of the exact ones whatever their length (PositiveSum,
// WholeSum, Total in transport_sums.hpp, where each bound has its roundings beside it). invalid_argument,
// out_of_memory, cancelled, internal.
Status wasserstein(const WassersteinRequest& request, Monitor& monitor, netmesh_wasserstein_distance* distance);

}  // namespace netmesh
