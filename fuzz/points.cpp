// Bytes to points to triangulation, mesh and diagram, D = 2..6. The first byte chooses D, the size of the block and
// what is done: points alone from 0 to 89, with weights, with radii, with periods, with periods and weights from 90,
// 135, 180 and 225 on. Each following byte is a coordinate or a weight: mostly from a few values, their neighbours in
// the last place and tiny powers of two, so that degenerate input is the rule. Whatever comes out must be a known
// status, and what is held must pass the checkers.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>
#include <vector>

#include "common/read.hpp"
#include "fuzz/decoder.hpp"
#include "netmesh.hpp"
#include "vocabulary/dimension.hpp"

using fuzz::coordinate;
using fuzz::require;

namespace {

bool fits_or_not(netmesh_status status) { return status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY; }
bool meshed_or_refused(netmesh_status status) {
    return fits_or_not(status) || status == NETMESH_OUT_OF_RANGE || status == NETMESH_TOO_CLOSE;
}

void triangulate(netmesh_context* context, const netmesh_points& points) {
    netmesh::Request request;
    request.points = points;
    request.mesh.method = &netmesh_method_delaunay;
    netmesh_status status = netmesh_mesh(context, &request);
    require(fits_or_not(status) || status == NETMESH_FLAT);
    if (status != NETMESH_OK) return;
    auto check = netmesh::sized<netmesh_check_request>();
    check.what = NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_GEOMETRIC | NETMESH_CHECK_DELAUNAY;
    require(netmesh_check(context, &check) == NETMESH_OK);
    const netmesh::Request alpha(&netmesh_filter_alpha);  // of what the context holds
    status = netmesh_persist(context, &alpha);
    require(fits_or_not(status) || status == NETMESH_OUT_OF_RANGE);
}

// Whether there is a mesh.
bool mesh_and_check(netmesh_context* context, const netmesh_request& request) {
    const netmesh_status status = netmesh_mesh(context, &request);
    require(meshed_or_refused(status));
    if (status != NETMESH_OK) return false;
    auto check = netmesh::sized<netmesh_check_request>();
    check.promised = &request;
    require(fits_or_not(netmesh_check(context, &check)));
    return true;
}

void persist(netmesh_context* context, double tau) {
    const netmesh::Request complete(&netmesh_filter_complete);
    const netmesh_status status = netmesh_persist(context, &complete);
    require(fits_or_not(status));
    auto report = netmesh::sized<netmesh_report>();
    require(netmesh_get_report(context, &report) == NETMESH_OK);
    if (status == NETMESH_OK) require(report.diagram.certified_ratio >= 1 && report.mesh.aspect_ratio_max <= tau);
}

// Rows of coordinates and a number that is the weight, the last one cut off where it ends; the lattice.
struct Extras {
    std::vector<double> rows, lattice;
    bool has_weights, are_radii, has_periods;
};

Extras read_extras(const std::uint8_t* data, std::size_t size, std::uint32_t dim, std::size_t points_max) {
    const int kind = data[0] / 45;
    Extras e = {{}, {}, kind != 4, kind == 3, kind >= 4};
    std::size_t at = 1;
    const auto next = [&] { return at < size ? data[at++] : std::uint8_t{0}; };
    if (e.has_periods) {
        const std::uint32_t count = 1 + next() % dim;
        for (std::uint32_t j = 0; j < count; ++j)
            for (std::uint32_t k = 0; k < dim; ++k) {
                const double x = coordinate(next());
                e.lattice.push_back(j == k ? 8 : std::fabs(x) < 8 ? x : 0);
            }
    }
    while (at < size && e.rows.size() < points_max * (dim + 1)) {
        const double x = coordinate(next());
        e.rows.push_back(e.are_radii && e.rows.size() % (dim + 1) == dim ? std::fabs(x) : x);
    }
    e.rows.resize(e.rows.size() / (dim + 1) * (dim + 1));
    e.rows.shrink_to_fit();
    return e;
}
netmesh::Request request_of(const Extras& e, std::uint32_t dim) {
    netmesh::Request request(&netmesh_filter_alpha);
    request.points.dim = dim;
    request.points.count = e.rows.size() / (dim + 1);
    request.points.coordinates = e.rows.data();
    request.points.stride_bytes = (dim + 1) * sizeof(double);
    if (e.has_weights) {
        request.points.weights = e.rows.data() + dim;
        request.points.weight_stride_bytes = request.points.stride_bytes;
        request.weighting = e.are_radii ? &netmesh_radii : &netmesh_weights;
    }
    if (e.has_periods) request.set_lattice(e.lattice);
    return request;
}

using Bar = std::tuple<std::uint32_t, double, double>;
std::vector<Bar> bars_of(const netmesh_context* context) {
    std::vector<Bar> bars;
    for (const netmesh_pair& pair : read_all(context, netmesh_get_pair))
        bars.emplace_back(pair.degree, pair.birth, pair.death);
    std::sort(bars.begin(), bars.end());
    return bars;
}
// A ball, or with periods a torus, is left in the end.
void require_lasting(const std::vector<Bar>& bars, std::uint32_t dim, std::uint32_t periods) {
    std::uint64_t wanted = 1;
    for (std::uint32_t degree = 0; degree <= dim; ++degree) {
        std::uint64_t lasting = 0;
        for (const Bar& bar : bars) lasting += std::get<0>(bar) == degree && std::isinf(std::get<2>(bar));
        require(lasting == wanted);
        wanted = degree < periods ? wanted * (periods - degree) / (degree + 1) : 0;
    }
}

void persist_extras(netmesh_context* context, Extras e, std::uint32_t dim) {
    const netmesh::Request request = request_of(e, dim);
    const netmesh_status status = netmesh_persist(context, &request);
    require(fits_or_not(status) || status == NETMESH_FLAT || status == NETMESH_OUT_OF_RANGE ||
            (e.has_periods && status == NETMESH_INVALID_ARGUMENT));
    if (status != NETMESH_OK) return;
    const std::vector<Bar> bars = bars_of(context);
    require_lasting(bars, dim, request.points.lattice_count);
    // The bars do not depend on the order of rows, nor on whether a triangulation is kept.
    const std::size_t n = e.rows.size() / (dim + 1);
    for (std::size_t i = 0; i < n / 2; ++i)
        std::swap_ranges(&e.rows[i * (dim + 1)], &e.rows[i * (dim + 1)] + dim + 1, &e.rows[(n - 1 - i) * (dim + 1)]);
    netmesh::Request again = request_of(e, dim);
    again.keep_mesh = e.has_periods ? 0 : 1;
    require(fits_or_not(netmesh_persist(context, &again)));
    if (detail_of(context).status != NETMESH_OK) return;
    require(bars_of(context) == bars);
    if (again.keep_mesh == 0) return;
    auto check = netmesh::sized<netmesh_check_request>();
    check.what = NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_GEOMETRIC;
    require(fits_or_not(netmesh_check(context, &check)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 3) return 0;
    const std::uint32_t dim = 2 + data[0] % 5;
    if (!netmesh::serves_dimension(dim)) return 0;
    const std::size_t block_bytes = std::size_t{4096} << (data[0] / 5 % 9);
    const std::size_t points_max = dim < 5 ? 24 : 9;
    const bool has_extras = data[0] >= 90;
    const Extras extras = has_extras ? read_extras(data, size, dim, points_max) : Extras();
    std::vector<double> points;
    for (std::size_t i = 1; i < size && points.size() < points_max * dim; ++i) points.push_back(coordinate(data[i]));
    const std::size_t n = points.size() / dim;
    if (has_extras ? extras.rows.empty() : n == 0) return 0;

    void* const block = std::aligned_alloc(16, block_bytes);
    netmesh_context* context;
    require(block != nullptr && netmesh_init(block, block_bytes, &context) == NETMESH_OK);
    if (has_extras) {
        persist_extras(context, extras, dim);
        std::free(block);
        return 0;
    }
    netmesh::Request request(&netmesh_filter_complete);
    request.set_points(dim, points);
    request.points.count = n;
    request.mesh.method = &netmesh_method_svr;
    request.mesh.tau = dim == 2 ? 2.3 : dim < 5 ? 3.2 : 4;
    triangulate(context, request.points);
    if (mesh_and_check(context, request)) persist(context, request.mesh.tau);
    request.mesh = {};
    request.goal.ratio = 1.5 + 0.5 * static_cast<double>(n % 5);
    mesh_and_check(context, request);
    std::free(block);
    return 0;
}
