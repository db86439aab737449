// Vineyards of the mesh that the context holds, of points, and of the caller's own values.
#include "api/measure.hpp"
#include "api/plan.hpp"
#include "api/points.hpp"
#include "api/requests.hpp"
#include "api/simplices.hpp"
#include "jobs/k_vineyard.hpp"
#include "jobs/points_vineyard.hpp"
#include "jobs/value_vineyard.hpp"

namespace netmesh {
namespace {

Complaint complaint_about(const netmesh_vineyard_request& request) {
    const Filter* const filter = find_filter(request.filter);
    if (filter == nullptr || !filter->has(filter_trait::has_vineyard))
        return {NETMESH_FIELD_FILTER, "the filter has no k on a mesh"};
    if (request.k_first < 1) return {NETMESH_FIELD_K_FIRST, "k begins at 1"};
    if (request.k_last < request.k_first) return {NETMESH_FIELD_K_LAST, "the last k is below the first"};
    const Complaint complaint = complaint_about_values(request.values);
    return complaint.text != nullptr ? complaint : complaint_about_built_filter(request.filter, request.k_last);
}

Complaint complaint_about(const netmesh_value_vineyard_request& request) {
    if (request.step_count == 0) return {NETMESH_FIELD_STEP_COUNT, "there are no steps"};
    if (request.step_count >= none) return {NETMESH_FIELD_STEP_COUNT, "more than 2^32 - 2 steps"};
    return complaint_about_simplices(request);
}

Complaint complaint_about(const netmesh_points_vineyard_request& request) {
    const Filter* const filter = find_filter(request.filter);
    if (filter == nullptr || filter->source != FilterSource::points || !filter->has(filter_trait::needs_k))
        return {NETMESH_FIELD_FILTER, "the filter has no k on points"};
    if (request.k_first < 1) return {NETMESH_FIELD_K_FIRST, "k begins at 1"};
    if (request.k_last < request.k_first) return {NETMESH_FIELD_K_LAST, "the last k is below the first"};
    if (request.k_last > points_degree_max) return {NETMESH_FIELD_K_LAST, "k is above 30"};
    if (request.max_degree > points_degree_max - request.k_last)
        return {NETMESH_FIELD_MAX_DEGREE, "k + max_degree is above 30"};
    return complaint_about_values(request.values);
}

PointsFilter filter_of(const netmesh_points_vineyard_request& request) {
    return {request.filter, values_of(request.values), request.k_first, request.max_degree};
}

// What the vines are of is for the caller to say: `kept` comes with filter, values and degree.
void keep_vineyard(netmesh_context* context, const KeptVineyard& kept, const VineList& vines) {
    const Arena& arena = context->arena;
    context->vineyard = kept;
    KeptVineyard& now = context->vineyard;
    const std::uint32_t count = kept.k_last - kept.k_first + 1;
    now.present = true;
    now.vines = vines.vine_count;
    now.ratios = Slice<double>::of(arena, vines.ratio, count);
    now.points = Slice<VinePoint>::of(arena, vines.points, vines.count);
    now.simplices = vines.simplices;
    now.transpositions = vines.transpositions;
    now.certified_ratio = 1;
    for (std::uint32_t i = 0; i < count; ++i)
        if (!(vines.ratio[i] <= now.certified_ratio)) now.certified_ratio = vines.ratio[i];
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_vineyard(netmesh_context* context, const netmesh_vineyard_request* from) {
    netmesh_vineyard_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    const Complaint complaint = complaint_about(request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    const char* const missing = missing_result(context, *find_filter(request.filter));
    if (missing != nullptr) return finish(context, Status::no_result, missing);
    if (request.k_last > context->input.distinct)
        return refuse(context, NETMESH_FIELD_K_LAST, "k is more than the number of different points");
    clear_diagram(context);
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    VineList vines = {};
    const VineRequest wanted = {request.filter, request.k_first, request.k_last, values_of(request.values),
                                degree_of(request.max_degree, context->input.dim)};
    const Status found = k_vineyard(filtered_mesh_of(*context), wanted, {context->arena, monitor}, &vines);
    const Status status = watch.heed(found);
    KeptVineyard kept;
    kept.filter = request.filter;
    kept.values = request.values;
    kept.max_degree = wanted.max_degree;
    kept.k_first = request.k_first;
    kept.k_last = request.k_last;
    status == Status::ok ? keep_vineyard(context, kept, vines) : clear_diagram(context);
    return finish(context, status);
}

netmesh_status netmesh_points_vineyard(netmesh_context* context, const netmesh_points_vineyard_request* from) {
    netmesh_points_vineyard_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    Complaint complaint = complaint_about_points(request);
    if (complaint.text == nullptr) complaint = complaint_about(request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    clear(context);
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    const std::uint32_t count = static_cast<std::uint32_t>(request.point_count);
    const PointsVineyardRequest wanted = {{rows_of(request), count, request.dim}, filter_of(request), request.k_last};
    PointsVineyard made;
    const Status status = watch.heed(points_vineyard(wanted, {context->arena, monitor}, &made));
    if (status != Status::ok) return fail_at_points(context, status, NETMESH_FIELD_K_LAST, made);
    context->complete = true;
    context->input = input_of(request, made);
    KeptVineyard kept;
    kept.filter = request.filter;
    kept.values = request.values;
    kept.max_degree = request.max_degree;
    kept.k_first = request.k_first;
    kept.k_last = request.k_last;
    keep_vineyard(context, kept, made.vines);
    return finish(context, status);
}

size_t netmesh_plan_points_vineyard(const netmesh_points_vineyard_request* from) {
    netmesh_points_vineyard_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE) return 0;
    if (request.point_count == 0 || request.point_count > NETMESH_POINTS_MAX) return 0;
    if (complaint_about_dim(request.dim).text != nullptr || complaint_about(request).text != nullptr) return 0;
    if (complaint_about_layout(given_rows(request)).text != nullptr) return 0;
    const double bytes = points_vineyard_bytes(filter_of(request), request.k_last, request.point_count, request.dim);
    return whole_bytes(bytes + sizeof(netmesh_context) + complex_overhead);
}

netmesh_status netmesh_value_vineyard(netmesh_context* context, const netmesh_value_vineyard_request* from) {
    netmesh_value_vineyard_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    const Complaint complaint = complaint_about(request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    clear(context);
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    const ValueVineyardRequest wanted = {{request.vertices, request.starts, nullptr, request.simplex_count},
                                         request.entries,
                                         static_cast<std::uint32_t>(request.step_count),
                                         request.by_vertex != 0,
                                         request.max_degree};
    ValueVineyard made;
    const Status status = watch.heed(value_vineyard(wanted, {context->arena, monitor}, &made));
    if (status != Status::ok) return fail_at_simplex(context, status, made.fault, made.step);
    context->complete = true;
    context->input = {true, true, 0, 0, 0, made.input_fingerprint, made.vertices};
    KeptVineyard kept;
    kept.max_degree = made.max_degree;
    kept.k_first = 1;
    kept.k_last = wanted.steps;
    keep_vineyard(context, kept, made.vines);
    return finish(context, status);
}

size_t netmesh_plan_value_vineyard(const netmesh_value_vineyard_request* from) {
    netmesh_value_vineyard_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE) return 0;
    if (request.simplex_count == 0 || request.vertex_count < request.simplex_count) return 0;
    if (request.vertex_count > UINT64_MAX / 128 || request.step_count == 0 || request.step_count >= none) return 0;
    return whole_bytes(value_vineyard_bytes(request.simplex_count, request.vertex_count, request.step_count) +
                       complex_overhead);
}

}  // extern "C"
