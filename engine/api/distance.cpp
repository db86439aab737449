#include "api/dispatch.hpp"
#include "diagram/bottleneck.hpp"

using namespace netmesh;

extern "C" {

size_t netmesh_bottleneck_bytes(uint64_t count_a, uint64_t count_b) { return bottleneck_bytes(count_a, count_b); }

netmesh_status netmesh_bottleneck(const netmesh_pair* a, size_t count_a, const netmesh_pair* b, size_t count_b,
                                  uint32_t degree, netmesh_scale scale, void* scratch, size_t scratch_bytes,
                                  netmesh_poll poll, void* user, netmesh_distance* distance) {
    if ((a == nullptr && count_a > 0) || (b == nullptr && count_b > 0) || distance == nullptr ||
        !in_range(scale, NETMESH_SCALE_PLAIN, NETMESH_SCALE_LOG) || (scratch == nullptr && scratch_bytes > 0) ||
        reinterpret_cast<std::uintptr_t>(scratch) % Arena::alignment != 0) {
        return NETMESH_INVALID_ARGUMENT;
    }
    Monitor monitor(poll, user);
    return static_cast<netmesh_status>(bottleneck(a, count_a, b, count_b, degree, scale == NETMESH_SCALE_LOG, scratch,
                                                  scratch_bytes, monitor, distance));
}

}  // extern "C"
