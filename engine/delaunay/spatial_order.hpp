// The order in which points are inserted: biased random rounds, along a Hilbert curve inside a round.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// order[0..count): a permutation of 0..count-1. Point i is the D doubles at coordinates + i * stride_bytes (stride may
// be negative, as vertices grow downwards), all finite, no -0.0. Equal points are neighbours in the order, the one with
// the smallest index first; *repeats is false when there surely are none. Each round holds about a quarter of the
// points of the next one; without rounds all are along one curve. Depends only on values and seed. Points that share a
// cell of the curve's grid get a finer grid of their own, so the order stays spatial for any spread. Scratch: 20 bytes
// a point, released on return. O(n) for moderate spread. out_of_memory.
template <int D>
Status spatial_order(const unsigned char* coordinates, std::ptrdiff_t stride_bytes, std::uint32_t count,
                     std::uint64_t seed, Arena& arena, std::uint32_t* order, bool* repeats, bool in_rounds = true);

}  // namespace netmesh
