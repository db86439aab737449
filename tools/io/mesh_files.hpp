// Meshes in files: TetGen's .node/.ele/.neigh for any dimension (both ways); .off, .vtu, .ply, .obj, .msh and .mesh
// (out).
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "netmesh.h"
#include "tools/io/points.hpp"
#include "tools/io/text_writer.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

// A mesh that writers and plots read one item at a time, so that it need not be copied out of the engine's block.
class MeshSource {
public:
    virtual ~MeshSource() = default;
    virtual netmesh_vertex vertex(std::uint64_t index) const = 0;
    virtual netmesh_cell cell(std::uint64_t index) const = 0;

    std::uint32_t dim = 0;
    std::uint64_t vertex_count = 0, cell_count = 0;
    double tau = 0;                              // bound asked for; 0 for a Delaunay triangulation
    double ratio = 0;                            // asked of the certificate instead; 0: not asked for
    bool clipped = false;                        // the ratio is that of cells clipped to the domain
    double eps = 0;                              // of over-refinement; 0 when there was none
    double size_at_inputs = 0, size_growth = 0;  // the same by the distance to the inputs
    double net_spacing = 0;                      // of the boundary net; 0: not chosen
    double domain[NETMESH_DIM_MAX + 1] = {};     // centre, radius at index dim; radius 0 for a Delaunay triangulation
    bool has_values = false;                     // vertices carry filter values
    std::vector<netmesh_cage> cages;             // of a hierarchical mesh
    bool has_thesis_cages = false;               // of the kind of 4.5
    std::vector<double> ratios;                  // of vertices' clipped cells, where they have been measured
    std::vector<std::uint32_t> domains;          // innermost cages of vertices, with the ratios
};

// Ids from 0; header `count D attributes 1`, attributes 1 when there are filter values. Ahead of the vertices the lines
// `# domain c1 .. cD r` and `# tau T` or `# ratio C`, for a mesh, `# clipped` behind a ratio of cells that are clipped
// to the domain, `# eps E` and `# cell-size A B` for an over-refined
// one, `# boundary-net S` where a boundary net's spacing was chosen, `# cage V R` for each cage: its centre's id and
// its radius; before the first of them `# cages thesis` where they are of that kind.
void write_node(const MeshSource& mesh, TextWriter& out);
void write_ele(const MeshSource& mesh, TextWriter& out);
// -1 outside; neighbour i is opposite vertex i.
void write_neigh(const MeshSource& mesh, TextWriter& out);
// OFF for D = 3, nOFF otherwise; a face for each cell, of its D+1 vertices.
void write_off(const MeshSource& mesh, TextWriter& out);
// VTK's unstructured grid, D = 2 and 3, with point data `marker`, `value`, `aspect_ratio` and `domain` (-1: the
// outermost), as far as they are known.
void write_vtu(const MeshSource& mesh, TextWriter& out);

// The rest is for D = 2 and 3. Surfaces: the triangles of a mesh in the plane, all triangles of one in space, each
// once; .ply has value and marker as properties of vertices.
void write_ply(const MeshSource& mesh, TextWriter& out);
void write_obj(const MeshSource& mesh, TextWriter& out);
// Gmsh's format 2.2 in ASCII, with node data marker and value.
void write_msh(const MeshSource& mesh, TextWriter& out);
// Medit's .mesh, with markers as references, and the .sol of the values.
void write_medit(const MeshSource& mesh, TextWriter& out);
void write_medit_values(const MeshSource& mesh, TextWriter& out);

// A .node file as it stands.
struct NodeFile {
    PointCloud cloud;  // all vertices
    std::uint32_t attribute_count = 0;
    std::vector<double> attributes;  // [rows][attribute_count]
    bool has_markers = false;
    std::vector<std::uint8_t> markers;   // [rows]; 0 where the file has none
    std::uint64_t first_id = 0;          // 0 or 1
    std::vector<double> domain;          // dim + 1 numbers, or empty
    double tau = 0, ratio = 0, eps = 0;  // 0 when the file does not say
    bool clipped = false;                // its cells are clipped to the domain
    double size_at_inputs = 0, size_growth = 0, net_spacing = 0;
    std::vector<netmesh_cage> cages;  // centres counted from 0; no parents
    bool has_thesis_cages = false;    // of the kind of 4.5
};

// Every fault is Exit::data with file and line. node->cloud.name is used for messages.
Outcome parse_node(std::string_view content, NodeFile* node);

// Rows of `columns` integers with consecutive ids: .ele (vertices of cells) and .neigh. Entries are given counted from
// 0, -1 (outside) as NETMESH_NONE.
struct CellTable {
    std::string name;  // for messages
    std::uint32_t columns = 0;
    std::vector<std::uint32_t> entries;
    std::vector<std::uint64_t> lines;
};

// Which entries a table may have, as counted from 0: those below `limit`, and perhaps -1.
struct EntryRange {
    std::uint64_t first_id = 0;  // ids and entries of the file count from here
    std::uint64_t limit = 0;
    bool allow_outside = false;  // of .neigh, which has as many rows as there are cells
};
Outcome parse_cell_table(std::string_view content, const EntryRange& range, CellTable* table);

// The three files of a mesh; `path` names the .node.
struct MeshFiles {
    NodeFile node;
    CellTable cells, neighbours;
};
Outcome read_mesh_files(const std::string& path, MeshFiles* files);

}  // namespace netmesh::tool
