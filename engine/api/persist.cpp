// Persistence on the triangulation or mesh that the context holds.
#include "api/measure.hpp"
#include "api/requests.hpp"
#include "delaunay/check.hpp"
#include "jobs/diagram_of_mesh.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {
namespace {

void keep_mesh_diagram(netmesh_context* context, const PersistRequest& request, netmesh_values values,
                       const FilterDiagram& diagram) {
    const Arena& arena = context->arena;
    KeptDiagram& kept = context->diagram;
    kept.present = true;
    kept.keeps_zero = request.diagram.keep_zero;
    kept.filter = request.filter.filter;
    kept.values = values;
    kept.max_degree = request.diagram.max_degree;
    kept.k = request.filter.k;
    kept.pairs = Slice<Pair>::of(arena, diagram.pairs.pairs, diagram.pairs.count);
    kept.is_short = diagram.is_short;
    if (diagram.value != nullptr)
        kept.vertex_values = Slice<double>::of(arena, diagram.value, context->mesh.store.vertex_count);
    kept.simplices = diagram.simplices;
    kept.certified_ratio = diagram.certificate.ratio;
    kept.certified_ratio_best = diagram.certificate.ratio_best;
    kept.certified_from = diagram.certificate.from;
    kept.certified_error = diagram.certificate.error;
    if (diagram.clip_radius > 0) context->mesh.radius = diagram.clip_radius;
}

// What is wrong with cells that were loaded: simplices of anything but a triangulation of the convex hull pair
// otherwise than those of the points do.
CheckResult check_loaded(netmesh_context& context, Monitor& monitor) {
    const AnyStore store = store_of(context);
    monitor.begin(NETMESH_STAGE_CHECK, store.state.cell_slots);
    const CheckResult found = check_combinatorial(store);
    return found.violation != nullptr || monitor.has_stopped() ? found : check_geometric(store);
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" netmesh_status netmesh_persist(netmesh_context* context, const netmesh_persist_request* from) {
    netmesh_persist_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    const Filter* const filter = find_filter(request.filter);
    if (filter == nullptr || (filter->source != FilterSource::mesh && filter->source != FilterSource::delaunay))
        return refuse(context, NETMESH_FIELD_FILTER, "not a filter on a triangulation or mesh");
    netmesh_function function = {};
    Complaint complaint = complaint_about_values(request.values);
    if (complaint.text == nullptr && filter->has(filter_trait::needs_function))
        complaint = read_function(request.function, &function);
    if (complaint.text != nullptr) return refuse(context, complaint);
    const char* const missing = missing_result(context, *filter);
    if (missing != nullptr) return finish(context, Status::no_result, missing);
    const std::uint32_t asked_k = request.k > 1 ? request.k : 1;
    complaint = complaint_about_built_filter(request.filter, asked_k);
    if (complaint.text != nullptr) return refuse(context, complaint);
    const std::uint32_t k = !filter->has(filter_trait::needs_k) ? 0 : asked_k;
    if (k > context->input.distinct)
        return refuse(context, NETMESH_FIELD_K, "k is more than the number of different points");
    const PersistRequest wanted = {{request.filter, values_of(request.values), k, &function},
                                   {degree_of(request.max_degree, context->input.dim), request.keep_zero_pairs != 0}};
    clear_diagram(context);
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    if (built::alpha && context->mesh.is_loaded && filter->source == FilterSource::delaunay) {
        const CheckResult why = check_loaded(*context, monitor);
        if (why.violation != nullptr) return finish(context, Status::check_failed, why.violation, why.cell);
        if (monitor.has_stopped()) return finish(context, Status::cancelled);
    }
    FilterDiagram diagram;
    const Status found = diagram_of_mesh(filtered_mesh_of(*context), wanted, {context->arena, monitor}, &diagram);
    const Status status = watch.heed(found);
    if (status == Status::ok) {
        keep_mesh_diagram(context, wanted, request.values, diagram);
        return finish(context, status);
    }
    clear_diagram(context);
    if (status == Status::not_finite)
        return finish(context, status, "the function is not finite at a vertex", diagram.culprit);
    return finish(context, status);
}
