#include "api/dispatch.hpp"
#include "filtration/tight_filter.hpp"
#include "mesh/mesh_points.hpp"

namespace netmesh {
namespace {

const char* text_of(Status status) { return netmesh_status_text(static_cast<netmesh_status>(status)); }

// What a triangulation or mesh leaves behind in the context.
template <int D> void keep_store(netmesh_context* context, const InputReport& input, Status status) {
    context->dim = D;
    context->complete = status == Status::ok;
    context->points = input.rows;
    context->duplicates = input.duplicates;
    context->input_fingerprint = input.fingerprint;
    context->inputs = static_cast<std::uint32_t>(input.rows - input.duplicates);
    context->mesh_mark = context->arena.low_mark();
}

netmesh_status finish_job(netmesh_context* context, Status status, const InputReport& input) {
    const bool holds = status == Status::ok || status == Status::cancelled || status == Status::out_of_memory;
    if (!holds || context->store.cell_slots == 0) {
        const std::uint64_t wanted = context->arena.bytes_wanted();
        clear(context);
        const netmesh_status result = finish(context, status, text_of(status), input.row_a, input.row_b);
        if (status == Status::out_of_memory) context->detail.bytes_wanted = wanted;
        return result;
    }
    return finish(context, status, text_of(status), input.row_a, input.row_b);
}

netmesh_status check_arguments(netmesh_context* context, const double* points, size_t n, const netmesh_options* options,
                               int options_position) {
    if (points == nullptr) return finish(context, Status::invalid_argument, "points is null", 2);
    if (n == 0) return finish(context, Status::invalid_argument, "there are no points", 3);
    if (n > (size_t{1} << 28)) return finish(context, Status::invalid_argument, "more than 2^28 points", 3);
    if (!usable(options))
        return finish(context, Status::invalid_argument, "options are not initialised or the dimension is not 2..6",
                      static_cast<std::uint64_t>(options_position));
    return NETMESH_OK;
}

MeshMethod method_of(const netmesh_options& options) {
    if (options.ratio > 0) return MeshMethod::certificate;
    switch (options.method) {
    case NETMESH_METHOD_NETMESH: return MeshMethod::hierarchy;
    case NETMESH_METHOD_REFINE: return MeshMethod::reference;
    default: return MeshMethod::quality;
    }
}

// Why refinement by the certificate cannot be done as asked for; null when it can, or is not asked for.
const char* complaint_about_ratio(const netmesh_options& options, const netmesh_job& job) {
    const bool focused = options.focus_ratio != 0 || options.focus_from != 0 || options.focus_to != 0;
    if (options.ratio == 0) return focused ? "a focus without a ratio" : nullptr;
    if (!is_valid_ratio(options.ratio)) return "ratio is not a finite number above the root of 2";
    if (focused && !(options.focus_ratio > 1 && options.focus_ratio < options.ratio))
        return "focus_ratio is not between 1 and ratio";
    if (focused && !(options.focus_from > 0 && options.focus_from < options.focus_to))
        return "not 0 < focus_from < focus_to";
    if (job != NETMESH_JOB_PERSIST) return "refinement by the certificate is for persistence with the complete filter";
    if (options.method != NETMESH_METHOD_SVR) return "refinement by the certificate is a method of its own";
    if (size_rule_of(options).asks()) return "refinement by the certificate does not over-refine";
    return nullptr;
}

bool is_valid_tau(double tau) { return tau > 2 && is_finite(tau); }

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_delaunay(netmesh_context* context, const double* points, size_t n,
                                const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    const netmesh_status checked = check_arguments(context, points, n, options, 4);
    if (checked != NETMESH_OK) return checked;
    clear(context);
    Monitor monitor = monitor_of(*options);
    return with_dimension(options->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        InputReport input;
        Store<D> store(context->arena, context->store);
        context->store = StoreState{};
        const Status status = triangulate<D>(store, points, n, options->seed, monitor, &input);
        keep_store<D>(context, input, status);
        return finish_job(context, status, input);
    });
}

netmesh_status netmesh_mesh(netmesh_context* context, const double* points, size_t n, netmesh_job for_job,
                            const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    const netmesh_status checked = check_arguments(context, points, n, options, 5);
    if (checked != NETMESH_OK) return checked;
    if (!in_range(for_job, NETMESH_JOB_MESH, NETMESH_JOB_PERSIST_TIGHT) || for_job == NETMESH_JOB_PERSIST_ALPHA)
        return finish(context, Status::invalid_argument, "the job is neither a mesh nor persistence", 4);
    const double tau = tau_of(*options);
    if (!is_valid_tau(tau)) return finish(context, Status::invalid_argument, "tau is not a finite number above 2", 5);
    if (!(options->over_refine_eps >= 0) || !is_finite(options->over_refine_eps))
        return finish(context, Status::invalid_argument, "over_refine_eps is neither 0 nor a finite number above", 5);
    double factor = options->domain_factor != 0 ? options->domain_factor : 1;
    if (!(factor >= 1 && factor <= 8))
        return finish(context, Status::invalid_argument, "domain_factor is not between 1 and 8", 5);
    if (!in_range(options->method, NETMESH_METHOD_SVR, NETMESH_METHOD_REFINE))
        return finish(context, Status::invalid_argument, "unknown method", 5);
    SizeRule rule = size_rule_of(*options);
    if (for_job == NETMESH_JOB_PERSIST_TIGHT) {
        const double eps = eps_of(*options);
        if (!is_valid_eps(eps)) return finish(context, Status::invalid_argument, "eps is not in (0, 1/2]", 5);
        if (!(rule.eps > 0 && rule.eps < tight_size(eps))) rule.eps = tight_size(eps);
        if (factor < tight_domain_factor(eps)) factor = tight_domain_factor(eps);
    }
    if (options->method == NETMESH_METHOD_NETMESH && for_job != NETMESH_JOB_MESH && options->finish == 0)
        return finish(context, Status::invalid_argument, "a mesh with cages is not for persistence; finish it", 4);
    if (options->method == NETMESH_METHOD_NETMESH && rule.asks())
        return finish(context, Status::invalid_argument, "the method netmesh does not over-refine", 5);
    if (options->audit > (NETMESH_AUDIT_LOCATION | NETMESH_AUDIT_QUALITY))
        return finish(context, Status::invalid_argument, "unknown audit", 5);
    if (options->audit != 0 && (options->method == NETMESH_METHOD_REFINE || for_job != NETMESH_JOB_MESH || rule.asks()))
        return finish(context, Status::invalid_argument,
                      "audits are for meshes by svr or netmesh, not over-refined and not for persistence", 5);
    const char* const complaint = complaint_about_ratio(*options, for_job);
    if (complaint != nullptr) return finish(context, Status::invalid_argument, complaint, 5);
    clear(context);
    MeshRequest request;
    request.method = method_of(*options);
    request.tau = tau;
    request.domain_factor = factor;
    request.certify_filter = for_job == NETMESH_JOB_PERSIST;
    request.size = rule;
    request.goal = goal_of(*options);
    request.finish = options->finish != 0;
    request.audit_location = (options->audit & NETMESH_AUDIT_LOCATION) != 0;
    request.audit_quality = (options->audit & NETMESH_AUDIT_QUALITY) != 0;
    request.seed = options->seed;
    Monitor monitor = monitor_of(*options);
    return with_dimension(options->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Store<D> store(context->arena, context->store);
        context->store = StoreState{};
        MeshResult<D> result = {};
        Status status = mesh_points<D>(store, points, n, request, {context->arena, monitor}, &result);
        const InputReport& input = result.input;
        const Domain<D>& domain = result.domain;
        keep_store<D>(context, input, status);
        context->method = options->method;
        context->audit = options->audit;
        context->hierarchy = result.hierarchy;
        context->mesh_audit = result.audit;
        if (result.cages != nullptr) context->cages_offset = context->arena.offset_of(result.cages);
        context->is_mesh = true;
        context->tau = options->ratio > 0 ? 0 : tau;
        context->goal = goal_of(*options);
        for (int k = 0; k < D; ++k) context->domain_centre[k] = domain.centre[k];
        context->domain_radius = domain.radius;
        context->enclosing_radius = domain.enclosing_radius;
        context->over_refine_eps = rule.eps;
        context->aspect_ratio_max = context->size_ratio_max = 0;
        if (context->store.cell_slots > 0) {
            HierarchyQuality quality;
            const Status measured = measure_mesh<D>(*context, store, &quality);
            context->aspect_ratio_max = quality.worst;
            if (status == Status::ok) status = measured;
            if (status == Status::ok && quality.encroached.violation != nullptr) status = Status::internal;
            std::uint32_t worst;
            if (status == Status::ok)
                status = worst_size_ratio<D>(store, domain, context->inputs, rule, Corners::kept, context->arena,
                                             &context->size_ratio_max, &worst);
        }
        if (status == Status::invalid_argument) {
            clear(context);
            if (options->ratio > 0)
                return finish(context, status, "focus_from is below what coordinates resolve at focus_ratio", 5);
            return finish(context, status, "the size asked for is not positive or below what coordinates resolve", 6,
                          input.row_a);
        }
        return finish_job(context, status, input);
    });
}

}  // extern "C"
