// Vineyards in files: comments, then lines `vine degree k birth death`, sorted by vine, then k.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "netmesh.hpp"
#include "tools/filters.hpp"
#include "tools/io/text_writer.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

struct Vines {
    std::uint32_t k_first = 1;
    std::vector<double> ratios;  // certified, of k_first, k_first + 1, ...
    std::vector<netmesh_vine_point> points;
};

// Copies the vineyard out of an engine that holds one.
Vines vines_of(const Engine& engine);

// The comments name the format, what is filtered, and the certified ratio of each k.
void write_vines(const Vines& vines, const netmesh_vineyard_report& report, TextWriter& out);
// The line of one point, without its end.
void write_vine_point(const netmesh_vine_point& point, TextWriter& out);

// A .vines file as it was read. Faults of its form are Exit::data with file and line.
struct VineFile {
    Vines vines;
    FilterChoice choice;
    bool of_values = false;            // of a complex and values of the user's; k is the step
    std::vector<std::uint64_t> lines;  // of each point
};
Outcome parse_vines(std::string_view content, const std::string& name, VineFile* file);

}  // namespace netmesh::tool
