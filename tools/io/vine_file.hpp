// Vineyards in files: comments, then lines `vine degree k birth death`, sorted by vine, then k.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "netmesh.h"
#include "tools/io/text_writer.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

struct Vines {
    std::uint32_t k_first = 1;
    std::vector<double> ratios;  // certified, of k_first, k_first + 1, ...
    std::vector<netmesh_vine_point> points;
};

// Copies the vineyard out of a context that holds one.
Vines vines_of(const netmesh_context* context);

// The comments name the format, what is filtered, and the certified ratio of each k.
void write_vines(const Vines& vines, const netmesh_report& report, TextWriter& out);

// A .vines file as it was read. Faults of its form are Exit::data with file and line.
struct VineFile {
    Vines vines;
    netmesh_filter filter = NETMESH_FILTER_NONE;
    netmesh_values values = NETMESH_VALUES_CERTIFIED;
    std::vector<std::uint64_t> lines;  // of each point
};
Outcome parse_vines(std::string_view content, const std::string& name, VineFile* file);

}  // namespace netmesh::tool
