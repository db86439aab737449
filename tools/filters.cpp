#include "tools/filters.hpp"

namespace netmesh::tool {

namespace {

std::vector<netmesh_filter_info> read_filters() {
    std::vector<netmesh_filter_info> rows;
    for_each_filter([&](const netmesh_filter_info& info) { rows.push_back(info); });
    return rows;
}

netmesh_filter_info no_filter() {
    netmesh_filter_info info = sized<netmesh_filter_info>();
    info.name = "none";
    info.reference = "filtered complex";
    return info;
}

void replace(std::string& text, const std::string& place, const std::string& by) {
    const std::size_t at = text.find(place);
    if (at != std::string::npos) text.replace(at, place.size(), by);
}

}  // namespace

const std::vector<netmesh_filter_info>& filters() {
    static const std::vector<netmesh_filter_info> table = read_filters();
    return table;
}

const netmesh_filter_info& about(netmesh_filter_id filter) {
    static const netmesh_filter_info none = no_filter();
    for (const netmesh_filter_info& info : filters()) {
        if (info.id == (filter == NETMESH_FILTER_AUTO ? NETMESH_FILTER_COMPLETE : filter)) return info;
    }
    return none;
}

const netmesh_filter_info& about(const netmesh_filter* filter) {
    for (const netmesh_filter_info& info : filters()) {
        if (info.filter == filter) return info;
    }
    return about(filter == &netmesh_filter_simplices ? NETMESH_FILTER_NONE : NETMESH_FILTER_COMPLETE);
}

const char* values_name(netmesh_values values) { return values == NETMESH_VALUES_THESIS ? "thesis" : "certified"; }

const char* method_name(netmesh_method_id method) {
    switch (method) {
    case NETMESH_METHOD_NETMESH: return "netmesh";
    case NETMESH_METHOD_THESIS: return "thesis";
    case NETMESH_METHOD_REFINE: return "refine";
    case NETMESH_METHOD_CERTIFICATE: return "certificate";
    case NETMESH_METHOD_DELAUNAY: return "delaunay";
    default: return "svr";
    }
}

FilterChoice choice_of(const netmesh_request& request) {
    return {about(request.filter).id,
            request.values == NETMESH_VALUES_THESIS ? NETMESH_VALUES_THESIS : NETMESH_VALUES_CERTIFIED};
}

std::string choice_text(const FilterChoice& choice) {
    std::string text = std::string("filter ") + filter_name(choice.filter);
    if (about(choice.filter).has_values != 0) text += std::string(", ") + values_name(choice.values) + " values";
    return text;
}

std::string reported_choice_text(const FilterChoice& choice) {
    if (about(choice.filter).is_by_scales == 0) return choice_text(choice);
    return std::string("filter ") + filter_name(choice.filter);
}

std::string reference_name(const netmesh_report& report) {
    if (report.diagram.filter == NETMESH_FILTER_RIPS && report.input.dim == 0)
        return "Vietoris-Rips complex of the distances, edges at half of them";
    std::string text = report.input.weighting != NETMESH_WEIGHTING_NONE ? "unions of balls about the points in R^{D}"
                                                                        : about(report.diagram.filter).reference;
    replace(text, "{k}", std::to_string(report.diagram.k));
    replace(text, "{D}", std::to_string(report.input.dim));
    if (report.input.periods > 0) text += " modulo the lattice";
    return text;
}

}  // namespace netmesh::tool
