// check: every certificate recomputed from the files alone.
#include "platform/clock.hpp"
#include "tools/commands/check_parts.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/output.hpp"

namespace netmesh::tool {

std::string candidate_text(const Candidate& candidate) {
    std::string text = std::string("filter ") + filter_name(candidate.filter);
    const bool one_kind = candidate.filter == NETMESH_FILTER_ALPHA || candidate.filter == NETMESH_FILTER_RIPS ||
                          candidate.filter == NETMESH_FILTER_CECH ||
                          candidate.filter == NETMESH_FILTER_BARYCENTRIC_CECH;
    if (!one_kind) {
        text += std::string(", ") + values_name(candidate.values) + " values";
    }
    return text;
}

// The filters that a diagram or a vertex value may come from, by the options.
std::vector<Candidate> candidates(const Options& options, bool on_mesh, bool on_delaunay) {
    std::vector<Candidate> list;
    for (const netmesh_filter filter :
         {NETMESH_FILTER_COMPLETE, NETMESH_FILTER_BASIC, NETMESH_FILTER_ALPHA, NETMESH_FILTER_KNN,
          NETMESH_FILTER_KDISTANCE, NETMESH_FILTER_TIGHT, NETMESH_FILTER_SCALES}) {
        const bool counts = filter == NETMESH_FILTER_KNN || filter == NETMESH_FILTER_KDISTANCE;
        if (options.filter ? *options.filter != filter : counts && !options.k) continue;  // no k is tried by itself
        // Where there is no mesh yet, its making depends on the filter: these have to be named.
        const bool from_points = options.mesh_path.empty() && ending_of(options.positionals[0]) == ".pers";
        if (filter == NETMESH_FILTER_TIGHT && from_points && !options.filter) continue;
        if (filter == NETMESH_FILTER_SCALES && !(from_points && options.filter)) continue;
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

Outcome run_check(const Options& options) {
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
    RunReport run;
    run.options = &options;
    run.checked.emplace();
    Outcome outcome = check_accuracy(options);
    if (outcome.good()) outcome = check_ratio(options);
    if (!outcome.good()) return outcome;
    if (ending == ".node") {
        MeshFiles files;
        outcome = read_mesh_files(options.positionals[0], &files);
        if (outcome.good()) {
            Session session(options, files.node.cloud.dim);
            outcome = check_mesh(options, files, &run, session);
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
