// homology: the persistence diagram of a filtered complex that a file lists.
#include <cstdio>

#include "platform/clock.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/cycles.hpp"
#include "tools/commands/output.hpp"
#include "tools/io/complex_file.hpp"
#include "tools/plot/plots.hpp"
#include "tools/report/report.hpp"
#include "tools/session.hpp"

namespace netmesh::tool {

namespace {

Outcome check_outputs(const Options& options) {
    if (!options.out.empty() && ending_of(options.out) != ".pers") {
        return usage_error(options.out + ": a diagram is written to .pers");
    }
    return check_writable({options.out, options.svg, options.representatives});
}

// Names the simplex that has no place in a complex, and what it lacks.
Outcome explain_fault(const SimplexFile& file, const netmesh_detail& detail) {
    const std::uint64_t at = detail.index_a;
    const std::string where = file.lines.where(at) + ": simplex " + simplex_text(file, at) + ": ";
    const std::string what = detail.message;
    if (what.find("missing") != std::string::npos) {
        return data_error(where + "its face " + simplex_text(file, at, detail.index_b) + " is missing");
    }
    if (what.find("later") != std::string::npos) {
        return data_error(where + "enters at " + number_text(file.values[at]) + ", before its face " +
                          simplex_text(file, detail.index_b) + " of " + file.lines.place(detail.index_b) + " at " +
                          number_text(file.values[detail.index_b]));
    }
    if (what.find("listed twice") != std::string::npos) {
        return data_error(where + "is listed in " + file.lines.place(detail.index_b) + " already");
    }
    return data_error(where + what);
}

}  // namespace

Outcome run_homology(const Options& options) {
    const double start = platform::seconds_now();
    Outcome outcome = check_outputs(options);
    SimplexFile file;
    std::string content;
    file.lines.name = shown_name(options.positionals[0]);
    if (outcome.good()) outcome = read_content(options.positionals[0], &content);
    if (outcome.good()) outcome = parse_simplices(content, &file);
    if (!outcome.good()) return outcome;
    RunReport run;
    run.options = &options;
    run.read_seconds = platform::seconds_now() - start;

    Session session(options, NETMESH_DIM_MIN);
    const bool cycles = options.check || !options.representatives.empty();
    netmesh_status status = NETMESH_OK;
    outcome =
        session.run_planned(netmesh_homology_bytes(file.count(), file.vertices.size()), file.lines, [&](Session& s) {
            status = s.call(NETMESH_STAGE_REDUCE, [&] {
                return netmesh_homology(s.context(), file.vertices.data(), file.starts.data(), file.values.data(),
                                        file.count(), options.max_degree.value_or(NETMESH_DEGREE_MAX),
                                        options.all ? 1 : 0, cycles ? 1 : 0, &s.engine_options());
            });
            return status;
        });
    if (status == NETMESH_NOT_A_COMPLEX) return explain_fault(file, netmesh_get_detail(session.context()));
    if (!outcome.good()) return outcome;
    run.engine = session.report();
    run.clock = session.clock();

    const double computed = platform::seconds_now();
    const std::vector<Bar> bars = bars_of(session.context());
    if (options.check) {
        const std::string complaint = cycles_complaint(session.context());
        if (!complaint.empty()) return {Exit::check, "netmesh: check failed: " + complaint};
        run.checked = std::vector<std::string>{"every bar has a cycle that is born with it"};
    }
    std::vector<FileJob> jobs;
    if (!options.svg.empty()) {
        for (const Bar& bar : bars) {
            if (bar.birth < 0)
                return data_error("--svg " + options.svg + ": the logarithmic scale has no negative values");
        }
        jobs.push_back({options.svg, [&](TextWriter& out) { out << diagram_picture(bars, *run.engine); }});
    }
    if (!options.representatives.empty()) {
        jobs.push_back({options.representatives, [&](TextWriter& out) { write_cycles(session.context(), out); }});
    }
    if (!options.out.empty() || !options.json) {
        jobs.push_back({options.out, [&](TextWriter& out) { write_diagram(bars, {}, out); }});
    }
    outcome = write_files(jobs);
    if (!outcome.good()) return outcome;
    run.write_seconds = platform::seconds_now() - computed;
    run.total_seconds = platform::seconds_now() - start;
    if (options.json && options.out.empty()) run.bars = &bars;
    if (!options.quiet && !options.json) std::fputs(text_report(run).c_str(), stderr);
    if (!options.json) return {};
    return write_files({{"", [&](TextWriter& out) { out << json_report(run); }}});
}

}  // namespace netmesh::tool
