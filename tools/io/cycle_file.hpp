// Representatives in files: for each bar a line `bar DEGREE BIRTH DEATH N`, then N simplices, their vertices one a
// line.
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
    std::uint64_t line;                                 // of `bar`
};

// Faults are Exit::data with file and line.
Outcome parse_cycles(std::string_view content, const std::string& name, std::vector<CycleEntry>* cycles);

}  // namespace netmesh::tool
