// check of a vineyard: by itself, or recomputed from points or mesh.
#include <algorithm>

#include "tools/commands/check_parts.hpp"
#include "tools/commands/diagram_checks.hpp"
#include "tools/commands/output.hpp"
#include "tools/commands/steps.hpp"
#include "tools/commands/value_vineyard.hpp"
#include "tools/io/numbers.hpp"
#include "tools/io/vine_file.hpp"

namespace netmesh::tool {

namespace {

std::string vine_text(const std::vector<netmesh_vine_point>& points, std::size_t index) {
    if (index >= points.size()) return "nothing";
    TextWriter text;
    write_vine_point(points[index], text);
    return text.text();
}

// What vines through bars that maps match satisfy at every step: the image's bar lies in both, each begins no later and
// ends no later for the lower k.
Outcome check_matches(const VineFile& file, const std::string& name) {
    for (std::size_t i = 1; i < file.vines.points.size(); i++) {
        const netmesh_vine_point &here = file.vines.points[i - 1], &next = file.vines.points[i];
        if (here.vine != next.vine) continue;
        const bool good =
            next.k == here.k + 1 && here.birth <= next.birth && next.birth < here.death && here.death <= next.death;
        if (!good)
            return mismatch(name + ": line " + std::to_string(file.lines[i]) + ": no map from k = " +
                            std::to_string(next.k) + " to the k of the line before matches these bars");
    }
    return {};
}

// The diagram of each k by itself: one essential class, born first.
Outcome check_form(const VineFile& file, const std::string& name) {
    if (file.of_values) return {};  // a complex may be of any form, and values of any sign
    for (std::size_t i = 0; i < file.vines.ratios.size(); i++) {
        const std::uint32_t k = file.vines.k_first + static_cast<std::uint32_t>(i);
        const std::string complaint = diagram_complaint(diagram_at(file.vines, k));
        if (!complaint.empty())
            return mismatch(name + ": the diagram at k = " + std::to_string(k) + " has " + complaint);
    }
    return is_on_points(file.choice.filter) ? check_matches(file, name) : Outcome();
}

// Where the file departs from the vineyard of the same filter, values and k that the session holds.
std::string difference(const VineFile& file, const Vines& due) {
    for (std::size_t i = 0; i < due.ratios.size(); i++) {
        if (i < file.vines.ratios.size() && file.vines.ratios[i] == due.ratios[i]) continue;
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

// A vineyard's file and where it is said to come from.
struct VineSource {
    const VineFile& file;
    const std::string& name;
    const PointCloud& cloud;
};

// Degrees above those in the file may have been left out, or be empty. `mesh`: to be loaded; null: of the points.
Outcome recompute(const Options& options, const VineSource& source, const MeshFiles* mesh, Session& session,
                  RunReport* run) {
    const VineFile& file = source.file;
    Options of_file = options;
    of_file.command = Command::vineyard;
    of_file.request.filter = about(file.choice.filter).filter;
    of_file.request.values = file.choice.values;
    of_file.request.k = file.vines.k_first;
    of_file.request.k_last = file.vines.k_first + static_cast<std::uint32_t>(file.vines.ratios.size() - 1);
    const netmesh_request request = settled(of_file, source.cloud.dim).request;
    Vines due;
    const std::size_t plan = plan_of(of_file, source.cloud.dim, source.cloud.rows());
    const Outcome outcome = session.run(plan, source.cloud, [&](Session& s) {
        netmesh_status status = mesh != nullptr ? load_mesh(s, *mesh) : NETMESH_OK;
        if (status == NETMESH_OK)
            status = persist(s, mesh != nullptr ? on_what_is_there(request) : on_points(request, source.cloud));
        if (status == NETMESH_OK) due = vines_of(s.engine());
        return status;
    });
    if (!outcome.good()) return outcome;
    const std::string complaint = difference(file, due);
    if (!complaint.empty()) {
        const std::string hint = top_degree(file) < request.max_degree ? "; --max-degree leaves out what is above" : "";
        return mismatch(source.name + " is not the vineyard of " + source.cloud.name + ": " + complaint + hint);
    }
    run->engine = session.report();
    run->clock = session.clock();
    run->checked->push_back(source.name + " is the vineyard of " + source.cloud.name + " for " +
                            choice_text(file.choice) + "; certified ratio at most " +
                            bound_text(run->engine->vineyard.certified_ratio, 6));
    return {};
}

Outcome check_with_values(const Options& options, const VineFile& file, const std::string& name, RunReport* run) {
    ValueInput input;
    Outcome outcome = read_value_input(options, options.complex_path, &input);
    if (!outcome.good()) return outcome;
    Session session(options, NETMESH_DIM_MIN);
    Vines due;
    outcome = make_value_vineyard(options, input, session, &due);
    if (!outcome.good()) return outcome;
    std::string complaint = difference(file, due);
    if (complaint.empty() && file.vines.ratios.size() != due.ratios.size())
        complaint = "it has " + counted(file.vines.ratios.size(), "step", "steps") + " where " +
                    std::to_string(due.ratios.size()) + " are due";
    const std::string of = input.complex.lines.name + " with the values of " + input.values.lines.name;
    if (!complaint.empty()) return mismatch(name + " is not the vineyard of " + of + ": " + complaint);
    run->engine = session.report();
    run->clock = session.clock();
    run->checked->push_back(name + " is the vineyard of " + of);
    return {};
}

Outcome check_with_mesh(const Options& options, const VineFile& file, const std::string& name, RunReport* run) {
    MeshFiles files;
    Outcome outcome = read_mesh_files(options.mesh_path, &files);
    if (!outcome.good()) return outcome;
    if (files.node.domain.empty()) return usage_error("--mesh " + options.mesh_path + ": a vineyard needs a mesh");
    Session session(options, files.node.cloud.dim);
    outcome = check_mesh(options, files, run, session);
    if (outcome.good()) outcome = check_vertex_values(options, files, run, session);
    if (!outcome.good()) return outcome;
    return recompute(options, {file, name, files.node.cloud}, &files, session, run);
}

Outcome check_with_points(const Options& options, const VineFile& file, const std::string& name, RunReport* run) {
    PointCloud points;
    const Outcome outcome = read_cloud(options, options.points_path, &points);
    if (!outcome.good()) return outcome;
    Session session(options, points.dim);
    return recompute(options, {file, name, points}, nullptr, session, run);
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
    run->checked->push_back(
        name + " has " + counted(file.vines.points.size(), "point", "points") + " of " +
        counted(file.vines.points.empty() ? 0 : file.vines.points.back().vine + 1, "vine", "vines") +
        (file.of_values ? "" : ", each diagram with one essential class"));
    const bool with_values = !options.complex_path.empty() && !options.values_path.empty();
    const bool with_points = !options.mesh_path.empty() || !options.points_path.empty();
    if (file.of_values && with_points)
        return usage_error(std::string(options.mesh_path.empty() ? "--points" : "--mesh") + ": " + name +
                           " is of a complex: --complex and --values FILE say which");
    if (!file.of_values && with_values) return usage_error(name + " is of points or a mesh");
    if (!options.mesh_path.empty() && is_on_points(file.choice.filter))
        return usage_error(name + " is of points: --points FILE says which");
    if (with_values) return check_with_values(options, file, name, run);
    if (!options.mesh_path.empty()) return check_with_mesh(options, file, name, run);
    if (!options.points_path.empty()) return check_with_points(options, file, name, run);
    return {};
}

}  // namespace netmesh::tool
