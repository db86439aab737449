// Bytes to plan for, as calls return them.
#pragma once
#include <cstddef>

namespace netmesh {

// Rounded up to the block's alignment; SIZE_MAX when they do not fit a size_t.
std::size_t whole_bytes(double bytes);

}  // namespace netmesh
