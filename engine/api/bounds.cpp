// Where the true bars surely are, of the diagram that the context holds.
#include "api/measure.hpp"
#include "api/requests.hpp"
#include "jobs/bound_bars.hpp"

namespace netmesh {
namespace {

Status bound(netmesh_context* context, Monitor& monitor, BoundedBars* bars) {
    const KeptDiagram& diagram = context->diagram;
    const Work work = {context->arena, monitor};
    const Filter* const filter = find_filter(diagram.filter);
    const BoundBarsRequest request = {{diagram.filter, values_of(diagram.values), diagram.k},
                                      {diagram.pairs.in(context), diagram.pairs.count}};
    if (filter == nullptr || !filter->has(filter_trait::bounds_by_scale))
        return bound_bars_by_ratio({diagram.certified_ratio, diagram.value_error,
                                    diagram.filter == NETMESH_FILTER_FUNCTION ? diagram.certified_error : -1,
                                    filter == nullptr || filter->source != FilterSource::points},
                                   request.bars, work, bars);
    return with_dimension(context->input.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Store<D> store(context->arena, context->mesh.store);
        return bound_bars<D>(filtered_mesh_of<D>(*context, store), request, work, bars);
    });
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" netmesh_status netmesh_bound_bars(netmesh_context* context, const netmesh_bounds_request* from) {
    netmesh_bounds_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    if (!context->diagram.present) return finish(context, Status::no_result, "there is no diagram");
    if (context->bounds.present) return finish(context, Status::ok);
    const std::size_t low = context->arena.low_mark();
    Monitor monitor = monitor_of(request.monitor);
    BoundedBars bars = {};
    const Status status = bound(context, monitor, &bars);
    if (status != Status::ok) {
        context->arena.release_low(low);
        return finish(context, status);
    }
    context->bounds.present = true;
    context->bounds.bars = Slice<BarBounds>::of(context->arena, bars.bounds, context->diagram.pairs.count);
    context->bounds.steps = Slice<ScaleStep>::of(context->arena, bars.curve.steps, bars.curve.count);
    return finish(context, status);
}
