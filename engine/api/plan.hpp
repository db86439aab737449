// Bytes to plan for, as calls return them.
#pragma once
#include <cstddef>

namespace netmesh {

// What small jobs on complexes take besides what is in proportion to them: tables and scratch of sorting.
constexpr double complex_overhead = 20480;

// Rounded up to the block's alignment; SIZE_MAX when they do not fit a size_t.
std::size_t whole_bytes(double bytes);

}  // namespace netmesh
