#include "api/dispatch.hpp"
#include "filtration/alpha.hpp"
#include "filtration/function_filter.hpp"
#include "filtration/tight_filter.hpp"
#include "vocabulary/callback.hpp"

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
    if (!in_range(filter, NETMESH_FILTER_COMPLETE, NETMESH_FILTER_TIGHT))
        return finish(context, Status::invalid_argument, "unknown filter", 2);
    if (!in_range(values, NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS))
        return finish(context, Status::invalid_argument, "unknown kind of values", values_position);
    if (context->dim == 0 || !context->complete)
        return finish(context, Status::no_result, "there is no complete triangulation or mesh");
    if (context->store.cell_slots == 0) return finish(context, Status::no_result, "there is no triangulation or mesh");
    const bool alpha = filter == NETMESH_FILTER_ALPHA;
    if (alpha == context->is_mesh)
        return finish(context, Status::no_result,
                      alpha ? "the alpha filter needs a Delaunay triangulation of the points alone"
                            : "this filter needs a mesh");
    if (context->hierarchy.cages > 0)
        return finish(context, Status::no_result, "this filter needs a mesh without cages");
    return NETMESH_OK;
}

// How a job ends: with a diagram, or as if it had not been asked for.
struct Outcome {
    PairList pairs;
    std::uint64_t simplices;
    Certificate certificate;
    const double* value;  // null: none is kept
};

netmesh_status keep_diagram(netmesh_context* context, const Request& request, std::uint32_t k, Status status,
                            const Outcome& outcome) {
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

// Diagram of the lower-star filtration of value[], which stands at the arena's low end.
template <int D>
Status persist_values(netmesh_context* context, const Store<D>& store, const double* value, std::uint32_t zero_born,
                      const Request& request, Monitor& monitor, Outcome* outcome) {
    outcome->value = value;
    return persist_lower_star<D>(store.view(), value, zero_born, request.max_degree, request.keep_zero, {context->arena, monitor}, &outcome->pairs, &outcome->simplices);
}

template <int D>
Status persist_mesh(netmesh_context* context, const Store<D>& store, const Request& request, std::uint32_t k,
                    Monitor& monitor, Outcome* outcome) {
    double* const value = context->arena.take_low<double>(context->store.vertex_count);
    if (value == nullptr) return Status::out_of_memory;
    const Domain<D> domain = domain_of<D>(*context);
    const FilterValues kind = kind_of(request.values);
    Status status;
    std::uint32_t zero_born = 0;
    if (k > 1) {
        const InputDistance distance =
            request.filter == NETMESH_FILTER_KNN ? InputDistance::kth : InputDistance::root_mean_square;
        status = distance_filter_values<D>(store, domain, context->inputs, distance, k, kind, {context->arena, monitor},
                                           value, &outcome->certificate);
    } else if (request.filter == NETMESH_FILTER_TIGHT) {
        zero_born = context->inputs;
        monitor.begin(NETMESH_STAGE_CERTIFY, context->store.cell_slots);
        status =
            tight_filter_values<D>(store, domain, context->inputs, kind, context->arena, value, &outcome->certificate);
    } else {
        const bool basic = request.filter == NETMESH_FILTER_BASIC;
        if (!basic) zero_born = context->inputs;
        monitor.begin(NETMESH_STAGE_CERTIFY, context->store.cell_slots);
        status = mesh_filter_values<D>(store, domain, basic ? MeshFilter::basic : MeshFilter::complete, kind,
                                       context->arena, value, &outcome->certificate);
    }
    if (status != Status::ok) return status;
    return persist_values<D>(context, store, value, zero_born, request, monitor, outcome);
}

// value[v] = f(v); not_finite and the vertex when f is not what it has to be.
template <int D>
Status evaluate(const Store<D>& store, const netmesh_function& function, Monitor& monitor, double* value,
                std::uint32_t* at) {
    monitor.begin(NETMESH_STAGE_CERTIFY, store.state.vertex_count);
    for (std::uint32_t v = 0; v < store.state.vertex_count; ++v) {
        value[v] = value_at(function, store.point(v));
        *at = v;
        if (!is_finite(value[v]) || value[v] < 0) return Status::not_finite;
        if (monitor.advance(v, 10)) return Status::cancelled;
    }
    return Status::ok;
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
    const bool counts = filter == NETMESH_FILTER_KNN || filter == NETMESH_FILTER_KDISTANCE;
    const std::uint32_t k = !counts ? 0 : options->k > 1 ? options->k : 1;
    if (k > context->inputs)
        return finish(context, Status::invalid_argument, "k is more than the number of different points", 7);
    const Request request = {filter, values, max_degree < context->dim ? max_degree : context->dim - 1,
                             keep_zero_pairs != 0};
    clear_diagram(context);
    Monitor monitor = monitor_of(*options);
    return with_dimension(context->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        const Store<D> store(context->arena, context->store);
        Outcome outcome = {{}, 0, {1, 1, 0}, nullptr};
        const Status status =
            filter == NETMESH_FILTER_ALPHA
                ? persist_alpha<D>(store.view(), store.point(0), Store<D>::vertex_stride, request.max_degree,
                                   request.keep_zero, {context->arena, monitor}, &outcome.pairs, &outcome.simplices)
                : persist_mesh<D>(context, store, request, k, monitor, &outcome);
        return keep_diagram(context, request, k, status, outcome);
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
        const Store<D> store(context->arena, context->store);
        Outcome outcome = {{}, 0, {1, 1, 0}, nullptr};
        double* const value = context->arena.take_low<double>(context->store.vertex_count);
        std::uint32_t at = 0;
        Status status = value == nullptr ? Status::out_of_memory : evaluate<D>(store, *function, monitor, value, &at);
        const LipschitzBounds bounds = {function->lipschitz, function->distance_factor, function->cut};
        if (status == Status::ok)
            status = function_filter_values<D>(store, domain_of<D>(*context), bounds, kind_of(values), context->arena,
                                               value, &outcome.certificate);
        if (status == Status::ok) status = persist_values<D>(context, store, value, 0, request, monitor, &outcome);
        const netmesh_status result = keep_diagram(context, request, 0, status, outcome);
        if (status == Status::not_finite)
            return finish(context, status, "the function is not finite and >= 0 at a vertex", at);
        return result;
    });
}

}  // extern "C"
