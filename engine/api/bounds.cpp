#include "api/dispatch.hpp"
#include "filtration/bar_bounds.hpp"
#include "filtration/function_filter.hpp"
#include "filtration/tight_filter.hpp"

namespace netmesh {
namespace {

const Pair* pairs_of(const netmesh_context* context) {
    return reinterpret_cast<const Pair*>(reinterpret_cast<const unsigned char*>(context) + context->pairs_offset);
}

// The filter's values and intervals anew.
template <int D>
Status measure(const netmesh_context* context, const Store<D>& store, Arena& arena, Monitor& monitor, double* value,
               Interval* interval) {
    const Domain<D> domain = domain_of<D>(*context);
    const FilterValues kind =
        context->values == NETMESH_VALUES_THESIS ? FilterValues::thesis : FilterValues::certified;
    MeshCertificate certificate;
    if (context->k > 1) {
        const InputDistance distance =
            context->filter == NETMESH_FILTER_KNN ? InputDistance::kth : InputDistance::root_mean_square;
        return distance_filter_values<D>(store, domain, context->inputs, distance, context->k, kind, arena, monitor,
                                         value, &certificate, interval);
    }
    monitor.begin(NETMESH_STAGE_CERTIFY, context->store.cell_slots);
    if (context->filter == NETMESH_FILTER_TIGHT)
        return tight_filter_values<D>(store, domain, context->inputs, kind, arena, value, &certificate, interval);
    return mesh_filter_values<D>(store, domain, MeshFilter::complete, kind, arena, value, &certificate, interval);
}

template <int D>
Status bound_by_scale(const netmesh_context* context, Arena& arena, Monitor& monitor, BarBounds* bounds) {
    StoreState state = context->store;
    const Store<D> store(arena, state);
    const ArenaScope scope(arena);
    double* const value = arena.take_high<double>(state.vertex_count);
    Interval* const interval = arena.take_high<Interval>(state.vertex_count);
    if (value == nullptr || interval == nullptr) return Status::out_of_memory;
    const Status status = measure<D>(context, store, arena, monitor, value, interval);
    if (status != Status::ok) return status;
    return bound_bars(value, interval, state.vertex_count, pairs_of(context), context->pair_count, arena, bounds);
}

void bound_by_ratio(const netmesh_context* context, BarBounds* bounds) {
    const double c = context->certified_ratio;
    for (std::uint64_t i = 0; i < context->pair_count; ++i) {
        const Pair& pair = pairs_of(context)[i];
        const bool zero = pair.birth == 0;
        bounds[i] = {zero ? 0 : pair.birth / c, zero ? 0 : pair.birth * c,
                     pair.death < infinity ? pair.death / c : infinity, pair.death > 0 ? pair.death * c : 0,
                     zero ? 0 : pair.birth * c * c};
    }
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_bound_bars(netmesh_context* context, const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (!usable(options)) return finish(context, Status::invalid_argument, "options are not initialised", 2);
    if (!context->has_diagram) return finish(context, Status::no_result, "there is no diagram");
    if (context->filter == NETMESH_FILTER_BASIC)
        return finish(context, Status::no_result, "the basic filter's certificate has no bounds for single bars");
    if (context->has_bounds) return finish(context, Status::ok, "");
    const std::size_t low = context->arena.low_mark();
    BarBounds* const bounds = context->arena.take_low<BarBounds>(static_cast<std::size_t>(context->pair_count));
    Status status = bounds == nullptr ? Status::out_of_memory : Status::ok;
    Monitor monitor = monitor_of(*options);
    const bool by_scale = context->filter == NETMESH_FILTER_COMPLETE || context->filter == NETMESH_FILTER_TIGHT ||
                          context->filter == NETMESH_FILTER_KNN || context->filter == NETMESH_FILTER_KDISTANCE;
    if (status == Status::ok && by_scale)
        status = with_dimension(context->dim, [&](auto dimension) {
            return bound_by_scale<decltype(dimension)::value>(context, context->arena, monitor, bounds);
        });
    if (status == Status::ok && !by_scale) bound_by_ratio(context, bounds);
    if (status != Status::ok) {
        context->arena.release_low(low);
        return finish(context, status, netmesh_status_text(static_cast<netmesh_status>(status)));
    }
    context->has_bounds = true;
    context->bounds_offset = context->arena.offset_of(bounds);
    return finish(context, Status::ok, "");
}

netmesh_status netmesh_get_bar_bounds(const netmesh_context* context, uint64_t index, netmesh_bar_bounds* bounds) {
    if (bounds == nullptr || context == nullptr || context->magic != context_magic || !context->has_bounds ||
        index >= context->pair_count)
        return NETMESH_INVALID_ARGUMENT;
    const BarBounds& b = reinterpret_cast<const BarBounds*>(reinterpret_cast<const unsigned char*>(context) +
                                                            context->bounds_offset)[index];
    *bounds = {b.birth_low, b.birth_high, b.death_low, b.death_high, b.certain_after,
               pairs_of(context)[index].death > b.certain_after ? 1u : 0u};
    return NETMESH_OK;
}

}  // extern "C"
