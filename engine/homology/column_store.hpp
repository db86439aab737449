// What column reductions of an explicit filtration share: sets of simplices and columns that are kept.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"

namespace netmesh {

class Bits {
public:
    static std::size_t words_needed(std::uint32_t size) { return size / 64 + 1; }
    void adopt(std::uint64_t* words, std::uint32_t size) {
        words_ = words;
        for (std::size_t i = 0; i < words_needed(size); ++i) words_[i] = 0;
    }
    bool has(std::uint32_t i) const { return (words_[i >> 6] >> (i & 63) & 1) != 0; }
    void insert(std::uint32_t i) { words_[i >> 6] |= std::uint64_t{1} << (i & 63); }
    void erase(std::uint32_t i) { words_[i >> 6] &= ~(std::uint64_t{1} << (i & 63)); }

private:
    std::uint64_t* words_ = nullptr;
};

// Reduced columns that differ from their boundary, one after the other downwards from where the arena's high end was:
// [rows[row_count], row_count, creator] in words, addressed from the top in steps of 16 bytes.
class ColumnStore {
public:
    explicit ColumnStore(Arena& arena) : arena_(arena), top_(arena.high_mark()) {}

    // Room for a column of n rows; null: out of memory. Its rows are to be filled in at once.
    std::uint32_t* append(std::uint32_t n, std::uint32_t creator, std::uint32_t* handle) {
        const std::size_t bytes = (std::size_t{n} + 2 + 3) / 4 * 16;
        if (used_ / 16 + bytes / 16 >= stored || arena_.take_high<unsigned char>(bytes) == nullptr) return nullptr;
        used_ += bytes;
        *handle = static_cast<std::uint32_t>(used_ / 16);
        std::uint32_t* column = reinterpret_cast<std::uint32_t*>(arena_.at(top_ - used_));
        column[0] = creator;
        column[1] = n;
        return column + 2;
    }
    const std::uint32_t* column(std::uint32_t handle) const {
        return reinterpret_cast<const std::uint32_t*>(arena_.at(top_ - std::size_t{handle} * 16));
    }

    static constexpr std::uint32_t stored = 0x80000000u;  // tells handles from the numbers of unchanged columns

private:
    Arena& arena_;
    std::size_t top_, used_ = 0;
};

}  // namespace netmesh
