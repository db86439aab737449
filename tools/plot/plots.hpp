// Pictures: a diagram as barcode and scatter plot side by side, a mesh in the plane.
#pragma once
#include <string>
#include <vector>

#include "netmesh.h"
#include "tools/io/cycle_file.hpp"
#include "tools/io/diagram_file.hpp"
#include "tools/io/mesh_files.hpp"
#include "tools/io/vine_file.hpp"
#include "tools/plot/axis.hpp"

namespace netmesh::tool {

// A whole SVG document, as high as it needs to be; no text touches another. Radii on a logarithmic scale with births at
// 0 in a column of their own, or on a linear one as values of any sign; essential classes as arrows. The barcode has
// those bars first that are certified to exist, with birth and death, and the longest first; of a degree with many, and
// of degree 0, what is left out is a curve of how many there are. The diagram is a square and shows all. Bars that are
// certified to exist by their bounds, or by the certified ratio c (death > c^2 birth), are drawn solid, others faint;
// the diagram shows by birth up to which death a bar may be an artefact. With bounds by scale the certified ratio c(r)
// stands above the barcode. Of a function's diagram the band of what may be an artefact is death <= birth + 2 e for the
// additive bound e, and with bounds e(v) stands above.
std::string diagram_picture(const std::vector<Bar>& bars, const netmesh_report& report, const Bounds& bounds = {},
                            Axis axis = Axis::natural);

// A whole SVG document: for each degree a panel with k upwards against the radius on a logarithmic scale, or against
// values as they are; the longest vines of each.
std::string vineyard_picture(const Vines& vines, const netmesh_report& report, Axis axis = Axis::natural);

// A whole SVG document. D = 2: triangles, inputs, Steiner points, domain, cages; `voronoi`: Voronoi cells by their
// out-radius over the distance to the second nearest input, which over-refinement makes small. D = 3: the tetrahedra
// behind a plane through the middle, seen along a fixed direction, in parallel.
void write_mesh_picture(const MeshSource& mesh, bool voronoi, TextWriter& out);

// A whole SVG document: the points, and a cycle, in a colour of its own, of each bar that was chosen, else of those
// that stand apart by their length; it says how many were left out. Those of degree 1 are pulled tight. D = 3 as seen
// along a fixed direction, in parallel; D = 2 as it is.
void write_cycle_picture(const std::vector<CycleEntry>& cycles, const CyclePlaces& places, TextWriter& out);

}  // namespace netmesh::tool
