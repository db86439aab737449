// Pictures: a diagram as barcode and scatter plot side by side, a mesh in the plane.
#pragma once
#include <string>
#include <vector>

#include "netmesh.h"
#include "tools/io/diagram_file.hpp"
#include "tools/io/mesh_files.hpp"
#include "tools/io/vine_file.hpp"

namespace netmesh::tool {

// A whole SVG document. Radii on a natural-log scale, births at 0 in a column of their own, essential classes as
// arrows; of a degree with many bars the barcode shows the longest (ratio death / birth) and says so, the diagram shows
// all. Bars that surely are real by their bounds, or by the certified ratio c (death > c^2 birth), are drawn solid,
// others faint; the diagram shows by birth up to which death a bar may be an artefact. With bounds by scale the
// certified ratio c(r) stands above the barcode. Of a function's diagram values are drawn as they are, of any sign, the
// band of what may be an artefact is death <= birth + 2 e for the additive bound e, and with bounds e(v) stands above.
std::string diagram_picture(const std::vector<Bar>& bars, const netmesh_report& report, const Bounds& bounds = {});

// A whole SVG document: for each degree a panel with k upwards against the radius on a natural-log scale; the longest
// vines of each.
std::string vineyard_picture(const Vines& vines, const netmesh_report& report);

// A whole SVG document: cells, inputs, Steiner points, domain. D = 2.
void write_mesh_picture(const MeshSource& mesh, TextWriter& out);

}  // namespace netmesh::tool
