// What pictures of meshes say of them in words, and the colours that they share.
#pragma once
#include <string>

#include "tools/io/mesh_files.hpp"
#include "tools/plot/legend.hpp"

namespace netmesh::tool {

struct MeshCounts {
    std::uint64_t markers[3] = {0, 0, 0};  // inputs, Steiner points, boundary vertices
};
MeshCounts counts_of(const MeshSource& mesh);

// By the marker of a vertex.
const char* vertex_colour(std::uint32_t marker);
Mark vertex_mark(std::uint32_t marker);
// The darker the finer: of a Voronoi cell's out-radius over the distance to the second nearest input.
const char* fineness_colour(double ratio);

std::string cells_text(const MeshSource& mesh);  // "2 triangles", "1 tetrahedron"
std::string mesh_title(const MeshSource& mesh, const MeshCounts& counts);
std::string mesh_description(const MeshSource& mesh, const MeshCounts& counts);

void add_vertices(const MeshCounts& counts, Legend* legend);
// Cells, and circles of domain and cages, as a picture in the plane shows them.
void add_cells(const MeshSource& mesh, const MeshCounts& counts, bool voronoi, Legend* legend);

}  // namespace netmesh::tool
