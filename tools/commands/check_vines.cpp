// check of a vineyard: by itself, or recomputed from points or mesh.
#include <algorithm>

#include "tools/commands/check_parts.hpp"
#include "tools/commands/diagram_checks.hpp"
#include "tools/commands/output.hpp"
#include "tools/io/vine_file.hpp"

namespace netmesh::tool {

namespace {

std::string vine_text(const std::vector<netmesh_vine_point>& points, std::size_t index) {
    if (index >= points.size()) return "nothing";
    const netmesh_vine_point& p = points[index];
    TextWriter text;
    text << p.vine << ' ' << p.degree << ' ' << p.k << ' ' << p.birth << ' ' << p.death;
    return text.text();
}

// The diagram of each k by itself: one essential class, born first.
Outcome check_form(const VineFile& file, const std::string& name) {
    for (std::size_t i = 0; i < file.vines.ratios.size(); i++) {
        const std::uint32_t k = file.vines.k_first + static_cast<std::uint32_t>(i);
        const std::string complaint = diagram_complaint(diagram_at(file.vines, k));
        if (!complaint.empty())
            return mismatch(name + ": the diagram at k = " + std::to_string(k) + " has " + complaint);
    }
    return {};
}

// Where the file departs from the vineyard of the same filter, values and k that the session holds.
std::string difference(const VineFile& file, const Vines& due) {
    for (std::size_t i = 0; i < due.ratios.size(); i++) {
        if (file.vines.ratios[i] == due.ratios[i]) continue;
        TextWriter text;
        text << "the certified ratio at k = " << static_cast<std::uint64_t>(due.k_first + i) << " is " << due.ratios[i];
        return text.text();
    }
    for (std::size_t i = 0; i < due.points.size() || i < file.vines.points.size(); i++) {
        const std::string have = vine_text(file.vines.points, i), want = vine_text(due.points, i);
        if (have == want) continue;
        const std::string at = i < file.lines.size() ? "line " + std::to_string(file.lines[i]) : "the end";
        return at + " has " + have + " where " + want + " is due";
    }
    return "";
}

std::uint32_t top_degree(const VineFile& file) {
    std::uint32_t top = 0;
    for (const netmesh_vine_point& p : file.vines.points) top = std::max(top, p.degree);
    return top;
}

// Degrees above those in the file may have been left out, or be empty.
Outcome recompute(const Options& options, const VineFile& file, const std::string& name, const PointCloud& cloud,
                  const std::function<netmesh_status(Session&)>& prepare, Session& session, RunReport* run) {
    Vines due;
    const std::uint32_t degree = options.max_degree.value_or(cloud.dim - 1);
    const Outcome outcome = session.run(NETMESH_JOB_PERSIST, cloud, [&](Session& s) {
        netmesh_status status = prepare(s);
        if (status != NETMESH_OK) return status;
        const std::uint32_t last = file.vines.k_first + static_cast<std::uint32_t>(file.vines.ratios.size() - 1);
        status = s.call(NETMESH_STAGE_REDUCE, [&] {
            return netmesh_vineyard(s.context(), file.filter, file.vines.k_first, last, file.values, degree,
                                    &s.engine_options());
        });
        if (status == NETMESH_OK) due = vines_of(s.context());
        return status;
    });
    if (!outcome.good()) return outcome;
    const std::string complaint = difference(file, due);
    if (!complaint.empty()) {
        const std::string hint = top_degree(file) < degree ? "; --max-degree leaves out what is above" : "";
        return mismatch(name + " is not the vineyard of " + cloud.name + ": " + complaint + hint);
    }
    run->engine = session.report();
    run->clock = session.clock();
    run->checked->push_back(name + " is the vineyard of " + cloud.name + " for filter " + filter_name(file.filter) +
                            ", " + values_name(file.values) + " values; certified ratio at most " +
                            rounded_text(run->engine->certified_ratio, 6));
    return {};
}

}  // namespace

Outcome check_vines(const Options& options, RunReport* run) {
    VineFile file;
    std::string content;
    const std::string name = shown_name(options.positionals[0]);
    Outcome outcome = read_content(options.positionals[0], &content);
    if (outcome.good()) outcome = parse_vines(content, name, &file);
    if (outcome.good()) outcome = check_form(file, name);
    if (!outcome.good()) return outcome;
    run->checked->push_back(name + " has " + grouped_text(file.vines.points.size()) + " points of " +
                            grouped_text(file.vines.points.empty() ? 0 : file.vines.points.back().vine + 1) +
                            " vines, each diagram with one essential class");
    if (!options.mesh_path.empty()) {
        MeshFiles files;
        outcome = read_mesh_files(options.mesh_path, &files);
        if (!outcome.good()) return outcome;
        if (files.node.domain.empty()) return usage_error("--mesh " + options.mesh_path + ": a vineyard needs a mesh");
        Session session(options, files.node.cloud.dim);
        outcome = check_mesh(options, files, run, session);
        if (!outcome.good()) return outcome;
        return recompute(
            options, file, name, files.node.cloud, [&](Session& s) { return load_mesh(s, files); }, session, run);
    }
    if (options.points_path.empty()) return {};
    PointCloud points;
    outcome = read_points(options.points_path, &points);
    if (!outcome.good()) return outcome;
    Session session(options, points.dim);
    const auto prepare = [&](Session& s) {
        return s.call(NETMESH_STAGE_REFINE, [&] {
            return netmesh_mesh(s.context(), points.coordinates.data(), points.rows(), NETMESH_JOB_PERSIST,
                                &s.engine_options());
        });
    };
    return recompute(options, file, name, points, prepare, session, run);
}

}  // namespace netmesh::tool
