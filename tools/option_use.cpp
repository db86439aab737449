#include "tools/option_use.hpp"

#include <algorithm>

#include "tools/io/points.hpp"
#include "tools/option_table.hpp"
#include "tools/sample/shapes.hpp"

namespace netmesh::tool {

namespace {

using Why = std::string;  // why an option does nothing; empty: it does something
using Names = std::initializer_list<const char*>;

bool is_one_of(const std::string& name, Names names) {
    return std::any_of(names.begin(), names.end(), [&](const char* other) { return name == other; });
}

constexpr Names table_options = {"--columns", "--delimiter", "--skip"};

std::string filter_text(const Options& options) {
    return std::string("filter ") + filter_name(filter_of(options)) + " ";
}

// Of a diagram that is made of points.
Why why_not_of_diagram(const Options& options, const std::string& name) {
    const netmesh_filter_info& filter = about(filter_of(options));
    const bool on_points = filter.source == NETMESH_SOURCE_POINTS;
    const bool has_cells = filter.source == NETMESH_SOURCE_MESH || filter.source == NETMESH_SOURCE_SCALES;
    if (name == "--tau" && !has_cells) return filter_text(options) + "has no mesh whose cells it bounds";
    if (name == "--tau" && options.fit) return "--fit makes the mesh that fits, whatever tau is";
    if (name == "--tau" && options.ratio && refines_by_certificate(options))
        return "--ratio says what the mesh is made for; without it tau does";
    if (name == "--method" && filter.source != NETMESH_SOURCE_MESH)
        return filter_text(options) + "is not of one mesh of quality";
    if (name == "--values" && filter.has_values == 0) return filter_text(options) + "has one kind of values";
    if (name == "--k" && filter.needs_k == 0) return filter_text(options) + "looks at no number of neighbours";
    if (name == "--seed" && on_points) return filter_text(options) + "makes no random choice";
    return {};
}

Why why_not_of_persist(const Options& options, const std::string& name) {
    if (!options.values_at.empty() && is_one_of(name, table_options)) return "a mesh is no table";
    if (!options.distances) return why_not_of_diagram(options, name);
    if (is_one_of(name, {"-o", "--distances", "--sparse", "--threshold", "--filter", "--max-degree", "--all",
                         "--representatives", "--svg", "--axis", "--json", "--memory", "--check", "--min-persistence",
                         "--top"}))
        return {};
    return "it says nothing about --distances";
}

Why why_not_of_vineyard(const Options& options, const std::string& name) {
    if (!options.values_path.empty()) return is_one_of(name, table_options) ? "a complex is no table" : "";
    return why_not_of_diagram(options, name);
}

// A plan is for uniform points.
Why why_not_of_size(const Options& options, const std::string& name) {
    const netmesh_filter_info& filter = about(filter_of(options));
    const bool on_points = filter.source == NETMESH_SOURCE_POINTS;
    if (filter.has_eps != 0 && is_one_of(name, {"--tau", "--method", "--finish", "--audit"}))
        return "the plan for " + filter_text(options) + "goes by --eps";
    if (filter.source != NETMESH_SOURCE_MESH &&
        is_one_of(name, {"--tau", "--method", "--finish", "--audit", "--cages", "--eps"}) && filter.has_eps == 0)
        return filter_text(options) + "has no mesh to plan for";
    if (name == "--audit" && (options.audit & NETMESH_AUDIT_LOCATION) == 0) return "it takes no memory";
    if (name == "--k" && !is_barycentric(filter.filter)) return "the plan for " + filter_text(options) + "is for any k";
    if (name == "--max-degree" && !on_points) return "the plan for " + filter_text(options) + "is for all degrees";
    return {};
}

// Which of its many options `check` has a use for goes by the file.
Why why_not_of_check(const Options& options, const std::string& name) {
    const std::string ending = ending_of(options.positionals[0]);
    const bool points = !options.points_path.empty(), mesh = !options.mesh_path.empty();
    if (is_one_of(name, {"--points", "--mesh", "--complex", "--json"})) return {};
    if (is_one_of(name, table_options)) return points ? "" : "--points is what would be read so";
    if (ending == ".node") {
        if (is_one_of(name, {"--tau", "--eps", "--cell-size", "--net", "--ratio", "--focus", "--from", "--to",
                             "--whole-cells", "--filter", "--k", "--values", "--function", "--values-at", "--lipschitz",
                             "--cut", "--error", "--memory"}))
            return {};
        return "it says nothing about a mesh (.node)";
    }
    if (ending == ".vines") {
        if (is_one_of(name, {"--memory", "--max-degree"}))
            return points || mesh || !options.complex_path.empty() ? "" : "nothing is made again from the file alone";
        if (name == "--values" && !options.values_path.empty()) return {};
        if (name == "--tau" && (points || mesh)) return {};
        if (name == "--seed" && points && !mesh) return {};
        if (mesh && is_one_of(name, {"--eps", "--cell-size", "--net"})) return {};
        return "a vineyard (.vines) says itself how it was made";
    }
    if (!mesh && is_one_of(name, {"--cell-size", "--net"})) return "it says nothing about a diagram without --mesh";
    if (!mesh && !points && is_one_of(name, {"--memory", "--representatives"}))
        return "nothing is made again without --points or --mesh";
    return {};
}

Why why_not_of_sample(const Options& options, const std::string& name) {
    const std::string& shape = options.positionals[0];
    if (name == "--turns" && shape != "clifford") return "it is of the shape clifford";
    if (name == "--seed" && options.noise == 0 && !is_random_shape(shape))
        return shape + " makes no random choice without --noise";
    return {};
}

Why why_not(const Options& options, const std::string& name) {
    if (name == "--axis" && options.svg.empty()) return "it is of the picture (--svg)";
    switch (options.command) {
    case Command::persist: return why_not_of_persist(options, name);
    case Command::vineyard: return why_not_of_vineyard(options, name);
    case Command::size: return why_not_of_size(options, name);
    case Command::check: return why_not_of_check(options, name);
    case Command::sample: return why_not_of_sample(options, name);
    default: return {};
    }
}

template <class Ask> Outcome first_refused(const Options& options, Ask ask) {
    for (const auto& given : options.given) {
        if (given.first == "--quiet") continue;
        const Why why = ask(given.first);
        if (!why.empty()) return usage_error(given.first + " does nothing here: " + why);
    }
    return {};
}

}  // namespace

Outcome check_use(const Options& options) {
    return first_refused(options, [&](const std::string& name) { return why_not(options, name); });
}

Outcome check_use_in_diagram(const Options& made) {
    return first_refused(made, [&](const std::string& name) { return why_not_of_diagram(made, name); });
}

Outcome refuse_options(const Options& options, std::initializer_list<const char*> names, const std::string& why) {
    return first_refused(options, [&](const std::string& name) { return is_one_of(name, names) ? why : Why(); });
}

}  // namespace netmesh::tool
