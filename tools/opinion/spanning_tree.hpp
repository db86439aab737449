// Degree 0 of the points themselves, without rounding but for that of each value to the nearest double.
#pragma once
#include <vector>

#include "tools/io/points.hpp"

namespace netmesh::tool {

// Half of the edges of a minimum spanning tree of different points, ascending: the deaths of degree 0 of unions of
// balls. Prim's algorithm on all pairs.
std::vector<double> spanning_tree_halves(const PointCloud& different);

// Half of the distance from that point to the nearest other one, of two or more different points: an edge that a
// minimum spanning tree has.
double nearest_half(const PointCloud& different, std::size_t row);

}  // namespace netmesh::tool
