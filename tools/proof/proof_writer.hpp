// The proof of an alpha diagram: the triangulation, in the format of docs/proofs.md.
#pragma once
#include "tools/io/diagram_file.hpp"
#include "tools/io/mesh_files.hpp"
#include "tools/io/points.hpp"
#include "tools/io/text_writer.hpp"

namespace netmesh::tool {

// triangulation: of the different points of the cloud, in their order. bars: the whole diagram. The same bytes wherever
// it is written. Takes 4 D bytes a cell, 36 a point, and the proof; O(n log n).
void write_proof(const MeshSource& triangulation, const PointCloud& cloud, const BarSource& bars, TextWriter& out);

}  // namespace netmesh::tool
