// vineyard: points in, one mesh or one complex, the diagrams of all k and the vines between them out; or a complex and
// values.
#include "platform/clock.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/diagram_checks.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/steps.hpp"
#include "tools/commands/value_vineyard.hpp"
#include "tools/io/vine_file.hpp"
#include "tools/plot/plots.hpp"

namespace netmesh::tool {

namespace {

// The checkers of the mesh where there is one, then each diagram computed afresh.
netmesh_status check(Session& session, const PointCloud& cloud, const Vines& vines, std::string* fault) {
    const bool on_points_alone = about(session.request().filter).is_on_points != 0;
    netmesh_status status = on_points_alone ? NETMESH_OK : check_everything(session);
    netmesh_request alone = on_points_alone ? on_points(session.request(), cloud) : on_what_is_there(session.request());
    alone.vines = nullptr;
    alone.k_last = 0;
    for (std::size_t i = 0; i < vines.ratios.size() && status == NETMESH_OK; i++) {
        alone.k = vines.k_first + static_cast<std::uint32_t>(i);
        status = persist(session, alone);
        if (status != NETMESH_OK) break;
        if (first_difference(diagram_at(vines, alone.k), bars_of(session.engine())) == SIZE_MAX) continue;
        *fault = "the diagram at k = " + std::to_string(alone.k) + " is not that of a fresh computation";
        break;
    }
    return status;
}

Outcome read_input(const Options& options, PointCloud* cloud) {
    if (options.request.k == 0) return usage_error("vineyard needs --k FIRST..LAST");
    Outcome outcome = check_ending(options.out, ".vines", "a vineyard");
    if (outcome.good()) outcome = check_picture_ending(options);
    if (outcome.good()) outcome = check_writable({options.out, options.svg});
    return outcome.good() ? read_cloud(options, options.positionals[0], cloud) : outcome;
}

// The files of a vineyard that was made.
Outcome finish(double start, const Vines& vines, RunReport* run) {
    const Options& options = *run->options;
    run->vines = &vines;
    std::vector<FileJob> jobs;
    if (!options.svg.empty()) {
        jobs.push_back({picture_path(options.svg),
                        [&](TextWriter& out) { out << vineyard_picture(vines, *run->engine, options.axis); }});
    }
    if (writes_data(options)) {
        jobs.push_back({options.out, [&](TextWriter& out) { write_vines(vines, run->engine->vineyard, out); }});
    }
    return finish_run(jobs, start, run);
}

Outcome run_with_values(const Options& options) {
    const double start = platform::seconds_now();
    ValueInput input;
    Outcome outcome = check_ending(options.out, ".vines", "a vineyard");
    if (outcome.good()) outcome = check_picture_ending(options);
    if (outcome.good()) outcome = check_writable({options.out, options.svg});
    if (outcome.good()) outcome = read_value_input(options, options.positionals[0], &input);
    if (!outcome.good()) return outcome;
    RunReport run;
    run.options = &options;
    run.read_seconds = platform::seconds_now() - start;
    Session session(options, NETMESH_DIM_MIN);
    Vines vines;
    outcome = make_value_vineyard(options, input, session, &vines);
    if (!outcome.good()) return outcome;
    run.engine = session.report();
    if (options.check) {
        std::string fault;
        outcome = check_value_vineyard(options, input, vines, session, &fault);
        if (!outcome.good()) return outcome;
        if (!fault.empty()) return {Exit::check, "netmesh: check failed: " + fault};
        run.checked = std::vector<std::string>{"each diagram equals a fresh computation"};
    }
    run.clock = session.clock();
    return finish(start, vines, &run);
}

}  // namespace

Outcome run_vineyard(const Options& options) {
    if (!options.values_path.empty()) return run_with_values(options);
    const double start = platform::seconds_now();
    PointCloud cloud;
    Outcome outcome = read_input(options, &cloud);
    if (!outcome.good()) return outcome;
    RunReport run;
    run.options = &options;
    run.read_seconds = platform::seconds_now() - start;

    Session session(options, cloud.dim);
    Vines vines;
    std::string fault;
    outcome = session.run(plan_of(options, cloud.dim, cloud.rows()), cloud, [&](Session& s) {
        const netmesh_status status = persist(s, on_points(s.request(), cloud));
        if (status != NETMESH_OK) return status;
        vines = vines_of(s.engine());
        run.engine = s.report();
        return options.check ? check(s, cloud, vines, &fault) : status;
    });
    if (!outcome.good()) return outcome;
    if (!fault.empty()) return {Exit::check, "netmesh: check failed: " + fault};
    run.clock = session.clock();
    if (options.check) {
        run.checked.emplace();
        if (!is_on_points(filter_of(options)))
            run.checked->push_back("combinatorics, orientation, Delaunay property, quality");
        run.checked->push_back("each diagram equals a fresh computation");
    }
    return finish(start, vines, &run);
}

}  // namespace netmesh::tool
