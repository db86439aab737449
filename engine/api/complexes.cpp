// Homology of complexes that are not meshes: of points themselves, and given by their simplices.
#include "api/keep_complex.hpp"
#include "api/plan.hpp"
#include "api/points.hpp"
#include "api/requests.hpp"
#include "api/simplices.hpp"
#include "filtration/filters.hpp"
#include "jobs/diagram_of_points.hpp"
#include "jobs/diagram_of_simplices.hpp"
#include "numerics/real.hpp"

namespace netmesh {
namespace {

// Rips complexes need nothing but distances.
std::uint32_t dim_max_of(const netmesh_points_request& request) {
    return in_range(request.filter, NETMESH_FILTER_RIPS, NETMESH_FILTER_RIPS) ? NETMESH_RIPS_DIM_MAX : NETMESH_DIM_MAX;
}

Complaint complaint_about_complex(const netmesh_points_request& request) {
    const Filter* const filter = find_filter(request.filter);
    if (filter == nullptr || filter->source != FilterSource::points)
        return {NETMESH_FIELD_FILTER, "the filter is not one on points"};
    const Complaint complaint = complaint_about_values(request.values);
    if (complaint.text != nullptr) return complaint;
    const bool with_k = filter->has(filter_trait::needs_k);
    if (with_k && request.k == 0) return {NETMESH_FIELD_K, "k is 0"};
    if (request.max_degree > points_degree_max) return {NETMESH_FIELD_MAX_DEGREE, "max_degree is above 30"};
    if (with_k && request.k > points_degree_max) return {NETMESH_FIELD_K, "k is above 30"};
    if (with_k && request.k + request.max_degree > points_degree_max)
        return {NETMESH_FIELD_MAX_DEGREE, "k + max_degree is above 30"};
    if (!(request.threshold >= 0)) return {NETMESH_FIELD_THRESHOLD, "threshold is negative or NaN"};
    if (request.threshold > 0 && request.threshold < infinity && dim_max_of(request) == NETMESH_DIM_MAX)
        return {NETMESH_FIELD_THRESHOLD, "threshold is for the filter RIPS"};
    if (request.representatives != 0 && !filter->has(filter_trait::has_cycles))
        return {NETMESH_FIELD_REPRESENTATIVES, "there are no representatives of barycentric filtrations"};
    return {};
}

PointsFilter points_filter_of(const netmesh_points_request& request) {
    return {request.filter, values_of(request.values), request.k, request.max_degree};
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_persist_points(netmesh_context* context, const netmesh_points_request* from) {
    netmesh_points_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    Complaint complaint = complaint_about_points(request, dim_max_of(request));
    if (complaint.text == nullptr) complaint = complaint_about_complex(request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    clear(context);
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    const PointsRequest wanted = {points_filter_of(request),
                                  rows_of(request),
                                  static_cast<std::uint32_t>(request.point_count),
                                  request.dim,
                                  request.threshold > 0 ? request.threshold : infinity,
                                  request.keep_zero_pairs != 0,
                                  request.representatives != 0};
    PointsDiagram made;
    const Status status = watch.heed(diagram_of_points(wanted, {context->arena, monitor}, &made));
    if (status != Status::ok) return fail_at_points(context, status, NETMESH_FIELD_K, made);
    KeptDiagram diagram;
    diagram.filter = request.filter;
    diagram.values = request.values;
    diagram.max_degree = request.max_degree;
    diagram.k = find_filter(request.filter)->has(filter_trait::needs_k) ? request.k : 0;
    diagram.certified_ratio = diagram.certified_ratio_best = made.ratio;
    keep_diagram(context, input_of(request, made), diagram, made.diagram, made.is_listed ? &made.complex : nullptr);
    return finish(context, status);
}

size_t netmesh_plan_points(const netmesh_points_request* from) {
    netmesh_points_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE) return 0;
    if (request.point_count == 0 || request.point_count > NETMESH_POINTS_MAX) return 0;
    const bool is_large = request.dim > NETMESH_DIM_MAX && request.dim <= dim_max_of(request);
    if (!is_large && complaint_about_dim(request.dim).text != nullptr) return 0;
    if (complaint_about_layout(given_rows(request)).text != nullptr) return 0;
    if (complaint_about_complex(request).text != nullptr) return 0;
    return whole_bytes(points_bytes(points_filter_of(request), request.point_count, request.dim) +
                       sizeof(netmesh_context) + complex_overhead);
}

netmesh_status netmesh_homology(netmesh_context* context, const netmesh_homology_request* from) {
    netmesh_homology_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    const Complaint complaint = complaint_about_simplices(request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    clear(context);
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    const SimplexList list = {request.vertices, request.starts, request.entries, request.simplex_count};
    const ComplexRequest wanted = {{request.max_degree, request.keep_zero_pairs != 0}, request.representatives != 0};
    SimplicesDiagram made;
    const Status status = watch.heed(diagram_of_simplices(list, wanted, {context->arena, monitor}, &made));
    if (status != Status::ok) return fail_at_simplex(context, status, made.listed.fault);
    KeptDiagram diagram;
    diagram.max_degree = made.max_degree;
    diagram.certified_ratio = diagram.certified_ratio_best = 1;
    const KeptInput input = {true, true, 0, 0, 0, made.listed.input_fingerprint, made.listed.complex.count[0]};
    keep_diagram(context, input, diagram, made.diagram, wanted.representatives ? &made.listed.complex : nullptr);
    return finish(context, status);
}

size_t netmesh_plan_homology(const netmesh_homology_request* from) {
    netmesh_homology_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE) return 0;
    if (request.simplex_count == 0 || request.vertex_count < request.simplex_count) return 0;
    if (request.vertex_count > UINT64_MAX / 128) return 0;
    return whole_bytes(simplices_bytes(request.simplex_count, request.vertex_count) + complex_overhead);
}

}  // extern "C"
