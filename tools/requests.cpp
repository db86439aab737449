#include "tools/requests.hpp"

#include <algorithm>

namespace netmesh::tool {

namespace {

// What is asked of functions and distances does not go by their values.
const netmesh_function any_function = {
    sizeof(netmesh_function), [](void*, const double*) { return 0.0; }, nullptr, 0, 0, 0};
const netmesh_distances any_distances = sized<netmesh_distances>();

bool makes_mesh_alone(const Options& options) {
    return options.command == Command::mesh || options.command == Command::delaunay;
}

// The triangulation of alpha is wanted, not its diagram alone; other filters refuse to keep what they do not make.
bool keeps_mesh(const Options& options) {
    const bool is_alpha = about(options.request.filter).is_on_triangulation != 0;
    return !options.mesh_out.empty() ||
           (is_alpha && (!options.proof.empty() || options.check || options.command == Command::size));
}

// With --check cycles are made where that is no call of its own.
bool wants_cycles(const Options& options) {
    const netmesh_filter_info& filter = about(options.request.filter);
    const bool at_once = filter.is_on_points != 0 || filter.is_by_scales != 0;
    return !options.representatives.empty() || (at_once && options.check && filter.has_representatives != 0);
}

// Points that were not read.
netmesh_points points_without_places(std::uint32_t dim, std::size_t count) {
    netmesh_points points = {};
    points.count = count;
    points.dim = dim;
    points.format = NETMESH_POINTS_FLOAT64;
    return points;
}

// Before points are read their lattice may be of another dimension, or not known.
void put_lattice(const Lattice& lattice, netmesh_points* points) {
    static constexpr double any_vector[NETMESH_DIM_MAX] = {1};
    if (lattice.kind == Lattice::none) return;
    const bool fits = lattice.dim == points->dim;
    points->lattice = fits ? lattice.vectors.data() : any_vector;
    points->lattice_count = fits ? lattice.count() : 1;
}

// Of points, unless a mesh or distances are there.
netmesh_request asked_of(const Options& options, std::uint32_t dim) {
    netmesh_request r = options.request;
    const bool persists = options.command == Command::persist, sizes = options.command == Command::size;
    if (options.distances) {
        r.distances = &any_distances;
    } else if (!persists || options.values_at.empty()) {
        r.points = points_without_places(dim, 1);
        put_lattice(options.table.lattice, &r.points);
    }
    if (options.table.lattice.kind != Lattice::none) r.periods = &netmesh_periodic;
    if (!options.table.weights.empty()) r.weighting = options.table.are_radii ? &netmesh_radii : &netmesh_weights;
    if (options.function || !options.values_at.empty() || (sizes && about(r.filter).needs_function != 0))
        r.function = &any_function;
    if (options.command == Command::delaunay) r.mesh.method = &netmesh_method_delaunay;
    const bool is_meshed = options.command == Command::mesh || (sizes && about(r.filter).is_on_mesh != 0);
    if (is_meshed && r.filter != &netmesh_filter_auto && r.mesh.method == nullptr) r.mesh.method = &netmesh_method_svr;
    if (options.command == Command::vineyard) r.vines = &netmesh_vines;
    if (persists && wants_cycles(options)) r.cycles = &netmesh_cycles;
    if ((persists || sizes) && keeps_mesh(options)) r.keep_mesh = 1;
    return r;
}

}  // namespace

Outcome settle(const Options& options, std::uint32_t dim, netmesh_request* settled, netmesh_field* at) {
    const netmesh_request asked = asked_of(options, dim);
    netmesh_detail detail = sized<netmesh_detail>();
    *settled = asked;
    const netmesh_status status = netmesh::settle(asked, settled, &detail);
    const bool has_degrees = settled->points.dim == 0 && settled->distances == nullptr;
    if (has_degrees) settled->max_degree = std::min(settled->max_degree, dim - 1);
    settled->points = {};
    settled->distances = nullptr;
    settled->function = nullptr;
    if (at != nullptr) *at = detail.field;
    if (status == NETMESH_OK) return {};
    const std::string option = option_of(options, detail.field);
    return usage_error((option.empty() ? "" : option + ": ") + detail.message);
}

Options settled(const Options& options, std::uint32_t dim) {
    Options all = options;
    settle(options, dim, &all.request);
    return all;
}

std::string option_against_auto(const Options& options) {
    for (const char* const name : {"--mesh", "--values", "--function", "--values-at", "--lipschitz", "--cut"})
        if (was_given(options, name)) return name;
    netmesh_detail detail = sized<netmesh_detail>();
    netmesh_request settled;
    if (netmesh::settle(asked_of(options, NETMESH_DIM_MIN), &settled, &detail) == NETMESH_OK) return {};
    const std::string option = option_of(options, detail.field);
    return option.substr(0, option.find(' '));
}

double default_tau(std::uint32_t dim) {
    netmesh_request r = Request(&netmesh_filter_basic);
    r.points = points_without_places(dim, 1);
    return netmesh::settle(r, &r) == NETMESH_OK ? r.mesh.tau : 0;
}

netmesh_request on_points(netmesh_request request, const PointCloud& cloud) {
    request.points = points_of(cloud.dim, cloud.coordinates);
    if (!cloud.weights.empty()) request.points.weights = cloud.weights.data();
    put_lattice(cloud.lattice, &request.points);
    return request;
}

netmesh_request on_what_is_there(netmesh_request request) {
    request.points = {};
    request.weighting = nullptr;
    request.periods = nullptr;
    request.goal = {};
    request.mesh = {};
    request.fit = nullptr;
    request.seed = netmesh_default_request().seed;
    return request;
}

netmesh_request promised(netmesh_request request) {
    request.points = {};
    request.weighting = nullptr;
    request.periods = nullptr;
    request.squares = 0;
    request.bounds = request.cycles = request.vines = request.fit = nullptr;
    request.goal.longer_than = 0;
    return request;
}

std::size_t plan_of(const Options& options, std::uint32_t dim, std::size_t points) {
    netmesh_request r = asked_of(options, dim);
    r.points = points_without_places(dim, points);
    put_lattice(options.table.lattice, &r.points);
    return makes_mesh_alone(options) ? plan_mesh(r) : plan(r);
}

// Without a filter enough for each of triangulation, mesh and the diagrams of complete and of what persist takes.
std::size_t plan_for_size(const Options& options) {
    const bool has_filter = was_given(options, "--filter") && options.implies_mesh.empty() &&
                            options.request.filter != &netmesh_filter_auto;
    if (has_filter) return plan_of(options, options.dim, options.point_count);
    Options other = options;
    const auto plan = [&](Command command, const netmesh_filter* filter) {
        other.command = command;
        other.request.filter = filter;
        return plan_of(other, options.dim, options.point_count);
    };
    return std::max({plan(Command::mesh, nullptr), plan(Command::size, options.request.filter),
                     plan(Command::size, &netmesh_filter_complete), plan(Command::delaunay, nullptr)});
}

std::size_t plan_to_read(std::uint32_t dim, std::size_t vertices) {
    netmesh_request r = Request(&netmesh_filter_basic);
    r.points = points_without_places(dim, vertices);
    return plan(r);
}

}  // namespace netmesh::tool
