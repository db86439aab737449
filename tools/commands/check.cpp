// check: every certificate recomputed from the files alone.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <unordered_map>

#include "platform/clock.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/diagram_checks.hpp"
#include "tools/commands/output.hpp"
#include "tools/io/lines.hpp"
#include "tools/report/report.hpp"
#include "tools/session.hpp"

namespace netmesh::tool {

namespace {

struct Candidate {
    netmesh_filter filter;
    netmesh_values values;
};

std::string candidate_text(const Candidate& candidate) {
    std::string text = std::string("filter ") + filter_name(candidate.filter);
    if (candidate.filter != NETMESH_FILTER_ALPHA) text += std::string(", ") + values_name(candidate.values) + " values";
    return text;
}

// The filters that a diagram or a vertex value may come from, by the options.
std::vector<Candidate> candidates(const Options& options, bool on_mesh, bool on_delaunay) {
    std::vector<Candidate> list;
    for (const netmesh_filter filter : {NETMESH_FILTER_COMPLETE, NETMESH_FILTER_BASIC, NETMESH_FILTER_ALPHA}) {
        if (options.filter && *options.filter != filter) continue;
        if (!(filter == NETMESH_FILTER_ALPHA ? on_delaunay : on_mesh)) continue;
        for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
            if (options.values && *options.values != values && filter != NETMESH_FILTER_ALPHA) continue;
            if (filter == NETMESH_FILTER_ALPHA && values == NETMESH_VALUES_THESIS) continue;
            list.push_back({filter, values});
        }
    }
    return list;
}

Outcome mismatch(const std::string& what) { return {Exit::check, "netmesh: check failed: " + what}; }

// ---- meshes ----

// The markers a mesh with a domain may have, inputs first; without a domain all vertices are inputs.
Outcome settle_markers(MeshFiles* files) {
    NodeFile& node = files->node;
    if (node.domain.empty()) {
        std::fill(node.markers.begin(), node.markers.end(), std::uint8_t{0});
        return {};
    }
    bool input_over = false;
    for (std::size_t i = 0; i < node.markers.size(); i++) {
        if (node.markers[i] > 2)
            return line_error(node.cloud.name, node.cloud.lines[i], "a marker that is not 0, 1 or 2");
        if (node.markers[i] == 0 && input_over) {
            return line_error(node.cloud.name, node.cloud.lines[i], "an input (marker 0) behind other vertices");
        }
        input_over = input_over || node.markers[i] != 0;
    }
    return {};
}

netmesh_status load(Session& session, const MeshFiles& files) {
    const NodeFile& node = files.node;
    return session.call(NETMESH_STAGE_DELAUNAY, [&] {
        return netmesh_load(session.context(), node.cloud.coordinates.data(), node.markers.data(), node.cloud.rows(),
                            files.cells.entries.data(), files.cells.lines.size(),
                            node.domain.empty() ? nullptr : node.domain.data(), &session.engine_options());
    });
}

// The .neigh file against the neighbours that loading found. Loading may reorder the vertices of a cell.
Outcome compare_neighbours(const MeshFiles& files, const ContextMesh& mesh) {
    const std::uint32_t columns = files.cells.columns;
    for (std::size_t c = 0; c < files.cells.lines.size(); c++) {
        const netmesh_cell cell = mesh.cell(c);
        for (std::uint32_t i = 0; i < columns; i++) {
            const std::uint32_t opposite = files.cells.entries[c * columns + i];
            std::uint32_t j = 0;
            while (j + 1 < columns && cell.vertices[j] != opposite) j++;
            if (files.neighbours.entries[c * columns + i] == cell.neighbours[j]) continue;
            return {Exit::check, files.neighbours.name + ":" + std::to_string(files.neighbours.lines[c]) +
                                     ": check failed: neighbour " + std::to_string(i) +
                                     " is not the cell behind that facet"};
        }
    }
    return {};
}

struct KeyHash {
    std::size_t operator()(const std::string& key) const { return std::hash<std::string>()(key); }
};

// The inputs of the mesh must be the points, in their order, without repetitions, bit for bit.
Outcome compare_inputs(const MeshFiles& files, const PointCloud& points) {
    const NodeFile& node = files.node;
    if (points.dim != node.cloud.dim) return mismatch("the points have another dimension than the mesh");
    const std::size_t row_bytes = points.dim * sizeof(double);
    std::unordered_map<std::string, std::size_t, KeyHash> seen;
    std::size_t due = 0;
    for (std::size_t row = 0; row < points.rows(); row++) {
        const double* const x = points.coordinates.data() + row * points.dim;
        const std::string key(reinterpret_cast<const char*>(x), row_bytes);
        if (!seen.emplace(key, row).second) continue;
        const bool there = due < node.cloud.rows() && node.markers[due] == 0;
        if (!there || std::memcmp(node.cloud.coordinates.data() + due * points.dim, x, row_bytes) != 0) {
            return mismatch("vertex " + std::to_string(due) + " of " + node.cloud.name + " is not the point of " +
                            points.where(row));
        }
        due++;
    }
    if (due < node.cloud.rows() && node.markers[due] == 0) {
        return mismatch(node.cloud.name + " has more inputs than " + points.name + " has different points");
    }
    return {};
}

// The vertex attribute against the values of each filter; *found says which.
Outcome compare_values(Session& session, const Options& options, const MeshFiles& files, std::string* found) {
    const NodeFile& node = files.node;
    for (const Candidate& candidate : candidates(options, true, false)) {
        const netmesh_status status = session.call(NETMESH_STAGE_CERTIFY, [&] {
            return netmesh_persist(session.context(), candidate.filter, candidate.values, 0, 0,
                                   &session.engine_options());
        });
        if (status == NETMESH_CANCELLED) return {Exit::cancelled, "netmesh: cancelled"};
        if (status != NETMESH_OK) continue;
        const ContextMesh mesh(session.context());
        std::size_t i = 0;
        while (i < node.cloud.rows() && mesh.vertex(i).value == node.attributes[i * node.attribute_count]) i++;
        if (i < node.cloud.rows()) continue;
        *found = candidate_text(candidate);
        return {};
    }
    return mismatch("the values in " + node.cloud.name + " are those of no filter");
}

Outcome check_mesh(const Options& options, MeshFiles& files, RunReport* run, Session& session) {
    Outcome outcome = settle_markers(&files);
    PointCloud points;
    if (outcome.good() && !options.points_path.empty()) {
        outcome = read_points(options.points_path, &points);
        if (outcome.good()) outcome = compare_inputs(files, points);
    }
    if (!outcome.good()) return outcome;
    if (!options.tau && files.node.tau > 0) session.set_tau(files.node.tau);
    outcome = session.run(NETMESH_JOB_PERSIST, files.node.cloud, [&](Session& s) {
        const netmesh_status status = load(s, files);
        if (status != NETMESH_OK) return status;
        return s.call(NETMESH_STAGE_CHECK,
                      [&] { return netmesh_check(s.context(), NETMESH_CHECK_ALL, &s.engine_options()); });
    });
    if (outcome.good()) outcome = compare_neighbours(files, ContextMesh(session.context()));
    if (!outcome.good()) return outcome;
    run->checked->push_back("facets shared by two, cells positively oriented, spheres empty, hull convex");
    run->checked->push_back(files.neighbours.name + " names the cells behind the facets");
    run->engine = session.report();
    if (!files.node.domain.empty()) {
        run->checked->push_back("aspect ratio at most " + rounded_text(run->engine->aspect_ratio_max, 6) + " (tau " +
                                rounded_text(session.engine_options().tau, 6) + ")");
    }
    if (!options.points_path.empty()) {
        run->checked->push_back("inputs equal " + points.name + " bit for bit, duplicates merged");
    }
    if (files.node.attribute_count == 1 && !files.node.domain.empty()) {
        std::string found;
        outcome = compare_values(session, options, files, &found);
        if (outcome.good()) run->checked->push_back("vertex values are those of " + found);
    }
    return outcome;
}

// ---- diagrams ----

struct DiagramFile {
    std::string name;
    std::vector<Bar> bars;
    std::vector<std::uint64_t> lines;
    bool has_zero_bars = false;
    std::uint32_t top_degree = 0;
};

Outcome read_diagram(const std::string& path, DiagramFile* file) {
    std::string content;
    file->name = shown_name(path);
    Outcome outcome = read_content(path, &content);
    if (outcome.good()) outcome = parse_diagram(content, file->name, &file->bars, &file->lines);
    if (!outcome.good()) return outcome;
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

using Prepare = std::function<netmesh_status(Session&)>;

// Runs `prepare` (mesh, triangulation or load) and each candidate on it until one equals the file.
Outcome recompute(const Options& options, const DiagramFile& file, const std::vector<Candidate>& list,
                  const PointCloud& cloud, netmesh_job job, const Prepare& prepare, Session& session, Comparison* best,
                  Candidate* found) {
    if (list.empty() || best->equal) return {};
    return session.run(job, cloud, [&](Session& s) {
        netmesh_status status = prepare(s);
        for (std::size_t i = 0; i < list.size() && status == NETMESH_OK; i++) {
            status = s.call(NETMESH_STAGE_REDUCE, [&] {
                return netmesh_persist(s.context(), list[i].filter, list[i].values,
                                       options.max_degree.value_or(cloud.dim - 1),
                                       options.all || file.has_zero_bars ? 1 : 0, &s.engine_options());
            });
            if (status != NETMESH_OK) break;
            compare(file, bars_of(s.context()), list[i], best);
            *found = list[i];
            if (best->equal) break;
        }
        return status;
    });
}

Outcome conclude(const DiagramFile& file, const Comparison& best, const Candidate& found, const std::string& source,
                 const Session& session, RunReport* run) {
    if (!best.equal) {
        return mismatch(file.name + " is not the diagram of " + source + "; closest is " + best.closest);
    }
    run->engine = session.report();
    std::string text = file.name + " is the diagram of " + source + " for " + candidate_text(found) +
                       "; certified ratio " + rounded_text(run->engine->certified_ratio, 6);
    if (run->engine->is_mesh != 0) text += "; aspect ratio at most " + rounded_text(run->engine->aspect_ratio_max, 6);
    run->checked->push_back(text);
    return {};
}

Outcome check_diagram_with_points(const Options& options, const DiagramFile& file, RunReport* run) {
    PointCloud points;
    Outcome outcome = read_points(options.points_path, &points);
    if (!outcome.good()) return outcome;
    Session session(options, points.dim);
    Comparison best;
    Candidate found = {};
    const double* const x = points.coordinates.data();
    outcome = recompute(
        options, file, candidates(options, true, false), points, NETMESH_JOB_PERSIST,
        [&](Session& s) {
            return s.call(NETMESH_STAGE_REFINE, [&] {
                return netmesh_mesh(s.context(), x, points.rows(), NETMESH_JOB_PERSIST, &s.engine_options());
            });
        },
        session, &best, &found);
    if (!outcome.good()) return outcome;
    outcome = recompute(
        options, file, candidates(options, false, true), points, NETMESH_JOB_PERSIST_ALPHA,
        [&](Session& s) {
            return s.call(NETMESH_STAGE_DELAUNAY,
                          [&] { return netmesh_delaunay(s.context(), x, points.rows(), &s.engine_options()); });
        },
        session, &best, &found);
    // Flat points have no triangulation: then only the mesh filters could have made the diagram.
    if (!outcome.good() && outcome.exit != Exit::degenerate) return outcome;
    outcome = conclude(file, best, found, points.name, session, run);
    run->clock = nullptr;
    return outcome;
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
    outcome = recompute(
        options, file, candidates(options, is_mesh, !is_mesh), files.node.cloud,
        is_mesh ? NETMESH_JOB_PERSIST : NETMESH_JOB_PERSIST_ALPHA, [&](Session& s) { return load(s, files); }, session,
        &best, &found);
    return outcome.good() ? conclude(file, best, found, files.node.cloud.name, session, run) : outcome;
}

Outcome check_diagram(const Options& options, RunReport* run) {
    DiagramFile file;
    Outcome outcome = read_diagram(options.positionals[0], &file);
    if (!outcome.good()) return outcome;
    run->checked->push_back(file.name + " has " + grouped_text(file.bars.size()) +
                            " bars, sorted, with one essential class");
    if (!options.mesh_path.empty()) return check_diagram_with_mesh(options, file, run);
    if (!options.points_path.empty()) return check_diagram_with_points(options, file, run);
    return {};
}

}  // namespace

Outcome run_check(const Options& options) {
    const double start = platform::seconds_now();
    const std::string ending = ending_of(options.positionals[0]);
    if (ending != ".node" && ending != ".pers") {
        return usage_error(options.positionals[0] + ": check takes a mesh (.node) or a diagram (.pers)");
    }
    if (ending == ".node" && !options.mesh_path.empty()) return usage_error("--mesh goes with a diagram (.pers)");
    if (!options.mesh_path.empty() && ending_of(options.mesh_path) != ".node") {
        return usage_error("--mesh " + options.mesh_path + ": must be a .node file");
    }
    RunReport run;
    run.options = &options;
    run.checked.emplace();
    Outcome outcome;
    if (ending == ".node") {
        MeshFiles files;
        outcome = read_mesh_files(options.positionals[0], &files);
        if (outcome.good()) {
            Session session(options, files.node.cloud.dim);
            outcome = check_mesh(options, files, &run, session);
        }
    } else {
        outcome = check_diagram(options, &run);
    }
    if (!outcome.good()) return outcome;
    run.total_seconds = platform::seconds_now() - start;
    if (options.quiet && !options.json) return {};
    std::string text;
    for (const std::string& item : *run.checked) text += item + "\n";
    if (options.json) text = json_report(run);
    return write_files({{"", [&](TextWriter& out) { out << text; }}});
}

}  // namespace netmesh::tool
