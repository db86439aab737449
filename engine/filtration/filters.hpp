// The table of filters, and the one way to evaluate a filter on a mesh. Nothing else in the engine lists filters.
//
// A new filter on meshes is a row of the table, a constant MeshFilter beside it, and its function: lower and upper
// bounds of what is filtered on each Voronoi cell, and own values, which a Clamp (certificate/certificate.hpp) turns
// into filter values and a certificate. api/on_meshes.cpp makes it an object that requests name.
#pragma once
#include "filtration/any_mesh.hpp"

namespace netmesh {

// Rows in the order of netmesh_filter_id, without NONE.
constexpr std::uint32_t filter_count = NETMESH_FILTER_BARYCENTRIC_RIPS;  // the last one
const Filter& filter_row(std::uint32_t index);
const FilterText& filter_text(std::uint32_t index);

// The row of a filter; null when there is none. The value may be any that came from outside.
const Filter* find_filter(const netmesh_filter_id& filter);

// The filter that is evaluated for a request: with one neighbour, filters by neighbours are the complete filter
// (7.4.2).
const Filter& evaluated_filter(netmesh_filter_id filter, std::uint32_t k);

// How many of the inputs, the first vertices of a mesh, enter at 0 before their stars.
std::uint32_t zero_born_count(netmesh_filter_id filter, std::uint32_t k, std::uint32_t inputs);

// Puts the nerve of the clipped cells in the place of the mesh, and the ball that they are clipped to in that of its
// domain, where the mesh is refined for clipped cells and the filter takes them; at the arena's high end. Where no
// radius can be told to be right (clipped_nerve.hpp) cells stay whole, and ratios are what those certify.
// out_of_memory, cancelled.
Status clip_cells(const FilterRequest& request, const Work& work, AnyMesh* mesh);

// How a filter is evaluated: values, certificate and, when asked for, intervals on each cell. Costs and scratch: see
// mesh_filter.hpp, tight_filter.hpp, function_filter.hpp. out_of_memory, cancelled, not_finite (culprit).
struct MeshFilter {
    Status (*evaluate)(const AnyMesh& mesh, const FilterRequest& request, const Work& work, Evaluation* out);
};
// Those that jobs name themselves; the others are named by their objects alone.
extern const MeshFilter complete_on_mesh, tight_on_mesh;

// By the request's own.
Status evaluate(const AnyMesh& mesh, const FilterRequest& request, const Work& work, Evaluation* out);

}  // namespace netmesh
