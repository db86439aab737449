// Bytes to points to triangulation, mesh and diagram, D = 2..6. The first byte chooses D and the size of the block,
// each following byte a coordinate: mostly from a few values, their neighbours in the last place and tiny powers of
// two, so that degenerate input is the rule. Whatever comes out must be a known status, and what is held must pass the
// checkers.
#include <cstdlib>
#include <vector>

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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 3) return 0;
    const std::uint32_t dim = 2 + data[0] % 5;
    if (!netmesh::serves_dimension(dim)) return 0;
    const std::size_t block_bytes = std::size_t{4096} << (data[0] / 5 % 9);
    const std::size_t points_max = dim < 5 ? 24 : 9;
    std::vector<double> points;
    for (std::size_t i = 1; i < size && points.size() < points_max * dim; ++i) points.push_back(coordinate(data[i]));
    const std::size_t n = points.size() / dim;
    if (n == 0) return 0;

    void* const block = std::aligned_alloc(16, block_bytes);
    netmesh_context* context;
    require(block != nullptr && netmesh_init(block, block_bytes, &context) == NETMESH_OK);
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
