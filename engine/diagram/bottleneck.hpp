// Bottleneck distance between persistence diagrams. Thesis 6.5.
#pragma once
#include <cstddef>
#include <cstdint>

#include "diagram/pair_view.hpp"
#include "include/netmesh/distance.h"
#include "vocabulary/monitor.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

struct DistanceRequest {
    PairView a, b;
    std::uint32_t degree;  // or NETMESH_ALL_DEGREES
    bool log_scale;
    void* scratch;  // 16-byte aligned
    std::size_t scratch_bytes;
};

// Bytes of scratch for diagrams of so many pairs, SIZE_MAX when that does not fit.
std::size_t bottleneck_bytes(std::uint64_t count_a, std::uint64_t count_b);

// The distance between a and b in one degree, or the largest of all degrees. What the result means, and which pairs are
// admitted: netmesh_bottleneck in netmesh/bottleneck.h.
//
// The limit is sought by bisection among the keys of cost.hpp; each step either finds a matching, whose largest edge is
// the new upper bound, or a set of points with too few partners, whose nearest further partner is the new lower bound.
// A matching that covers one diagram's points off the diagonal and one that covers the other's together contain one
// that covers both (Mendelsohn and Dulmage), so the two are sought apart and points of the diagonal never appear.
// invalid_argument, out_of_memory, cancelled.
Status bottleneck(const DistanceRequest& request, Monitor& monitor, netmesh_distance* distance);

}  // namespace netmesh
