// persist of distances, and of points that are joined up to a threshold: Rips complexes, which need nothing else.
#include <algorithm>

#include "platform/clock.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/cycles.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/rips_input.hpp"
#include "tools/plot/plots.hpp"
#include "tools/proof/column_proof.hpp"

namespace netmesh::tool {

namespace {

Outcome check_given(const Options& options) {
    if (options.distances && options.positionals.size() > 1) return usage_error("--distances takes one FILE");
    if (options.request.bounds != nullptr) return usage_error("--bounds does not apply to filter rips");
    return {};
}

// With dim 0 before the input is read.
Outcome check_rips_outputs(const Options& options, std::uint32_t dim) {
    Outcome outcome = check_diagram_ending(options.out);
    if (outcome.good()) outcome = check_picture_ending(options);
    if (outcome.good()) outcome = check_cycles_ending(options.representatives, !options.distances, dim);
    if (outcome.good() && !options.proof.empty())
        outcome = check_ending(options.out, ".pers", "a diagram with a proof");
    return outcome.good() ? check_writable({options.out, options.svg, options.representatives, options.proof})
                          : outcome;
}

}  // namespace

Outcome run_distances(const Options& given) {
    const double start = platform::seconds_now();
    Options options = given;
    RipsInput input;
    Outcome outcome = check_given(given);
    if (outcome.good()) outcome = check_rips_outputs(options, 0);
    if (outcome.good()) outcome = read_rips_input(options, options.positionals[0], &input);
    if (outcome.good()) outcome = check_rips_outputs(options, input.cloud.dim);
    if (!outcome.good()) return outcome;
    RunReport run;
    run.options = &options;
    run.read_seconds = platform::seconds_now() - start;

    Session session(options, std::max(input.cloud.dim, dim_min));
    netmesh_report report;
    input.read_once = options.proof.empty();
    outcome = persist_rips(input, session, &report);
    if (!outcome.good()) return outcome;
    const Engine& engine = session.engine();
    run.engine = report;
    run.clock = session.clock();

    const BarSource all = bars_in(engine);
    if (options.check) {
        const SimplexList complex = complex_of(input, options, report.diagram.max_degree + 1);
        const std::string complaint = cycles_complaint(engine, complex, radius_tolerance);
        if (!complaint.empty()) return {Exit::check, "netmesh: check failed: " + complaint};
        run.checked = std::vector<std::string>{cycles_checked(complex)};
    }
    const std::vector<bool> chosen = chosen_bars(options, all);
    const BarSource bars = chosen_of(all, chosen);
    const Bounds bounds;
    const std::vector<Bar> list = needs_list(options) ? bars_of(bars) : std::vector<Bar>();
    if (options.json && options.out.empty()) run.bars = &list;
    CyclePlaces places = input.of_points() ? places_of(input.cloud) : CyclePlaces{};
    places.all_chosen = !chosen.empty();
    std::vector<FileJob> jobs;
    if (!options.svg.empty())
        jobs.push_back({picture_path(options.svg),
                        [&](TextWriter& out) { out << diagram_picture(list, *run.engine, {}, options.axis); }});
    if (!options.representatives.empty())
        jobs.push_back({options.representatives,
                        [&](TextWriter& out) { write_cycles(engine, options.representatives, chosen, places, out); }});
    std::string proof;
    if (!options.proof.empty()) {
        const double threshold = options.request.threshold;
        const std::uint32_t top = report.diagram.max_degree;
        proof = input.of_points() ? rips_proof(input.cloud, threshold, top, all)
                                  : rips_proof(input.file, threshold, top, all);
        if (proof.empty()) return no_numbers_for_proof();
        jobs.push_back({options.proof, [&](TextWriter& out) { out << proof; }});
    }
    const Head head = head_of(options, report);
    if (writes_data(options)) jobs.push_back(diagram_job(options, head, chosen, bars, bounds));
    return finish_run(jobs, start, &run);
}

}  // namespace netmesh::tool
