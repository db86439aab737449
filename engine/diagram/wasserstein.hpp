// Wasserstein distances between persistence diagrams, with potentials that bound them from below.
#pragma once
#include <cstddef>
#include <cstdint>

#include "diagram/pair_view.hpp"
#include "diagram/transport_cost.hpp"
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
// step becomes smaller from round to round, starting from the potentials of the round before, until the distance found
// is within the relative error of the bound that the potentials prove. What costs more than the best matching so far is
// cut off there, which changes no optimum: so potentials are never far larger than what is sought. invalid_argument,
// out_of_memory, cancelled.
Status wasserstein(const WassersteinRequest& request, Monitor& monitor, netmesh_wasserstein_distance* distance);

}  // namespace netmesh
