// Filtered simplicial complexes in files: one simplex a line, its vertices and then its value.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "tools/io/points.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

struct SimplexFile {
    PointCloud lines;  // name and lines, one a simplex; no points
    std::vector<std::uint32_t> vertices;
    std::vector<std::uint64_t> starts = {0};  // [simplices + 1]
    std::vector<double> values;               // finite
    std::size_t count() const { return values.size(); }
};

// The separators of point files. Vertices are whole numbers below 2^32, 1 to 32 in a line. Faults are Exit::data with
// file and line; whether the simplices make a complex is not looked at.
Outcome parse_simplices(std::string_view content, SimplexFile* file);

// "5 7 9", the vertices of simplex i in ascending order; without the vertex at place `skip` of that order.
std::string simplex_text(const SimplexFile& file, std::uint64_t i, std::uint64_t skip = UINT64_MAX);

// Vectors of values in files: one a line, all of one length.
struct ValueFile {
    PointCloud lines;            // name and lines, one a vector; no points
    std::vector<double> values;  // [vectors][width], finite
    std::size_t width = 0;
    std::size_t count() const { return lines.lines.size(); }
    bool by_vertex = false;
};

// Each line has a value for each simplex of `complex`, or for each simplex of one vertex (by_vertex), in the order of
// its lines. Faults are Exit::data with file and line.
Outcome parse_values(std::string_view content, const SimplexFile& complex, ValueFile* file);

}  // namespace netmesh::tool
