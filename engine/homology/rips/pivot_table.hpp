// Pivots of implicit columns.
#pragma once
#include <cstddef>
#include <cstdint>

#include "homology/check_reduction.hpp"
#include "homology/rips/rips_simplices.hpp"
#include "memory/arena.hpp"

namespace netmesh {

// The simplices that are pivots and the columns that own them, by open addressing.
class PivotTable {
public:
    // For so many pivots. False: out of memory.
    bool open(std::uint32_t pivots, Arena& arena) {
        bits_ = 4;
        while ((std::uint64_t{1} << bits_) < pivots + std::uint64_t{pivots} / 2) ++bits_;
        const std::size_t slots = std::size_t{1} << bits_;
        key_ = arena.take_high<std::uint64_t>(slots);
        column_ = arena.take_high<std::uint32_t>(slots);
        if (key_ != nullptr) arena.each(slots, 1, [this](std::uint64_t i) { key_[i] = no_key; });
        return key_ != nullptr && column_ != nullptr;
    }
    void insert(std::uint64_t key, std::uint32_t column) {
        const std::size_t at = place_of(key);
        key_[at] = key;
        column_[at] = column;
    }
    // The column of a pivot, `none` if it is not one.
    std::uint32_t find(std::uint64_t key) const {
        const std::size_t at = place_of(key);
        return key_[at] == key ? column_[at] : none;
    }
    bool has(std::uint64_t key) const { return key_[place_of(key)] == key; }
#ifdef NETMESH_VALIDATE
    // Whether each pivot is found where it is and no column owns two. Two pivots of up to validated_columns_max columns
    // are compared with each other.
    const char* violation() const {
        const std::size_t slots = std::size_t{1} << bits_;
        for (std::size_t at = 0; slots <= 4 * validated_columns_max && at < slots; ++at) {
            if (key_[at] == no_key) continue;
            if (place_of(key_[at]) != at) return "a pivot is in the table twice";
            for (std::size_t other = 0; other < at; ++other)
                if (key_[other] != no_key && column_[other] == column_[at]) return "a column owns two pivots";
        }
        return nullptr;
    }
#endif
    // Moves the keys up so that they end at `end`; the columns are gone. Returns where they begin.
    std::size_t keep_keys(Arena& arena, std::size_t end) {
        const std::size_t bytes = sizeof(std::uint64_t) << bits_;
        auto* const to = reinterpret_cast<std::uint64_t*>(arena.at(end - bytes));
        move_bytes(to, key_, bytes, arena);
        key_ = to;
        column_ = nullptr;
        return end - bytes;
    }

private:
    std::size_t place_of(std::uint64_t key) const {
        const std::size_t mask = (std::size_t{1} << bits_) - 1;
        std::size_t at = static_cast<std::size_t>(key * 0x9E3779B97F4A7C15u >> (64 - bits_));
        while (key_[at] != no_key && key_[at] != key) at = (at + 1) & mask;
        return at;
    }

    std::uint64_t* key_ = nullptr;
    std::uint32_t *column_ = nullptr, bits_ = 4;
};

}  // namespace netmesh
