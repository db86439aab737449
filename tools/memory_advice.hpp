// What to do where a block of memory was too small.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

#include "tools/options.hpp"

namespace netmesh::tool {

// "--fit finds the best ratio that fits; --filter alpha is exact: plan for 60 KiB": what the options could say
// instead so that `points` points of R^dim fit into `bytes`, or take less. Empty where nothing helps but more memory.
std::string memory_advice(const Options& options, std::uint32_t dim, std::size_t points, std::size_t bytes);

}  // namespace netmesh::tool
