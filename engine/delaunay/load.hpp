// A triangulation from lists of vertices and cells.
#pragma once
#include <cstddef>
#include <cstdint>

#include "delaunay/check.hpp"
#include "delaunay/sphere.hpp"
#include "delaunay/store.hpp"

namespace netmesh {

// Fills an empty store: coordinates[vertex_count][D], cells[cell_count][D+1]. Cells are turned to positive orientation
// and linked by their facets, balls and nearest2 computed; vertex.marker is input, origin the vertex itself. Scratch:
// 24 bytes a facet. out_of_memory, check_failed (*why says what).
template <int D>
Status load_cells(Store<D>& store, const double* coordinates, std::uint32_t vertex_count, const std::uint32_t* cells,
                  std::uint32_t cell_count, CheckResult* why);

}  // namespace netmesh
