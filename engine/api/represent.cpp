// Cycles for the diagram of a triangulation, from its complex made explicit.
#include "api/complex_job.hpp"
#include "jobs/represent.hpp"

namespace netmesh {
namespace {

Status represent_bars(netmesh_context* context, const Work& work, Representation* out) {
    Arena& arena = context->arena;
    const auto* const before = reinterpret_cast<const Pair*>(arena.at(context->pairs_offset));
    RepresentRequest request = {{context->filter, FilterValues::certified, context->k},
                                nullptr,
                                {context->max_degree, context->keeps_zero},
                                {before, context->pair_count}};
    if (context->has_values) request.value = reinterpret_cast<const double*>(arena.at(context->values_offset));
    return with_dimension(context->dim, [&](auto d) {
        constexpr int D = decltype(d)::value;
        Store<D> store(arena, context->store);
        return represent<D>({store, domain_of<D>(*context), context->inputs}, request, work, out);
    });
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
    Representation made = {};
    Status status = represent_bars(context, {context->arena, monitor}, &made);
    context->kept_offset = 0;
    if (status == Status::ok && made.is_listed && !keep_complex(context, made.complex)) status = Status::out_of_memory;
    if (status != Status::ok) {
        context->arena.release_low(low);
        context->arena.release_high(high);
        return finish(context, status, netmesh_status_text(static_cast<netmesh_status>(status)));
    }
    context->has_cycles = true;
    context->cycles_high = high;
    context->cycles = made.cycles;
    context->pairs_offset = context->arena.offset_of(made.pairs.pairs);
    return finish(context, Status::ok, "");
}
