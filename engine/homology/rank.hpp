// Vertices in the order of a lower-star filtration.
#pragma once
#include <cstdint>

#include "memory/arena.hpp"

namespace netmesh {

// order[count]: the vertices by value, then index; rank[count]: its inverse. 0.0 and -0.0 are equal; no NaN.
// Radix sort with 16 bytes a vertex of scratch at the high end, given back. False: out of memory.
bool rank_vertices(const double* value, std::uint32_t count, Arena& arena, std::uint32_t* order, std::uint32_t* rank);

}  // namespace netmesh
