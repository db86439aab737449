// Where the true bars surely are, of the diagram that the context holds.
#include "api/measure.hpp"
#include "api/requests.hpp"
#include "jobs/bound_bars.hpp"

namespace netmesh {
namespace {

Status bound_diagram(netmesh_context* context, const netmesh_function* function, Monitor& monitor, BoundedBars* bars) {
    const KeptDiagram& diagram = context->diagram;
    const Work work = {context->arena, monitor};
    const Filter* const filter = find_filter(diagram.filter);
    const BoundBarsRequest request = {{diagram.filter, values_of(diagram.values), diagram.k, function},
                                      diagram.bars(context),
                                      diagram.vertex_values.in(context),
                                      diagram.certified_error};
    const bool has_cells = filter != nullptr && filter->has(filter_trait::bounds_by_scale);
    const bool is_rounded =
        filter != nullptr && (filter->source == FilterSource::delaunay || filter->source == FilterSource::points);
    if (!has_cells || (filter->has(filter_trait::needs_function) && function == nullptr))
        return bound_bars_by_ratio({diagram.certified_ratio, is_rounded,
                                    diagram.filter == NETMESH_FILTER_FUNCTION ? diagram.certified_error : -1,
                                    diagram.k <= 1},
                                   request.bars, work, bars);
    return bound_bars(filtered_mesh_of(*context), request, work, bars);
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" netmesh_status netmesh_bound_bars(netmesh_context* context, const netmesh_bounds_request* from) {
    netmesh_bounds_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    if (!context->diagram.present) return finish(context, Status::no_result, "there is no diagram");
    netmesh_function function = {};
    const bool has_function = request.function != nullptr && context->diagram.filter == NETMESH_FILTER_FUNCTION;
    if (has_function) {
        const Complaint complaint = read_function(request.function, &function);
        if (complaint.text != nullptr) return refuse(context, complaint);
    }
    if (context->bounds.present) return finish(context, Status::ok);
    const std::size_t low = context->arena.low_mark();
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    BoundedBars bars = {};
    const Status status = watch.heed(bound_diagram(context, has_function ? &function : nullptr, monitor, &bars));
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
