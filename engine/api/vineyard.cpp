// Vineyards of the mesh that the context holds, of points, and of the caller's own values.
#include "api/measure.hpp"
#include "api/request.hpp"
#include "api/settling.hpp"
#include "api/simplices.hpp"
#include "jobs/k_vineyard.hpp"
#include "jobs/points_vineyard.hpp"
#include "jobs/value_vineyard.hpp"

namespace netmesh {
namespace {

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

KeptVineyard vineyard_of(const netmesh_request& r, std::uint32_t max_degree) {
    KeptVineyard kept;
    kept.filter = r.filter->id;
    kept.values = r.values;
    kept.max_degree = max_degree;
    kept.k_first = r.k;
    kept.k_last = r.k_last;
    return kept;
}

netmesh_status vines_of_mesh(netmesh_context* context) {
    const netmesh_request& r = context->request;
    const char* const missing = missing_mesh(context);
    if (missing != nullptr) return finish(context, Status::no_result, missing);
    if (r.k_last > context->input.distinct)
        return refuse(context, NETMESH_FIELD_K_LAST, "k is more than the number of different points");
    clear_diagram(context);
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    VineList vines = {};
    const VineRequest wanted = {r.filter->id, r.filter->on_mesh,   r.k,
                                r.k_last,     values_of(r.values), degree_of(r.max_degree, context->input.dim)};
    const Status found = k_vineyard(filtered_mesh_of(*context), wanted, {context->arena, monitor}, &vines);
    const Status status = watch.heed(found);
    status == Status::ok ? keep_vineyard(context, vineyard_of(r, wanted.max_degree), vines) : clear_diagram(context);
    return finish(context, status);
}

netmesh_status vines_of_points(netmesh_context* context) {
    const netmesh_request& r = context->request;
    clear(context);
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    const std::uint32_t count = static_cast<std::uint32_t>(r.points.count);
    const PointsVineyardRequest wanted = {
        {rows_of(r.points), count, r.points.dim}, {r.filter->id, values_of(r.values), r.k, r.max_degree}, r.k_last};
    PointsVineyard made;
    const Status status = watch.heed(points_vineyard(wanted, {context->arena, monitor}, &made));
    if (status != Status::ok) return fail_at_points(context, status, NETMESH_FIELD_K_LAST, made);
    context->complete = true;
    context->input = input_of(r.points, made);
    keep_vineyard(context, vineyard_of(r, r.max_degree), made.vines);
    return finish(context, status);
}

netmesh_status vines_of_values(netmesh_context* context) {
    const netmesh_request& r = context->request;
    netmesh_simplices given;
    const Complaint complaint = read_simplices(r, &given);
    if (complaint.text != nullptr) return refuse(context, complaint);
    clear(context);
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    const ValueVineyardRequest wanted = {{given.vertices, given.starts, nullptr, given.simplex_count},
                                         given.entries,
                                         static_cast<std::uint32_t>(given.step_count),
                                         given.by_vertex != 0,
                                         r.max_degree};
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

Complaint settle_vines(const Settling& s) {
    if (s.r.bounds != nullptr || s.r.cycles != nullptr || s.r.fit != nullptr)
        return {NETMESH_FIELD_VINES, "vines stand alone: leave out bounds, cycles and fit"};
    return s.r.keep_zero_pairs != 0
               ? Complaint{NETMESH_FIELD_KEEP_ZERO_PAIRS, "vines have no pairs of zero length; leave it out"}
               : fine();
}

netmesh_status run_vines(netmesh_context* context) {
    const netmesh_request& r = context->request;
    if (r.simplices != nullptr) return vines_of_values(context);
    const bool of_points = source_of(r) == Source::points;
    if (r.filter->on_mesh == nullptr)
        return of_points ? vines_of_points(context)
                         : refuse(context, NETMESH_FIELD_POINTS, "this filter begins with points");
    const netmesh_status status = of_points ? dispatch(*r.mesh.method, context) : NETMESH_OK;
    return status == NETMESH_OK ? vines_of_mesh(context) : status;
}

}  // namespace
}  // namespace netmesh

extern "C" {
extern const netmesh_want netmesh_vines;
const netmesh_want netmesh_vines = {netmesh::Want::vines, netmesh::run_vines, netmesh::settle_vines, nullptr};
}
