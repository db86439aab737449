#include "tools/requests.hpp"

#include <cmath>

namespace netmesh::tool {

namespace {

// What requests for diagrams have in common.
template <class Request>
void set_diagram(const Options& options, const DiagramRequest& diagram, std::uint32_t dim, Request* request) {
    request->values = diagram.choice.values;
    request->max_degree = max_degree_of(options, dim);
    request->keep_zero_pairs = diagram.keep_zero_pairs ? 1 : 0;
}

constexpr double thesis_tau = 7;  // of meshes with cages of the thesis, unless --tau says

}  // namespace

double default_ratio(const netmesh_mesh_request& mesh) { return std::sqrt(2 + tau(mesh)); }

Options suited(const Options& options, std::uint32_t dim) {
    Options all = options;
    const netmesh_filter_info& filter = about(filter_of(options));
    const bool is_open = filter.has_eps != 0 && options.eps == 0 && !options.ratio && !options.fit && !options.method;
    if (dim < 4 || !is_open || choice_of(options).values != NETMESH_VALUES_CERTIFIED) return all;
    const double theta = filter.has_theta == 0 ? 0 : options.theta > 0 ? options.theta : default_theta;
    all.ratio = default_ratio(mesh_request(options, dim)) * (1 + 3 * theta);
    return all;
}

netmesh_certificate_goal goal_of(const Options& options, double ratio) {
    return {ratio, options.focus, options.from, options.to};
}

requests::Mesh mesh_request(const Options& options, std::uint32_t dim) {
    requests::Mesh mesh(dim);
    mesh.seed = options.seed;
    if (options.command != Command::mesh) mesh.purpose = about(filter_of(options)).purpose;
    if (refines_by_certificate(options)) mesh.purpose = NETMESH_PURPOSE_PERSIST;
    mesh.method = options.method.value_or(NETMESH_METHOD_SVR);
    mesh.cage_kind = options.cages.value_or(NETMESH_CAGES_COMPACT);
    mesh.tau = options.tau.value_or(mesh.cage_kind == NETMESH_CAGES_THESIS ? thesis_tau : 0);
    (promises_accuracy(options) ? mesh.tight_eps : mesh.sizes.eps) = options.eps;
    mesh.size_at_inputs = options.size_at_inputs;
    mesh.size_growth = options.size_growth;
    mesh.domain_factor = options.domain_factor;
    mesh.net_spacing = options.net_spacing;
    mesh.finish = options.finish ? 1 : 0;
    mesh.audit = options.audit;
    if (refines_by_certificate(options))
        mesh.certificate = goal_of(options, options.ratio.value_or(options.fit ? 0 : default_ratio(mesh)));
    mesh.whole_cells = options.whole_cells || !clips_cells(options) ? 1 : 0;
    return mesh;
}

requests::Delaunay delaunay_request(const Options& options, std::uint32_t dim) {
    requests::Delaunay delaunay(dim);
    delaunay.seed = options.seed;
    delaunay.purpose = options.command == Command::delaunay ? NETMESH_PURPOSE_MESH : NETMESH_PURPOSE_PERSIST;
    return delaunay;
}

bool wants_diagram_alone(const Options& options) {
    return options.command == Command::persist && !options.check && options.mesh_out.empty() &&
           options.representatives.empty();
}

namespace {

// What alpha and auto ask for alike.
template <class Request> Request diagram_request(const Options& options, std::uint32_t dim) {
    Request request(dim);
    request.seed = options.seed;
    request.max_degree = max_degree_of(options, dim);
    request.keep_zero_pairs = options.all ? 1 : 0;
    return request;
}

}  // namespace

requests::Alpha alpha_request(const Options& options, std::uint32_t dim) {
    return diagram_request<requests::Alpha>(options, dim);
}

requests::Auto auto_request(const Options& options, std::uint32_t dim) {
    return diagram_request<requests::Auto>(options, dim);
}

requests::Persist persist_request(const Options& options, const DiagramRequest& diagram, std::uint32_t dim) {
    requests::Persist persist(diagram.choice.filter);
    set_diagram(options, diagram, dim, &persist);
    persist.k = options.k.value_or(1);
    return persist;
}

requests::Fit fit_request(const Options& options, std::uint32_t dim) {
    requests::Fit fit(dim);
    fit.seed = options.seed;
    fit.by_error = choice_of(options).filter == NETMESH_FILTER_FUNCTION ? 1 : 0;
    fit.ratio = fit.by_error != 0 ? 0 : options.ratio.value_or(default_fit_ratio);
    if (options.focus_auto) {
        fit.ratio = mesh_request(options, dim).certificate.ratio;
        fit.longer_than = options.longer_than > 0 ? options.longer_than : default_longer_than;
    }
    fit.focus_from = options.from;
    fit.focus_to = options.to;
    fit.max_degree = max_degree_of(options, dim);
    fit.keep_zero_pairs = options.all ? 1 : 0;
    fit.bounds = options.bounds ? 1 : 0;
    fit.filter = choice_of(options).filter;
    fit.values = choice_of(options).values;
    fit.k = options.k.value_or(1);
    fit.whole_cells = options.whole_cells ? 1 : 0;
    return fit;
}

requests::Scales scales_request(const Options& options, const DiagramRequest& diagram, std::uint32_t dim) {
    requests::Scales scales(dim);
    set_diagram(options, diagram, dim, &scales);
    scales.seed = options.seed;
    scales.tau = options.tau.value_or(0);
    scales.eps = options.eps;
    scales.ratio = options.ratio.value_or(0);
    scales.theta = options.theta;
    scales.bounds = options.bounds ? 1 : 0;
    scales.representatives = diagram.cycles ? 1 : 0;
    return scales;
}

namespace {

template <class Request> Request over_k(Request request, const VineyardRequest& vineyard) {
    request.values = vineyard.choice.values;
    request.k_first = vineyard.k_first;
    request.k_last = vineyard.k_last;
    request.max_degree = vineyard.max_degree;
    return request;
}

}  // namespace

requests::Vineyard vineyard_request(const VineyardRequest& vineyard) {
    return over_k(requests::Vineyard(vineyard.choice.filter), vineyard);
}

requests::PointsVineyard points_vineyard_request(const VineyardRequest& vineyard, std::uint32_t dim) {
    return over_k(requests::PointsVineyard(dim, vineyard.choice.filter), vineyard);
}

requests::Points points_request(const Options& options, const DiagramRequest& diagram, std::uint32_t dim) {
    requests::Points points(dim, diagram.choice.filter);
    set_diagram(options, diagram, dim, &points);
    points.k = options.k.value_or(1);
    points.representatives = diagram.cycles ? 1 : 0;
    return points;
}

namespace {

template <class Request> std::size_t plan_for(Request request, std::size_t point_count) {
    request.point_count = point_count;
    return plan(request);
}

}  // namespace

std::size_t plan_diagram(const Options& given, netmesh_filter filter, std::uint32_t dim, std::size_t point_count) {
    if (given.auto_filter) return plan_for(auto_request(given, dim), point_count);
    const Options options = suited(given, dim);
    DiagramRequest diagram;
    diagram.choice.filter = filter;
    switch (about(filter).source) {
    case NETMESH_SOURCE_SCALES: return plan_for(scales_request(options, diagram, dim), point_count);
    case NETMESH_SOURCE_POINTS: return plan_for(points_request(options, diagram, dim), point_count);
    case NETMESH_SOURCE_DELAUNAY:
        return wants_diagram_alone(options) ? plan_for(alpha_request(options, dim), point_count)
                                            : plan_for(delaunay_request(options, dim), point_count);
    default: break;
    }
    requests::Mesh mesh = mesh_request(options, dim);
    if (!refines_by_certificate(options)) mesh.purpose = about(filter).purpose;
    return plan_for(mesh, point_count);
}

std::size_t plan_vineyard(const Options& options, const VineyardRequest& vineyard, std::uint32_t dim,
                          std::size_t point_count) {
    return is_on_points(vineyard.choice.filter) ? plan_for(points_vineyard_request(vineyard, dim), point_count)
                                                : plan_diagram(options, vineyard.choice.filter, dim, point_count);
}

}  // namespace netmesh::tool
