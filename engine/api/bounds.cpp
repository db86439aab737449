#include "api/dispatch.hpp"
#include "filtration/bar_bounds.hpp"
#include "certificate/cells.hpp"
#include "filtration/function_filter.hpp"
#include "filtration/sharp_bounds.hpp"
#include "filtration/sure_bars.hpp"
#include "filtration/tight_filter.hpp"

namespace netmesh {
namespace {

const Pair* pairs_of(const netmesh_context* context) {
    return reinterpret_cast<const Pair*>(reinterpret_cast<const unsigned char*>(context) + context->pairs_offset);
}

// The filter's values and intervals anew; *zero_born: the inputs of covers that begin with balls.
template <int D>
Status measure(const netmesh_context* context, Store<D>& store, const Work& work, double* value,
               Interval* interval, std::uint32_t* zero_born) {
    const Domain<D> domain = domain_of<D>(*context);
    const FilterValues kind = context->values == NETMESH_VALUES_THESIS ? FilterValues::thesis : FilterValues::certified;
    Certificate certificate;
    *zero_born = 0;
    if (context->k > 1) {
        const InputDistance distance =
            context->filter == NETMESH_FILTER_KNN ? InputDistance::kth : InputDistance::root_mean_square;
        return distance_filter_values<D>(store, domain, context->inputs, distance, context->k, kind, work,
                                         value, &certificate, interval);
    }
    *zero_born = context->inputs;
    work.monitor.begin(NETMESH_STAGE_CERTIFY, context->store.cell_slots);
    if (context->filter == NETMESH_FILTER_TIGHT)
        return tight_filter_values<D>(store, domain, context->inputs, kind, work.arena, value, &certificate, interval);
    const MeshFilter filter = context->filter == NETMESH_FILTER_BASIC ? MeshFilter::basic : MeshFilter::complete;
    const Status status = mesh_filter_values<D>(store, domain, filter, kind, work.arena, value, &certificate, interval);
    if (status != Status::ok) return status;
    return sharpen_intervals<D>(store, context->inputs, domain.enclosing_radius * up, work, interval);
}

template <int D>
Status bound_by_scale(netmesh_context* context, Monitor& monitor, BarBounds* bounds, ScaleCurve* curve) {
    Arena& arena = context->arena;
    Store<D> store(arena, context->store);
    const std::uint32_t count = context->store.vertex_count;
    const std::size_t high = arena.high_mark();
    double* const value = arena.take_high<double>(count);
    Interval* const interval = arena.take_high<Interval>(count);
    std::uint32_t zero_born = 0;
    Status status = value == nullptr || interval == nullptr ? Status::out_of_memory : Status::ok;
    if (status == Status::ok) status = measure<D>(context, store, {arena, monitor}, value, interval, &zero_born);
    if (status == Status::ok)
        status = bound_bars(value, interval, count, pairs_of(context), context->pair_count, arena, bounds, curve);
    if (status == Status::ok)
        status = find_sure_bars<D>(store.view(), value, interval, zero_born, pairs_of(context), context->pair_count,
                                   {arena, monitor}, bounds);
    arena.release_high(high);
    return status;
}

Status bound_by_ratio(netmesh_context* context, BarBounds* bounds, ScaleCurve* curve) {
    const double c = context->certified_ratio;
    for (std::uint64_t i = 0; i < context->pair_count; ++i) {
        const Pair& pair = pairs_of(context)[i];
        const bool zero = pair.birth == 0;
        const double after = zero ? 0 : pair.birth * c * c;
        bounds[i] = {zero ? 0 : pair.birth / c,
                     zero ? 0 : pair.birth * c,
                     pair.death < infinity ? pair.death / c : infinity,
                     pair.death > 0 ? pair.death * c : 0,
                     after,
                     pair.death > after ? 1u : 0u,
                     0};
    }
    *curve = {context->arena.take_low<ScaleStep>(c > 1 ? 1 : 0), c > 1 ? 1u : 0u};
    if (curve->steps == nullptr) return Status::out_of_memory;
    if (c > 1) curve->steps[0] = {0, infinity};
    return Status::ok;
}

bool goes_by_scale(netmesh_filter filter) {
    return filter == NETMESH_FILTER_COMPLETE || filter == NETMESH_FILTER_BASIC || filter == NETMESH_FILTER_TIGHT ||
           filter == NETMESH_FILTER_KNN || filter == NETMESH_FILTER_KDISTANCE;
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
    const std::size_t low = context->arena.low_mark();
    BarBounds* const bounds = context->arena.take_low<BarBounds>(static_cast<std::size_t>(context->pair_count));
    Status status = bounds == nullptr ? Status::out_of_memory : Status::ok;
    Monitor monitor = monitor_of(*options);
    ScaleCurve curve = {};
    if (status == Status::ok)
        status = !goes_by_scale(context->filter)
                     ? bound_by_ratio(context, bounds, &curve)
                     : with_dimension(context->dim, [&](auto dimension) {
                           return bound_by_scale<decltype(dimension)::value>(context, monitor, bounds, &curve);
                       });
    if (status != Status::ok) {
        context->arena.release_low(low);
        return finish(context, status, netmesh_status_text(static_cast<netmesh_status>(status)));
    }
    context->has_bounds = true;
    context->bounds_offset = context->arena.offset_of(bounds);
    context->curve_offset = context->arena.offset_of(curve.steps);
    context->curve_steps = curve.count;
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
    const double ratio = s.reach > s.from ? square_root(s.reach / s.from) * up : 1;
    *step = {s.from, s.reach, ratio < context->certified_ratio ? ratio : context->certified_ratio};
    return NETMESH_OK;
}

}  // extern "C"
