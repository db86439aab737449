// Cycles as things that ParaView and MeshLab show: .vtu and .obj.
#include <algorithm>

#include "tools/io/cycle_file.hpp"

namespace netmesh::tool {

namespace {

using Simplex = std::vector<std::uint32_t>;

void open_array(TextWriter& out, const char* type, const char* name, const char* more = "") {
    out << "        <DataArray type=\"" << type << "\" Name=\"" << name << "\"" << more << " format=\"ascii\">\n";
}
constexpr const char* close_array = "        </DataArray>\n";

template <class Visit> void for_each_simplex(const std::vector<CycleEntry>& cycles, Visit visit) {
    for (std::size_t i = 0; i < cycles.size(); i++)
        for (const Simplex& simplex : cycles[i].simplices) visit(i, simplex);
}

// VTK's vertex, line, triangle and tetrahedron; of more vertices only these.
std::uint64_t vtk_type(std::size_t vertices) {
    constexpr std::uint64_t types[] = {1, 3, 5, 10};
    return vertices <= 4 ? types[vertices - 1] : 2;
}

void write_places(const CyclePlaces& places, const char* start, TextWriter& out) {
    const std::size_t count = places.coordinates.size() / places.dim;
    for (std::size_t v = 0; v < count; v++) {
        const double* const place = &places.coordinates[v * places.dim];
        out << start << place[0] << ' ' << place[1] << ' ' << (places.dim > 2 ? place[2] : 0.0) << '\n';
    }
}

}  // namespace

void write_cycles_vtu(const std::vector<CycleEntry>& cycles, const CyclePlaces& places, TextWriter& out) {
    std::uint64_t cells = 0, offset = 0;
    for_each_simplex(cycles, [&](std::size_t, const Simplex&) { cells++; });
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n  <UnstructuredGrid>\n    <Piece NumberOfPoints=\""
        << std::uint64_t{places.coordinates.size() / places.dim} << "\" NumberOfCells=\"" << cells
        << "\">\n      <Points>\n";
    open_array(out, "Float64", "Points", " NumberOfComponents=\"3\"");
    write_places(places, "", out);
    out << close_array << "      </Points>\n      <Cells>\n";
    open_array(out, "Int64", "connectivity");
    for_each_simplex(cycles, [&](std::size_t, const Simplex& simplex) {
        for (std::size_t v = 0; v < simplex.size(); v++) out << simplex[v] << (v + 1 < simplex.size() ? ' ' : '\n');
    });
    out << close_array;
    open_array(out, "Int64", "offsets");
    for_each_simplex(cycles, [&](std::size_t, const Simplex& simplex) { out << (offset += simplex.size()) << '\n'; });
    out << close_array;
    open_array(out, "UInt8", "types");
    for_each_simplex(cycles, [&](std::size_t, const Simplex& simplex) { out << vtk_type(simplex.size()) << '\n'; });
    out << close_array << "      </Cells>\n      <CellData Scalars=\"bar\">\n";
    open_array(out, "Int64", "bar");
    for_each_simplex(cycles, [&](std::size_t i, const Simplex&) { out << std::uint64_t{i} << '\n'; });
    out << close_array;
    open_array(out, "Int64", "degree");
    for_each_simplex(cycles, [&](std::size_t i, const Simplex&) { out << cycles[i].bar.degree << '\n'; });
    out << close_array;
    open_array(out, "Float64", "birth");
    for_each_simplex(cycles, [&](std::size_t i, const Simplex&) { out << cycles[i].bar.birth << '\n'; });
    out << close_array;
    open_array(out, "Float64", "death");
    for_each_simplex(cycles, [&](std::size_t i, const Simplex&) { out << cycles[i].bar.death << '\n'; });
    out << close_array << "      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
}

void write_cycles_obj(const std::vector<CycleEntry>& cycles, const CyclePlaces& places, TextWriter& out) {
    out << "# netmesh: a group for each bar, g bar_NUMBER_degree_DEGREE\n";
    write_places(places, "v ", out);
    for (std::size_t i = 0; i < cycles.size(); i++) {
        const Bar& bar = cycles[i].bar;
        out << "# " << bar.degree << ' ' << bar.birth << ' ' << bar.death << "\ng bar_" << std::uint64_t{i}
            << "_degree_" << bar.degree << '\n';
        for (const Simplex& simplex : cycles[i].simplices) {
            if (simplex.size() < 3) {
                out << (simplex.size() == 1 ? "p" : "l");
                for (const std::uint32_t v : simplex) out << ' ' << std::uint64_t{v} + 1;
                out << '\n';
                continue;
            }
            for (std::size_t a = 0; a < simplex.size(); a++)  // of a tetrahedron its four triangles
                for (std::size_t b = a + 1; b < simplex.size(); b++)
                    for (std::size_t c = b + 1; c < simplex.size(); c++)
                        out << "f " << std::uint64_t{simplex[a]} + 1 << ' ' << std::uint64_t{simplex[b]} + 1 << ' '
                            << std::uint64_t{simplex[c]} + 1 << '\n';
        }
    }
}

}  // namespace netmesh::tool
