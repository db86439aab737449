#include "api/dispatch.hpp"
#include "jobs/k_vineyard.hpp"

using namespace netmesh;

extern "C" netmesh_status netmesh_vineyard(netmesh_context* context, netmesh_filter filter, uint32_t k_first,
                                           uint32_t k_last, netmesh_values values, uint32_t max_degree,
                                           const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    const auto refuse = [&](const char* message, std::uint64_t position) {
        return finish(context, Status::invalid_argument, message, position);
    };
    if (!usable(options)) return refuse("options are not initialised", 8);
    const Filter* const row = find_filter(filter);
    if (row == nullptr || !row->has(filter_trait::has_vineyard)) return refuse("the filter has no k", 2);
    if (!in_range(values, NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS)) return refuse("unknown kind of values", 5);
    if (context->dim == 0 || !context->complete || !context->is_mesh)
        return finish(context, Status::no_result, "there is no complete mesh");
    if (k_first < 1) return refuse("k begins at 1", 3);
    if (k_last < k_first) return refuse("the last k is below the first", 4);
    if (k_last > context->inputs) return refuse("k is more than the number of different points", 7);
    clear_diagram(context);
    Monitor monitor = monitor_of(*options);
    return with_dimension(context->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Store<D> store(context->arena, context->store);
        const VineRequest request = {
            filter, k_first, k_last,
            values == NETMESH_VALUES_THESIS ? FilterValues::thesis : FilterValues::certified,
            max_degree < D ? max_degree : static_cast<std::uint32_t>(D - 1)};
        VineList vines = {};
        const Status status =
            k_vineyard<D>({store, domain_of<D>(*context), context->inputs}, request, {context->arena, monitor}, &vines);
        if (status != Status::ok) {
            clear_diagram(context);
            return finish(context, status, netmesh_status_text(static_cast<netmesh_status>(status)));
        }
        context->has_vineyard = true;
        context->vine_ratios_offset = context->arena.offset_of(vines.ratio);
        context->vine_points_offset = context->arena.offset_of(vines.points);
        context->vine_points = vines.count;
        context->vines = vines.vine_count;
        context->transpositions = vines.transpositions;
        context->k_first = k_first;
        context->k_last = k_last;
        context->k = 0;
        context->filter = filter;
        context->values = values;
        context->max_degree = request.max_degree;
        context->simplices = vines.simplices;
        context->certified_ratio = 1;
        for (std::uint32_t i = 0; i <= k_last - k_first; ++i)
            if (!(vines.ratio[i] <= context->certified_ratio)) context->certified_ratio = vines.ratio[i];
        return finish(context, Status::ok, "");
    });
}
