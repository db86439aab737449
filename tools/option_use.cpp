#include "tools/option_use.hpp"

#include <algorithm>
#include <cstring>

#include "tools/io/points.hpp"
#include "tools/option_table.hpp"
#include "tools/requests.hpp"
#include "tools/sample/shapes.hpp"

namespace netmesh::tool {

namespace {

using Why = std::string;  // why an option does nothing; empty: it does something
using Names = std::initializer_list<const char*>;

bool is_one_of(const std::string& name, Names names) {
    return std::any_of(names.begin(), names.end(), [&](const char* other) { return name == other; });
}

constexpr Names table_options = {"--columns", "--delimiter", "--skip", "--drop-missing"};
// Of size, those that the engine reads.
constexpr Names size_options = {"--tau", "--eps", "--method", "--finish", "--cages", "--audit", "--k", "--max-degree"};

// What the engine cannot see of a diagram that is made of points: an option that says what is so anyway.
Why why_not_of_diagram(const Options& options, const std::string& name) {
    const netmesh_filter_info& filter = about(filter_of(options));
    const std::string text = std::string("filter ") + filter.name + " ";
    if (name == "--values" && filter.has_values == 0) return text + "has one kind of values";
    if (name == "--whole-cells" && filter.clips_cells == 0) return text + "filters whole cells anyway";
    return {};
}

Why why_not_of_persist(const Options& options, const std::string& name) {
    if (!options.values_at.empty() && is_one_of(name, table_options)) return "a mesh is no table";
    if (options.distances && is_one_of(name, table_options)) return "it says nothing about --distances";
    return why_not_of_diagram(options, name);
}

Why why_not_of_vineyard(const Options& options, const std::string& name) {
    if (!options.values_path.empty()) return is_one_of(name, table_options) ? "a complex is no table" : "";
    return why_not_of_diagram(options, name);
}

// The plan is the same without it, and it is not what is taken anyway.
Why why_not_of_size(const Options& options, const std::string& name) {
    std::vector<std::string> others = {"size"};
    for (const auto& given : options.given) {
        if (given.first == name) continue;
        others.push_back(given.first);
        if (!given.second.empty()) others.push_back(given.second);
    }
    Options without;
    if (options.dim == 0 || options.point_count == 0) return {};
    if (!is_one_of(name, size_options) || !parse_options(others, &without).good()) return {};
    const netmesh_request with = settled(options, options.dim).request, open = settled(without, options.dim).request;
    if (std::memcmp(&with, &open, sizeof with) == 0 || plan_for_size(options) != plan_for_size(without)) return {};
    return "the plan is the same without it";
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
