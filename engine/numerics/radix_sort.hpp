// Stable sort of (64-bit key, 32-bit item) pairs.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"

namespace netmesh {

// Sorts keys[0..count) ascending and carries items along; equal keys keep their order. spare_keys and spare_items have
// count entries each and hold nothing afterwards. O(count) for each 8-bit digit in which keys differ. `arena` is told
// of the work.
void radix_sort(std::uint64_t* keys, std::uint32_t* items, std::uint64_t* spare_keys, std::uint32_t* spare_items,
                std::size_t count, const Arena& arena);

#ifdef __OPTIMIZE_SIZE__
// Sorts by key, equal keys by item, O(count log count), with nothing to spare. keys: the bytes of 64-bit numbers, which
// may stand in the place of doubles.
void sort_keys(void* keys, std::uint32_t* items, std::size_t count, const Arena& arena);
#endif

}  // namespace netmesh
