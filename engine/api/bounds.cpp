// Where the true bars surely are, of the diagram that the context holds.
#include "api/measure.hpp"
#include "api/request.hpp"
#include "jobs/bound_bars.hpp"

namespace netmesh {
namespace {

Status bound_diagram(netmesh_context* context, const netmesh_function* function, Monitor& monitor, BoundedBars* bars) {
    const KeptDiagram& diagram = context->diagram;
    const Work work = {context->arena, monitor};
    const Filter* const filter = find_filter(diagram.filter);
    const BoundBarsRequest request = {
        {diagram.filter, context->request.filter->on_mesh, values_of(diagram.values), diagram.k, function},
        diagram.bars(context),
        diagram.vertex_values.in(context),
        diagram.certified_error};
    const bool has_cells = filter != nullptr && filter->has(filter_trait::bounds_by_scale);
    const bool is_rounded =
        filter != nullptr && (filter->source == FilterSource::delaunay || filter->source == FilterSource::points);
    // Of a function that is not said the one bound of all bars is left.
    const bool by_error = diagram.filter == NETMESH_FILTER_FUNCTION && function == nullptr;
    if (!has_cells || by_error)
        return bound_bars_by_ratio(
            {diagram.certified_ratio, is_rounded, by_error ? diagram.certified_error : -1, diagram.k <= 1},
            request.bars, work, bars);
    return bound_bars(filtered_mesh_of(*context), request, work, bars);
}

netmesh_status run_bounds(netmesh_context* context) {
    const netmesh_request& r = context->request;
    if (context->bounds.present) return finish(context, Status::ok);
    if (context->input.weighting != NETMESH_WEIGHTING_NONE) return finish(context, Status::no_result, weighted_cells);
    netmesh_function function = {};
    if (r.function != nullptr) {
        const Complaint complaint = read_function(r.function, &function);
        if (complaint.text != nullptr) return refuse(context, complaint);
    }
    const std::size_t low = context->arena.low_mark();
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    BoundedBars bars = {};
    const netmesh_function* const read = r.function != nullptr ? &function : nullptr;
    const Status status = watch.heed(bound_diagram(context, read, monitor, &bars));
    if (status != Status::ok) {
        context->arena.release_low(low);
        if (status == Status::invalid_argument || status == Status::not_finite)
            return refuse(context, NETMESH_FIELD_FUNCTION, "not the function that the diagram is of");
        return finish(context, status);
    }
    context->bounds.present = true;
    context->bounds.bars = Slice<BarBounds>::of(context->arena, bars.bounds, context->diagram.pairs.count);
    context->bounds.steps = Slice<ScaleStep>::of(context->arena, bars.curve.steps, bars.curve.count);
    return finish(context, status);
}

}  // namespace
}  // namespace netmesh

extern "C" {
extern const netmesh_want netmesh_bounds;
const netmesh_want netmesh_bounds = {netmesh::Want::bounds, netmesh::run_bounds, nullptr, nullptr};
}
