#include <algorithm>

#include "platform/files.hpp"
#include "tools/asked_function.hpp"
#include "tools/commands/check_parts.hpp"
#include "tools/commands/cycles.hpp"
#include "tools/commands/diagram_checks.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/rips_input.hpp"
#include "tools/commands/steps.hpp"
#include "tools/io/cycle_file.hpp"
#include "tools/io/lines.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/provenance.hpp"
#include "tools/option_use.hpp"
#include "tools/vertex_function.hpp"

namespace netmesh::tool {

namespace {

// Where a ratio decides, tau is what that ratio follows from, or the one that is taken where none is given.
Outcome check_tau(const Provenance& head, const DiagramFile& file) {
    const HeadLine* const line = head.find("tau");
    if (line == nullptr || head.options.request.mesh.tau > 0) return {};
    std::uint64_t dim = 0;
    parse_unsigned(head.find("dim")->value, &dim);
    const double due = default_tau(static_cast<std::uint32_t>(dim));
    if (due == head.tau) return {};
    return file.wrong(line->number, quoted("# " + head_text(*line)) + " where " + quoted("# tau " + number_text(due)) +
                                        " is due, as # ratio does not follow from it");
}

// What the head says of bars that anyone can see.
Outcome check_with_head(const DiagramFile& file) {
    const Options& made = file.head->options;
    const std::uint32_t top = made.request.max_degree;
    for (std::size_t i = 0; i < file.bars.size(); i++) {
        const Bar& bar = file.bars[i];
        if (bar.degree > top)
            return file.wrong(file.line_of(i), "a bar of degree " + std::to_string(bar.degree) +
                                                   " where max-degree is " + std::to_string(top));
        if (made.request.keep_zero_pairs == 0 && bar.birth == bar.death)
            return file.wrong(file.line_of(i), "a bar of length zero, which are kept with `# all` alone");
    }
    const Outcome outcome = check_tau(*file.head, file);
    const bool has_bounds = made.request.bounds != nullptr;
    if (!outcome.good() || has_bounds == !file.bounds.empty()) return outcome;
    const std::uint64_t line = has_bounds ? file.head->find("bounds")->number : file.bounds[0].number;
    return file.wrong(line, has_bounds ? "there are no bounds of bars" : "bounds of bars, but no line `# bounds`");
}

Outcome read_diagram(const std::string& path, const Options& options, DiagramFile* file) {
    std::string content;
    file->name = shown_name(path);
    Outcome outcome = read_content(path, &content);
    if (outcome.good()) outcome = parse_head(content, file->name, &file->head);
    if (outcome.good()) outcome = parse_diagram(content, file->name, &file->bars, &file->lines);
    if (!outcome.good()) return outcome;
    file->bounds = bound_lines(content);
    std::size_t at = 0;
    const Options& made = file->head ? file->head->options : options;
    const bool any_sign = filter_of(made) == NETMESH_FILTER_FUNCTION || !made.table.weights.empty();
    const std::string complaint =
        diagram_complaint(file->bars, &at, any_sign, goes_by_distances(made) || may_end_beyond(filter_of(made)));
    if (!complaint.empty()) return file->wrong(file->line_of(at), complaint);
    return file->head ? check_with_head(*file) : Outcome{};
}

// A diagram's file against the same diagram made anew, which the session holds.
class Reproduction {
public:
    Reproduction(const DiagramFile& file, const PointCloud& cloud, const Options& made, const Session& session)
        : Reproduction(file, cloud, made, session, session.report()) {}
    // The same, where the engine's report is not all that there is to say.
    Reproduction(const DiagramFile& file, const PointCloud& cloud, const Options& made, const Session& session,
                 const netmesh_report& report)
        : file_(file), cloud_(cloud), made_(made), engine_(session.engine()), report_(report) {}

    // Bars, what is certified, and bounds; `facts` are the lines of the head that this run can tell.
    Outcome compare(const std::vector<const char*>& facts) const;
    std::string said() const;

private:
    Outcome compare_bars() const;
    Outcome compare_bounds() const;

    const DiagramFile& file_;
    const PointCloud& cloud_;
    const Options& made_;
    const Engine& engine_;
    const netmesh_report report_;
};

Outcome compare_line(const DiagramFile& file, const char* name, const Head& due) {
    const auto is_it = [&](const HeadLine& line) { return line.name == name; };
    const auto want = std::find_if(due.begin(), due.end(), is_it);
    const HeadLine* const have = file.head->find(name);
    const std::string due_text = want == due.end() ? "no such line" : quoted("# " + head_text(*want));
    if (have == nullptr && want != due.end()) return file.wrong(1, due_text + " is due and missing");
    if (have == nullptr || (want != due.end() && want->value == have->value)) return {};
    return file.wrong(have->number, quoted("# " + head_text(*have)) + " where " + due_text + " is due");
}

Outcome Reproduction::compare(const std::vector<const char*>& facts) const {
    Outcome outcome = compare_bars();
    if (file_.head) {
        const Head due = head_of(made_, report_);
        for (const char* name : facts) {
            if (outcome.good()) outcome = compare_line(file_, name, due);
        }
    }
    return outcome.good() ? compare_bounds() : outcome;
}

Outcome Reproduction::compare_bars() const {
    const std::vector<Bar> due = bars_of(engine_);
    const std::size_t at = first_difference(file_.bars, due);
    if (at == SIZE_MAX) return {};
    std::string why = bar_text(file_.bars, at) + " where " + bar_text(due, at) + " is due for " +
                      choice_text(choice_of(made_)) + " of " + cloud_.name;
    if (file_.head)
        why += ", made as lines " + std::to_string(file_.head->lines.front().number) + " to " +
               std::to_string(file_.head->lines.back().number) + " say; this bar or one of those lines is wrong";
    return file_.wrong(file_.line_of(at), why);
}

// Text against text: the same bounds are written in the same way.
Outcome Reproduction::compare_bounds() const {
    if (file_.bounds.empty()) return {};
    TextWriter text;
    write_diagram(bars_of(engine_), bounds_of(engine_), text);
    const std::vector<BoundLine> due = bound_lines(text.text());
    const std::vector<BoundLine>& have = file_.bounds;
    for (std::size_t i = 0; i < have.size() || i < due.size(); i++) {
        if (i < have.size() && i < due.size() && have[i].text == due[i].text) continue;
        const std::uint64_t line = i < have.size() ? have[i].number : file_.lines.back();
        return file_.wrong(line, "bounds differ: " + (i < due.size() ? quoted(due[i].text) + " is due"
                                                                     : std::string("nothing is due")));
    }
    return {};
}

std::string Reproduction::said() const {
    const netmesh_diagram_report& diagram = report_.diagram;
    std::string text = "reproduced: the engine makes the same bars";
    if (!file_.bounds.empty()) text += ", bounds and ratios by scale";
    text += " of " + cloud_.name + " for " + choice_text(choice_of(made_)) + "; certified ratio " +
            bound_text(diagram.certified_ratio, 6);
    if (diagram.certified_from > 0) text += " from radius " + bound_text(diagram.certified_from, 6);
    if (diagram.filter == NETMESH_FILTER_FUNCTION) text += ", error " + bound_text(diagram.certified_error, 6);
    if (report_.mesh.is_mesh != 0) text += "; aspect ratio at most " + bound_text(report_.mesh.aspect_ratio_max, 6);
    return text;
}

// Representatives in a file against those made anew.
Outcome compare_cycles(const std::string& path, const Engine& engine) {
    const std::string name = shown_name(path);
    std::string content;
    std::vector<CycleEntry> have, due;
    TextWriter text;
    write_cycles(engine, text);
    Outcome outcome = read_content(path, &content);
    if (outcome.good()) outcome = parse_cycles(content, name, &have);
    if (outcome.good()) outcome = parse_cycles(text.text(), name, &due);
    if (!outcome.good()) return outcome;
    for (std::size_t i = 0; i < have.size() || i < due.size(); i++) {
        if (i < have.size() && i < due.size() && have[i].bar == due[i].bar && have[i].simplices == due[i].simplices)
            continue;
        const std::uint64_t line = i < have.size() ? have[i].line : have.empty() ? 1 : have.back().line;
        return line_error(name, line,
                          std::string("check failed: ") +
                              (i < due.size() ? "not the cycle that the engine makes" : "there is no such bar"),
                          0, Exit::check);
    }
    return {};
}

// What comes of a run that could not be ended. Points that do not allow what the head says are not those that it is of.
Outcome explain_refusal(const DiagramFile& file, const Outcome& outcome) {
    const bool refused = outcome.exit == Exit::usage || outcome.exit == Exit::data || outcome.exit == Exit::degenerate;
    if (!file.head || !refused) return outcome;
    return file.wrong(file.head->lines.front().number, "it cannot be made as the head says: " + outcome.message);
}

void add_report(const Session& session, RunReport* run) {
    run->engine = session.report();
    run->engine->bounds = {};  // compared with the file's, not asked for
    run->clock = session.clock();
}

// Points or distances against what the head says of them.
Outcome compare_count(const DiagramFile& file, const char* name, std::uint64_t count, const std::string& of,
                      const std::pair<const char*, const char*>& what) {
    const HeadLine* const line = file.head ? file.head->find(name) : nullptr;
    if (line == nullptr || line->value == std::to_string(count)) return {};
    return file.wrong(line->number, of + " has " + counted(count, what.first, what.second));
}

// Rips complexes of distances, or with a threshold.
Outcome check_with_distances(const Options& open, const DiagramFile& file, const std::string& cycles, RunReport* run) {
    RipsInput input;
    Outcome outcome = read_rips_input(open, open.points_path, &input);
    if (!outcome.good()) return outcome;
    const Options made = settled(open, input.of_points() ? input.cloud.dim : dim_min);
    if (input.of_points())
        outcome = compare_count(file, "dim", input.cloud.dim, input.name(), {"dimension", "dimensions"});
    if (outcome.good()) outcome = compare_count(file, "points", input.rows, input.name(), {"point", "points"});
    if (!outcome.good()) return outcome;
    Session session(made, input.of_points() ? std::max(input.cloud.dim, dim_min) : dim_min);
    netmesh_report report;
    outcome = persist_rips(input, session, &report);
    if (!outcome.good()) return explain_refusal(file, outcome);
    PointCloud named;
    named.name = input.name();
    const Reproduction again(file, named, made, session, report);
    if (file.head) {
        const Head due = head_of(made, report);
        if (input.of_points()) outcome = compare_line(file, "duplicates", due);
        if (outcome.good()) outcome = compare_line(file, "input", due);
    }
    if (outcome.good()) outcome = again.compare({"certified-ratio", "reference"});
    if (!outcome.good()) return outcome;
    add_report(session, run);
    run->engine->input = report.input;
    run->checked->push_back(again.said());
    DiagramClaim claim = {file, made, cycles, false};
    outcome = verify_proof(input, &claim, run);
    if (!outcome.good()) return outcome;
    return second_opinion_on_complex(claim, complex_of(input, made, made.request.max_degree + 1), run);
}

Outcome check_with_points(const Options& open, const DiagramFile& file, const std::string& cycles, RunReport* run) {
    if (goes_by_distances(open)) return check_with_distances(open, file, cycles, run);
    PointCloud points;
    Outcome outcome = read_cloud(open, open.points_path, &points);
    if (!outcome.good()) return outcome;
    Options made = settled(open, points.dim);
    const bool by_scales = about(filter_of(made)).is_by_scales != 0;
    if (by_scales) made.representatives = cycles;  // so that they are made again
    outcome = compare_count(file, "dim", points.dim, points.name, {"dimension", "dimensions"});
    if (outcome.good()) outcome = compare_count(file, "points", points.rows(), points.name, {"point", "points"});
    if (!outcome.good()) return outcome;
    outcome = check_coordinates(made, points.dim);
    if (!outcome.good()) return explain_refusal(file, outcome);
    Session session(made, points.dim);
    outcome = session.run(plan_of(made, points.dim, points.rows()), points,
                          [&](Session& s) { return persist_as_asked(s, points); });
    if (outcome.good()) outcome = check_claims(made, session.engine());
    if (!outcome.good()) return explain_refusal(file, outcome);
    if (file.head) {  // other points have other bars, so this comes first
        const Head due = head_of(made, session.report());
        outcome = compare_line(file, "duplicates", due);
        if (outcome.good()) outcome = compare_line(file, "input", due);
    }
    const Reproduction again(file, points, made, session);
    if (outcome.good())
        outcome = again.compare(
            {"domain", "certified-ratio", "certified-from", "certified-error", "fitted-error", "reference"});
    if (!outcome.good()) return outcome;
    if (by_scales && !cycles.empty()) outcome = compare_cycles(cycles, session.engine());
    if (!outcome.good()) return outcome;
    add_report(session, run);
    run->checked->push_back(again.said());
    DiagramClaim claim = {file, made, cycles, false};
    outcome = verify_proof(points, &claim, run);
    return outcome.good() ? second_opinion_on_points(claim, points, run) : outcome;
}

// The only thing that a mesh tells of what it was made of. Without a domain all vertices are inputs.
Outcome compare_inputs_with(const DiagramFile& file, const NodeFile& node) {
    const auto inputs = node.domain.empty() ? static_cast<std::ptrdiff_t>(node.cloud.rows())
                                            : std::count(node.markers.begin(), node.markers.end(), std::uint8_t{0});
    std::uint64_t points = 0, duplicates = 0;
    parse_unsigned(file.head->find("points")->value, &points);
    parse_unsigned(file.head->find("duplicates")->value, &duplicates);
    if (points - duplicates == static_cast<std::uint64_t>(inputs)) return {};
    return file.wrong(file.head->find("points")->number, counted(points, "point", "points") + ", " +
                                                             std::to_string(duplicates) +
                                                             " of them duplicates, where " + node.cloud.name + " has " +
                                                             counted(inputs, "input", "inputs"));
}

// A mesh promises what it was made for, as the head says. What a fit reached is in the mesh's file alone.
Outcome compare_promise(const DiagramFile& file, const NodeFile& node) {
    const Options& made = file.head->options;
    const bool by_ratio = made.request.goal.ratio > 0;
    const char* const name = by_ratio ? "ratio" : "tau";
    const double due = by_ratio ? made.request.goal.ratio : made.request.mesh.tau,
                 have = by_ratio ? node.ratio : node.tau;
    if (made.request.fit != nullptr || node.domain.empty() || due == 0 || have == due) return {};
    return file.wrong(file.head->find(name)->number,
                      node.cloud.name + (have > 0 ? " promises " + std::string(name) + " " + number_text(have)
                                                  : " promises no " + std::string(name)));
}

// Are they the values and vertices that the head speaks of? Other ones have other bars, so this comes first.
Outcome compare_values(const DiagramFile& file, const VertexFunction& values, const std::string& path) {
    if (!file.head) return {};
    const HeadLine &of_values = *file.head->find("values-at"), &of_mesh = *file.head->find("mesh");
    if (of_mesh.value != values.mesh_fingerprint())
        return file.wrong(of_mesh.number,
                          "the vertices of this mesh have the fingerprint " + values.mesh_fingerprint());
    if (of_values.value != values.values_fingerprint())
        return file.wrong(of_values.number,
                          "the values of " + shown_name(path) + " have the fingerprint " + values.values_fingerprint());
    return {};
}

Outcome check_with_mesh(const Options& open, const DiagramFile& file, const std::string& cycles, RunReport* run) {
    MeshFiles files;
    Outcome outcome = read_mesh_files(open.mesh_path, &files);
    if (!outcome.good()) return outcome;
    const PointCloud& cloud = files.node.cloud;
    Options made = settled(open, cloud.dim);
    if (file.head) outcome = compare_inputs_with(file, files.node);
    if (outcome.good() && file.head && made.values_at.empty()) outcome = compare_promise(file, files.node);
    if (outcome.good()) outcome = read_values_at(files.node, &made);
    if (outcome.good() && made.vertex_function) outcome = compare_values(file, *made.vertex_function, made.values_at);
    if (outcome.good()) outcome = check_coordinates(made, cloud.dim);
    if (!outcome.good()) return outcome;
    Options promised = open;  // of the mesh; what a fit reached is in the mesh's own file
    if (made.request.fit != nullptr) {
        promised.request.fit = nullptr;
        promised.request.goal = {};
        const HeadLine* const error = file.head ? file.head->find("fitted-error") : nullptr;
        if (error != nullptr) parse_finite(error->value, &promised.request.goal.error);
        promised.memory_bytes = 0;  // what the mesh was fitted in need not hold its check too
    }
    promised.vertex_function = made.vertex_function;
    Session session(promised, cloud.dim);
    outcome = check_mesh(promised, files, run, session);
    if (!outcome.good()) return outcome;
    outcome = session.run(plan_of(made, cloud.dim, cloud.rows()), cloud, [&](Session& s) {
        const netmesh_status status = load_mesh(s, files);
        s.function().set_domain(s.report());
        return status == NETMESH_OK ? persist(s, on_what_is_there(made.request)) : status;
    });
    if (outcome.good()) outcome = check_claims(made, session.engine());
    if (!outcome.good()) return explain_refusal(file, outcome);
    const Reproduction again(file, cloud, made, session);
    outcome = again.compare({"dim", "domain", "certified-ratio", "certified-from", "certified-error", "reference"});
    if (!outcome.good()) return outcome;
    add_report(session, run);
    run->checked->push_back(again.said() +
                            (made.vertex_function
                                 ? ", of the values in " + shown_name(made.values_at)
                                 : "; how the mesh was made, and of which points, is for --points alone to tell"));
    outcome = check_vertex_values(made, files, run, session);
    return outcome.good() ? second_opinion_on_mesh({file, made, cycles, false}, files, run) : outcome;
}

// How the diagram was made: as the file says, else as the options say.
Options making_of(const Options& options, const DiagramFile& file) {
    Options made = file.head ? file.head->options : options;
    made.command = Command::persist;
    made.positionals = options.positionals;
    made.points_path = options.points_path;
    made.mesh_path = options.mesh_path;
    made.proof_path = options.proof_path;
    made.values_at = options.values_at;
    made.table = options.table;
    if (file.head) {
        made.table.weights = file.head->options.table.weights;
        made.table.are_radii = file.head->options.table.are_radii;
    }
    made.json = options.json;
    made.quiet = options.quiet;
    made.representatives.clear();
    if (made.request.fit == nullptr) made.memory_bytes = options.memory_bytes;
    if (made.request.filter == nullptr) made.request.filter = &netmesh_filter_complete;
    if (!file.head) made.request.bounds = file.bounds.empty() ? nullptr : &netmesh_bounds;
    return made;
}

// A diagram alone proves nothing; a proof that lies beside it does so with the points.
Outcome nothing_checked(const Options& options, const std::string& name, const std::string& what) {
    const std::string& path = options.positionals[0];
    const std::string proof = path.substr(0, path.size() - ending_of(path).size()) + ".proof";
    std::string why;
    const bool is_there = path != "-" && platform::InputFile().open(proof, &why);
    return file_error(name,
                      "nothing was checked: it says how it was made, and " + what + " what to check that with" +
                          (is_there ? "; " + proof + " is checked by --points POINTS --proof " + proof : ""),
                      Exit::check);
}

}  // namespace

Outcome check_diagram(const Options& options, RunReport* run) {
    DiagramFile file;
    Outcome outcome = read_diagram(options.positionals[0], options, &file);
    if (outcome.good() && file.head && file.head->options.table.lattice.kind != Lattice::none)
        return usage_error(file.name + ": is of points that repeat, of which there is no second opinion yet; persist "
                                       "with the options of its head makes it again");
    if (outcome.good() && file.head) outcome = check_contradiction(*file.head, file.name, options);
    if (!outcome.good()) return outcome;
    const auto essential =
        std::count_if(file.bars.begin(), file.bars.end(), [](const Bar& bar) { return !std::isfinite(bar.death); });
    run->checked->push_back(
        file.name + " has " + counted(file.bars.size(), "bar", "bars") + ", sorted, with " +
        (essential == 1 ? "one essential class"
                        : counted(static_cast<std::size_t>(essential), "essential class", "essential classes")));
    if (!file.head && !says_how(options)) {
        outcome = refuse_options(
            options, {"--representatives", "--memory", "--columns", "--delimiter", "--skip", "--drop-missing"},
            "nothing says how " + file.name + " was made, so nothing is made again");
        if (!outcome.good()) return outcome;
        // What can be made again by nobody cannot be checked, whatever points stand beside it.
        return file_error(file.name, "carries no certificate: it does not say how it was made, nor do options",
                          Exit::check);
    }
    const Options made = making_of(options, file);
    if (!file.head) outcome = check_use_in_diagram(made);
    if (!outcome.good()) return outcome;
    const bool is_of_values = file.head && !file.head->options.values_at.empty();
    if (is_of_values && made.values_at.empty()) {
        if (made.mesh_path.empty() && made.points_path.empty())
            return nothing_checked(options, file.name, "--mesh MESH.node and --values-at FILE are");
        return usage_error(file.name + " is of values at the vertices of a mesh: --values-at FILE says which");
    }
    if (!made.values_at.empty() && made.mesh_path.empty())
        return usage_error("--values-at goes with --mesh, at whose vertices the values are");
    netmesh_request asked;
    outcome = check_together(made);
    if (outcome.good()) outcome = check_function(made);
    if (outcome.good()) outcome = settle(made, dim_min, &asked);
    if (!outcome.good()) return outcome;
    const netmesh_filter_info& filter = about(filter_of(made));
    if (filter.is_on_mesh == 0 && filter.is_on_triangulation == 0 && !made.mesh_path.empty())
        return usage_error("--mesh: filter " + std::string(filter_name(filter_of(made))) + " has no mesh");
    if (!made.mesh_path.empty()) return check_with_mesh(made, file, options.representatives, run);
    if (!made.points_path.empty()) return check_with_points(made, file, options.representatives, run);
    return nothing_checked(options, file.name, "--points POINTS or --mesh MESH.node is");
}

}  // namespace netmesh::tool
