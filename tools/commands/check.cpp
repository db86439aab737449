// check: every certificate recomputed from the files alone.
#include "platform/clock.hpp"
#include "tools/asked_function.hpp"
#include "tools/commands/check_parts.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/output.hpp"
#include "tools/requests.hpp"

namespace netmesh::tool {

namespace {

// Of several k none is tried by itself.
bool is_tried(const Options& options, const netmesh_filter_info& filter) {
    if (options.request.filter != nullptr) return options.request.filter == filter.filter;
    return filter.needs_function == 0 && (filter.needs_k == 0 || options.request.k != 0);
}

}  // namespace

std::vector<FilterChoice> candidates(const Options& options) {
    std::vector<FilterChoice> list;
    for (const netmesh_filter_info& filter : filters()) {
        if (filter.is_on_mesh == 0 || !is_tried(options, filter)) continue;
        const bool both = filter.has_values != 0;
        const netmesh_values asked = options.request.values;
        if (!both || asked != NETMESH_VALUES_THESIS) list.push_back({filter.id, NETMESH_VALUES_CERTIFIED});
        if (both && asked != NETMESH_VALUES_CERTIFIED) list.push_back({filter.id, NETMESH_VALUES_THESIS});
    }
    return list;
}

Outcome mismatch(const std::string& what) { return {Exit::check, "netmesh: check failed: " + what}; }

namespace {

// The numbers that a mesh is said to keep, each by itself and among themselves.
Outcome check_rules(const Options& given) {
    Options options = given;
    netmesh_request& r = options.request;
    options.command = Command::mesh;
    const bool by_ratio = r.goal.ratio > 0 || r.goal.focus_ratio > 0 || r.mesh.whole_cells != 0;
    r.mesh.method = by_ratio                 ? &netmesh_method_certificate
                    : r.mesh.net_spacing > 0 ? &netmesh_method_refine
                                             : &netmesh_method_svr;
    if (about(r.filter).is_on_mesh == 0) r.filter = nullptr;
    netmesh_request settled;
    return settle(options, NETMESH_DIM_MIN, &settled);
}

}  // namespace

Outcome run_check(const Options& given) {
    Options options = given;
    const double start = platform::seconds_now();
    const std::string ending = ending_of(options.positionals[0]);
    if (ending != ".node" && ending != ".pers" && ending != ".vines") {
        return usage_error(options.positionals[0] +
                           ": check takes a mesh (.node), a diagram (.pers) or a vineyard (.vines)");
    }
    if (ending == ".node" && !options.mesh_path.empty())
        return usage_error("--mesh goes with a diagram (.pers) or a vineyard (.vines)");
    if (!options.mesh_path.empty() && ending_of(options.mesh_path) != ".node") {
        return usage_error("--mesh " + options.mesh_path + ": must be a .node file");
    }
    if (!options.proof_path.empty() && (ending != ".pers" || options.points_path.empty() || !options.mesh_path.empty()))
        return usage_error("--proof goes with a diagram (.pers) and --points, without --mesh");
    if (options.complex_path.empty() != options.values_path.empty())
        return usage_error("--complex COMPLEX and --values FILE belong together");
    if (!options.complex_path.empty() && ending != ".vines")
        return usage_error("--complex goes with a vineyard (.vines)");
    RunReport run;
    run.options = &options;
    run.checked.emplace();
    Outcome outcome;
    if (ending == ".pers" || is_of_eps(options)) take_eps_as_goal(&options);
    if (ending != ".pers") {
        outcome = check_function(options);
        if (outcome.good()) outcome = check_rules(options);
    }
    if (!outcome.good()) return outcome;
    if (ending == ".node") {
        MeshFiles files;
        outcome = read_mesh_files(options.positionals[0], &files);
        if (outcome.good()) outcome = read_values_at(files.node, &options);
        if (outcome.good()) {
            Session session(options, files.node.cloud.dim);
            outcome = check_coordinates(options, files.node.cloud.dim);
            if (outcome.good()) outcome = check_mesh(options, files, &run, session);
            if (outcome.good()) outcome = check_vertex_values(options, files, &run, session);
        }
    } else {
        outcome = ending == ".pers" ? check_diagram(options, &run) : check_vines(options, &run);
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
