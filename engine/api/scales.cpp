#include "jobs/persist_scales.hpp"
#include "api/dispatch.hpp"
#include "delaunay/triangulate.hpp"

namespace netmesh {
namespace {

void keep_scales(netmesh_context* context, const ScalesResult& result, const ScalesRequest& request,
                 netmesh_values values) {
    context->has_diagram = true;
    context->pairs_offset = context->arena.offset_of(result.pairs.pairs);
    context->pair_count = result.pairs.count;
    context->simplices = result.simplices;
    context->filter = NETMESH_FILTER_SCALES;
    context->values = values;
    context->max_degree = request.max_degree;
    context->k = 0;
    context->certified_ratio = result.ratio;
    context->certified_ratio_best = result.ratio_best;
    context->certified_from = 0;
    context->scales = result.clusters;
    context->separation = result.separation;
    context->scale_points_max = result.most_points;
    context->scale_vertices_max = result.most_vertices;
    context->scale_vertices = result.vertices;
}

// What is left in the context: the points' counts, and no vertex.
void keep_input(netmesh_context* context, std::uint32_t dim, const InputReport& input, std::uint32_t inputs) {
    context->dim = dim;
    context->complete = true;
    context->points = input.rows;
    context->duplicates = input.duplicates;
    context->input_fingerprint = input.fingerprint;
    context->inputs = inputs;
    context->store = StoreState{};
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" netmesh_status netmesh_persist_scales(netmesh_context* context, const double* points, size_t n,
                                                 netmesh_values values, uint32_t max_degree, int keep_zero_pairs,
                                                 const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    const auto refuse = [&](const char* message, std::uint64_t position) {
        return finish(context, Status::invalid_argument, message, position);
    };
    if (points == nullptr) return refuse("points is null", 2);
    if (n == 0) return refuse("there are no points", 3);
    if (n > (size_t{1} << 28)) return refuse("more than 2^28 points", 3);
    if (!in_range(values, NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS)) return refuse("unknown kind of values", 4);
    if (!usable(options)) return refuse("options are not initialised or the dimension is not 2..6", 7);
    const double tau = tau_of(*options);
    if (!(tau > 2) || !is_finite(tau)) return refuse("tau is not a finite number above 2", 7);
    if (!is_valid_eps(eps_of(*options))) return refuse("eps is not in (0, 1/2]", 7);
    if (!is_valid_theta(theta_of(*options))) return refuse("theta is not in (0, 1/9]", 7);
    clear(context);
    Monitor monitor = monitor_of(*options);
    return with_dimension(options->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        const ScalesRequest request = {theta_of(*options),
                                       eps_of(*options),
                                       tau,
                                       options->seed,
                                       values == NETMESH_VALUES_THESIS ? FilterValues::thesis : FilterValues::certified,
                                       max_degree < D ? max_degree : static_cast<std::uint32_t>(D - 1),
                                       keep_zero_pairs != 0};
        InputReport input;
        StoreState state = {};
        Store<D> store(context->arena, state);
        ScalesResult result = {};
        std::uint32_t* order;
        Status status = take_input<D>(store, points, n, options->seed, monitor, &input, &order);
        context->arena.release_low(context->start);  // the order
        const std::uint32_t inputs = state.vertex_count;
        if (status == Status::ok) status = persist_scales<D>(store, inputs, request, {context->arena, monitor}, &result);
        const std::size_t low = context->arena.low_mark();
        const std::uint64_t wanted = context->arena.bytes_wanted();
        if (status != Status::ok) {
            clear(context);
            const bool size = status == Status::invalid_argument;
            const bool bad_row = status == Status::not_finite;
            finish(context, status,
                   size ? "the size asked for is below what coordinates resolve"
                        : netmesh_status_text(static_cast<netmesh_status>(status)),
                   size      ? 8
                   : bad_row ? input.row_a
                             : result.row_a,
                   size ? result.row_a : result.row_b);
            if (status == Status::out_of_memory)
                context->detail.bytes_wanted = wanted + (context->block_bytes - context->arena.bytes());
            return context->detail.status;
        }
        store.truncate_vertices(0);
        keep_input(context, D, input, inputs);
        context->mesh_mark = context->start;
        context->arena.release_low(low);
        keep_scales(context, result, request, values);
        return finish(context, Status::ok, "");
    });
}
