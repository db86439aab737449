// Point clouds from files of every format the tool reads.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "netmesh.h"
#include "tools/outcome.hpp"

namespace netmesh::tool {

constexpr std::uint32_t dim_min = NETMESH_DIM_MIN, dim_max = NETMESH_DIM_MAX;

struct PointCloud {
    std::string name;                  // the file as the user wrote it, <stdin> for "-"
    std::uint32_t dim = 0;             // 2..6
    std::vector<double> coordinates;   // [rows][dim], finite, no -0.0
    std::vector<std::uint64_t> lines;  // physical line of each row, counted from 1; empty for binary formats

    std::size_t rows() const { return dim == 0 ? 0 : coordinates.size() / dim; }
    // FILE:LINE of a row, or "FILE: row N" (counted from 1) where rows are not lines.
    std::string where(std::uint64_t row) const;
    // "line 7" or "row 7".
    std::string place(std::uint64_t row) const;
};

// Reads `path` ("-" is stdin, always text) by its ending: .npy .off .ply .node, anything else is text. Every fault is
// Exit::data with file and line; an interrupt while reading is Exit::cancelled.
Outcome read_points(const std::string& path, PointCloud* cloud);

// The formats one by one, on content that is already in memory. cloud->name is used for messages only.
Outcome parse_text_points(std::string_view content, PointCloud* cloud);
Outcome parse_npy_points(std::string_view content, PointCloud* cloud);
Outcome parse_off_points(std::string_view content, PointCloud* cloud);
Outcome parse_ply_points(std::string_view content, PointCloud* cloud);
Outcome parse_node_points(std::string_view content, PointCloud* cloud);

// The ending of a file name in lower case, dot included; empty when there is none.
std::string ending_of(const std::string& path);

// Content of a file, stdin for "-"; Exit::data "FILE: why" or Exit::cancelled otherwise.
Outcome read_content(const std::string& path, std::string* content);
// How messages call the file: <stdin> for "-".
std::string shown_name(const std::string& path);

}  // namespace netmesh::tool
