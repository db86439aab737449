// Vineyards in files: comments, then lines `vine degree k birth death`, sorted by vine, then k.
#pragma once
#include <cstdint>
#include <vector>

#include "netmesh.h"
#include "tools/io/text_writer.hpp"

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

}  // namespace netmesh::tool
