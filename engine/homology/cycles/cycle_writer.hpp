// Cycles of a filtration whose complex is not stored: each a list of simplices by their vertices.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"

namespace netmesh {

// Cycles one after the other at the arena's low end, where nobody else may take memory meanwhile:
// [count | vertices[count][degree + 1]] in words, addressed from the first one in steps of 16 bytes, from 1.
class CycleWriter {
public:
    explicit CycleWriter(Arena& arena)
        : arena_(arena), begin_((arena.low_mark() + Arena::alignment - 1) & ~(Arena::alignment - 1)) {}

    std::size_t begin() const { return begin_; }
    // Room for a cycle of `count` simplices; null: out of memory. Its vertices are to be filled in.
    std::uint32_t* append(std::uint64_t count, std::uint32_t degree, std::uint32_t* handle) {
        const std::uint64_t words = count * (std::uint64_t{degree} + 1) + 1, steps = (words + 3) / 4;
        if (count >= none || steps_ + steps >= none || steps > SIZE_MAX / 64) return nullptr;
        auto* const cycle = arena_.take_low<std::uint32_t>(static_cast<std::size_t>(steps) * 4);
        if (cycle == nullptr) return nullptr;
        *handle = static_cast<std::uint32_t>(steps_ + 1);
        steps_ += steps;
        cycle[0] = static_cast<std::uint32_t>(count);
        return cycle + 1;
    }

private:
    Arena& arena_;
    std::size_t begin_;
    std::uint64_t steps_ = 0;
};

}  // namespace netmesh
