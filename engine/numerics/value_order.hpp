// Deterministic sorting of values together with their positions.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"

namespace netmesh {

// Sorts value[count] in place, ascending, equal values by position; position[j] becomes the place that value[j] came
// from. Values: no NaN, no -0.0. In-place radix sort from the top digit on the bit patterns: about 5-10 ns a
// value, few passes however the values cluster. Scratch: 40 KiB of the arena, given back. False when that is missing;
// nothing has changed then.
bool sort_values(double* value, std::uint32_t* position, std::uint32_t count, Arena& arena);

// The same with labels of the caller's, which are distinct: label[j] moves with value[j], equal values go by label.
bool sort_labelled(double* value, std::uint32_t* label, std::uint32_t count, Arena& arena);

}  // namespace netmesh
