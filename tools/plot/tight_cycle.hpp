// Cycles of degree 1 pulled tight for pictures.
#pragma once
#include <cstdint>
#include <vector>

#include "tools/io/cycle_file.hpp"

namespace netmesh::tool {

// Edges of a cycle that is homologous to `cycle` where the balls have any radius from `radius` to its bar's death, and
// no longer: it is swept across simplices of the Delaunay triangulation (places.cells) whose circumscribed balls are
// smaller than `radius`. Without cells, or where nothing is left for rounding, the cycle itself.
std::vector<std::vector<std::uint32_t>> tightened(const std::vector<std::vector<std::uint32_t>>& cycle, double radius,
                                                  const CyclePlaces& places);

}  // namespace netmesh::tool
