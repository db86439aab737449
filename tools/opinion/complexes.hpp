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
// The same for alpha complexes, with all that is exact about them.
constexpr std::size_t alpha_simplices_max = 400000;
// Share by which radii may differ where they are not compared as they are: in complexes of distances with a threshold,
// and of bars that hold within a ratio.
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

// The rest is without rounding, but for the one of each value to the nearest double, which exchanges no two of them.

// The alpha complex of the vertices, by cells that are a Delaunay triangulation of them: a face enters at the radius of
// its smallest circumscribed sphere when none of the vertices that it has a cofacet with lies inside, otherwise with
// its first cofacet. Nothing where there are more than `most` faces of all dimensions, or a flat one.
//
// Which of the triangulations it is where points are cospherical makes no difference. Let V be the places that are as
// far from all vertices of a face s as from the nearest points: s enters at the distance of the least place z of V. Let
// c be the centre of the smallest sphere, c - z = d not 0, and Q the points that are as near to z as s. As z is
// least, d is in the cone of Q at s but for directions of s. Cells fill the hull of Q, so d is in that of one of
// their faces, which contains s and has points of Q: one of these is on the side of d, hence inside the sphere of s,
// and s enters with it. All s inside one face of the hulls of such Q have the same V, so what has entered by a radius
// is the same place in space for all triangulations.
SimplexList alpha_complex(const MeshFiles& files, std::uint32_t top, std::size_t most = opinion_simplices_max);

PointCloud different_points(const PointCloud& cloud);           // in their order, without lines
std::vector<Place> different_places(const PointCloud& cloud);   // the same
double count_of_sets(std::size_t members, std::uint32_t size);  // of 1 to `size` members

// All sets of up to top + 1 different points, numbered in their order: Rips at half of the longest edge, Cech at the
// radius of the smallest enclosing ball. Nothing where there are more than `most`.
SimplexList complex_of_points(const PointCloud& cloud, bool rips, std::uint32_t top,
                              std::size_t most = opinion_simplices_max);

// All sets of up to top + 1 of the balls of weighted points, equal ones too: each at the least power that a place has
// to all of them at most, as a square or as its root with its sign. The nerve of the balls, which grow by adding to all
// weights: hidden balls are inside of others as soon as they are there, so they change no bar.
SimplexList nerve_of_balls(const PointCloud& cloud, bool are_radii, bool squares, std::uint32_t top,
                           std::size_t most = opinion_simplices_max);

// All sets of up to top + 1 members, which are the sets of k different points, at the radius of the union of the
// members, times `factor`, rounded. With Cech radii: places within r of all points of a member are a convex set, and
// the places within r of k points are the union of these; members have a place in common from the radius of their union
// on. So this is their nerve. With Rips radii: sending a set of members to its union and a set of points to all members
// in it makes it homotopy equivalent to the nested sets of k points or more. Nothing where there are more than `most`,
// or more than 16 points.
SimplexList nerve_of_sets(const PointCloud& cloud, std::uint32_t k, bool rips, double factor, std::uint32_t top,
                          std::size_t most);

}  // namespace netmesh::tool
