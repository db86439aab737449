// What can be said about a diagram without knowing where it comes from, and how two of them differ.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "tools/io/diagram_file.hpp"
#include "tools/io/vine_file.hpp"

namespace netmesh::tool {

// Empty when the bars are sorted, births are finite and not negative unless they may have any sign, deaths not before
// births, and the only essential class, unless any may be, is one of degree 0, born first; otherwise the first thing
// that is wrong. *at, when asked for, is the bar at fault.
std::string diagram_complaint(const std::vector<Bar>& bars, std::size_t* at = nullptr, bool any_sign = false,
                              bool any_essential = false);

// Index of the first bar in which two sorted diagrams differ, the length of the shorter one included; SIZE_MAX when
// they are equal.
std::size_t first_difference(const std::vector<Bar>& a, const std::vector<Bar>& b);

// "1 0.25 0.5", or "nothing" past the end.
std::string bar_text(const std::vector<Bar>& bars, std::size_t index);

// The diagram of one k, in canonical order.
std::vector<Bar> diagram_at(const Vines& vines, std::uint32_t k);

}  // namespace netmesh::tool
