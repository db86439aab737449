// Distances between diagrams. No context is needed.
#include "api/call.hpp"
#include "diagram/bottleneck.hpp"

namespace netmesh {
namespace {

Complaint read_request(const netmesh_bottleneck_request* from, netmesh_bottleneck_request* request) {
    const netmesh_field fault = read_struct(from, request, sizeof *request);
    if (fault != NETMESH_FIELD_NONE) return complaint_about_struct(fault);
    if (request->pairs_a == nullptr && request->count_a > 0) return {NETMESH_FIELD_PAIRS_A, "pairs_a is null"};
    if (request->pairs_b == nullptr && request->count_b > 0) return {NETMESH_FIELD_PAIRS_B, "pairs_b is null"};
    if (request->pair_bytes < sizeof(netmesh_pair))
        return {NETMESH_FIELD_PAIR_BYTES, "pair_bytes is not the size of a pair"};
    if (!in_range(request->scale, NETMESH_SCALE_PLAIN, NETMESH_SCALE_LOG))
        return {NETMESH_FIELD_SCALE, "unknown scale"};
    if (reinterpret_cast<std::uintptr_t>(request->scratch) % Arena::alignment != 0 ||
        (request->scratch == nullptr && request->scratch_bytes > 0))
        return {NETMESH_FIELD_SCRATCH, "scratch is null or not 16-byte aligned"};
    return {};
}

Complaint complaint_about_pairs(const DistanceRequest& asked) {
    const char* const text = "a birth is not finite, or a death before it";
    if (!are_diagram(asked.a, asked.log_scale)) return {NETMESH_FIELD_PAIRS_A, text};
    if (!are_diagram(asked.b, asked.log_scale)) return {NETMESH_FIELD_PAIRS_B, text};
    return {};
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

size_t netmesh_bottleneck_bytes(const netmesh_bottleneck_request* from) {
    netmesh_bottleneck_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE) return 0;
    return bottleneck_bytes(request.count_a, request.count_b);
}

netmesh_status netmesh_bottleneck(const netmesh_bottleneck_request* from, netmesh_distance* distance,
                                  netmesh_detail* detail) {
    netmesh_bottleneck_request request;
    netmesh_distance found = {};
    Complaint complaint = read_request(from, &request);
    if (complaint.text == nullptr && !has_room(distance)) complaint = {NETMESH_FIELD_RESULT, "distance has no size"};
    Status status = Status::invalid_argument;
    if (complaint.text == nullptr) {
        const DistanceRequest asked = {{request.pairs_a, request.pair_bytes, request.count_a},
                                       {request.pairs_b, request.pair_bytes, request.count_b},
                                       request.degree,
                                       request.scale == NETMESH_SCALE_LOG,
                                       request.scratch,
                                       request.scratch_bytes};
        Monitor monitor = monitor_of(request.monitor);
        status = bottleneck(asked, monitor, &found);
        if (status == Status::invalid_argument) complaint = complaint_about_pairs(asked);
    }
    if (status == Status::ok) give_result(found, distance);
    netmesh_detail said = detail_of(status, complaint.text);
    said.field = complaint.field;
    if (status == Status::out_of_memory) said.bytes_wanted = bottleneck_bytes(request.count_a, request.count_b);
    give_result(said, detail);
    return said.status;
}

}  // extern "C"
