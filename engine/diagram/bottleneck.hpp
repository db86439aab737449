// Bottleneck distance between persistence diagrams. Thesis 6.5.
#pragma once
#include <cstddef>
#include <cstdint>

#include "include/netmesh.h"
#include "vocabulary/monitor.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// Pairs as the caller has them: `stride` bytes from one to the next, as its netmesh_pair may be of a later version.
struct PairView {
    const void* first;
    std::size_t stride;  // >= sizeof(netmesh_pair)
    std::uint64_t count;
    Monitor* monitor = nullptr;  // is told of loops over the pairs; null: nobody is

    void report(std::uint64_t i) const {
        if (i % 256 == 0 && monitor != nullptr) monitor->pass(25);
    }
    netmesh_pair operator[](std::size_t i) const {
        report(i);
        netmesh_pair pair;
        __builtin_memcpy(&pair, static_cast<const unsigned char*>(first) + i * stride, sizeof pair);
        return pair;
    }
};

struct DistanceRequest {
    PairView a, b;
    std::uint32_t degree;  // or NETMESH_ALL_DEGREES
    bool log_scale;
    void* scratch;  // 16-byte aligned
    std::size_t scratch_bytes;
};

// Are births finite and deaths not before them; on the log scale, are births not negative?
bool are_diagram(const PairView& pairs, bool log_scale);

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
