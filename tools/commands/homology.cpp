// homology: the persistence diagram of a filtered complex that a file lists.
#include <algorithm>

#include "platform/clock.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/cycles.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/steps.hpp"
#include "tools/commands/value_vineyard.hpp"
#include "tools/io/complex_file.hpp"
#include "tools/plot/plots.hpp"
#include "tools/proof/column_proof.hpp"
#include "tools/session.hpp"

namespace netmesh::tool {

namespace {

Outcome read_input(const Options& options, SimplexFile* file) {
    Outcome outcome = check_diagram_ending(options.out);
    if (outcome.good()) outcome = check_picture_ending(options);
    if (outcome.good()) outcome = check_cycles_ending(options.representatives, false, 0);
    if (outcome.good() && !options.proof.empty())
        outcome = check_ending(options.out, ".pers", "a diagram with a proof");
    if (outcome.good()) outcome = check_writable({options.out, options.svg, options.representatives, options.proof});
    std::string content;
    file->lines.name = shown_name(options.positionals[0]);
    if (outcome.good()) outcome = read_content(options.positionals[0], &content);
    return outcome.good() ? parse_simplices(content, file) : outcome;
}

netmesh_simplices complex_of(const SimplexFile& file) {
    netmesh_simplices simplices = sized<netmesh_simplices>();
    simplices.vertices = file.vertices.data();
    simplices.starts = file.starts.data();
    simplices.entries = file.values.data();
    simplices.simplex_count = file.count();
    simplices.vertex_count = file.vertices.size();
    return simplices;
}

// None when they are too many for a second opinion.
SimplexList simplices_of(const SimplexFile& file) {
    if (file.count() > opinion_simplices_max) return {};
    std::vector<FilteredSimplex> list;
    for (std::size_t i = 0; i < file.count(); i++) {
        Vertices vertices(file.vertices.begin() + static_cast<std::ptrdiff_t>(file.starts[i]),
                          file.vertices.begin() + static_cast<std::ptrdiff_t>(file.starts[i + 1]));
        std::sort(vertices.begin(), vertices.end());
        list.push_back({std::move(vertices), file.values[i]});
    }
    return list;
}

}  // namespace

Outcome run_homology(const Options& options) {
    const double start = platform::seconds_now();
    SimplexFile file;
    Outcome outcome = read_input(options, &file);
    if (!outcome.good()) return outcome;
    RunReport run;
    run.options = &options;
    run.read_seconds = platform::seconds_now() - start;

    Session session(options, NETMESH_DIM_MIN);
    const netmesh_simplices simplices = complex_of(file);
    netmesh_request request = options.request;
    request.simplices = &simplices;
    request.filter = &netmesh_filter_simplices;
    if (options.check || !options.representatives.empty()) request.cycles = &netmesh_cycles;
    outcome = session.run(plan(request), file.lines, [&](Session& s) { return persist(s, request); });
    const Engine& engine = session.engine();
    if (engine.status() == NETMESH_NOT_A_COMPLEX) return explain_fault(file, file.values.data(), engine.detail());
    if (!outcome.good()) return outcome;
    run.engine = engine.report();
    run.clock = session.clock();

    const BarSource all = bars_in(engine);
    if (options.check) {
        const SimplexList complex = simplices_of(file);
        const std::string complaint = cycles_complaint(engine, complex, 0);
        if (!complaint.empty()) return {Exit::check, "netmesh: check failed: " + complaint};
        run.checked = std::vector<std::string>{cycles_checked(complex)};
    }
    const std::vector<bool> chosen = chosen_bars(options, all);
    const BarSource bars = chosen_of(all, chosen);
    const Bounds bounds;
    const std::vector<Bar> list = needs_list(options) ? bars_of(bars) : std::vector<Bar>();
    if (options.json && options.out.empty()) run.bars = &list;
    std::vector<FileJob> jobs;
    if (!options.svg.empty())
        jobs.push_back({picture_path(options.svg),
                        [&](TextWriter& out) { out << diagram_picture(list, *run.engine, {}, options.axis); }});
    if (!options.representatives.empty())
        jobs.push_back({options.representatives,
                        [&](TextWriter& out) { write_cycles(engine, options.representatives, chosen, {}, out); }});
    if (!options.proof.empty())
        jobs.push_back(
            {options.proof, [&](TextWriter& out) { out << complex_proof(file, run.engine->diagram.max_degree, all); }});
    const Head head;  // there is none
    if (writes_data(options)) jobs.push_back(diagram_job(options, head, chosen, bars, bounds));
    return finish_run(jobs, start, &run);
}

}  // namespace netmesh::tool
