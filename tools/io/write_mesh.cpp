#include "tools/io/mesh_files.hpp"

namespace netmesh::tool {

void write_node(const MeshSource& mesh, TextWriter& out) {
    if (mesh.domain[mesh.dim] > 0) {
        out << "# domain";
        for (std::uint32_t k = 0; k <= mesh.dim; k++) out << ' ' << mesh.domain[k];
        mesh.ratio > 0 ? out << "\n# ratio " << mesh.ratio << '\n' : out << "\n# tau " << mesh.tau << '\n';
        if (mesh.ratio > 0 && mesh.clipped) out << "# clipped\n";
        if (mesh.eps > 0) out << "# eps " << mesh.eps << '\n';
        if (mesh.size_at_inputs > 0) out << "# cell-size " << mesh.size_at_inputs << ' ' << mesh.size_growth << '\n';
        if (mesh.net_spacing > 0) out << "# boundary-net " << mesh.net_spacing << '\n';
        if (mesh.has_thesis_cages) out << "# cages thesis\n";
        for (const netmesh_cage& cage : mesh.cages) out << "# cage " << cage.centre << ' ' << cage.radius << '\n';
    }
    out << mesh.vertex_count << ' ' << mesh.dim << (mesh.has_values ? " 1 1\n" : " 0 1\n");
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) {
        const netmesh_vertex vertex = mesh.vertex(i);
        out << i;
        for (std::uint32_t k = 0; k < mesh.dim; k++) out << ' ' << vertex.coordinates[k];
        if (mesh.has_values) out << ' ' << vertex.value;
        out << ' ' << vertex.marker << '\n';
    }
}

void write_ele(const MeshSource& mesh, TextWriter& out) {
    out << mesh.cell_count << ' ' << mesh.dim + 1 << " 0\n";
    for (std::uint64_t i = 0; i < mesh.cell_count; i++) {
        const netmesh_cell cell = mesh.cell(i);
        out << i;
        for (std::uint32_t k = 0; k <= mesh.dim; k++) out << ' ' << cell.vertices[k];
        out << '\n';
    }
}

void write_neigh(const MeshSource& mesh, TextWriter& out) {
    out << mesh.cell_count << ' ' << mesh.dim + 1 << '\n';
    for (std::uint64_t i = 0; i < mesh.cell_count; i++) {
        const netmesh_cell cell = mesh.cell(i);
        out << i;
        for (std::uint32_t k = 0; k <= mesh.dim; k++) {
            if (cell.neighbours[k] == NETMESH_NONE) {
                out << " -1";
            } else {
                out << ' ' << cell.neighbours[k];
            }
        }
        out << '\n';
    }
}

void write_off(const MeshSource& mesh, TextWriter& out) {
    if (mesh.dim == 3) {
        out << "OFF\n";
    } else {
        out << "nOFF\n" << mesh.dim << '\n';
    }
    out << mesh.vertex_count << ' ' << mesh.cell_count << " 0\n";
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) {
        const netmesh_vertex vertex = mesh.vertex(i);
        for (std::uint32_t k = 0; k < mesh.dim; k++) {
            if (k > 0) out << ' ';
            out << vertex.coordinates[k];
        }
        out << '\n';
    }
    for (std::uint64_t i = 0; i < mesh.cell_count; i++) {
        const netmesh_cell cell = mesh.cell(i);
        out << mesh.dim + 1;
        for (std::uint32_t k = 0; k <= mesh.dim; k++) out << ' ' << cell.vertices[k];
        out << '\n';
    }
}

namespace {

void open_array(TextWriter& out, const char* type, const char* name, std::uint32_t components) {
    out << "        <DataArray type=\"" << type << "\" Name=\"" << name << '"';
    if (components > 1) out << " NumberOfComponents=\"" << components << '"';
    out << " format=\"ascii\">\n";
}

void write_vtu_points(const MeshSource& mesh, TextWriter& out) {
    out << "      <Points>\n";
    open_array(out, "Float64", "Points", 3);
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) {
        const netmesh_vertex vertex = mesh.vertex(i);
        out << vertex.coordinates[0] << ' ' << vertex.coordinates[1] << ' ';
        out << (mesh.dim > 2 ? vertex.coordinates[2] : 0.0) << '\n';
    }
    out << "        </DataArray>\n      </Points>\n";
}

void write_vtu_cells(const MeshSource& mesh, TextWriter& out) {
    const std::uint32_t corners = mesh.dim + 1;
    out << "      <Cells>\n";
    open_array(out, "Int64", "connectivity", 1);
    for (std::uint64_t i = 0; i < mesh.cell_count; i++) {
        const netmesh_cell cell = mesh.cell(i);
        for (std::uint32_t k = 0; k < corners; k++) out << cell.vertices[k] << (k + 1 < corners ? ' ' : '\n');
    }
    out << "        </DataArray>\n";
    open_array(out, "Int64", "offsets", 1);
    for (std::uint64_t i = 0; i < mesh.cell_count; i++) out << (i + 1) * corners << '\n';
    out << "        </DataArray>\n";
    open_array(out, "UInt8", "types", 1);
    const char* const type = mesh.dim == 2 ? "5\n" : "10\n";  // VTK_TRIANGLE, VTK_TETRA
    for (std::uint64_t i = 0; i < mesh.cell_count; i++) out << type;
    out << "        </DataArray>\n      </Cells>\n";
}

void write_vtu_point_data(const MeshSource& mesh, TextWriter& out) {
    out << "      <PointData Scalars=\"marker\">\n";
    open_array(out, "UInt8", "marker", 1);
    for (std::uint64_t i = 0; i < mesh.vertex_count; i++) out << mesh.vertex(i).marker << '\n';
    out << "        </DataArray>\n";
    if (mesh.has_values) {
        open_array(out, "Float64", "value", 1);
        for (std::uint64_t i = 0; i < mesh.vertex_count; i++) out << mesh.vertex(i).value << '\n';
        out << "        </DataArray>\n";
    }
    if (!mesh.ratios.empty()) {
        open_array(out, "Float64", "aspect_ratio", 1);
        for (const double ratio : mesh.ratios) out << ratio << '\n';
        out << "        </DataArray>\n";
        open_array(out, "Int64", "domain", 1);
        for (const std::uint32_t domain : mesh.domains) {
            domain == NETMESH_NONE ? out << "-1\n" : out << domain << '\n';
        }
        out << "        </DataArray>\n";
    }
    out << "      </PointData>\n";
}

}  // namespace

void write_vtu(const MeshSource& mesh, TextWriter& out) {
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
           "  <UnstructuredGrid>\n    <Piece NumberOfPoints=\""
        << mesh.vertex_count << "\" NumberOfCells=\"" << mesh.cell_count << "\">\n";
    write_vtu_points(mesh, out);
    write_vtu_cells(mesh, out);
    write_vtu_point_data(mesh, out);
    out << "    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace netmesh::tool
