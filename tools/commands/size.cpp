#include <algorithm>

#include "platform/clock.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/output.hpp"
#include "tools/requests.hpp"

namespace netmesh::tool {

namespace {

// Enough for each of triangulation, mesh and the diagrams of the complete filter and of the one that persist takes.
std::size_t plan_all(const Options& options) {
    requests::Delaunay delaunay(options.dim);
    requests::Mesh mesh = mesh_request(options, options.dim);
    delaunay.point_count = mesh.point_count = options.point_count;
    mesh.purpose = NETMESH_PURPOSE_MESH;
    Options of_complete = options;
    of_complete.auto_filter = false;
    const auto diagram = [&](const Options& of) {
        return plan_diagram(of, filter_of(of), options.dim, options.point_count);
    };
    return std::max({plan(delaunay), plan(mesh), diagram(options), diagram(of_complete)});
}

}  // namespace

Outcome run_size(const Options& options) {
    if (options.dim == 0) return usage_error("size needs --dim D");
    if (options.point_count == 0) return usage_error("size needs --points N");
    const double start = platform::seconds_now();
    Outcome outcome = check_accuracy(options);
    if (outcome.good()) outcome = check_max_degree(options);
    if (!outcome.good()) return outcome;
    const std::size_t bytes =
        options.filter ? plan_diagram(options, *options.filter, options.dim, options.point_count) : plan_all(options);
    if (bytes == 0) return {Exit::internal, "netmesh: internal error: no plan for these options"};
    if (bytes == SIZE_MAX) return {Exit::memory, "netmesh: more bytes than this machine can address"};
    RunReport run;
    run.options = &options;
    run.plan_bytes = bytes;
    run.total_seconds = platform::seconds_now() - start;
    const std::string text = options.json ? json_report(run) : std::to_string(bytes) + "\n";
    return write_files({{"", [&](TextWriter& out) { out << text; }}});
}

}  // namespace netmesh::tool
