// The complexes of filters, simplex by simplex: what FilteredComplex takes.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "tools/io/mesh_files.hpp"
#include "tools/opinion/filtered_complex.hpp"
#include "tools/opinion/spheres.hpp"

namespace netmesh::tool {

// More simplices than that are not made; then there is no list. Reducing so many takes about ten seconds and 250 MB.
constexpr std::size_t opinion_simplices_max = 1000000;
// The same for the Cech complex of points with a diagram that is joined of scales, of which every set is one.
constexpr std::size_t joined_simplices_max = 200000;
// Share by which radii of alpha, Rips and Cech complexes may differ from the engine's.
constexpr double radius_tolerance = 1e-9;
using SimplexList = std::optional<std::vector<FilteredSimplex>>;

// The faces of a mesh's cells up to dimension `top`, each at the largest value of its vertices; vertices
// 0 .. zero_born - 1 enter alone at 0.
SimplexList lower_stars(const CellTable& cells, const std::vector<double>& values, std::uint32_t zero_born,
                        std::uint32_t top);

// The complex of a filter on a mesh: of a clipped one only the simplices count whose dual faces meet the ball. Nothing
// and *unknown > 0 where for so many it cannot be told whether they do.
SimplexList mesh_complex(const MeshFiles& files, const std::vector<double>& values, std::uint32_t zero_born,
                         std::uint32_t top, std::uint64_t* unknown);

// The alpha complex: a face enters at the radius of its smallest circumscribed sphere when none of the vertices that it
// has a cofacet with lies inside, otherwise with its first cofacet. Where the sphere does not tell, both must be the
// same. Nothing and *is_flat where they are not, or the vertices of a face are affinely dependent to working precision.
SimplexList alpha_complex(const MeshFiles& files, std::uint32_t top, bool* is_flat = nullptr);

// All sets of up to top + 1 different points, numbered in their order: Rips at half of the longest edge, Cech at the
// radius of the smallest enclosing ball. Nothing where there are more than `most`.
std::vector<Place> different_places(const PointCloud& cloud);  // in their order
SimplexList complex_of_points(const PointCloud& cloud, bool rips, std::uint32_t top,
                              std::size_t most = opinion_simplices_max);

}  // namespace netmesh::tool
