// persist of distances, and of points of more than six coordinates: Rips complexes, which need nothing else.
#include <cmath>

#include "platform/clock.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/cycles.hpp"
#include "tools/commands/output.hpp"
#include "tools/io/distance_file.hpp"
#include "tools/plot/plots.hpp"
#include "tools/session.hpp"

namespace netmesh::tool {

namespace {

// What these diagrams have no use for.
Outcome check_given(const Options& options) {
    static constexpr const char* used[] = {
        "-o",    "--distances", "--sparse", "--threshold", "--filter", "--max-degree", "--all", "--representatives",
        "--svg", "--axis",      "--json",   "--quiet",     "--memory", "--check"};
    for (const auto& given : options.given) {
        bool known = false;
        for (const char* const name : used) known = known || given.first == name;
        if (!known) return usage_error("option " + given.first + " does not apply to --distances");
    }
    if (options.filter && *options.filter != NETMESH_FILTER_RIPS)
        return usage_error("--distances are for --filter rips: others need points");
    if (options.positionals.size() > 1) return usage_error("--distances takes one FILE");
    return check_max_degree(options);
}

requests::Distances distances_request(const Options& options, const DistanceFile& file) {
    requests::Distances request;
    request.layout = file.layout;
    request.numbers = file.numbers.data();
    request.entries = file.entries.data();
    request.entry_count = file.entries.size();
    request.point_count = file.points;
    request.threshold = options.threshold.value_or(HUGE_VAL);
    request.max_degree = options.max_degree.value_or(1);
    request.keep_zero_pairs = options.all ? 1 : 0;
    request.representatives = options.check || !options.representatives.empty() ? 1 : 0;
    return request;
}

}  // namespace

Outcome run_distances(const Options& given) {
    const double start = platform::seconds_now();
    Options options = given;
    options.filter = NETMESH_FILTER_RIPS;
    DistanceFile file;
    Outcome outcome = check_given(given);
    if (outcome.good()) outcome = check_ending(options.out, ".pers", "a diagram");
    if (outcome.good()) outcome = check_writable({options.out, options.svg, options.representatives});
    if (outcome.good()) outcome = read_distances(options.positionals[0], options.sparse, &file);
    if (!outcome.good()) return outcome;
    RunReport run;
    run.options = &options;
    run.read_seconds = platform::seconds_now() - start;

    Session session(options, NETMESH_DIM_MIN);
    const requests::Distances request = distances_request(options, file);
    outcome = session.run(plan(request), file.place, [&](Session& s) {
        return s.call(NETMESH_STAGE_REDUCE, [&] { return s.engine().persist_distances(s.watched(request)); });
    });
    const Engine& engine = session.engine();
    const netmesh_field field = engine.detail().field;
    if (engine.status() == NETMESH_INVALID_ARGUMENT &&
        (field == NETMESH_FIELD_NUMBERS || field == NETMESH_FIELD_ENTRIES))
        return data_error(file.where(engine.detail().index_a, engine.detail().index_b) + ": " +
                          engine.detail().message);
    if (!outcome.good()) return outcome;
    run.engine = engine.report();
    run.clock = session.clock();

    const std::vector<Bar> bars = bars_of(engine);
    if (options.check) {
        const std::string complaint = cycles_complaint(engine, {}, 0);
        if (!complaint.empty()) return {Exit::check, "netmesh: check failed: " + complaint};
        run.checked =
            std::vector<std::string>{"every bar has a cycle that is born with it; nobody looked when it dies"};
    }
    if (options.json && options.out.empty()) run.bars = &bars;
    std::vector<FileJob> jobs;
    if (!options.svg.empty())
        jobs.push_back(
            {options.svg, [&](TextWriter& out) { out << diagram_picture(bars, *run.engine, {}, options.axis); }});
    if (!options.representatives.empty())
        jobs.push_back({options.representatives, [&](TextWriter& out) { write_cycles(engine, out); }});
    if (!options.out.empty() || !options.json)
        jobs.push_back({options.out, [&](TextWriter& out) { write_diagram(bars, {}, out); }});
    return finish_run(jobs, start, &run);
}

}  // namespace netmesh::tool
