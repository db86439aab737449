#include "api/dispatch.hpp"
#include "jobs/persist_filter.hpp"

namespace netmesh {
namespace {

struct Request {
    netmesh_filter filter;
    netmesh_values values;
    std::uint32_t max_degree;
    bool keep_zero;
};

FilterValues kind_of(netmesh_values values) {
    return values == NETMESH_VALUES_THESIS ? FilterValues::thesis : FilterValues::certified;
}

bool is_length(double x) { return x >= 0 && is_finite(x); }

// What every persistence job checks. Enumerations come as they came from outside, see in_range.
netmesh_status check_request(netmesh_context* context, const netmesh_filter& filter, const netmesh_values& values,
                             std::uint64_t values_position, const netmesh_options* options,
                             std::uint64_t options_position) {
    if (!usable(options))
        return finish(context, Status::invalid_argument, "options are not initialised", options_position);
    const Filter* const row = find_filter(filter);
    if (row == nullptr || (row->source != FilterSource::mesh && row->source != FilterSource::delaunay))
        return finish(context, Status::invalid_argument, "unknown filter", 2);
    if (!in_range(values, NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS))
        return finish(context, Status::invalid_argument, "unknown kind of values", values_position);
    if (context->dim == 0 || !context->complete)
        return finish(context, Status::no_result, "there is no complete triangulation or mesh");
    if (context->store.cell_slots == 0) return finish(context, Status::no_result, "there is no triangulation or mesh");
    const bool alpha = row->source == FilterSource::delaunay;
    if (alpha == context->is_mesh)
        return finish(context, Status::no_result,
                      alpha ? "the alpha filter needs a Delaunay triangulation of the points alone"
                            : "this filter needs a mesh");
    if (context->hierarchy.cages > 0)
        return finish(context, Status::no_result, "this filter needs a mesh without cages");
    return NETMESH_OK;
}

netmesh_status keep_diagram(netmesh_context* context, const Request& request, std::uint32_t k, Status status,
                            const FilterDiagram& outcome) {
    if (status != Status::ok) {
        clear_diagram(context);
        return finish(context, status, netmesh_status_text(static_cast<netmesh_status>(status)));
    }
    if (outcome.value != nullptr) {
        context->has_values = true;
        context->values_offset = context->arena.offset_of(outcome.value);
    }
    context->has_diagram = true;
    context->keeps_zero = request.keep_zero;
    context->pairs_offset = context->arena.offset_of(outcome.pairs.pairs);
    context->pair_count = outcome.pairs.count;
    context->simplices = outcome.simplices;
    context->filter = request.filter;
    context->values = request.values;
    context->max_degree = request.max_degree;
    context->k = k;
    context->certified_ratio = outcome.certificate.ratio;
    context->certified_ratio_best = outcome.certificate.ratio_best;
    context->certified_from = outcome.certificate.from;
    return finish(context, Status::ok, "");
}

template <int D>
netmesh_status persist_on(netmesh_context* context, const Request& request, const FilterRequest& filter,
                          Monitor& monitor) {
    Store<D> store(context->arena, context->store);
    FilterDiagram diagram;
    const Status status = persist_filter<D>({store, domain_of<D>(*context), context->inputs},
                                            {filter, {request.max_degree, request.keep_zero}},
                                            {context->arena, monitor}, &diagram);
    const netmesh_status result = keep_diagram(context, request, filter.k, status, diagram);
    return status == Status::not_finite
               ? finish(context, status, "the function is not finite and >= 0 at a vertex", diagram.culprit)
               : result;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_persist(netmesh_context* context, netmesh_filter filter, netmesh_values values,
                               uint32_t max_degree, int keep_zero_pairs, const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    const netmesh_status checked = check_request(context, filter, values, 3, options, 6);
    if (checked != NETMESH_OK) return checked;
    if (filter == NETMESH_FILTER_FUNCTION)
        return finish(context, Status::invalid_argument, "functions go to netmesh_persist_function", 2);
    const bool counts = find_filter(filter)->has(filter_trait::needs_k);
    const std::uint32_t k = !counts ? 0 : options->k > 1 ? options->k : 1;
    if (k > context->inputs)
        return finish(context, Status::invalid_argument, "k is more than the number of different points", 7);
    const Request request = {filter, values, max_degree < context->dim ? max_degree : context->dim - 1,
                             keep_zero_pairs != 0};
    clear_diagram(context);
    Monitor monitor = monitor_of(*options);
    return with_dimension(context->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        return persist_on<D>(context, request, {filter, kind_of(values), k}, monitor);
    });
}

netmesh_status netmesh_persist_function(netmesh_context* context, const netmesh_function* function,
                                        netmesh_values values, uint32_t max_degree, int keep_zero_pairs,
                                        const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (function == nullptr || function->evaluate == nullptr || !is_length(function->lipschitz) ||
        !is_length(function->distance_factor) || !is_length(function->cut))
        return finish(context, Status::invalid_argument, "the function is null, or its numbers are not finite and >= 0",
                      2);
    const netmesh_status checked = check_request(context, NETMESH_FILTER_FUNCTION, values, 3, options, 6);
    if (checked != NETMESH_OK) return checked;
    const Request request = {NETMESH_FILTER_FUNCTION, values, max_degree < context->dim ? max_degree : context->dim - 1,
                             keep_zero_pairs != 0};
    clear_diagram(context);
    Monitor monitor = monitor_of(*options);
    return with_dimension(context->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        return persist_on<D>(context, request, {NETMESH_FILTER_FUNCTION, kind_of(values), 0, function}, monitor);
    });
}

}  // extern "C"
