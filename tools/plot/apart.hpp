// Which bars stand apart from the others: what pictures mark and draw cycles of.
#pragma once
#include <cstddef>
#include <vector>

#include "tools/io/diagram_file.hpp"

namespace netmesh::tool {

// Death less birth; infinite for bars that never die.
double length_of(const Bar& bar);

// How many of the lengths, which descend, stand apart: all that are infinite, and of the others, at most 12, those
// above the largest gap, where a length is at least 1.5 times the next one. Only lengths above 0 count; below
// the last of at most 8 is a gap, too, as of 2.5.
std::size_t count_apart(const std::vector<double>& lengths);

}  // namespace netmesh::tool
