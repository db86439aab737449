// Whether cells are a Delaunay triangulation, without rounding.
#pragma once
#include <string>
#include <vector>

#include "tools/io/mesh_files.hpp"
#include "tools/opinion/exact_spheres.hpp"

namespace netmesh::tool {

// Empty when the cells, D + 1 of the points each, tile the convex hull of the points, every point is a vertex, and no
// point is inside the sphere of a cell; otherwise what is wrong. Where more than D + 1 points are on such a sphere, any
// such cells will do. Time of O(cells log cells) operations on Exact.
//
// It is enough to look at facets and ridges (facets of facets), and where one place o inside the first cell is:
// 1. A facet is of one cell or of two that are on either side of it. So the number of cells that cover a place changes
//    across facets of one cell alone, the boundary facets.
// 2. o is in no other cell, and on the inner side of every boundary facet. A ray from o crosses boundary facets outward
//    alone, at each of which the number drops from 1: so it crosses one. The cones of boundary facets over o cover all
//    directions once, and the cells cover once what is star-shaped about o and ends at the boundary facets.
// 3. Let F be the linear function that is 0 at o and 1 on a boundary facet's plane. Behind a ridge stands a neighbour G
//    whose other vertex a has F(a) <= 1 = G(a): so F <= G on the far side, and from facet to facet on the way to any
//    direction. A vertex p in the cone of H has F(p) <= H(p) <= 1 for all F: the cells fill the convex hull.
// 4. Across a facet between cells t and u no vertex of u is inside the sphere of t: on u's side the power of a place
//    with regard to t is at least that with regard to u. On the straight way from t to a vertex p powers of p do not
//    grow, and end with 0: p is not inside the sphere of t.
std::string delaunay_complaint(const std::vector<ExactPlace>& points, const CellTable& cells);

}  // namespace netmesh::tool
