// Distances between diagrams. No context is needed.
#include "api/call.hpp"
#include "diagram/bottleneck.hpp"
#include "diagram/wasserstein.hpp"

namespace netmesh {
namespace {

// What both distances ask for.
template <class Request> Complaint read_request(const Request* from, Request* request) {
    const netmesh_field fault = read_struct(from, request, sizeof *request);
    if (fault != NETMESH_FIELD_NONE) return complaint_about_struct(fault);
    if (request->pairs_a == nullptr && request->count_a > 0) return {NETMESH_FIELD_PAIRS_A, "pairs_a is null"};
    if (request->pairs_b == nullptr && request->count_b > 0) return {NETMESH_FIELD_PAIRS_B, "pairs_b is null"};
    if (request->pair_bytes < sizeof(netmesh_pair))
        return {NETMESH_FIELD_PAIR_BYTES, "pair_bytes is not the size of a pair"};
    if (reinterpret_cast<std::uintptr_t>(request->scratch) % Arena::alignment != 0 ||
        (request->scratch == nullptr && request->scratch_bytes > 0))
        return {NETMESH_FIELD_SCRATCH, "scratch is null or not 16-byte aligned"};
    return complaint_about_monitor(request->monitor);
}
Complaint complaint_about_distance(const netmesh_bottleneck_request& request) {
    if (!in_range(request.scale, NETMESH_SCALE_PLAIN, NETMESH_SCALE_LOG)) return {NETMESH_FIELD_SCALE, "unknown scale"};
    return {};
}
Complaint complaint_about_distance(const netmesh_wasserstein_request& request) {
    if (request.order < 1 || request.order > NETMESH_ORDER_MAX)
        return {NETMESH_FIELD_ORDER, "order is not from 1 to 16"};
    if (!(request.relative_error >= relative_error_min && is_finite(request.relative_error)))
        return {NETMESH_FIELD_RELATIVE_ERROR, "relative_error is not a finite number of at least 2^-30"};
    if (request.degree == NETMESH_ALL_DEGREES) {
        const char* const text = "mates and potentials are those of one degree";
        if (request.mates_a != nullptr) return {NETMESH_FIELD_MATES, text};
        if (request.potentials_a != nullptr || request.potentials_b != nullptr) return {NETMESH_FIELD_POTENTIALS, text};
    }
    return {};
}

Complaint complaint_about_pairs(const PairView& a, const PairView& b, bool log_scale) {
    const char* const text = "a birth is not finite, or a death before it";
    if (!are_diagram(a, log_scale)) return {NETMESH_FIELD_PAIRS_A, text};
    if (!are_diagram(b, log_scale)) return {NETMESH_FIELD_PAIRS_B, text};
    return {};
}

bool is_log(const netmesh_bottleneck_request& request) { return request.scale == NETMESH_SCALE_LOG; }
bool is_log(const netmesh_wasserstein_request&) { return false; }
std::size_t scratch_of(const netmesh_bottleneck_request& r) { return bottleneck_bytes(r.count_a, r.count_b); }
std::size_t scratch_of(const netmesh_wasserstein_request& r) { return wasserstein_bytes(r.count_a, r.count_b); }

Status measure_distance(const netmesh_bottleneck_request& r, const PairView& a, const PairView& b, Monitor& monitor,
                        netmesh_distance* found) {
    return bottleneck({a, b, r.degree, is_log(r), r.scratch, r.scratch_bytes}, monitor, found);
}
Status measure_distance(const netmesh_wasserstein_request& r, const PairView& a, const PairView& b, Monitor& monitor,
                        netmesh_wasserstein_distance* found) {
    return wasserstein({a, b, r.degree, r.order, r.relative_error, r.scratch, r.scratch_bytes, r.mates_a,
                        r.potentials_a, r.potentials_b},
                       monitor, found);
}

// A call from request to result.
template <class Request, class Result>
netmesh_status compare(const Request* from, Result* result, netmesh_detail* detail) {
    Request request;
    Result found = {};
    Complaint complaint = read_request(from, &request);
    if (complaint.text == nullptr) complaint = complaint_about_distance(request);
    if (complaint.text == nullptr && !has_room(result)) complaint = {NETMESH_FIELD_RESULT, "distance has no size"};
    Status status = Status::invalid_argument;
    if (complaint.text == nullptr) {
        const PairView a = {request.pairs_a, request.pair_bytes, request.count_a};
        const PairView b = {request.pairs_b, request.pair_bytes, request.count_b};
        Monitor monitor = monitor_of(request.monitor);
        status = measure_distance(request, a, b, monitor, &found);
        if (status == Status::invalid_argument) complaint = complaint_about_pairs(a, b, is_log(request));
        if (status == Status::internal)
            complaint = {
                NETMESH_FIELD_RELATIVE_ERROR,
                "the bounds of the distance stay farther apart than relative_error: a defect, please report it"};
    }
    if (status == Status::ok) give_result(found, result);
    netmesh_detail said = detail_of(status, complaint.text);
    said.field = complaint.field;
    if (status == Status::out_of_memory) said.bytes_wanted = scratch_of(request);
    give_result(said, detail);
    return said.status;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

size_t netmesh_bottleneck_bytes(const netmesh_bottleneck_request* from) {
    netmesh_bottleneck_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE) return 0;
    return scratch_of(request);
}

netmesh_status netmesh_bottleneck(const netmesh_bottleneck_request* from, netmesh_distance* distance,
                                  netmesh_detail* detail) {
    return compare(from, distance, detail);
}

size_t netmesh_wasserstein_bytes(const netmesh_wasserstein_request* from) {
    netmesh_wasserstein_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE) return 0;
    return scratch_of(request);
}

netmesh_status netmesh_wasserstein(const netmesh_wasserstein_request* from, netmesh_wasserstein_distance* distance,
                                   netmesh_detail* detail) {
    return compare(from, distance, detail);
}

}  // extern "C"
