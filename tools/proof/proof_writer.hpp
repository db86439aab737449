// The proof of an alpha diagram, of points or of balls: the triangulation, in the format of docs/proofs.md.
#pragma once
#include <cstdint>
#include <vector>

#include "tools/io/diagram_file.hpp"
#include "tools/io/mesh_files.hpp"
#include "tools/io/points.hpp"
#include "tools/io/text_writer.hpp"

namespace netmesh::tool {

// triangulation: of the different points of the cloud that are not hidden, in their order. hidden: the rows of the
// others, ascending; none without weights. bars: the whole diagram. The same bytes wherever it is written. Takes 4 D
// bytes a cell, 36 a point, and the proof; O(n log n), and for each hidden point a walk from the one before along a
// curve, by exact signs.
void write_proof(const MeshSource& triangulation, const PointCloud& cloud, const std::vector<std::uint64_t>& hidden,
                 const BarSource& bars, bool are_radii, TextWriter& out);

}  // namespace netmesh::tool
