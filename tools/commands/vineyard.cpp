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

VineyardRequest asked_for(const Options& options, std::uint32_t dim) {
    return {choice_of(options), *options.k, options.k_last.value_or(*options.k), max_degree_of(options, dim)};
}

// The checkers of the mesh where there is one, then each diagram computed afresh.
netmesh_status check(Session& session, const Options& options, const PointCloud& cloud, const Vines& vines,
                     std::string* fault) {
    netmesh_status status = is_on_points(filter_of(options)) ? NETMESH_OK : check_everything(session);
    Options alone = options;
    for (std::size_t i = 0; i < vines.ratios.size() && status == NETMESH_OK; i++) {
        const std::uint32_t k = vines.k_first + static_cast<std::uint32_t>(i);
        alone.k = k;
        status = make_diagram(session, alone, {choice_of(options)}, cloud);
        if (status != NETMESH_OK) break;
        if (first_difference(diagram_at(vines, k), bars_of(session.engine())) == SIZE_MAX) continue;
        *fault = "the diagram at k = " + std::to_string(k) + " is not that of a fresh computation";
        break;
    }
    return status;
}

Outcome read_input(const Options& options, PointCloud* cloud) {
    const netmesh_filter_info& filter = about(filter_of(options));
    if (!has_vineyard(filter)) {
        return usage_error(std::string("--filter ") + filter.name + ": a vineyard is of " +
                           list_filters(has_vineyard, "or"));
    }
    if (!options.k) return usage_error("vineyard needs --k FIRST..LAST");
    Outcome outcome = check_max_degree(options);
    if (outcome.good()) outcome = check_ending(options.out, ".vines", "a vineyard");
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
    run.engine = session.engine().report();
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
    const VineyardRequest asked = asked_for(options, cloud.dim);
    outcome = session.run(plan_vineyard(options, asked, cloud.dim, cloud.rows()), cloud, [&](Session& s) {
        netmesh_status status = prepare_for(s, options, asked.choice.filter, cloud);
        if (status == NETMESH_OK) status = make_vineyard(s, asked, cloud, &vines);
        if (status != NETMESH_OK) return status;
        run.engine = s.engine().report();
        return options.check ? check(s, options, cloud, vines, &fault) : status;
    });
    if (!outcome.good()) return outcome;
    if (!fault.empty()) return {Exit::check, "netmesh: check failed: " + fault};
    run.clock = session.clock();
    if (options.check) {
        run.checked.emplace();
        if (!is_on_points(asked.choice.filter))
            run.checked->push_back("combinatorics, orientation, Delaunay property, quality");
        run.checked->push_back("each diagram equals a fresh computation");
    }
    return finish(start, vines, &run);
}

}  // namespace netmesh::tool
