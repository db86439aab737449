// A set of integers 0..size-1 as bits under a 64-ary tree: the pivot column of a Z/2 reduction. Adding a column is a
// sequence of toggles, its pivot the largest member.
#pragma once
#include <cstddef>
#include <cstdint>

#include "numerics/bits.hpp"
#include "vocabulary/ids.hpp"

namespace netmesh {

class BitTree {
public:
    // 64-bit words that a tree over 0..size-1 needs: size/63 and a few.
    static std::size_t words_needed(std::uint32_t size) {
        std::size_t total = 0;
        std::size_t n = size;
        do {
            n = (n + 63) / 64;
            total += n;
        } while (n > 1);
        return total;
    }

    // Takes over words[words_needed(size)] as the empty set. size >= 1. O(size / 64).
    void adopt(std::uint64_t* words, std::uint32_t size) {
        levels_ = 0;
        std::size_t n = size;
        do {
            n = (n + 63) / 64;
            level_[levels_++] = words;
            for (std::size_t i = 0; i < n; ++i) words[i] = 0;
            words += n;
        } while (n > 1);
    }

    bool empty() const { return *level_[levels_ - 1] == 0; }
    bool has(std::uint32_t i) const { return (level_[0][i >> 6] >> (i & 63) & 1) != 0; }

    // Adds i modulo 2.
    void toggle(std::uint32_t i) {
        const std::uint64_t old = level_[0][i >> 6];
        const std::uint64_t now = old ^ (std::uint64_t{1} << (i & 63));
        level_[0][i >> 6] = now;
        if (old == 0 || now == 0) spread(i >> 6, now != 0);
    }
    void insert(std::uint32_t i) {
        if (!has(i)) toggle(i);
    }

    // The largest member, `none` when empty.
    std::uint32_t top() const {
        int l = levels_ - 1;
        if (*level_[l] == 0) return none;
        std::uint32_t i = 0;
        for (; l >= 0; --l) i = i << 6 | highest_bit(level_[l][i]);
        return i;
    }
    // The largest member below i < size that is in i's word or the one before; `none` when there is none.
    std::uint32_t near_below(std::uint32_t i) const {
        std::uint32_t word = i >> 6;
        std::uint64_t members = level_[0][word] & ((std::uint64_t{1} << (i & 63)) - 1);
        if (members == 0 && word > 0) members = level_[0][--word];
        return members == 0 ? std::uint32_t{none} : word << 6 | highest_bit(members);
    }

private:
    // Word i of level 0 became non-zero (zero): tells the levels above.
    void spread(std::uint32_t i, bool filled) {
        for (int l = 1; l < levels_; ++l, i >>= 6) {
            const std::uint64_t bit = std::uint64_t{1} << (i & 63);
            const std::uint64_t old = level_[l][i >> 6];
            const std::uint64_t now = filled ? old | bit : old & ~bit;
            level_[l][i >> 6] = now;
            if ((filled ? old : now) != 0) return;
        }
    }

    std::uint64_t* level_[6];
    int levels_ = 0;
};

}  // namespace netmesh
