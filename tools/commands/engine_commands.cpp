// mesh, delaunay and persist: points in, one or two engine calls, files out.
#include <cstdio>

#include "platform/clock.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/diagram_checks.hpp"
#include "tools/commands/output.hpp"
#include "tools/plot/plots.hpp"
#include "tools/report/report.hpp"
#include "tools/session.hpp"

namespace netmesh::tool {

namespace {

netmesh_filter filter_of(const Options& options) { return options.filter.value_or(NETMESH_FILTER_COMPLETE); }

bool triangulates_only(const Options& options) {
    return options.command == Command::delaunay ||
           (options.command == Command::persist && filter_of(options) == NETMESH_FILTER_ALPHA);
}

bool goes_by_scales(const Options& options) {
    return options.command == Command::persist && filter_of(options) == NETMESH_FILTER_SCALES;
}

netmesh_job job_of(const Options& options) {
    if (options.command == Command::delaunay) return NETMESH_JOB_DELAUNAY;
    if (options.command == Command::mesh) return NETMESH_JOB_MESH;
    return tool::job_of(filter_of(options));
}

// Once before the points are read, with dim 0, and once behind.
Outcome check_outputs(const Options& options, std::uint32_t dim) {
    Outcome outcome;
    if (options.command == Command::persist) {
        if (!options.out.empty() && ending_of(options.out) != ".pers") {
            return usage_error(options.out + ": a diagram is written to .pers");
        }
        if (goes_by_scales(options) && !options.mesh_out.empty()) {
            return usage_error("--mesh " + options.mesh_out + ": scales has one mesh after the other and keeps none");
        }
        outcome = check_mesh_ending(options.mesh_out, dim);
    } else {
        outcome = check_mesh_ending(options.out, dim);
        if (!options.svg.empty() && dim > 2) {
            return usage_error("--svg " + options.svg + ": draws meshes in the plane, these points have " +
                               std::to_string(dim) + " dimensions");
        }
    }
    if (!outcome.good()) return outcome;
    return check_writable({options.out, options.mesh_out, options.svg});
}

netmesh_status work(Session& session, const Options& options, const PointCloud& cloud,
                    netmesh_analysis* analysis) {
    netmesh_context* const context = session.context();
    const netmesh_options* const engine_options = &session.engine_options();
    const auto bound = [&](netmesh_status status) {
        if (status != NETMESH_OK || !options.bounds) return status;
        return session.call(NETMESH_STAGE_CERTIFY, [&] { return netmesh_bound_bars(context, engine_options); });
    };
    if (goes_by_scales(options)) {
        return bound(session.call(NETMESH_STAGE_REDUCE, [&] {
            return netmesh_persist_scales(context, cloud.coordinates.data(), cloud.rows(),
                                          options.values.value_or(NETMESH_VALUES_CERTIFIED),
                                          options.max_degree.value_or(cloud.dim - 1), options.all ? 1 : 0, engine_options);
        }));
    }
    const bool triangulate = triangulates_only(options);
    netmesh_status status = session.call(triangulate ? NETMESH_STAGE_DELAUNAY : NETMESH_STAGE_REFINE, [&] {
        const double* const points = cloud.coordinates.data();
        return triangulate ? netmesh_delaunay(context, points, cloud.rows(), engine_options)
                           : netmesh_mesh(context, points, cloud.rows(), job_of(options), engine_options);
    });
    if (status == NETMESH_OK && options.command == Command::persist) {
        status = bound(session.call(NETMESH_STAGE_REDUCE, [&] {
            return netmesh_persist(context, filter_of(options), options.values.value_or(NETMESH_VALUES_CERTIFIED),
                                   options.max_degree.value_or(cloud.dim - 1), options.all ? 1 : 0, engine_options);
        }));
    }
    if (status == NETMESH_OK && options.analyse) {
        analysis->struct_bytes = sizeof *analysis;
        const std::uint32_t what = triangulate ? NETMESH_ANALYSE_ALL & ~NETMESH_ANALYSE_SIZE : NETMESH_ANALYSE_ALL;
        status = session.call(NETMESH_STAGE_ANALYSE,
                              [&] { return netmesh_analyse(context, what, 0, engine_options, analysis); });
    }
    if (status == NETMESH_OK && options.check) {
        status = session.call(NETMESH_STAGE_CHECK,
                              [&] { return netmesh_check(context, NETMESH_CHECK_ALL, engine_options); });
    }
    return status;
}

// What the result is made of, by the options: files, pictures, data on stdout.
std::vector<FileJob> result_jobs(const Options& options, const ContextMesh& mesh, const std::vector<Bar>& bars,
                                 const std::vector<netmesh_bar_bounds>& bounds, const netmesh_report& report) {
    std::vector<FileJob> jobs;
    const bool data_on_stdout = options.out.empty() && !options.json;
    if (options.command == Command::persist) {
        if (!options.mesh_out.empty()) add_mesh_files(mesh, options.mesh_out, &jobs);
        if (!options.svg.empty()) {
            jobs.push_back({options.svg, [&](TextWriter& out) { out << diagram_picture(bars, report); }});
        }
        if (!options.out.empty() || data_on_stdout) {
            jobs.push_back({options.out, [&](TextWriter& out) { write_diagram(bars, bounds, out); }});
        }
        return jobs;
    }
    if (!options.svg.empty()) jobs.push_back({options.svg, [&](TextWriter& out) { write_mesh_picture(mesh, out); }});
    if (!options.out.empty() || data_on_stdout) add_mesh_files(mesh, options.out, &jobs);
    return jobs;
}

}  // namespace

netmesh_job job_of(netmesh_filter filter) {
    switch (filter) {
    case NETMESH_FILTER_ALPHA:
        return NETMESH_JOB_PERSIST_ALPHA;
    case NETMESH_FILTER_TIGHT:
        return NETMESH_JOB_PERSIST_TIGHT;
    case NETMESH_FILTER_SCALES:
        return NETMESH_JOB_PERSIST_SCALES;
    default:
        return NETMESH_JOB_PERSIST;
    }
}

Outcome run_engine_command(const Options& options) {
    const double start = platform::seconds_now();
    Outcome outcome = check_accuracy(options);
    if (outcome.good() && options.bounds && filter_of(options) == NETMESH_FILTER_BASIC) {
        outcome = usage_error("--bounds: the basic filter's certificate begins at a scale and has no bounds for single bars");
    }
    if (outcome.good()) outcome = check_outputs(options, 0);
    PointCloud cloud;
    if (outcome.good()) outcome = read_points(options.positionals[0], &cloud);
    if (outcome.good()) outcome = check_outputs(options, cloud.dim);
    if (!outcome.good()) return outcome;
    RunReport run;
    run.options = &options;
    run.dim = cloud.dim;
    run.read_seconds = platform::seconds_now() - start;

    Session session(options, cloud.dim);
    netmesh_analysis analysis = {};
    outcome = session.run(job_of(options), cloud, [&](Session& s) { return work(s, options, cloud, &analysis); });
    if (!outcome.good()) return outcome;
    run.engine = session.report();
    run.clock = session.clock();
    if (options.analyse) run.analysis = analysis;

    const double computed = platform::seconds_now();
    std::vector<Bar> bars;
    std::vector<netmesh_bar_bounds> bounds;
    if (options.command == Command::persist) {
        bars = bars_of(session.context());
        bounds = bounds_of(session.context());
    }
    if (options.check && options.command == Command::persist) {
        const std::string complaint = diagram_complaint(bars);
        if (!complaint.empty()) return {Exit::check, "netmesh: check failed: diagram: " + complaint};
    }
    ContextMesh mesh(session.context());
    const std::string& mesh_path = options.command == Command::persist ? options.mesh_out : options.out;
    if (mesh.tau > 0 && ending_of(mesh_path) == ".vtu") mesh.measure(session.context());
    outcome = write_files(result_jobs(options, mesh, bars, bounds, *run.engine));
    if (!outcome.good()) return outcome;
    run.write_seconds = platform::seconds_now() - computed;
    run.total_seconds = platform::seconds_now() - start;
    if (options.bounds) {
        run.certain.resize(run.engine->max_degree + 1);
        for (std::size_t i = 0; i < bounds.size(); i++) run.certain[bars[i].degree] += bounds[i].certain;
        run.bounds = &bounds;
    }
    if (options.json && options.out.empty() && options.command == Command::persist) run.bars = &bars;
    if (options.check) {
        run.checked = std::vector<std::string>{
            goes_by_scales(options) ? "bars sorted, with one essential class"
                                    : "combinatorics, orientation, Delaunay property, quality, bounds on size and degrees"};
    }
    if (!options.quiet && !options.json) std::fputs(text_report(run).c_str(), stderr);
    if (!options.json) return {};
    return write_files({{"", [&](TextWriter& out) { out << json_report(run); }}});
}

}  // namespace netmesh::tool
