// The edges of a Vietoris-Rips complex of points.
#pragma once
#include <cstdint>

#include "homology/rips/rips.hpp"
#include "memory/arena.hpp"
#include "memory/work.hpp"
#include "vocabulary/monitor.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// As rips_complex (point_complexes.hpp), the edges alone: coordinates[n][dim], distinct points, dim is D or, with
// any_dimension, 65,536 at most; an edge's value is half its length, rounded to nearest, and none beyond the largest
// double. Which vertex is which point is not told. At the arena's low end. Looks at pairs in cubes of a grid that
// touch, as wide as the longest edge, over up to three axes. invalid_argument (n > RipsGraph::vertices_max),
// out_of_memory (also of 2^31 edges or more), cancelled.
template <int D>
Status rips_graph(int dim, const double* coordinates, std::uint32_t n, double threshold, const Work& work,
                  RipsGraph* out);

// What such a graph of n vertices and so many edges and its diagram (persist_rips) take, but for the fill.
double rips_bytes(std::uint64_t n, std::uint32_t max_degree, double edges);

}  // namespace netmesh
