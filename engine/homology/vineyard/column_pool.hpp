// Columns over Z/2 that come and go: sorted lists of row numbers in blocks of 2^c words, given back to a list of their
// size.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// `where`: the row itself when there is one, the block when there are more, none when there is none.
struct SparseColumn {
    std::uint32_t where, length;
};

// Blocks lie below where the arena's high end was when the pool was opened; nothing else may be taken there meanwhile.
class ColumnPool {
public:
    // longest: no column has more rows. out_of_memory.
    Status open(Arena& arena, std::uint32_t longest) {
        arena_ = &arena;
        scratch_ = arena.take_high<std::uint32_t>(std::size_t{longest} + 1);
        top_ = arena.high_mark();
        used_ = 0;
        for (std::uint32_t& head : free_) head = none;
        return scratch_ == nullptr ? Status::out_of_memory : Status::ok;
    }

    const std::uint32_t* rows(const SparseColumn& column) const {
        return column.length <= 1 ? &column.where : block(column.where);
    }
    bool has(const SparseColumn& column, std::uint32_t row) const {
        if (column.length <= 1) return column.where == row;
        const std::uint32_t* const list = block(column.where);
        std::uint32_t first = 0, count = column.length;
        while (count > 1) {
            const std::uint32_t half = count / 2;
            if (list[first + half] <= row) first += half;
            count -= half;
        }
        return list[first] == row;
    }

    // column becomes list[0, length), ascending. False: out of memory, and then the column is as before.
    bool assign(SparseColumn& column, const std::uint32_t* list, std::uint32_t length) {
        SparseColumn fresh = {none, length};
        if (length == 1) {
            fresh.where = list[0];
        } else if (length > 1) {
            if (length >= 64) arena_->pass(length / 8);
            if (!take(size_class(length), &fresh.where)) return false;
            __builtin_memcpy(block(fresh.where), list, std::size_t{length} * 4);
        }
        release(column);
        column = fresh;
        return true;
    }
    // column becomes the sum of itself and other. False: out of memory, as before.
    bool add(SparseColumn& column, const SparseColumn& other) {
        const std::uint32_t* a = rows(column);
        const std::uint32_t* b = rows(other);
        const std::uint32_t* const a_end = a + column.length;
        const std::uint32_t* const b_end = b + other.length;
        std::uint32_t length = 0;
        while (a < a_end && b < b_end) {
            if (*a == *b) {
                ++a;
                ++b;
            } else {
                scratch_[length++] = *a < *b ? *a++ : *b++;
            }
        }
        while (a < a_end) scratch_[length++] = *a++;
        while (b < b_end) scratch_[length++] = *b++;
        return assign(column, scratch_, length);
    }
    void release(SparseColumn& column) {
        if (column.length > 1) {
            const std::uint32_t size = size_class(column.length);
            block(column.where)[0] = free_[size];
            free_[size] = column.where;
        }
        column = {none, 0};
    }

private:
    static constexpr std::uint32_t classes = 32;
    // Blocks of 4 << size words.
    static std::uint32_t size_class(std::uint32_t length) {
        std::uint32_t size = 0;
        while ((std::uint32_t{4} << size) < length) ++size;
        return size;
    }
    std::uint32_t* block(std::uint32_t number) const {
        return reinterpret_cast<std::uint32_t*>(arena_->at(top_ - std::size_t{number} * 16));
    }
    bool take(std::uint32_t size, std::uint32_t* number) {
        if (free_[size] != none) {
            *number = free_[size];
            free_[size] = block(*number)[0];
            return true;
        }
        const std::size_t bytes = std::size_t{16} << size;
        if (used_ / 16 + bytes / 16 >= none || !arena_->extend_high(bytes)) return false;
        used_ += bytes;
        *number = static_cast<std::uint32_t>(used_ / 16);
        return true;
    }

    Arena* arena_ = nullptr;
    std::uint32_t* scratch_ = nullptr;
    std::size_t top_ = 0, used_ = 0;
    std::uint32_t free_[classes];
};

}  // namespace netmesh
