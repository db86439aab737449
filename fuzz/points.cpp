// Bytes to points to triangulation, mesh and diagram, D = 2..6. The first byte chooses D and the size of the block,
// each following byte a coordinate: mostly from a few values, their neighbours in the last place and tiny powers of
// two, so that degenerate input is the rule. Whatever comes out must be a known status, and what is held must pass the
// checkers.
#include <cstdlib>
#include <vector>

#include "fuzz/decoder.hpp"
#include "netmesh.h"

using fuzz::coordinate;
using fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size < 3) return 0;
    const std::uint32_t dim = 2 + data[0] % 5;
    const std::size_t block_bytes = std::size_t{4096} << (data[0] / 5 % 9);
    const std::size_t points_max = dim < 5 ? 24 : 9;
    std::vector<double> points;
    for (std::size_t i = 1; i < size && points.size() < points_max * dim; ++i) points.push_back(coordinate(data[i]));
    const std::size_t n = points.size() / dim;
    if (n == 0) return 0;

    void* const block = std::aligned_alloc(16, block_bytes);
    netmesh_context* context;
    require(block != nullptr && netmesh_init(block, block_bytes, &context) == NETMESH_OK);
    netmesh_options options;
    netmesh_options_init(&options, dim);
    options.tau = dim == 2 ? 2.3 : dim < 5 ? 3.2 : 4;
    constexpr std::uint32_t triangulation =
        NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_GEOMETRIC | NETMESH_CHECK_DELAUNAY;

    netmesh_status status = netmesh_delaunay(context, points.data(), n, &options);
    require(status == NETMESH_OK || status == NETMESH_FLAT || status == NETMESH_OUT_OF_MEMORY);
    if (status == NETMESH_OK) {
        require(netmesh_check(context, triangulation, &options) == NETMESH_OK);
        status = netmesh_persist(context, NETMESH_FILTER_ALPHA, NETMESH_VALUES_CERTIFIED, dim, 0, &options);
        require(status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY);
    }
    status = netmesh_mesh(context, points.data(), n, NETMESH_JOB_PERSIST, &options);
    require(status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY || status == NETMESH_OUT_OF_RANGE ||
            status == NETMESH_TOO_CLOSE);
    if (status == NETMESH_OK) {
        status = netmesh_check(context, NETMESH_CHECK_ALL, &options);
        require(status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY);
        status = netmesh_persist(context, NETMESH_FILTER_COMPLETE, NETMESH_VALUES_CERTIFIED, dim, 0, &options);
        require(status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY);
        netmesh_report report;
        report.struct_bytes = sizeof report;
        require(netmesh_get_report(context, &report) == NETMESH_OK);
        if (status == NETMESH_OK) require(report.certified_ratio >= 1 && report.aspect_ratio_max <= options.tau);
    }
    options.ratio = 1.5 + 0.5 * static_cast<double>(n % 5);
    status = netmesh_mesh(context, points.data(), n, NETMESH_JOB_PERSIST, &options);
    require(status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY || status == NETMESH_OUT_OF_RANGE ||
            status == NETMESH_TOO_CLOSE);
    if (status == NETMESH_OK) {
        status = netmesh_check(context, NETMESH_CHECK_ALL, &options);
        require(status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY);
    }
    std::free(block);
    return 0;
}
