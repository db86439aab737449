#include <algorithm>

#include "tools/commands/check_parts.hpp"
#include "tools/commands/diagram_checks.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/steps.hpp"

namespace netmesh::tool {

namespace {

struct DiagramFile {
    std::string name;
    std::vector<Bar> bars;
    std::vector<std::uint64_t> lines;
    std::vector<BoundLine> bounds;
    bool has_zero_bars = false;
    std::uint32_t top_degree = 0;
};

Outcome read_diagram(const std::string& path, DiagramFile* file) {
    std::string content;
    file->name = shown_name(path);
    Outcome outcome = read_content(path, &content);
    if (outcome.good()) outcome = parse_diagram(content, file->name, &file->bars, &file->lines);
    if (!outcome.good()) return outcome;
    file->bounds = bound_lines(content);
    for (const Bar& bar : file->bars) {
        file->has_zero_bars = file->has_zero_bars || bar.birth == bar.death;
        file->top_degree = std::max(file->top_degree, bar.degree);
    }
    std::size_t at = 0;
    const std::string complaint = diagram_complaint(file->bars, &at);
    if (complaint.empty()) return {};
    const std::uint64_t line = at < file->lines.size() ? file->lines[at] : file->lines.empty() ? 1 : file->lines.back();
    return {Exit::check, file->name + ":" + std::to_string(line) + ": check failed: " + complaint};
}

// A diagram's file against diagrams computed anew, of one filter after the other until one equals it.
class Recomputation {
public:
    Recomputation(const Options& options, const DiagramFile& file, const PointCloud& cloud, Session& session)
        : options_(options), file_(file), cloud_(cloud), session_(session) {}

    // Tries each of the filters, all of which go by what `prepare` leaves in the session.
    Outcome attempt(const std::vector<FilterChoice>& list, const Session::Work& prepare);
    // What came out of all attempts.
    Outcome conclude(RunReport* run) const;

private:
    netmesh_status try_each(const std::vector<FilterChoice>& list);
    void compare(const std::vector<Bar>& recomputed, const FilterChoice& choice);
    std::string bounds_complaint() const;

    const Options& options_;
    const DiagramFile& file_;
    const PointCloud& cloud_;
    Session& session_;
    bool equal_ = false;
    FilterChoice found_;            // the last one tried
    std::size_t common_ = 0;        // bars before the first difference, at best
    std::string closest_;           // what the sentence about the closest filter says
    std::string bounds_complaint_;  // empty where the bounds in the file are those computed anew
};

Outcome Recomputation::attempt(const std::vector<FilterChoice>& list, const Session::Work& prepare) {
    if (list.empty() || equal_) return {};
    const std::size_t plan = plan_diagram(options_, list[0].filter, cloud_.dim, cloud_.rows());
    return session_.run(plan, cloud_, [&](Session& s) {
        netmesh_status status = prepare(s);
        if (status == NETMESH_OK) status = try_each(list);
        if (status != NETMESH_OK || !equal_ || file_.bounds.empty()) return status;
        status = bound_bars(s);
        if (status == NETMESH_OK) bounds_complaint_ = bounds_complaint();
        return status;
    });
}

netmesh_status Recomputation::try_each(const std::vector<FilterChoice>& list) {
    for (const FilterChoice& choice : list) {
        const DiagramRequest diagram{choice, options_.all || file_.has_zero_bars, false};
        const netmesh_status status = make_diagram(session_, options_, diagram, cloud_);
        if (status != NETMESH_OK) return status;
        found_ = choice;
        compare(bars_of(session_.engine()), choice);
        if (equal_) break;
    }
    return NETMESH_OK;
}

void Recomputation::compare(const std::vector<Bar>& recomputed, const FilterChoice& choice) {
    const std::size_t at = first_difference(file_.bars, recomputed);
    equal_ = at == SIZE_MAX;
    if (equal_ || (at < common_ && !closest_.empty())) return;
    common_ = at;
    closest_ = choice_text(choice) + ": ";
    std::vector<Bar> low;
    for (const Bar& bar : recomputed) {
        if (bar.degree <= file_.top_degree) low.push_back(bar);
    }
    if (first_difference(file_.bars, low) == SIZE_MAX) {
        const std::string top = std::to_string(file_.top_degree);
        closest_ += "equal up to degree " + top + ", nothing above (--max-degree " + top + " leaves the rest out)";
        return;
    }
    closest_ += at < file_.lines.size() ? "line " + std::to_string(file_.lines[at]) : "the end";
    closest_ += " has " + bar_text(file_.bars, at) + " where " + bar_text(recomputed, at) + " is due";
}

// What the file says about bounds against those of the diagram that the session holds. Empty where they agree.
std::string Recomputation::bounds_complaint() const {
    TextWriter text;
    write_diagram(bars_of(session_.engine()), bounds_of(session_.engine()), text);
    const std::vector<BoundLine> due = bound_lines(text.text());
    const std::vector<BoundLine>& have = file_.bounds;
    for (std::size_t i = 0; i < have.size() || i < due.size(); i++) {
        if (i < have.size() && i < due.size() && have[i].text == due[i].text) continue;
        const std::uint64_t line = i < have.size() ? have[i].number : file_.lines.back();
        return file_.name + ":" + std::to_string(line) +
               ": bounds differ: " + (i < due.size() ? "\"" + due[i].text + "\" is due" : "nothing is due");
    }
    return "";
}

Outcome Recomputation::conclude(RunReport* run) const {
    if (!bounds_complaint_.empty()) return mismatch(bounds_complaint_);
    if (!equal_) return mismatch(file_.name + " is not the diagram of " + cloud_.name + "; closest is " + closest_);
    run->engine = session_.engine().report();
    run->engine->bounds = {};  // compared with the file's, not asked for
    run->clock = session_.clock();
    const netmesh_diagram_report& diagram = run->engine->diagram;
    const netmesh_mesh_report& mesh = run->engine->mesh;
    std::string text = file_.name + " is the diagram of " + cloud_.name + " for " + choice_text(found_) +
                       "; certified ratio " + rounded_text(diagram.certified_ratio, 6);
    if (diagram.certified_from > 0) text += " from radius " + rounded_text(diagram.certified_from, 6);
    if (mesh.is_mesh != 0) text += "; aspect ratio at most " + rounded_text(mesh.aspect_ratio_max, 6);
    run->checked->push_back(text);
    if (!file_.bounds.empty())
        run->checked->push_back("its bounds of bars and ratios by scale are those computed anew");
    return {};
}

// Filters on the points themselves grow too fast to be tried: candidates() has only the one that --filter names.
Outcome check_diagram_with_points(const Options& options, const DiagramFile& file, RunReport* run) {
    PointCloud points;
    Outcome outcome = read_points(options.points_path, &points);
    if (outcome.good()) outcome = check_max_degree(options);
    if (!outcome.good()) return outcome;
    Session session(options, points.dim);
    Recomputation recomputation(options, file, points, session);
    const std::vector<FilterChoice> on_mesh = candidates(options, NETMESH_SOURCE_MESH);
    const Session::Work make = [&](Session& s) { return make_mesh(s, points); };
    if (!on_mesh.empty() && about(on_mesh[0].filter).has_goal != 0 && on_mesh[0].values == NETMESH_VALUES_CERTIFIED) {
        requests::Mesh& mesh = session.mesh();
        mesh.certificate = goal_of(options, options.ratio.value_or(default_ratio(mesh)));
        outcome = recomputation.attempt({on_mesh[0]}, make);
        mesh.certificate = {};
    }
    if (outcome.good()) outcome = recomputation.attempt(on_mesh, make);
    for (const netmesh_source source : {NETMESH_SOURCE_SCALES, NETMESH_SOURCE_POINTS}) {
        if (outcome.good())
            outcome = recomputation.attempt(candidates(options, source), [](Session&) { return NETMESH_OK; });
    }
    if (!outcome.good()) return outcome;
    outcome = recomputation.attempt(candidates(options, NETMESH_SOURCE_DELAUNAY),
                                    [&](Session& s) { return make_triangulation(s, options, points); });
    // Flat points have no triangulation: then only the mesh filters could have made the diagram.
    if (!outcome.good() && outcome.exit != Exit::degenerate) return outcome;
    return recomputation.conclude(run);
}

Outcome check_diagram_with_mesh(const Options& options, const DiagramFile& file, RunReport* run) {
    MeshFiles files;
    Outcome outcome = read_mesh_files(options.mesh_path, &files);
    if (!outcome.good()) return outcome;
    Session session(options, files.node.cloud.dim);
    outcome = check_mesh(options, files, run, session);
    if (!outcome.good()) return outcome;
    const bool is_mesh = !files.node.domain.empty();
    Recomputation recomputation(options, file, files.node.cloud, session);
    outcome = recomputation.attempt(candidates(options, is_mesh ? NETMESH_SOURCE_MESH : NETMESH_SOURCE_DELAUNAY),
                                    [&](Session& s) { return load_mesh(s, files); });
    return outcome.good() ? recomputation.conclude(run) : outcome;
}

}  // namespace

Outcome check_diagram(const Options& options, RunReport* run) {
    DiagramFile file;
    Outcome outcome = read_diagram(options.positionals[0], &file);
    if (!outcome.good()) return outcome;
    run->checked->push_back(file.name + " has " + grouped_text(file.bars.size()) +
                            " bars, sorted, with one essential class");
    if (is_on_points(filter_of(options)) && !options.mesh_path.empty())
        return usage_error(std::string("--mesh: filter ") + filter_name(filter_of(options)) + " has no mesh");
    if (!options.mesh_path.empty()) return check_diagram_with_mesh(options, file, run);
    if (!options.points_path.empty()) return check_diagram_with_points(options, file, run);
    return {};
}

}  // namespace netmesh::tool
