#include <algorithm>

#include "tools/commands/check_parts.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/diagram_checks.hpp"
#include "tools/commands/output.hpp"

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

// The best that the candidates tried so far came to.
struct Comparison {
    bool equal = false;
    std::size_t common = 0;  // bars before the first difference
    std::string closest;     // what the sentence about the closest candidate says
};

void compare(const DiagramFile& file, const std::vector<Bar>& recomputed, const Candidate& candidate,
             Comparison* best) {
    const std::size_t at = first_difference(file.bars, recomputed);
    best->equal = at == SIZE_MAX;
    if (best->equal || (at < best->common && !best->closest.empty())) return;
    best->common = at;
    best->closest = candidate_text(candidate) + ": ";
    std::vector<Bar> low;
    for (const Bar& bar : recomputed) {
        if (bar.degree <= file.top_degree) low.push_back(bar);
    }
    if (first_difference(file.bars, low) == SIZE_MAX) {
        best->closest += "equal up to degree " + std::to_string(file.top_degree) + ", nothing above (--max-degree " +
                         std::to_string(file.top_degree) + " leaves the rest out)";
        return;
    }
    best->closest += at < file.lines.size() ? "line " + std::to_string(file.lines[at]) : "the end";
    best->closest += " has " + bar_text(file.bars, at) + " where " + bar_text(recomputed, at) + " is due";
}

// What the file says about bounds against those of the diagram that the session holds. Empty where they agree.
std::string bounds_complaint(const DiagramFile& file, const netmesh_context* context) {
    TextWriter text;
    write_diagram(bars_of(context), bounds_of(context), text);
    const std::vector<BoundLine> due = bound_lines(text.text());
    for (std::size_t i = 0; i < file.bounds.size() || i < due.size(); i++) {
        if (i < file.bounds.size() && i < due.size() && file.bounds[i].text == due[i].text) continue;
        const std::uint64_t line = i < file.bounds.size() ? file.bounds[i].number : file.lines.back();
        return file.name + ":" + std::to_string(line) +
               ": bounds differ: " + (i < due.size() ? "\"" + due[i].text + "\" is due" : "nothing is due");
    }
    return "";
}

using Prepare = std::function<netmesh_status(Session&)>;

// Runs `prepare` (mesh, triangulation or load) and each candidate on it until one equals the file.
Outcome recompute(const Options& options, const DiagramFile& file, const std::vector<Candidate>& list,
                  const PointCloud& cloud, netmesh_job job, const Prepare& prepare, Session& session, Comparison* best,
                  Candidate* found, std::string* complaint) {
    if (list.empty() || best->equal) return {};
    return session.run(job, cloud, [&](Session& s) {
        netmesh_status status = prepare(s);
        for (std::size_t i = 0; i < list.size() && status == NETMESH_OK; i++) {
            status = s.call(NETMESH_STAGE_REDUCE, [&] {
                if (list[i].filter == NETMESH_FILTER_SCALES) {
                    return netmesh_persist_scales(s.context(), cloud.coordinates.data(), cloud.rows(), list[i].values,
                                                  options.max_degree.value_or(cloud.dim - 1),
                                                  options.all || file.has_zero_bars ? 1 : 0, &s.engine_options());
                }
                return netmesh_persist(s.context(), list[i].filter, list[i].values,
                                       options.max_degree.value_or(cloud.dim - 1),
                                       options.all || file.has_zero_bars ? 1 : 0, &s.engine_options());
            });
            if (status != NETMESH_OK) break;
            compare(file, bars_of(s.context()), list[i], best);
            *found = list[i];
            if (best->equal) break;
        }
        if (status != NETMESH_OK || !best->equal || file.bounds.empty()) return status;
        status = s.call(NETMESH_STAGE_CERTIFY, [&] { return netmesh_bound_bars(s.context(), &s.engine_options()); });
        if (status == NETMESH_OK) *complaint = bounds_complaint(file, s.context());
        return status;
    });
}

Outcome conclude(const DiagramFile& file, const Comparison& best, const Candidate& found, const std::string& source,
                 const std::string& complaint, const Session& session, RunReport* run) {
    if (!complaint.empty()) return mismatch(complaint);
    if (!best.equal) {
        return mismatch(file.name + " is not the diagram of " + source + "; closest is " + best.closest);
    }
    run->engine = session.report();
    run->clock = session.clock();
    std::string text = file.name + " is the diagram of " + source + " for " + candidate_text(found) +
                       "; certified ratio " + rounded_text(run->engine->certified_ratio, 6);
    if (run->engine->certified_from > 0) text += " from radius " + rounded_text(run->engine->certified_from, 6);
    if (run->engine->is_mesh != 0) text += "; aspect ratio at most " + rounded_text(run->engine->aspect_ratio_max, 6);
    run->checked->push_back(text);
    if (!file.bounds.empty()) run->checked->push_back("its bounds of bars and ratios by scale are those computed anew");
    return {};
}

Outcome check_diagram_with_points(const Options& options, const DiagramFile& file, RunReport* run) {
    PointCloud points;
    Outcome outcome = read_points(options.points_path, &points);
    if (!outcome.good()) return outcome;
    Session session(options, points.dim);
    Comparison best;
    Candidate found = {};
    std::string complaint;
    const double* const x = points.coordinates.data();
    const netmesh_job job =
        options.filter && promises_accuracy(options) ? job_of(*options.filter) : NETMESH_JOB_PERSIST;
    const Prepare mesh = [&](Session& s) {
        if (job == NETMESH_JOB_PERSIST_SCALES) return NETMESH_OK;  // points are all that it needs
        return s.call(NETMESH_STAGE_REFINE,
                      [&] { return netmesh_mesh(s.context(), x, points.rows(), job, &s.engine_options()); });
    };
    const std::vector<Candidate> list = candidates(options, true, false);
    if (!list.empty() && list[0].filter == NETMESH_FILTER_COMPLETE && list[0].values == NETMESH_VALUES_CERTIFIED) {
        session.set_goal(options.ratio.value_or(session.default_ratio()), options.focus, options.from, options.to);
        outcome = recompute(options, file, {list[0]}, points, job, mesh, session, &best, &found, &complaint);
        session.set_goal(0, 0, 0, 0);
        if (!outcome.good()) return outcome;
    }
    outcome = recompute(options, file, list, points, job, mesh, session, &best, &found, &complaint);
    if (!outcome.good()) return outcome;
    outcome = recompute(
        options, file, candidates(options, false, true), points, NETMESH_JOB_PERSIST_ALPHA,
        [&](Session& s) {
            return s.call(NETMESH_STAGE_DELAUNAY,
                          [&] { return netmesh_delaunay(s.context(), x, points.rows(), &s.engine_options()); });
        },
        session, &best, &found, &complaint);
    // Flat points have no triangulation: then only the mesh filters could have made the diagram.
    if (!outcome.good() && outcome.exit != Exit::degenerate) return outcome;
    return conclude(file, best, found, points.name, complaint, session, run);
}

// Filters on the points themselves grow too fast to be tried: only the one that --filter names.
Outcome check_points_filter(const Options& options, const DiagramFile& file, RunReport* run) {
    PointCloud points;
    Outcome outcome = read_points(options.points_path, &points);
    if (!outcome.good()) return outcome;
    const netmesh_filter filter = *options.filter;
    const std::uint32_t k = options.k.value_or(1), degree = max_degree_of(options, points.dim);
    std::vector<Candidate> list = {{filter, options.values.value_or(NETMESH_VALUES_CERTIFIED)}};
    if (filter == NETMESH_FILTER_BARYCENTRIC_RIPS && !options.values) list.push_back({filter, NETMESH_VALUES_THESIS});
    Session session(options, points.dim);
    const std::size_t plan = netmesh_points_bytes(filter, &session.engine_options(), points.rows(), k, degree);
    if (plan == 0) return usage_error("--max-degree, with --k added for barycentric filters, is at most 30");
    Comparison best;
    Candidate found = {};
    std::string complaint;
    outcome = session.run_planned(plan, points, [&](Session& s) {
        netmesh_status status = NETMESH_OK;
        for (std::size_t i = 0; i < list.size() && status == NETMESH_OK && !best.equal; i++) {
            status = s.call(NETMESH_STAGE_REDUCE, [&] {
                return netmesh_persist_points(s.context(), points.coordinates.data(), points.rows(), filter,
                                              list[i].values, k, degree, options.all || file.has_zero_bars ? 1 : 0, 0,
                                              &s.engine_options());
            });
            if (status != NETMESH_OK) break;
            compare(file, bars_of(s.context()), list[i], &best);
            found = list[i];
        }
        return status;
    });
    return outcome.good() ? conclude(file, best, found, points.name, complaint, session, run) : outcome;
}

Outcome check_diagram_with_mesh(const Options& options, const DiagramFile& file, RunReport* run) {
    MeshFiles files;
    Outcome outcome = read_mesh_files(options.mesh_path, &files);
    if (!outcome.good()) return outcome;
    Session session(options, files.node.cloud.dim);
    outcome = check_mesh(options, files, run, session);
    if (!outcome.good()) return outcome;
    const bool is_mesh = !files.node.domain.empty();
    Comparison best;
    Candidate found = {};
    std::string complaint;
    outcome = recompute(
        options, file, candidates(options, is_mesh, !is_mesh), files.node.cloud,
        is_mesh ? NETMESH_JOB_PERSIST : NETMESH_JOB_PERSIST_ALPHA, [&](Session& s) { return load_mesh(s, files); },
        session, &best, &found, &complaint);
    return outcome.good() ? conclude(file, best, found, files.node.cloud.name, complaint, session, run) : outcome;
}

}  // namespace

Outcome check_diagram(const Options& options, RunReport* run) {
    DiagramFile file;
    Outcome outcome = read_diagram(options.positionals[0], &file);
    if (!outcome.good()) return outcome;
    run->checked->push_back(file.name + " has " + grouped_text(file.bars.size()) +
                            " bars, sorted, with one essential class");
    const bool points_filter = options.filter && is_points_filter(*options.filter);
    if (points_filter && !options.mesh_path.empty()) {
        return usage_error(std::string("--mesh: filter ") + filter_name(*options.filter) + " has no mesh");
    }
    if (points_filter && !options.points_path.empty()) return check_points_filter(options, file, run);
    if (!options.mesh_path.empty()) return check_diagram_with_mesh(options, file, run);
    if (!options.points_path.empty()) return check_diagram_with_points(options, file, run);
    return {};
}

}  // namespace netmesh::tool
