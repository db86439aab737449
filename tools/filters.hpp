// The library's table of filters, as the command line and the reports read it.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "netmesh.hpp"

namespace netmesh::tool {

// The filters that the command line offers: all.
const std::vector<netmesh_filter_info>& filters();

// The row of a filter. NONE, which complexes given by their simplices have, is called "none" and needs nothing; AUTO is
// as complete, which it may be.
const netmesh_filter_info& about(netmesh_filter_id filter);
const netmesh_filter_info& about(const netmesh_filter* filter);

inline const char* filter_name(netmesh_filter_id filter) { return about(filter).name; }
const char* values_name(netmesh_values values);
const char* method_name(netmesh_method_id method);

// A filter and its kind of values: what a diagram is of.
struct FilterChoice {
    netmesh_filter_id filter = NETMESH_FILTER_NONE;
    netmesh_values values = NETMESH_VALUES_CERTIFIED;
};
// Of a request; values that are open are certified.
FilterChoice choice_of(const netmesh_request& request);
// "filter complete, certified values"; the values are left out where both kinds are the same.
std::string choice_text(const FilterChoice& choice);
// The same as reports of a run have it: a diagram joined of scales does not say its values.
std::string reported_choice_text(const FilterChoice& choice);

inline bool is_on_points(netmesh_filter_id filter) { return about(filter).is_on_points != 0; }
// Whether radii are rounded to infinity where they are beyond the largest double, and read like those of what never
// dies.
inline bool may_end_beyond(netmesh_filter_id filter) { return filter == NETMESH_FILTER_ALPHA || is_on_points(filter); }

// Nested sets of points (8.5).
inline bool is_barycentric(netmesh_filter_id filter) { return is_on_points(filter) && about(filter).needs_k != 0; }
// Over a range of k: on a mesh, or of nested sets.
inline bool has_vineyard(const netmesh_filter_info& info) { return info.has_vineyard != 0 || is_barycentric(info.id); }

// "knn or kdistance": the filters with `wanted`, in the table's order, the last two joined by `conjunction`.
template <class Wanted> std::string list_filters(Wanted&& wanted, const std::string& conjunction) {
    std::string text, last;
    for (const netmesh_filter_info& info : filters()) {
        if (!wanted(info)) continue;
        if (!last.empty()) text += (text.empty() ? "" : ", ") + last;
        last = info.name;
    }
    return text.empty() ? last : text + " " + conjunction + " " + last;
}

// The function that a certified ratio is about: "closed offsets of the points in R^3", with weights "unions of balls
// about the points in R^3", with periods "... modulo the lattice", "sublevel sets of d_5 in R^3", ...
std::string reference_name(const netmesh_report& report);

}  // namespace netmesh::tool
