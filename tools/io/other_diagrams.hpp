// Diagrams as other programs and our own other endings have them.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "tools/io/diagram_file.hpp"
#include "tools/outcome.hpp"

namespace netmesh::tool {

// `degree birth death` a line in the dialects of tables, in the order that a header names, behind the field as
// GUDHI's programs write it or not; what ripser and GUDHI's lists print; our own .csv, .json and .npy, and arrays
// [bars][3] of anybody's; .npz and lists with [birth, death] for each degree; DIPHA's binary files. A class that never
// dies has inf, Inf, Infinity, null or nothing for a death. Any order. Every fault is Exit::data.
// A file that has neither a bar nor a head, a header or brackets is no diagram.
Outcome parse_any_diagram(std::string_view content, const std::string& name, std::vector<Bar>* bars);
// Text as ripser prints it, whose births and deaths are diameters.
bool is_of_ripser(std::string_view content);

}  // namespace netmesh::tool
