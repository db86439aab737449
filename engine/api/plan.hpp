// Bytes to plan for.
#pragma once
#include <cstddef>
#include <cstdint>

#include "include/netmesh.h"

namespace netmesh {

// What small jobs on complexes take besides what is in proportion to them: tables and scratch of sorting.
constexpr double complex_overhead = 20480;

// Rounded up to the block's alignment; SIZE_MAX when they do not fit a size_t; 0 stays.
std::size_t whole_bytes(double bytes);

// Of requests that are settled. with_diagram: of the alpha complex as well.
double plan_of_triangulation(const netmesh_points& points, bool with_diagram);
double plan_of_alpha(const netmesh_request& request);
double plan_of_leaf(std::uint32_t dim, std::uint64_t points, std::uint32_t pieces);
double plan_of_mesh(const netmesh_request& request, bool with_diagram);
double plan_of_scales(const netmesh_request& request);
double plan_of_points(const netmesh_request& request);     // filters on points
double plan_of_distances(const netmesh_request& request);  // 0: the distances are at fault
double plan_of_simplices(const netmesh_request& request);  // 0: the simplices are at fault
double plan_with_periods(const netmesh_request& request);
// Of any request for a diagram. Objects do not point here, so that a program which does not plan holds no plans.
double plan_of_diagram(const netmesh_request& request);

// What netmesh_plan and netmesh_plan_mesh say. 0: nothing can be planned.
std::size_t bytes_of_diagram(const netmesh_request& request);
std::size_t bytes_of_cells(const netmesh_request& request);

// What weights take besides: a number of each point, and what alpha diagrams copy of it.
inline double weight_bytes(const netmesh_request& r) {
    return r.weighting != nullptr ? 16 * static_cast<double>(r.points.count) : 0;
}

}  // namespace netmesh
