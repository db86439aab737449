// vineyard: points in, one mesh, the diagrams of all k and the vines between them out.
#include <algorithm>
#include <cstdio>

#include "platform/clock.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/diagram_checks.hpp"
#include "tools/commands/output.hpp"
#include "tools/io/vine_file.hpp"
#include "tools/plot/plots.hpp"
#include "tools/report/report.hpp"
#include "tools/session.hpp"

namespace netmesh::tool {

namespace {

netmesh_filter filter_of(const Options& options) { return options.filter.value_or(NETMESH_FILTER_KNN); }

// The checkers of the mesh, then each diagram computed afresh.
netmesh_status check(Session& session, const Options& options, const Vines& vines, std::uint32_t max_degree,
                     std::string* fault) {
    netmesh_options engine_options = session.engine_options();
    netmesh_status status = session.call(
        NETMESH_STAGE_CHECK, [&] { return netmesh_check(session.context(), NETMESH_CHECK_ALL, &engine_options); });
    for (std::size_t i = 0; i < vines.ratios.size() && status == NETMESH_OK; i++) {
        engine_options.k = vines.k_first + static_cast<std::uint32_t>(i);
        status = session.call(NETMESH_STAGE_CHECK, [&] {
            return netmesh_persist(session.context(), filter_of(options),
                                   options.values.value_or(NETMESH_VALUES_CERTIFIED), max_degree, 0, &engine_options);
        });
        if (status != NETMESH_OK) break;
        if (first_difference(diagram_at(vines, engine_options.k), bars_of(session.context())) == SIZE_MAX) continue;
        *fault = "the diagram at k = " + std::to_string(engine_options.k) + " is not that of a fresh computation";
        break;
    }
    return status;
}

Outcome check_outputs(const Options& options) {
    if (!options.out.empty() && ending_of(options.out) != ".vines") {
        return usage_error(options.out + ": a vineyard is written to .vines");
    }
    return check_writable({options.out, options.svg});
}

}  // namespace

Outcome run_vineyard(const Options& options) {
    const double start = platform::seconds_now();
    if (options.filter && filter_of(options) != NETMESH_FILTER_KNN && filter_of(options) != NETMESH_FILTER_KDISTANCE) {
        return usage_error(std::string("--filter ") + filter_name(*options.filter) +
                           ": a vineyard is of knn or kdistance");
    }
    if (!options.k) return usage_error("vineyard needs --k FIRST..LAST");
    Outcome outcome = check_outputs(options);
    PointCloud cloud;
    if (outcome.good()) outcome = read_points(options.positionals[0], &cloud);
    if (!outcome.good()) return outcome;
    RunReport run;
    run.options = &options;
    run.dim = cloud.dim;
    run.read_seconds = platform::seconds_now() - start;

    Session session(options, cloud.dim);
    Vines vines;
    std::string fault;
    outcome = session.run(NETMESH_JOB_PERSIST, cloud, [&](Session& s) {
        netmesh_status status = s.call(NETMESH_STAGE_REFINE, [&] {
            return netmesh_mesh(s.context(), cloud.coordinates.data(), cloud.rows(), NETMESH_JOB_PERSIST,
                                &s.engine_options());
        });
        const std::uint32_t degree = options.max_degree.value_or(cloud.dim - 1);
        if (status == NETMESH_OK) {
            status = s.call(NETMESH_STAGE_REDUCE, [&] {
                return netmesh_vineyard(s.context(), filter_of(options), *options.k,
                                        options.k_last.value_or(*options.k),
                                        options.values.value_or(NETMESH_VALUES_CERTIFIED), degree, &s.engine_options());
            });
        }
        if (status != NETMESH_OK) return status;
        vines = vines_of(s.context());
        run.engine = s.report();
        return options.check ? check(s, options, vines, degree, &fault) : status;
    });
    if (!outcome.good()) return outcome;
    if (!fault.empty()) return {Exit::check, "netmesh: check failed: " + fault};
    run.clock = session.clock();
    run.vines = &vines;

    const double computed = platform::seconds_now();
    std::vector<FileJob> jobs;
    if (!options.svg.empty()) {
        jobs.push_back({options.svg, [&](TextWriter& out) { out << vineyard_picture(vines, *run.engine); }});
    }
    if (!options.out.empty() || !options.json) {
        jobs.push_back({options.out, [&](TextWriter& out) { write_vines(vines, *run.engine, out); }});
    }
    outcome = write_files(jobs);
    if (!outcome.good()) return outcome;
    run.write_seconds = platform::seconds_now() - computed;
    run.total_seconds = platform::seconds_now() - start;
    if (options.check) {
        run.checked = std::vector<std::string>{"combinatorics, orientation, Delaunay property, quality",
                                               "each diagram equals a fresh computation"};
    }
    if (!options.quiet && !options.json) std::fputs(text_report(run).c_str(), stderr);
    if (!options.json) return {};
    return write_files({{"", [&](TextWriter& out) { out << json_report(run); }}});
}

}  // namespace netmesh::tool
