// What the command line asks of the library, as the library's requests. Points and monitor are the session's to set.
#pragma once
#include <cstddef>
#include <cstdint>

#include "netmesh.hpp"
#include "tools/options.hpp"

namespace netmesh::tool {

// A diagram that is wanted: of what, and what is kept of it.
struct DiagramRequest {
    FilterChoice choice;
    bool keep_zero_pairs = false;
    bool cycles = false;  // of scales and of filters on the points; others get theirs by a step of its own
};

// Diagrams for a range of k, and vines between them.
struct VineyardRequest {
    FilterChoice choice;
    std::uint32_t k_first, k_last, max_degree;
};

// What the library takes for an option that is not given: the ratio that --fit begins with, --eps of the filters tight
// and scales, --theta, --longer-than.
constexpr double default_fit_ratio = 4, default_eps = 0.5, default_theta = 1.0 / 9, default_longer_than = 1.5;

// The certified ratio of a mesh of aspect ratio tau, which is what refinement by the certificate aims at by default.
double default_ratio(const netmesh_mesh_request& mesh);
// The options with what they leave to the dimension: from D = 4 on, where a point of an over-refined mesh has 10^4
// vertices and more, tight and scales are asked for a ratio.
Options suited(const Options& options, std::uint32_t dim);
// The ratio and the scales of interest of the command line.
netmesh_certificate_goal goal_of(const Options& options, double ratio);

requests::Mesh mesh_request(const Options& options, std::uint32_t dim);
requests::Delaunay delaunay_request(const Options& options, std::uint32_t dim);
// Does nobody want the triangulation of filter alpha, but its diagram? Then requests::Alpha takes less memory and time.
bool wants_diagram_alone(const Options& options);
requests::Alpha alpha_request(const Options& options, std::uint32_t dim);
requests::Auto auto_request(const Options& options, std::uint32_t dim);
requests::Persist persist_request(const Options& options, const DiagramRequest& diagram, std::uint32_t dim);
requests::Fit fit_request(const Options& options, std::uint32_t dim);
requests::Scales scales_request(const Options& options, const DiagramRequest& diagram, std::uint32_t dim);
requests::Vineyard vineyard_request(const VineyardRequest& vineyard);
requests::PointsVineyard points_vineyard_request(const VineyardRequest& vineyard, std::uint32_t dim);
requests::Points points_request(const Options& options, const DiagramRequest& diagram, std::uint32_t dim);

// Bytes to plan for a diagram of the filter, with the mesh or triangulation made for it.
std::size_t plan_diagram(const Options& options, netmesh_filter filter, std::uint32_t dim, std::size_t point_count);
// The same for a vineyard over a range of k.
std::size_t plan_vineyard(const Options& options, const VineyardRequest& vineyard, std::uint32_t dim,
                          std::size_t point_count);

}  // namespace netmesh::tool
