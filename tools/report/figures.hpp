// The library's figures as JSON: an object for each of their parts, no list of the tool's own.
#pragma once
#include <functional>
#include <string_view>
#include <vector>

#include "netmesh.hpp"
#include "tools/report/json.hpp"

namespace netmesh::tool {

// The figures of a report or an analysis, in the library's order; they point into it. Figures that JSON has elsewhere,
// or not at all, are left out.
std::vector<netmesh_figure> figures_of(const netmesh_report& report);
std::vector<netmesh_figure> figures_of(const netmesh_analysis& analysis);

// Called behind each figure of a part with its path, for what JSON says besides figures. Not called when the part is
// null.
using Behind = std::function<void(std::string_view path)>;

// The key `part` and its object: figures that do not apply are null, or left out when they have to be asked for.
// Without any that applies the object is null, unless it is to be `kept`.
void write_part(Json& json, const std::vector<netmesh_figure>& figures, std::string_view part,
                const Behind& behind = {}, bool kept = false);
// All figures as one object.
void write_figures(Json& json, const std::vector<netmesh_figure>& figures);

}  // namespace netmesh::tool
