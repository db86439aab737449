// The edges of Rips complexes, for proofs.
#pragma once
#include <cstdint>
#include <vector>

#include "tools/io/distance_file.hpp"
#include "tools/io/points.hpp"

namespace netmesh::tool {

struct RipsEdge {
    double value;  // half of the distance, rounded to nearest
    std::uint32_t larger, smaller;
};

struct RipsEdges {
    std::uint32_t vertices = 0;
    double limit = 0;             // all edges up to here: the threshold, or a vertex is joined to all others by then
    std::vector<RipsEdge> edges;  // by value, larger and smaller vertex
};

// Of different points, as far as the threshold. O(n^2) where that leaves nothing out.
RipsEdges rips_edges(const PointCloud& points, double threshold);
// Of distances that are without a flaw.
RipsEdges rips_edges(const DistanceFile& distances, double threshold);

}  // namespace netmesh::tool
