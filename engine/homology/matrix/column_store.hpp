// Columns that are kept, one after the other downwards from where the arena's high end was.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"

namespace netmesh {

// A column is [number | count | entries[count]] in words, addressed from the top in steps of 16 bytes. While columns
// are appended nothing else may be taken at the high end.
class ColumnStore {
public:
    static constexpr std::uint32_t stored = 0x80000000u;  // tells handles from the numbers of columns
    static constexpr std::uint32_t count_max = 0xFFFFFFEFu;

    void open(Arena& arena) {
        arena_ = &arena;
        top_ = arena.high_mark();
        used_ = 0;
    }
    // Room for a column of that number with `count` entries, which are to be filled in at once; null: out of memory.
    // *handle has the bit `stored`.
    std::uint32_t* append(std::uint64_t count, std::uint32_t number, std::uint32_t* handle) {
        if (count > count_max) return nullptr;
        const std::size_t bytes = (static_cast<std::size_t>(count) + 2 + 3) / 4 * 16;
        if (used_ / 16 + bytes / 16 >= stored || arena_->take_high<unsigned char>(bytes) == nullptr) return nullptr;
        used_ += bytes;
        *handle = stored | static_cast<std::uint32_t>(used_ / 16);
        std::uint32_t* const column = reinterpret_cast<std::uint32_t*>(arena_->at(top_ - used_));
        column[0] = number;
        column[1] = static_cast<std::uint32_t>(count);
        return column + 2;
    }
    const std::uint32_t* column(std::uint32_t handle) const { return column_below(*arena_, top_, handle); }
    // The same for a store that ended up below `top`.
    static const std::uint32_t* column_below(const Arena& arena, std::size_t top, std::uint32_t handle) {
        return reinterpret_cast<const std::uint32_t*>(arena.at(top - std::size_t{handle & ~stored} * 16));
    }

private:
    Arena* arena_ = nullptr;
    std::size_t top_ = 0, used_ = 0;
};

}  // namespace netmesh
