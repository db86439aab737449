// Representatives in files: for each bar a line `bar DEGREE BIRTH DEATH N`, then N simplices, their vertices one a
// line. With periods a vertex that is not at its own place has its translation behind it, as in 12:0,-1.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tools/io/diagram_file.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

struct CycleEntry {
    Bar bar;
    std::vector<std::vector<std::uint32_t>> simplices;  // vertices ascending
    std::uint64_t line = 0;                             // of `bar`
};

// Where the vertices of cycles are, D = 2 and 3.
struct CyclePlaces {
    std::uint32_t dim = 0;
    std::vector<double> coordinates;        // [vertices][dim]
    std::size_t inputs = 0;                 // so many of the first are input points
    std::vector<std::uint32_t> cells = {};  // [..][dim + 1], of the Delaunay triangulation that an alpha diagram is of
    bool all_chosen = false;                // bars were chosen by the user; else pictures choose
    std::vector<double> lattice = {};       // [..][dim], with periods: vertices of cycles are copies of the inputs
};
// VTK's unstructured grid of vertices, lines, triangles and tetrahedra, with cell data bar, degree, birth and death.
void write_cycles_vtu(const std::vector<CycleEntry>& cycles, const CyclePlaces& places, TextWriter& out);
// A group for each bar, of points, lines or triangles.
void write_cycles_obj(const std::vector<CycleEntry>& cycles, const CyclePlaces& places, TextWriter& out);

// Faults are Exit::data with file and line.
Outcome parse_cycles(std::string_view content, const std::string& name, std::vector<CycleEntry>* cycles);

}  // namespace netmesh::tool
