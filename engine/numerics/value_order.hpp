// Deterministic sorting of values together with their positions.
#pragma once
#include <cstddef>
#include <cstdint>

#include "memory/arena.hpp"
#include "memory/prefetch.hpp"
#include "numerics/bits.hpp"

namespace netmesh {

// Sorts value[count] in place, ascending, equal values by position; position[j] becomes the place that value[j] came
// from. Values: no NaN, no -0.0. In-place radix sort from the top digit on the bit patterns: about 5-10 ns a
// value, few passes however the values cluster. Scratch: 64 KiB of the arena, 40 for few values, given back. False when
// that is missing; nothing has changed then.
bool sort_values(double* value, std::uint32_t* position, std::uint32_t count, Arena& arena);

// The same with labels of the caller's, which are distinct: label[j] moves with value[j], equal values go by label.
bool sort_labelled(double* value, std::uint32_t* label, std::uint32_t count, Arena& arena);

// From here on sorting takes scratch that makes it faster.
constexpr std::uint32_t many_values = 4096;

// Values are put where their first digit belongs as they are listed: into buckets that the caches hold. With values of
// either sign these divide what is between the least and the greatest evenly.
template <bool is_signed> class ValueBuckets {
public:
    // value[count]: none is negative unless is_signed; among them are all that will be listed. Takes 8 KiB of the
    // arena's high end.
    bool take(const double* value, std::uint32_t count, Arena& arena);
    void add(double x, bool is_listed) { end_[bucket_of(x)] += is_listed; }
    // All have been added.
    void begin_places();
    // Where the next item with this value goes.
    std::uint32_t place_of(double x) { return end_[bucket_of(x)]++; }
    // Sorts what stands at its places, as sort_labelled does. False: out of memory.
    bool sort(double* value, std::uint32_t* label, Arena& arena) const;

private:
    static constexpr int bits = 11;
    static constexpr std::uint32_t buckets = 1u << bits;
    std::uint32_t bucket_of(double x) const {
        if constexpr (is_signed) {
            const double at = (x - least_) * factor_;  // grows with x, as rounding exchanges no order
            return at < buckets - 1 ? static_cast<std::uint32_t>(at) : buckets - 1;
        } else {
            return static_cast<std::uint32_t>(bits_of(x) >> shift_) & (buckets - 1);
        }
    }

    std::uint32_t* end_ = nullptr;
    int shift_ = 0;
    double least_ = 0, factor_ = 0;  // of values of either sign
};

// Lists those of value[0..count), none of them negative unless is_signed, that is_listed(i) says, which may be asked
// twice, as sort_labelled puts them in order: sorted and label, of room for them. False: out of memory.
template <bool is_signed = false, class IsListed>
bool sort_listed(const double* value, std::uint32_t count, IsListed is_listed, double* sorted, std::uint32_t* label,
                 Arena& arena) {
    if (!jumps_matter || count < many_values) {
        std::uint32_t listed = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            if (!is_listed(i)) continue;
            label[listed] = i;
            sorted[listed++] = value[i];
        }
        return sort_labelled(sorted, label, listed, arena);
    }
#ifndef __OPTIMIZE_SIZE__
    const HighScope scope(arena);
    ValueBuckets<is_signed> buckets;
    if (!buckets.take(value, count, arena)) return false;
    arena.each(count, 12, [&](std::uint64_t i) { buckets.add(value[i], is_listed(static_cast<std::uint32_t>(i))); });
    buckets.begin_places();
    arena.each(count, 20, [&](std::uint64_t i) {
        if (!is_listed(static_cast<std::uint32_t>(i))) return;
        const std::uint32_t place = buckets.place_of(value[i]);
        sorted[place] = value[i];
        label[place] = static_cast<std::uint32_t>(i);
    });
    return buckets.sort(sorted, label, arena);
#else
    return false;
#endif
}

}  // namespace netmesh
