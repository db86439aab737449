// mesh, delaunay and persist: points in, one or two engine calls, files out.
#include <cstdio>

#include "platform/clock.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/cycles.hpp"
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

std::uint32_t k_of(const Options& options) { return options.k.value_or(1); }

bool uses_points_alone(const Options& options) {
    return options.command == Command::persist && is_points_filter(filter_of(options));
}

bool goes_by_scales(const Options& options) {
    return options.command == Command::persist && filter_of(options) == NETMESH_FILTER_SCALES;
}

netmesh_job job_of(const Options& options) {
    if (options.command == Command::delaunay) return NETMESH_JOB_DELAUNAY;
    if (options.command == Command::mesh) return NETMESH_JOB_MESH;
    return tool::job_of(filter_of(options));
}

// Filters on the points take options that others do not, and the other way round.
Outcome check_filter(const Options& options) {
    const netmesh_filter filter = filter_of(options);
    const bool points_filter = options.command == Command::persist && is_points_filter(filter);
    if (!options.representatives.empty() && (is_barycentric(filter) || filter == NETMESH_FILTER_SCALES)) {
        return usage_error(std::string("--representatives does not apply to filter ") + filter_name(filter));
    }
    if (!points_filter) return {};
    if (options.bounds) return usage_error(std::string("--bounds does not apply to filter ") + filter_name(filter));
    if (!options.mesh_out.empty())
        return usage_error(std::string("--mesh: filter ") + filter_name(filter) + " has no mesh");
    const std::uint64_t sum = std::uint64_t{max_degree_of(options, 2)} + (is_barycentric(filter) ? k_of(options) : 0);
    if (sum > 30) return usage_error("--max-degree, with --k added for barycentric filters, is at most 30");
    return {};
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
    return check_writable({options.out, options.mesh_out, options.svg, options.representatives});
}

netmesh_status persist_points(Session& session, const Options& options, const PointCloud& cloud) {
    const bool cycles = !is_barycentric(filter_of(options)) && (options.check || !options.representatives.empty());
    return session.call(NETMESH_STAGE_REDUCE, [&] {
        return netmesh_persist_points(session.context(), cloud.coordinates.data(), cloud.rows(), filter_of(options),
                                      options.values.value_or(NETMESH_VALUES_CERTIFIED), k_of(options),
                                      max_degree_of(options, cloud.dim), options.all ? 1 : 0, cycles ? 1 : 0,
                                      &session.engine_options());
    });
}

// More points than there are in a set of a barycentric filter, after merging.
Outcome check_k(const Options& options, const PointCloud& cloud, const Session& session, const Outcome& outcome) {
    if (outcome.good() || session.context() == nullptr || !is_barycentric(filter_of(options))) return outcome;
    const netmesh_detail detail = netmesh_get_detail(session.context());
    if (detail.status != NETMESH_INVALID_ARGUMENT || detail.index_a != 6) return outcome;
    return data_error(cloud.name + ": --k " + std::to_string(k_of(options)) +
                      " is more than there are distinct points");
}

netmesh_status work(Session& session, const Options& options, const PointCloud& cloud, netmesh_analysis* analysis) {
    netmesh_context* const context = session.context();
    const netmesh_options* const engine_options = &session.engine_options();
    const auto bound = [&](netmesh_status status) {
        if (status != NETMESH_OK || !options.bounds) return status;
        return session.call(NETMESH_STAGE_CERTIFY, [&] { return netmesh_bound_bars(context, engine_options); });
    };
    if (goes_by_scales(options)) {
        return bound(session.call(NETMESH_STAGE_REDUCE, [&] {
            return netmesh_persist_scales(
                context, cloud.coordinates.data(), cloud.rows(), options.values.value_or(NETMESH_VALUES_CERTIFIED),
                options.max_degree.value_or(cloud.dim - 1), options.all ? 1 : 0, engine_options);
        }));
    }
    const bool triangulate = triangulates_only(options);
    netmesh_status status = session.call(triangulate ? NETMESH_STAGE_DELAUNAY : NETMESH_STAGE_REFINE, [&] {
        const double* const points = cloud.coordinates.data();
        if (options.fit) {
            return netmesh_fit(context, points, cloud.rows(), max_degree_of(options, cloud.dim), options.all ? 1 : 0,
                               options.bounds ? 1 : 0, engine_options);
        }
        return triangulate ? netmesh_delaunay(context, points, cloud.rows(), engine_options)
                           : netmesh_mesh(context, points, cloud.rows(), job_of(options), engine_options);
    });
    if (status == NETMESH_OK && options.command == Command::persist && !options.fit) {
        status = bound(session.call(NETMESH_STAGE_REDUCE, [&] {
            return netmesh_persist(context, filter_of(options), options.values.value_or(NETMESH_VALUES_CERTIFIED),
                                   max_degree_of(options, cloud.dim), options.all ? 1 : 0, engine_options);
        }));
    }
    if (status == NETMESH_OK && options.fit) {  // what was reached is what is checked
        const netmesh_report reached = session.report();
        session.set_goal(reached.ratio, reached.focus_ratio, reached.focus_from, reached.focus_to);
    }
    if (status == NETMESH_OK && options.analyse) {
        analysis->struct_bytes = sizeof *analysis;
        const std::uint32_t what = triangulate ? NETMESH_ANALYSE_ALL & ~NETMESH_ANALYSE_SIZE : NETMESH_ANALYSE_ALL;
        status = session.call(NETMESH_STAGE_ANALYSE,
                              [&] { return netmesh_analyse(context, what, 0, engine_options, analysis); });
    }
    if (status == NETMESH_OK && !options.representatives.empty()) {
        status = session.call(NETMESH_STAGE_REDUCE, [&] { return netmesh_represent(context, engine_options); });
    }
    if (status == NETMESH_OK && options.check) {
        status = session.call(NETMESH_STAGE_CHECK,
                              [&] { return netmesh_check(context, NETMESH_CHECK_ALL, engine_options); });
    }
    return status;
}

std::string checked_text(const Options& options) {
    if (goes_by_scales(options)) return "bars sorted, with one essential class";
    if (!uses_points_alone(options))
        return "combinatorics, orientation, Delaunay property, quality, bounds on size and degrees";
    return is_barycentric(filter_of(options)) ? "the diagram's form" : "every bar has a cycle that is born with it";
}

// What the result is made of, by the options: files, pictures, data on stdout.
std::vector<FileJob> result_jobs(const Options& options, const netmesh_context* context, const ContextMesh& mesh,
                                 const std::vector<Bar>& bars, const Bounds& bounds,
                                 const netmesh_report& report) {
    std::vector<FileJob> jobs;
    const bool data_on_stdout = options.out.empty() && !options.json;
    if (options.command == Command::persist) {
        if (!options.representatives.empty()) {
            jobs.push_back({options.representatives, [&](TextWriter& out) { write_cycles(context, out); }});
        }
        if (!options.mesh_out.empty()) add_mesh_files(mesh, options.mesh_out, &jobs);
        if (!options.svg.empty()) {
            jobs.push_back({options.svg, [&](TextWriter& out) { out << diagram_picture(bars, report, bounds); }});
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
    case NETMESH_FILTER_ALPHA: return NETMESH_JOB_PERSIST_ALPHA;
    case NETMESH_FILTER_TIGHT: return NETMESH_JOB_PERSIST_TIGHT;
    case NETMESH_FILTER_SCALES: return NETMESH_JOB_PERSIST_SCALES;
    default: return NETMESH_JOB_PERSIST;
    }
}

Outcome run_engine_command(const Options& options) {
    const double start = platform::seconds_now();
    Outcome outcome = check_accuracy(options);
    if (outcome.good()) outcome = check_ratio(options);
    if (outcome.good()) outcome = check_filter(options);
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
    if (uses_points_alone(options)) {
        const std::size_t plan = netmesh_points_bytes(filter_of(options), &session.engine_options(), cloud.rows(),
                                                      k_of(options), max_degree_of(options, cloud.dim));
        outcome = session.run_planned(plan, cloud, [&](Session& s) { return persist_points(s, options, cloud); });
    } else {
        outcome = session.run(job_of(options), cloud, [&](Session& s) { return work(s, options, cloud, &analysis); });
    }
    outcome = check_k(options, cloud, session, outcome);
    if (!outcome.good()) return outcome;
    run.engine = session.report();
    run.clock = session.clock();
    if (options.analyse) run.analysis = analysis;

    const double computed = platform::seconds_now();
    std::vector<Bar> bars;
    Bounds bounds;
    if (options.command == Command::persist) {
        bars = bars_of(session.context());
        bounds = bounds_of(session.context());
    }
    if (options.check && options.command == Command::persist) {
        std::string complaint = diagram_complaint(bars);
        const bool cycles =
            uses_points_alone(options) ? !is_barycentric(filter_of(options)) : !options.representatives.empty();
        if (complaint.empty() && cycles) {
            complaint = cycles_complaint(session.context());
        }
        if (!complaint.empty()) return {Exit::check, "netmesh: check failed: diagram: " + complaint};
    }
    ContextMesh mesh(session.context());
    const std::string& mesh_path = options.command == Command::persist ? options.mesh_out : options.out;
    if (run.engine->is_mesh != 0 && ending_of(mesh_path) == ".vtu") mesh.measure(session.context());
    outcome = write_files(result_jobs(options, session.context(), mesh, bars, bounds, *run.engine));
    if (!outcome.good()) return outcome;
    run.write_seconds = platform::seconds_now() - computed;
    run.total_seconds = platform::seconds_now() - start;
    if (options.bounds) {
        run.certain.resize(run.engine->max_degree + 1);
        for (std::size_t i = 0; i < bounds.bars.size(); i++) run.certain[bars[i].degree] += bounds.bars[i].certain;
        run.bounds = &bounds;
    }
    if (options.json && options.out.empty() && options.command == Command::persist) run.bars = &bars;
    if (options.check) run.checked = std::vector<std::string>{checked_text(options)};
    if (!options.quiet && !options.json) std::fputs(text_report(run).c_str(), stderr);
    if (!options.json) return {};
    return write_files({{"", [&](TextWriter& out) { out << json_report(run); }}});
}

}  // namespace netmesh::tool
