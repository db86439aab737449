// Results of a context as values: tests that are not about struct_bytes set it here and nowhere else.
#pragma once
#include <cstdint>
#include <vector>

#include "netmesh.hpp"

inline netmesh_report report_of(const netmesh_context* context) {
    auto report = netmesh::sized<netmesh_report>();
    netmesh_get_report(context, &report);
    return report;
}

inline netmesh_detail detail_of(const netmesh_context* context) {
    auto detail = netmesh::sized<netmesh_detail>();
    netmesh_get_detail(context, &detail);
    return detail;
}

// Whether the library serves a dimension, by what its interface says.
inline bool plans_for(int dim) {
    netmesh::Request request(&netmesh_filter_alpha);
    request.points.dim = static_cast<std::uint32_t>(dim);
    request.points.count = 1;
    return netmesh_plan(&request) != 0;
}

// Everything that one of the calls by index has: read_all(context, netmesh_get_vertex).
template <class Item>
std::vector<Item> read_all(const netmesh_context* context,
                           netmesh_status (*get)(const netmesh_context*, std::uint64_t, Item*)) {
    std::vector<Item> all;
    auto item = netmesh::sized<Item>();
    for (std::uint64_t i = 0; get(context, i, &item) == NETMESH_OK; ++i) all.push_back(item);
    return all;
}

// The simplices of the representative of a pair; none where there is no representative.
inline std::vector<netmesh_simplex> cycle_of(const netmesh_context* context, std::uint64_t pair) {
    std::vector<netmesh_simplex> cycle;
    std::uint64_t count = 0;
    if (netmesh_get_cycle(context, pair, &count) != NETMESH_OK) return cycle;
    auto simplex = netmesh::sized<netmesh_simplex>();
    for (std::uint64_t i = 0; i < count; ++i)
        if (netmesh_get_cycle_simplex(context, pair, i, &simplex) == NETMESH_OK) cycle.push_back(simplex);
    return cycle;
}

inline netmesh_pair bar(std::uint32_t degree, double birth, double death) {
    return {sizeof(netmesh_pair), degree, birth, death};
}
