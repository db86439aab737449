// A function that is known at the vertices of a mesh alone: the values of --values-at, one a line in a file.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tools/io/points.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

// A value on each line that holds something, # starts a comment. `cloud.rows()` of them, in the order of the vertices
// in their file; lines[v] is the line of v's. Exit::data with file and line for what is no number, for two on one line
// and for too many or too few.
Outcome parse_vertex_values(std::string_view content, const std::string& name, const PointCloud& cloud,
                            std::vector<double>* values, std::vector<std::uint64_t>* lines);

class VertexFunction {
public:
    // Reads the file; the cloud, of different points, is copied. Faults as above, Exit::data where it cannot be read.
    static Outcome read(const std::string& path, const PointCloud& cloud, VertexFunction* function);

    // At a vertex, by its coordinates; elsewhere no number.
    double operator()(const double* x) const;

    // "FILE:12", the line of a vertex's value.
    std::string where(std::size_t vertex) const { return name_ + ":" + std::to_string(lines_[vertex]); }
    // Of the values in their order, and of the vertices' coordinates: 16 hexadecimal digits each.
    std::string values_fingerprint() const { return fingerprint(values_); }
    std::string mesh_fingerprint() const { return fingerprint(coordinates_); }

private:
    static std::string fingerprint(const std::vector<double>& numbers);
    int compare(std::size_t vertex, const double* x) const;

    std::string name_;
    std::uint32_t dim_ = 0;
    std::vector<double> coordinates_, values_;
    std::vector<std::uint64_t> lines_;
    std::vector<std::size_t> sorted_;  // vertices by their coordinates
};

}  // namespace netmesh::tool
