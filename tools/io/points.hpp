// Point clouds from files of every format the tool reads.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "netmesh.h"
#include "tools/io/table.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

constexpr std::uint32_t dim_min = NETMESH_DIM_MIN, dim_max = NETMESH_DIM_MAX;

struct PointCloud {
    std::string name;                  // the file as the user wrote it, <stdin> for "-"
    std::uint32_t dim = 0;             // 2..6; more where these were asked for
    std::vector<double> coordinates;   // [rows][dim], finite, no -0.0
    std::vector<double> weights;       // [rows], radii or weights; empty: none
    Lattice lattice;                   // by which they repeat; the cell of the file, where that was asked for
    std::vector<std::uint64_t> lines;  // physical line of each row, counted from 1; empty for binary formats
    FileCell cell;                     // of atoms
    std::string note;                  // what was left out or understood; empty when nothing
    bool has_slip = false;             // the note says what may be a slip (slips.hpp)

    std::size_t rows() const { return dim == 0 ? 0 : coordinates.size() / dim; }
    // Which coordinate is the same in all of at least two points: "coordinate 3 is 0 in all points; without it, by
    // --columns, ..."; empty where none is, and where two coordinates would not be left.
    std::string constant_coordinate() const;
    // Leaves such coordinates out, all of them, where two others are left: an isometric copy. "left out what is
    // the same in all points: coordinate 3 is 0"; empty where there is nothing to leave out.
    std::string leave_out_constant();
    // FILE:LINE of a row, or "FILE: row N" (counted from 1) where rows are not lines.
    std::string where(std::uint64_t row) const;
    // What is wrong there.
    Outcome fault(std::uint64_t row, const std::string& complaint, Exit exit = Exit::data) const {
        return {exit, where(row) + ": " + complaint, name, row < lines.size() ? lines[row] : 0};
    }
    // "line 7" or "row 7".
    std::string place(std::uint64_t row) const;
};

// Reads `path` ("-" is stdin). Its ending says what it holds: .npy .npz .off .ply .node .obj .stl .pdb .ent .pqr, of
// FILE.npz:NAME one array; .xyz with a number of atoms in front is a list of these; anything else is a table in text.
// .gz around any of them is unpacked. Content that gives itself away as another format is read as that where there is
// no ending, and refused where the ending says something else. A lattice of another dimension is Exit::usage; how many
// points are outside of its period stands in the note, as does a cell that is not asked for. Every fault is Exit::data
// with file and line and, where there is one, what to do; options of tables for something else are Exit::usage; an
// interrupt while reading is Exit::cancelled.
Outcome read_points(const std::string& path, const TableOptions& options, PointCloud* cloud,
                    std::uint32_t columns_max = dim_max);
inline Outcome read_points(const std::string& path, PointCloud* cloud) { return read_points(path, {}, cloud); }
// The same with any number of columns.
Outcome read_table(const std::string& path, const TableOptions& options, Table* table);
// Distances: an array of NumPy, of one axis or two, into *table, the content of anything else into *text. The table's
// name is set in both cases.
Outcome read_numbers(const std::string& path, Table* table, std::string* text);
// A table as points: Exit::data unless it has 2 to `columns_max` columns, besides one of weights.
Outcome take_table(Table table, PointCloud* cloud, std::uint32_t columns_max = dim_max);
// "; 6 numbers may be the distances of 4 points, ..": of n (n - 1) / 2 numbers, as scipy's pdist has them.
std::string remedy_for_condensed(std::uint64_t count);
// Exit::data at the first radius below 0.
Outcome check_radii(const PointCloud& cloud);

// The formats one by one, on content that is already in memory. cloud->name is used for messages only.
Outcome parse_text_points(std::string_view content, const TableOptions& options, PointCloud* cloud);
inline Outcome parse_text_points(std::string_view content, PointCloud* cloud) {
    return parse_text_points(content, {}, cloud);
}
Outcome parse_npy_points(std::string_view content, PointCloud* cloud);
Outcome parse_off_points(std::string_view content, PointCloud* cloud);
Outcome parse_ply_points(std::string_view content, PointCloud* cloud);
Outcome parse_node_points(std::string_view content, PointCloud* cloud);
Outcome parse_obj_points(std::string_view content, PointCloud* cloud);
Outcome parse_stl_points(std::string_view content, PointCloud* cloud);
// With their radii, where these are wanted: of .pqr those of the file, else van der Waals's by element.
Outcome parse_xyz_atoms(std::string_view content, bool with_radii, PointCloud* cloud);
Outcome parse_pdb_atoms(std::string_view content, bool with_radii, PointCloud* cloud);
Outcome parse_pqr_atoms(std::string_view content, bool with_radii, PointCloud* cloud);
Outcome parse_npy_table(std::string_view content, const TableOptions& options, Table* table);
// The array of that name, or the only one.
Outcome parse_npz_table(std::string_view content, const std::string& array, const TableOptions& options, Table* table);

// What gives itself away: a number of atoms and their lines; a size that fits the number of triangles.
bool is_chemical_xyz(std::string_view content);
bool is_binary_stl(std::string_view content);

// The ending of a file name in lower case, dot included; empty when there is none.
std::string ending_of(const std::string& path);

// Content of a file, stdin for "-", unpacked where it is gzip (*packed, when asked for); Exit::data "FILE: why" or
// Exit::cancelled otherwise.
Outcome read_content(const std::string& path, std::string* content, bool* packed = nullptr);
// How messages call the file: <stdin> for "-".
std::string shown_name(const std::string& path);

}  // namespace netmesh::tool
