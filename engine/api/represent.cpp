// Cycles for the diagram of a triangulation, from its complex made explicit.
#include "api/complex_job.hpp"
#include "filtration/alpha.hpp"
#include "filtration/explicit_complex.hpp"

namespace netmesh {
namespace {

// Pairs of zero length and the alpha filtration: the complex is listed and reduced.
Status represent_listed(netmesh_context* context, Monitor& monitor, PairList* pairs) {
    Arena& arena = context->arena;
    const std::uint32_t dimension = context->max_degree + 1;
    ListedComplex complex;
    const bool alpha = context->filter == NETMESH_FILTER_ALPHA;
    Status status = with_dimension(context->dim, [&](auto d) {
        constexpr int D = decltype(d)::value;
        Store<D> store(arena, context->store);
        if (alpha)
            return alpha_complex<D>(store.view(), store.point(0), Store<D>::vertex_stride, dimension, {arena, monitor},
                                    &complex);
        const auto* const value = reinterpret_cast<const double*>(arena.at(context->values_offset));
        return lower_star_complex<D>(store.view(), value, born_at_zero(context), dimension, {arena, monitor}, &complex);
    });
    if (status == Status::ok && !keep_complex(context, complex)) status = Status::out_of_memory;
    if (status != Status::ok) return status;
    Representatives found = {};
    status = persist_with_cycles(complex.filtered(), {context->max_degree, context->keeps_zero}, {arena, monitor}, &found);
    *pairs = found.pairs;
    context->cycles = found.store;
    if (status == Status::ok && alpha && !context->keeps_zero) drop_rounding(pairs);
    return status;
}

Status represent(netmesh_context* context, Monitor& monitor, PairList* pairs) {
    if (context->filter == NETMESH_FILTER_ALPHA || context->keeps_zero)
        return represent_listed(context, monitor, pairs);
    Arena& arena = context->arena;
    context->kept_offset = 0;
    return with_dimension(context->dim, [&](auto d) {
        constexpr int D = decltype(d)::value;
        const Store<D> store(arena, context->store);
        const auto* const value = reinterpret_cast<const double*>(arena.at(context->values_offset));
        Representatives found = {};
        const Status status = lower_star_cycles<D>({store.view(), value, born_at_zero(context)}, context->max_degree,
                                                   context->pair_count, {arena, monitor}, &found);
        *pairs = found.pairs;
        context->cycles = found.store;
        return status;
    });
}

// The bars of the diagram that was there.
bool same_bars(const netmesh_context* context, const PairList& pairs) {
    const auto* const before = reinterpret_cast<const Pair*>(context->arena.at(context->pairs_offset));
    if (pairs.count != context->pair_count) return false;
    for (std::uint64_t i = 0; i < pairs.count; ++i) {
        const Pair &a = before[i], &b = pairs.pairs[i];
        if (a.degree != b.degree || a.birth != b.birth || a.death != b.death) return false;
    }
    return true;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" netmesh_status netmesh_represent(netmesh_context* context, const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (!usable(options)) return finish(context, Status::invalid_argument, "options are not initialised", 2);
    if (context->dim == 0 || !context->has_diagram || context->store.cell_slots == 0 ||
        (!context->has_values && context->filter != NETMESH_FILTER_ALPHA))
        return finish(context, Status::no_result, "there is no diagram of a triangulation or mesh");
    if (context->has_cycles) return finish(context, Status::ok, "");
    const std::size_t low = context->arena.low_mark(), high = context->arena.high_mark();
    Monitor monitor = monitor_of(*options);
    PairList pairs = {};
    Status status = represent(context, monitor, &pairs);
    if (status == Status::ok && !same_bars(context, pairs)) status = Status::internal;
    if (status != Status::ok) {
        context->arena.release_low(low);
        context->arena.release_high(high);
        return finish(context, status, netmesh_status_text(static_cast<netmesh_status>(status)));
    }
    context->has_cycles = true;
    context->cycles_high = high;
    context->pairs_offset = context->arena.offset_of(pairs.pairs);
    return finish(context, Status::ok, "");
}
