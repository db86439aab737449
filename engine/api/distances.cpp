// Homology of data that is known by its distances.
#include "api/keep_complex.hpp"
#include "api/plan.hpp"
#include "api/requests.hpp"
#include "jobs/diagram_of_distances.hpp"
#include "jobs/point_set.hpp"

namespace netmesh {
namespace {

bool is_sparse(const netmesh_distances_request& request) { return request.layout == NETMESH_DISTANCES_SPARSE; }

Complaint complaint_about_size(const netmesh_distances_request& request) {
    if (!in_range(request.layout, NETMESH_DISTANCES_FULL, NETMESH_DISTANCES_FUNCTION))
        return {NETMESH_FIELD_LAYOUT, "unknown layout of distances"};
    const bool is_tree = request.max_degree == 0 && request.representatives == 0 && !is_sparse(request);
    if (!is_tree && request.point_count > RipsGraph::vertices_max)
        return {NETMESH_FIELD_POINT_COUNT, "more than 65,536 points"};
    const Complaint complaint = complaint_about_point_count(request.point_count);
    if (complaint.text != nullptr) return complaint;
    if (request.layout == NETMESH_DISTANCES_FULL && request.point_count > SIZE_MAX / 16 / request.point_count)
        return {NETMESH_FIELD_POINT_COUNT, "such a matrix does not fit an address space"};
    if (request.layout == NETMESH_DISTANCES_LOWER && request.point_count > SIZE_MAX / 8 / request.point_count)
        return {NETMESH_FIELD_POINT_COUNT, "such a triangle does not fit an address space"};
    if (is_sparse(request) && request.entry_count >= std::uint64_t{1} << 31)
        return {NETMESH_FIELD_ENTRY_COUNT, "2^31 entries or more"};
    if (!(request.threshold >= 0)) return {NETMESH_FIELD_THRESHOLD, "threshold is negative or NaN"};
    if (request.max_degree > points_degree_max) return {NETMESH_FIELD_MAX_DEGREE, "max_degree is above 30"};
    return {};
}

Complaint complaint_about_distances(const netmesh_distances_request& request) {
    const Complaint complaint = complaint_about_size(request);
    if (complaint.text != nullptr) return complaint;
    if (is_sparse(request)) {
        if (request.entries == nullptr && request.entry_count > 0) return {NETMESH_FIELD_ENTRIES, "entries is null"};
    } else if (request.layout == NETMESH_DISTANCES_FUNCTION) {
        if (request.evaluate == nullptr) return {NETMESH_FIELD_EVALUATE, "evaluate is null"};
    } else if (request.numbers == nullptr && request.point_count > 1) {
        return {NETMESH_FIELD_NUMBERS, "numbers is null"};
    }
    return {};
}

// Requires a request that complaint_about_size finds nothing wrong with.
DistancesRequest wanted_of(const netmesh_distances_request& request) {
    DistancesRequest wanted = {};
    const std::uint32_t n = static_cast<std::uint32_t>(request.point_count);
    if (is_sparse(request))
        wanted.entries = {request.entries, static_cast<std::uint32_t>(request.entry_count), n};
    else
        wanted.source = {request.layout == NETMESH_DISTANCES_FULL    ? DistanceSource::Kind::full
                         : request.layout == NETMESH_DISTANCES_LOWER ? DistanceSource::Kind::lower
                                                                     : DistanceSource::Kind::function,
                         n,
                         request.numbers,
                         0,
                         request.evaluate,
                         request.user};
    wanted.threshold = request.threshold;
    wanted.max_degree = request.max_degree;
    wanted.keep_zero = request.keep_zero_pairs != 0;
    wanted.representatives = request.representatives != 0;
    return wanted;
}

const char* text_of_flaw(DistanceFlaw flaw) {
    switch (flaw) {
    case DistanceFlaw::none: return "more simplices than can be numbered";
    case DistanceFlaw::negative: return "a distance is negative";
    case DistanceFlaw::not_a_number: return "a distance is NaN";
    case DistanceFlaw::asymmetric: return "a distance is not the one the other way round";
    case DistanceFlaw::own: return "the distance of a point to itself is not 0";
    case DistanceFlaw::no_point: break;
    }
    return "an entry names a point that does not exist";
}

netmesh_status fail_at_distance(netmesh_context* context, Status status, const DistanceFault& fault, bool sparse) {
    if (status != Status::invalid_argument) return fail_and_clear(context, status);
    clear(context);
    const bool has_place = fault.flaw != DistanceFlaw::none;
    const netmesh_field field = sparse ? NETMESH_FIELD_ENTRIES : NETMESH_FIELD_NUMBERS;
    const netmesh_status result =
        refuse(context, {has_place ? field : NETMESH_FIELD_MAX_DEGREE, text_of_flaw(fault.flaw)}, fault.a);
    context->detail.said.index_b = fault.b;
    return result;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_persist_distances(netmesh_context* context, const netmesh_distances_request* from) {
    netmesh_distances_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    const Complaint complaint = complaint_about_distances(request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    clear(context);
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    DistancesDiagram made;
    const DistancesRequest wanted = wanted_of(request);
    const Status status = watch.heed(diagram_of_distances(wanted, {context->arena, monitor}, &made));
    if (status != Status::ok) return fail_at_distance(context, status, made.fault, is_sparse(request));
    KeptDiagram diagram;
    diagram.filter = NETMESH_FILTER_RIPS;
    diagram.max_degree = request.max_degree;
    diagram.certified_ratio = diagram.certified_ratio_best = 1;
    const std::uint32_t n = static_cast<std::uint32_t>(request.point_count);
    const KeptInput input = {true, true, 0, n, 0, made.input_fingerprint, n};
    keep_diagram(context, input, diagram, made.diagram, wanted.representatives ? &made.complex : nullptr);
    return finish(context, status);
}

size_t netmesh_plan_distances(const netmesh_distances_request* from) {
    netmesh_distances_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE) return 0;
    if (complaint_about_size(request).text != nullptr) return 0;
    return whole_bytes(distances_bytes(wanted_of(request), request.point_count) + sizeof(netmesh_context) +
                       complex_overhead);
}

}  // extern "C"
