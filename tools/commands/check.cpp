// check: every certificate recomputed from the files alone.
#include "platform/clock.hpp"
#include "tools/commands/check_parts.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/output.hpp"

namespace netmesh::tool {

namespace {

// Of several k none is tried by itself.
bool is_tried(const Options& options, const netmesh_filter_info& filter) {
    if (options.filter) return *options.filter == filter.filter;
    return filter.needs_function == 0 && (filter.needs_k == 0 || options.k);
}

}  // namespace

std::vector<FilterChoice> candidates(const Options& options) {
    std::vector<FilterChoice> list;
    for (const netmesh_filter_info& filter : filters()) {
        if (filter.source != NETMESH_SOURCE_MESH || !is_tried(options, filter)) continue;
        const bool both = filter.has_values != 0;
        if (!both || options.values.value_or(NETMESH_VALUES_CERTIFIED) == NETMESH_VALUES_CERTIFIED)
            list.push_back({filter.filter, NETMESH_VALUES_CERTIFIED});
        if (both && options.values.value_or(NETMESH_VALUES_THESIS) == NETMESH_VALUES_THESIS)
            list.push_back({filter.filter, NETMESH_VALUES_THESIS});
    }
    return list;
}

Outcome mismatch(const std::string& what) { return {Exit::check, "netmesh: check failed: " + what}; }

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
    if (options.complex_path.empty() != options.values_path.empty())
        return usage_error("--complex COMPLEX and --values FILE belong together");
    if (!options.complex_path.empty() && ending != ".vines")
        return usage_error("--complex goes with a vineyard (.vines)");
    RunReport run;
    run.options = &options;
    run.checked.emplace();
    Outcome outcome;
    if (ending != ".pers") outcome = check_accuracy(options);
    if (ending != ".pers" && outcome.good()) outcome = check_ratio(options);
    if (ending != ".pers" && outcome.good()) outcome = check_function(options);
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
