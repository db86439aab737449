#include "api/requests.hpp"

#include <cstddef>

#include "api/mesh_rules.hpp"
#include "filtration/filters.hpp"
#include "filtration/function_filter.hpp"
#include "vocabulary/callback.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {
namespace {

bool is_length(double x) { return x >= 0 && is_finite(x); }

}  // namespace

double tau_of(std::uint32_t dim, double tau) {
    if (tau != 0) return tau;
    return with_dimension(dim, [](auto d) { return figures<decltype(d)::value>.tau_default; });
}

bool is_valid_tau(double tau) { return tau > 2 && is_finite(tau); }
bool is_valid_ratio(double ratio) { return ratio > 1 && ratio * ratio > 2 && ratio < 0x1p100; }
bool is_valid_eps(double eps) { return eps > 0 && eps <= 0.5; }
bool is_valid_theta(double theta) { return theta > 0 && theta <= 1.0 / 9; }
bool is_valid_scales_ratio(double ratio, double theta) {
    return is_valid_ratio(ratio / (1 + 3 * theta) * (1 - 0x1p-40));
}

Complaint complaint_about_dim(std::uint32_t dim) {
    if (serves_dimension(dim)) return {};
    if (dim < NETMESH_DIM_MIN || dim > NETMESH_DIM_MAX) return {NETMESH_FIELD_DIM, "the dimension is not 2..6"};
    return {NETMESH_FIELD_DIM, "left out of this build: the dimension, by NETMESH_EACH_DIMENSION", true};
}

Complaint complaint_about_point_count(std::uint64_t count) {
    if (count == 0) return {NETMESH_FIELD_POINT_COUNT, "there are no points"};
    if (count > NETMESH_POINTS_MAX) return {NETMESH_FIELD_POINT_COUNT, "more than 2^28 points"};
    return {};
}

Complaint complaint_about_layout(const GivenRows& given) {
    if (!in_range(*given.format, NETMESH_POINTS_FLOAT64, NETMESH_POINTS_FLOAT32))
        return {NETMESH_FIELD_POINT_FORMAT, "unknown format of points"};
    const std::size_t stride = given.stride_bytes;
    const std::size_t row_bytes = given.dim * (given.has_floats() ? sizeof(float) : sizeof(double));
    if (stride != 0 && (stride < row_bytes || stride % given.alignment() != 0 || stride > SIZE_MAX / 2 / given.count))
        return {NETMESH_FIELD_POINT_STRIDE_BYTES, "less than a row, not aligned as points are, or too large"};
    return {};
}

Complaint complaint_about_rows(const GivenRows& given, std::uint32_t dim_max) {
    // The dimension first: how many points there are is often computed with it.
    const bool is_large = given.dim > NETMESH_DIM_MAX && given.dim <= dim_max;
    Complaint complaint = is_large ? Complaint{} : complaint_about_dim(given.dim);
    if (complaint.text != nullptr) return complaint;
    if (given.points == nullptr) return {NETMESH_FIELD_POINTS, "points is null"};
    complaint = complaint_about_point_count(given.count);
    if (complaint.text != nullptr) return complaint;
    if (given.dim > SIZE_MAX / 32 / given.count)
        return {NETMESH_FIELD_POINT_COUNT, "so many coordinates do not fit an address space"};
    complaint = complaint_about_layout(given);
    if (complaint.text == nullptr && reinterpret_cast<std::uintptr_t>(given.points) % given.alignment() != 0)
        return {NETMESH_FIELD_POINTS, "points is not aligned as its format asks"};
    return complaint;
}

Complaint complaint_about_built_filter(netmesh_filter filter, std::uint32_t k) {
    const netmesh_filter evaluated = evaluated_filter(filter, k).id;
    const auto is = [evaluated](netmesh_filter one) { return evaluated == one; };
    const char* text = nullptr;
    if (!built::alpha && is(NETMESH_FILTER_ALPHA)) text = "left out of this build: NETMESH_WITH_ALPHA";
    if (!built::basic && is(NETMESH_FILTER_BASIC)) text = "left out of this build: NETMESH_WITH_BASIC";
    if (!built::nearest_k && (is(NETMESH_FILTER_KNN) || is(NETMESH_FILTER_KDISTANCE)))
        text = "left out of this build: NETMESH_WITH_NEAREST_K";
    if (!built::function && is(NETMESH_FILTER_FUNCTION)) text = "left out of this build: NETMESH_WITH_FUNCTION";
    if (!built::tight && is(NETMESH_FILTER_TIGHT)) text = "left out of this build: NETMESH_WITH_TIGHT";
    return {NETMESH_FIELD_FILTER, text, true};
}

Complaint complaint_about_values(const netmesh_values& values) {
    if (in_range(values, NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS)) return {};
    return {NETMESH_FIELD_VALUES, "unknown kind of values"};
}

Complaint read_function(const netmesh_function* from, netmesh_function* function) {
    if (from == nullptr) return {NETMESH_FIELD_FUNCTION, "the function is null"};
    const netmesh_field fault = read_struct(from, function, sizeof *function);
    if (fault != NETMESH_FIELD_NONE) return complaint_about_struct(fault);
    if (function->evaluate == nullptr) return {NETMESH_FIELD_FUNCTION, "the function is null"};
    if (!is_length(function->lipschitz)) return {NETMESH_FIELD_LIPSCHITZ, "lipschitz is not finite and >= 0"};
    if (!is_length(function->distance_factor))
        return {NETMESH_FIELD_DISTANCE_FACTOR, "distance_factor is not finite and >= 0"};
    if (!is_finite(function->cut)) return {NETMESH_FIELD_CUT, "cut is not finite"};
    return {};
}

Complaint complaint_about_focus(double from, double to) {
    const char* const text = "not 0 < focus_from < focus_to";
    if (!(from > 0) || !is_finite(from)) return {NETMESH_FIELD_FOCUS_FROM, text};
    if (!(from < to)) return {NETMESH_FIELD_FOCUS_TO, text};
    return {};
}

const char* missing_result(const netmesh_context* context, const Filter& filter) {
    if (!context->complete) return "there is no complete triangulation or mesh";
    if (!context->mesh.present) return "there is no triangulation or mesh";
    if (filter.source == FilterSource::delaunay && context->mesh.is_mesh)
        return "the alpha filter needs a Delaunay triangulation of the points alone";
    if (filter.source == FilterSource::mesh && !context->mesh.is_mesh) return "this filter needs a mesh";
    return context->mesh.cages.count > 0 ? "this filter needs a mesh without cages" : nullptr;
}

Complaint read_promises(const netmesh_mesh_request* mesh, std::uint32_t dim, Promises* promises) {
    *promises = {};
    promises->tau = promises->net.tau = tau_of(dim, 0);
    if (mesh == nullptr) return {};
    netmesh_mesh_request request;
    const netmesh_field fault = read_struct(mesh, &request, sizeof request);
    if (fault != NETMESH_FIELD_NONE) return complaint_about_struct(fault);
    Complaint complaint = complaint_about_dim(request.dim);
    if (complaint.text != nullptr) return complaint;
    if (request.dim != dim) return {NETMESH_FIELD_MESH, "the mesh request is of another dimension"};
    complaint = complaint_about_promises(request);
    if (complaint.text != nullptr) return complaint;
    promises->tau = promises->net.tau = tau_of(dim, request.tau);
    promises->net.spacing = request.net_spacing;
    promises->sizes = sizes_of(request);
    promises->goal = goal_of(request);
    promises->cages = request.cage_kind == NETMESH_CAGES_THESIS ? CageKind::thesis : CageKind::compact;
    return {};
}

namespace {

template <class Request> void start(const Request& defaults, Request* request, std::size_t bytes) {
    start_struct(&defaults, sizeof defaults, request, bytes);
}

// Requests on points. A dimension that is none is kept: the job that gets the request refuses it, and a plan is 0.
template <class Request> Request points_defaults(std::uint32_t dim) {
    Request defaults = {};
    defaults.dim = dim;
    defaults.seed = 1;
    return defaults;
}

// A caller's number may be none of an enumeration's: C++ must not read it as one. The job refuses it.
template <class E> void keep(const E& from, E* to) { __builtin_memcpy(to, &from, sizeof *to); }

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

void netmesh_delaunay_request_init(netmesh_delaunay_request* request, size_t request_bytes, uint32_t dim) {
    start(points_defaults<netmesh_delaunay_request>(dim), request, request_bytes);
}

void netmesh_alpha_request_init(netmesh_alpha_request* request, size_t request_bytes, uint32_t dim) {
    netmesh_alpha_request defaults = points_defaults<netmesh_alpha_request>(dim);
    defaults.max_degree = NETMESH_DIM_MAX;
    start(defaults, request, request_bytes);
}

void netmesh_auto_request_init(netmesh_auto_request* request, size_t request_bytes, uint32_t dim) {
    netmesh_auto_request defaults = points_defaults<netmesh_auto_request>(dim);
    defaults.max_degree = NETMESH_DIM_MAX;
    start(defaults, request, request_bytes);
}

void netmesh_mesh_request_init(netmesh_mesh_request* request, size_t request_bytes, uint32_t dim) {
    start(points_defaults<netmesh_mesh_request>(dim), request, request_bytes);
}

double netmesh_tau(const netmesh_mesh_request* from) {
    netmesh_mesh_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE || !serves_dimension(request.dim)) return 0;
    return tau_of(request.dim, request.tau);
}

void netmesh_load_request_init(netmesh_load_request* request, size_t request_bytes, uint32_t dim) {
    netmesh_load_request defaults = {};
    defaults.dim = dim;
    start(defaults, request, request_bytes);
}

void netmesh_cages_request_init(netmesh_cages_request* request, size_t request_bytes, size_t cage_bytes) {
    netmesh_cages_request defaults = {};
    defaults.cage_bytes = static_cast<uint32_t>(cage_bytes);
    start(defaults, request, request_bytes);
}

void netmesh_check_request_init(netmesh_check_request* request, size_t request_bytes) {
    netmesh_check_request defaults = {};
    defaults.what = NETMESH_CHECK_ALL;
    start(defaults, request, request_bytes);
}

void netmesh_function_init(netmesh_function* function, size_t function_bytes) {
    start(netmesh_function{}, function, function_bytes);
}

double netmesh_size_for_error(const netmesh_function* from, double error, const double* x) {
    netmesh_function function;
    if (read_function(from, &function).text != nullptr || !(error > 0)) return 0;
    return wanted_reach(function, error, value_at(function, x));
}

void netmesh_persist_request_init(netmesh_persist_request* request, size_t request_bytes) {
    netmesh_persist_request defaults = {};
    defaults.filter = NETMESH_FILTER_COMPLETE;
    defaults.max_degree = NETMESH_DIM_MAX;
    start(defaults, request, request_bytes);
}

void netmesh_bounds_request_init(netmesh_bounds_request* request, size_t request_bytes) {
    start(netmesh_bounds_request{}, request, request_bytes);
}

void netmesh_represent_request_init(netmesh_represent_request* request, size_t request_bytes) {
    start(netmesh_represent_request{}, request, request_bytes);
}

void netmesh_fit_request_init(netmesh_fit_request* request, size_t request_bytes, uint32_t dim) {
    netmesh_fit_request defaults = points_defaults<netmesh_fit_request>(dim);
    defaults.filter = NETMESH_FILTER_COMPLETE;
    defaults.max_degree = NETMESH_DIM_MAX;
    start(defaults, request, request_bytes);
}

void netmesh_vineyard_request_init(netmesh_vineyard_request* request, size_t request_bytes, netmesh_filter filter) {
    netmesh_vineyard_request defaults = {};
    keep(filter, &defaults.filter);
    defaults.k_first = defaults.k_last = 1;
    defaults.max_degree = NETMESH_DIM_MAX;
    start(defaults, request, request_bytes);
}

void netmesh_scales_request_init(netmesh_scales_request* request, size_t request_bytes, uint32_t dim) {
    netmesh_scales_request defaults = points_defaults<netmesh_scales_request>(dim);
    defaults.max_degree = NETMESH_DIM_MAX;
    start(defaults, request, request_bytes);
}

void netmesh_points_request_init(netmesh_points_request* request, size_t request_bytes, uint32_t dim,
                                 netmesh_filter filter) {
    netmesh_points_request defaults = {};
    defaults.dim = dim;
    keep(filter, &defaults.filter);
    defaults.k = 1;
    defaults.max_degree = 1;
    start(defaults, request, request_bytes);
}

void netmesh_distances_request_init(netmesh_distances_request* request, size_t request_bytes) {
    netmesh_distances_request defaults = {};
    defaults.threshold = infinity;
    defaults.max_degree = 1;
    start(defaults, request, request_bytes);
}

void netmesh_points_vineyard_request_init(netmesh_points_vineyard_request* request, size_t request_bytes, uint32_t dim,
                                          netmesh_filter filter) {
    netmesh_points_vineyard_request defaults = {};
    defaults.dim = dim;
    keep(filter, &defaults.filter);
    defaults.k_first = defaults.k_last = 1;
    defaults.max_degree = 1;
    start(defaults, request, request_bytes);
}

void netmesh_homology_request_init(netmesh_homology_request* request, size_t request_bytes) {
    netmesh_homology_request defaults = {};
    defaults.max_degree = NETMESH_DEGREE_MAX;
    start(defaults, request, request_bytes);
}

void netmesh_value_vineyard_request_init(netmesh_value_vineyard_request* request, size_t request_bytes) {
    netmesh_value_vineyard_request defaults = {};
    defaults.max_degree = NETMESH_DEGREE_MAX;
    start(defaults, request, request_bytes);
}

void netmesh_bottleneck_request_init(netmesh_bottleneck_request* request, size_t request_bytes, size_t pair_bytes) {
    netmesh_bottleneck_request defaults = {};
    defaults.pair_bytes = static_cast<uint32_t>(pair_bytes);
    defaults.degree = NETMESH_ALL_DEGREES;
    start(defaults, request, request_bytes);
}

void netmesh_wasserstein_request_init(netmesh_wasserstein_request* request, size_t request_bytes, size_t pair_bytes) {
    netmesh_wasserstein_request defaults = {};
    defaults.pair_bytes = static_cast<uint32_t>(pair_bytes);
    defaults.degree = NETMESH_ALL_DEGREES;
    defaults.order = 1;
    defaults.relative_error = 0.001;
    start(defaults, request, request_bytes);
}

void netmesh_analyse_request_init(netmesh_analyse_request* request, size_t request_bytes) {
    netmesh_analyse_request defaults = {};
    defaults.what = NETMESH_ANALYSE_ALL;
    start(defaults, request, request_bytes);
}

}  // extern "C"
