#include "tools/report/figures.hpp"

#include <algorithm>

namespace netmesh::tool {

namespace {

// What the library says and JSON does not: that its `options` say already, and what only text reports and tests read.
constexpr std::string_view left_out[] = {"complete",
                                         "input.distinct",
                                         "mesh.method",
                                         "mesh.inputs",
                                         "mesh.size_eps",
                                         "mesh.cells_created",
                                         "diagram.values",
                                         "diagram.k",
                                         "diagram.representatives",
                                         "diagram.max_degree",
                                         "diagram.certified_ratio_best",
                                         "diagram.steps",
                                         "vineyard.certified_ratio",
                                         "vineyard.filter",
                                         "vineyard.values",
                                         "memory.used_bytes",
                                         "vineyard.max_degree",
                                         "what"};

bool is_left_out(const netmesh_figure& figure) {
    return std::find(std::begin(left_out), std::end(left_out), figure.path) != std::end(left_out);
}

template <class Report> std::vector<netmesh_figure> kept_figures(const Report& report) {
    std::vector<netmesh_figure> figures;
    for_each_figure(report, [&](const netmesh_figure& figure) {
        if (!is_left_out(figure)) figures.push_back(figure);
    });
    return figures;
}

void write_value(Json& json, const netmesh_figure& figure, std::uint32_t i) {
    switch (figure.type) {
    case NETMESH_FIGURE_FLAG: return json.value(static_cast<const std::uint32_t*>(figure.values)[i] != 0);
    case NETMESH_FIGURE_UINT32: return json.value(static_cast<const std::uint32_t*>(figure.values)[i]);
    case NETMESH_FIGURE_UINT64: return json.value(static_cast<const std::uint64_t*>(figure.values)[i]);
    case NETMESH_FIGURE_DOUBLE: return json.value(static_cast<const double*>(figure.values)[i]);
    case NETMESH_FIGURE_FINGERPRINT: return json.fingerprint(static_cast<const std::uint64_t*>(figure.values)[i]);
    case NETMESH_FIGURE_NAME: return json.value(figure.text);
    }
}

void write_figure(Json& json, const netmesh_figure& figure) {
    if (figure.applies == 0) return json.null();
    if (figure.is_array == 0) return write_value(json, figure, 0);
    json.open('[');
    for (std::uint32_t i = 0; i < figure.count; i++) write_value(json, figure, i);
    json.close(']');
}

// Figures that stand one after the other.
struct Range {
    const netmesh_figure* first;
    const netmesh_figure* last;

    bool has_any(std::uint32_t netmesh_figure::*flag) const {
        return std::any_of(first, last, [&](const netmesh_figure& figure) { return figure.*flag != 0; });
    }
    bool is_left_out() const {
        const auto is_silent = [](const netmesh_figure& f) { return f.applies == 0 && f.on_request != 0; };
        return std::all_of(first, last, is_silent);
    }
};

// Behind the figures that are the member `name`, or parts of it.
const netmesh_figure* end_of_member(const Range& range, std::string_view name) {
    return std::find_if(range.first, range.last, [&](const netmesh_figure& figure) {
        const std::string_view path = figure.path;
        return path.substr(0, name.size()) != name || (path.size() > name.size() && path[name.size()] != '.');
    });
}

void write_object(Json& json, const Range& range, std::size_t depth, const Behind& behind);

// The figures as members of the object that is open, which their paths name up to `depth` characters.
void write_members(Json& json, Range range, std::size_t depth, const Behind& behind) {
    while (range.first != range.last) {
        const std::string_view path = range.first->path;
        const std::size_t dot = path.find('.', depth);
        const std::string_view name = path.substr(0, dot);
        const Range member = {range.first, end_of_member(range, name)};
        range.first = member.last;
        if (!member.is_left_out()) {
            json.key(name.substr(depth));
            dot == std::string_view::npos ? write_figure(json, *member.first)
                                          : write_object(json, member, dot + 1, behind);
        }
        if (dot == std::string_view::npos && behind) behind(path);
    }
}

void write_object(Json& json, const Range& range, std::size_t depth, const Behind& behind) {
    if (!range.has_any(&netmesh_figure::applies)) return json.null();
    json.open('{');
    write_members(json, range, depth, behind);
    json.close('}');
}

}  // namespace

std::vector<netmesh_figure> figures_of(const netmesh_report& report) { return kept_figures(report); }
std::vector<netmesh_figure> figures_of(const netmesh_analysis& analysis) { return kept_figures(analysis); }

void write_part(Json& json, const std::vector<netmesh_figure>& figures, std::string_view part, const Behind& behind,
                bool kept) {
    Range range = {figures.data(), figures.data() + figures.size()};
    while (range.first != range.last && end_of_member(range, part) == range.first) ++range.first;
    range.last = end_of_member(range, part);
    if (!kept || range.has_any(&netmesh_figure::applies)) return write_members(json, range, 0, behind);
    json.key(part);
    json.open('{');
    write_members(json, range, part.size() + 1, behind);
    json.close('}');
}

void write_figures(Json& json, const std::vector<netmesh_figure>& figures) {
    write_object(json, {figures.data(), figures.data() + figures.size()}, 0, {});
}

}  // namespace netmesh::tool
