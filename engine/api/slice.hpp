// Where results lie in the block: offsets from its start, never addresses, so that a byte copy of the block is whole.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"

namespace netmesh {

// count objects of T. The context stands at the start of the block, so that its present address resolves the offset.
template <class T> struct Slice {
    std::uint64_t offset = 0, count = 0;

    static Slice of(const Arena& arena, const T* first, std::uint64_t count) {
        return {static_cast<std::uint64_t>(arena.offset_of(first)), count};
    }
    T* in(void* block) const { return reinterpret_cast<T*>(static_cast<unsigned char*>(block) + offset); }
    const T* in(const void* block) const {
        return reinterpret_cast<const T*>(static_cast<const unsigned char*>(block) + offset);
    }
};

}  // namespace netmesh
