#include "platform/clock.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/output.hpp"
#include "tools/report/report.hpp"

namespace netmesh::tool {

Outcome run_size(const Options& options) {
    if (options.dim == 0) return usage_error("size needs --dim D");
    if (options.point_count == 0) return usage_error("size needs --points N");
    const double start = platform::seconds_now();
    netmesh_options engine_options;
    netmesh_options_init(&engine_options, options.dim);
    if (options.tau) engine_options.tau = *options.tau;
    const Outcome outcome = check_accuracy(options);
    if (!outcome.good()) return outcome;
    (promises_accuracy(options) ? engine_options.eps : engine_options.over_refine_eps) = options.eps;
    engine_options.seed = options.seed;
    engine_options.method = options.method.value_or(NETMESH_METHOD_SVR);
    std::vector<netmesh_job> jobs = {NETMESH_JOB_DELAUNAY, NETMESH_JOB_MESH, NETMESH_JOB_PERSIST};
    if (options.filter) {
        jobs = {job_of(*options.filter)};
    }
    std::uint64_t bytes = 0;
    if (options.filter && is_points_filter(*options.filter)) {
        jobs.clear();
        bytes = netmesh_points_bytes(*options.filter, &engine_options, options.point_count, options.k.value_or(1),
                                     max_degree_of(options, options.dim));
        if (bytes == 0) return usage_error("--max-degree, with --k added for barycentric filters, is at most 30");
    }
    for (const netmesh_job job : jobs) {
        const std::uint64_t plan = netmesh_plan_bytes(job, &engine_options, options.point_count);
        if (plan > bytes) bytes = plan;
    }
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
