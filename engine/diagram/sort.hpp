// The canonical order of a diagram.
#pragma once
#include <cstdint>

#include "diagram/pair.hpp"

namespace netmesh {

// Sorts pairs[0, count) by degree, birth, death, in place; no NaN. O(count log count).
void sort_pairs(Pair* pairs, std::uint64_t count);

}  // namespace netmesh
