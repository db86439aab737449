// Meshes for other programs, D = 2 and 3: .ply and .obj for viewers of surfaces, .msh for Gmsh, .mesh and .sol for
// Medit.
#include "tools/io/mesh_files.hpp"

namespace netmesh::tool {

namespace {

// Each triangle once: the cells of a mesh in the plane, all faces of the cells of one in space.
template <class Visit> void for_each_triangle(const MeshSource& mesh, Visit visit) {
    for (std::uint64_t i = 0; i < mesh.cell_count; i++) {
        const netmesh_cell cell = mesh.cell(i);
        if (mesh.dim == 2) {
            visit(cell.vertices[0], cell.vertices[1], cell.vertices[2]);
            continue;
        }
        for (unsigned k = 0; k < 4; k++) {
            const std::uint32_t other = cell.neighbours[k];
            if (other != NETMESH_NONE && other < i) continue;
            std::uint32_t face[3];
            unsigned count = 0;
            for (unsigned v = 0; v < 4; v++)
                if (v != k) face[count++] = cell.vertices[v];
            visit(face[0], face[1], face[2]);
        }
    }
}

void write_place(const netmesh_vertex& vertex, std::uint32_t dim, TextWriter& out) {
    out << vertex.coordinates[0] << ' ' << vertex.coordinates[1] << ' ' << (dim > 2 ? vertex.coordinates[2] : 0.0);
}

void write_node_data(const MeshSource& mesh, const char* name, bool markers, TextWriter& out) {
    out << "$NodeData\n1\n\"" << name << "\"\n1\n0\n3\n0\n1\n" << mesh.vertex_count << '\n';
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) {
        const netmesh_vertex vertex = mesh.vertex(i);
        out << i + 1 << ' ';
        markers ? out << vertex.marker : out << vertex.value;
        out << '\n';
    }
    out << "$EndNodeData\n";
}

}  // namespace

void write_ply(const MeshSource& mesh, TextWriter& out) {
    std::uint64_t triangles = 0;
    for_each_triangle(mesh, [&](std::uint32_t, std::uint32_t, std::uint32_t) { triangles++; });
    out << "ply\nformat ascii 1.0\ncomment netmesh; marker 0 input, 1 Steiner, 2 exempt from quality\nelement vertex "
        << mesh.vertex_count << "\nproperty double x\nproperty double y\nproperty double z\n";
    if (mesh.has_values) out << "property double value\n";
    out << "property uchar marker\nelement face " << triangles << "\nproperty list uchar int vertex_indices\n"
        << "end_header\n";
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) {
        const netmesh_vertex vertex = mesh.vertex(i);
        write_place(vertex, mesh.dim, out);
        if (mesh.has_values) out << ' ' << vertex.value;
        out << ' ' << vertex.marker << '\n';
    }
    for_each_triangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        out << "3 " << a << ' ' << b << ' ' << c << '\n';
    });
}

void write_obj(const MeshSource& mesh, TextWriter& out) {
    out << "# netmesh\n";
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) {
        out << "v ";
        write_place(mesh.vertex(i), mesh.dim, out);
        out << '\n';
    }
    for_each_triangle(mesh, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        out << "f " << std::uint64_t{a} + 1 << ' ' << std::uint64_t{b} + 1 << ' ' << std::uint64_t{c} + 1 << '\n';
    });
}

void write_msh(const MeshSource& mesh, TextWriter& out) {
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << mesh.vertex_count << '\n';
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) {
        out << i + 1 << ' ';
        write_place(mesh.vertex(i), mesh.dim, out);
        out << '\n';
    }
    out << "$EndNodes\n$Elements\n" << mesh.cell_count << '\n';
    for (std::uint64_t i = 0; i < mesh.cell_count; i++) {
        const netmesh_cell cell = mesh.cell(i);
        out << i + 1 << (mesh.dim == 2 ? " 2 2 1 1" : " 4 2 1 1");  // triangle or tetrahedron, of entity 1
        for (std::uint32_t k = 0; k <= mesh.dim; k++) out << ' ' << std::uint64_t{cell.vertices[k]} + 1;
        out << '\n';
    }
    out << "$EndElements\n";
    write_node_data(mesh, "marker", true, out);
    if (mesh.has_values) write_node_data(mesh, "value", false, out);
}

void write_medit(const MeshSource& mesh, TextWriter& out) {
    out << "MeshVersionFormatted 2\nDimension " << mesh.dim << "\nVertices\n" << mesh.vertex_count << '\n';
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) {
        const netmesh_vertex vertex = mesh.vertex(i);
        for (std::uint32_t k = 0; k < mesh.dim; k++) out << vertex.coordinates[k] << ' ';
        out << vertex.marker << '\n';
    }
    out << (mesh.dim == 2 ? "Triangles\n" : "Tetrahedra\n") << mesh.cell_count << '\n';
    for (std::uint64_t i = 0; i < mesh.cell_count; i++) {
        const netmesh_cell cell = mesh.cell(i);
        for (std::uint32_t k = 0; k <= mesh.dim; k++) out << std::uint64_t{cell.vertices[k]} + 1 << ' ';
        out << "0\n";
    }
    out << "End\n";
}

void write_medit_values(const MeshSource& mesh, TextWriter& out) {
    out << "MeshVersionFormatted 2\nDimension " << mesh.dim << "\nSolAtVertices\n" << mesh.vertex_count << "\n1 1\n";
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) out << mesh.vertex(i).value << '\n';
    out << "End\n";
}

}  // namespace netmesh::tool
