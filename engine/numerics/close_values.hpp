// Which of many doubles may have another close by, found without sorting them.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"
#include "memory/prefetch.hpp"
#include "numerics/bits.hpp"

namespace netmesh {

// Doubles are cut into stretches of equal leading bits; two bits for each count whose interval meets it: none, one,
// more. An interval is shorter than a stretch, so it meets one or two, and intervals that overlap share one. Stretches
// share a pair of bits by a hash, which makes a value seem close to another now and then, one in 5 to 10, and hides
// none.
class CloseValues {
public:
    static constexpr double spread_max = 0x1p-20;

    // For up to `count` values, the intervals x (1 - spread) to x (1 + spread). 2 to 4 bytes a value at the low end of
    // the arena. False: out of memory.
    bool take(std::uint64_t count, double spread, Arena& arena) {
        // In units of the last place; below a power of two these are half as large, which the 53 provides for.
        margin_ = static_cast<std::uint64_t>(spread * 0x1p53) + 1;
        stretch_bits_ = 4 + static_cast<int>(highest_bit(margin_));
        int bits = 5;
        while ((std::uint64_t{1} << bits) < 8 * count) ++bits;
        hash_shift_ = 64 - bits;
        const std::size_t words = static_cast<std::size_t>(std::uint64_t{1} << (bits - 5));
        seen_ = arena.take_low<std::uint64_t>(words);
        if (seen_ != nullptr) arena.each(words, 1, [this](std::uint64_t i) { seen_[i] = 0; });
        return seen_ != nullptr;
    }

    // Asks for what add(x) or found(x) reads. Any x.
    __attribute__((always_inline)) void fetch(double x) const {
        prefetch(seen_ + (place((bits_of(x) - margin_) >> stretch_bits_) >> 5));
    }
    // x > 0. How often a stretch was met again: 0 to 2.
    std::uint32_t add(double x) {
        const std::uint64_t low = (bits_of(x) - margin_) >> stretch_bits_,
                            high = (bits_of(x) + margin_) >> stretch_bits_;
        return meet(low) + (low == high ? 0 : meet(high));
    }
    // x has been added: whether another interval met one of its stretches.
    bool found(double x) const {
        const std::uint64_t low = (bits_of(x) - margin_) >> stretch_bits_,
                            high = (bits_of(x) + margin_) >> stretch_bits_;
        return met_again(low) || (low != high && met_again(high));
    }

private:
    std::uint64_t place(std::uint64_t stretch) const { return stretch * 0x9E3779B97F4A7C15u >> hash_shift_; }
    std::uint32_t meet(std::uint64_t stretch) {
        const std::uint64_t at = place(stretch);
        const int shift = static_cast<int>(at & 31) * 2;
        std::uint64_t& word = seen_[at >> 5];
        const std::uint64_t again = word >> shift & 1;
        word |= (1 + again) << shift;
        return static_cast<std::uint32_t>(again);
    }
    bool met_again(std::uint64_t stretch) const {
        const std::uint64_t at = place(stretch);
        return (seen_[at >> 5] >> ((at & 31) * 2 + 1) & 1) != 0;
    }

    std::uint64_t* seen_ = nullptr;
    std::uint64_t margin_ = 0;
    int stretch_bits_ = 0, hash_shift_ = 0;
};

}  // namespace netmesh
