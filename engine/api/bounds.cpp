#include "api/dispatch.hpp"
#include "jobs/bound_bars.hpp"

namespace netmesh {
namespace {

const Pair* pairs_of(const netmesh_context* context) {
    return reinterpret_cast<const Pair*>(reinterpret_cast<const unsigned char*>(context) + context->pairs_offset);
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_bound_bars(netmesh_context* context, const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (!usable(options)) return finish(context, Status::invalid_argument, "options are not initialised", 2);
    if (!context->has_diagram) return finish(context, Status::no_result, "there is no diagram");
    if (context->has_bounds) return finish(context, Status::ok, "");
    Monitor monitor = monitor_of(*options);
    const Work work = {context->arena, monitor};
    const BarList bars = {pairs_of(context), context->pair_count};
    BoundedBars bounded = {};
    const Filter* const row = find_filter(context->filter);
    Status status;
    if (row != nullptr && row->has(filter_trait::bounds_by_scale)) {
        const FilterRequest filter = {
            row->id, context->values == NETMESH_VALUES_THESIS ? FilterValues::thesis : FilterValues::certified,
            context->k};
        status = with_dimension(context->dim, [&](auto dimension) {
            constexpr int D = decltype(dimension)::value;
            Store<D> store(context->arena, context->store);
            return bound_bars<D>({store, domain_of<D>(*context), context->inputs}, {filter, bars}, work, &bounded);
        });
    } else {
        status = bound_bars_by_ratio(context->certified_ratio, bars, work, &bounded);
    }
    if (status != Status::ok)
        return finish(context, status, netmesh_status_text(static_cast<netmesh_status>(status)));
    context->has_bounds = true;
    context->bounds_offset = context->arena.offset_of(bounded.bounds);
    context->curve_offset = context->arena.offset_of(bounded.curve.steps);
    context->curve_steps = bounded.curve.count;
    return finish(context, Status::ok, "");
}

netmesh_status netmesh_get_bar_bounds(const netmesh_context* context, uint64_t index, netmesh_bar_bounds* bounds) {
    if (bounds == nullptr || context == nullptr || context->magic != context_magic || !context->has_bounds ||
        index >= context->pair_count)
        return NETMESH_INVALID_ARGUMENT;
    const BarBounds& b = reinterpret_cast<const BarBounds*>(reinterpret_cast<const unsigned char*>(context) +
                                                            context->bounds_offset)[index];
    *bounds = {b.birth_low, b.birth_high, b.death_low, b.death_high, b.certain_after, b.certain};
    return NETMESH_OK;
}

netmesh_status netmesh_get_scale_step(const netmesh_context* context, uint64_t index, netmesh_scale_step* step) {
    if (step == nullptr || context == nullptr || context->magic != context_magic || !context->has_bounds ||
        index >= context->curve_steps)
        return NETMESH_INVALID_ARGUMENT;
    const ScaleStep& s = reinterpret_cast<const ScaleStep*>(reinterpret_cast<const unsigned char*>(context) +
                                                            context->curve_offset)[index];
    *step = {s.from, s.reach, step_ratio(s, context->certified_ratio)};
    return NETMESH_OK;
}

}  // extern "C"
