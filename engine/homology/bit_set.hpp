// A set of integers 0..size-1 as bits.
#pragma once
#include <cstddef>
#include <cstdint>

namespace netmesh {

class BitSet {
public:
    static std::size_t words_needed(std::uint32_t size) { return size / 64 + 1; }
    // Takes over words[words_needed(size)] as the empty set.
    void adopt(std::uint64_t* words, std::uint32_t size) {
        words_ = words;
        for (std::size_t i = 0; i < words_needed(size); ++i) words_[i] = 0;
    }
    // The same of words that say which are in the set.
    void adopt_filled(std::uint64_t* words) { words_ = words; }
    bool has(std::uint32_t i) const { return (words_[i >> 6] >> (i & 63) & 1) != 0; }
    void insert(std::uint32_t i) { words_[i >> 6] |= std::uint64_t{1} << (i & 63); }
    void erase(std::uint32_t i) { words_[i >> 6] &= ~(std::uint64_t{1} << (i & 63)); }

private:
    std::uint64_t* words_ = nullptr;
};

}  // namespace netmesh
