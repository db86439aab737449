// The largest (least) of some numbers over all items up to (from) a key.
#pragma once
#include <cstdint>

#include "memory/arena.hpp"
#include "numerics/real.hpp"
#include "numerics/value_order.hpp"

namespace netmesh {

class ValueTable {
public:
    // key(i), of(i) of items i < count, count >= 1. 16 bytes an item at the arena's high end, 4 more for the time of
    // the call. False: no room. O(count log count).
    template <class Key, class Of> bool open_largest(std::uint32_t count, Key&& key, Of&& of, Arena& arena) {
        return open(count, key, of, arena, true);
    }
    template <class Key, class Of> bool open_least(std::uint32_t count, Key&& key, Of&& of, Arena& arena) {
        return open(count, key, of, arena, false);
    }
    std::uint32_t count() const { return count_; }
    double key(std::uint32_t i) const { return key_[i]; }  // ascending
    double key_or_infinity(std::uint32_t i) const { return i < count_ ? key_[i] : infinity; }
    double first() const { return key_[0]; }
    double last() const { return key_[count_ - 1]; }

    // After open_largest: over keys <= x, 0 or `otherwise` for none.
    double largest_up_to(double x, double otherwise = 0) const {
        const std::uint32_t n = keys_until(x, false);
        return n > 0 ? extreme_[n - 1] : otherwise;
    }
    // After open_least: over keys >= x (> x), infinity for none.
    double least_from(double x) const { return least(keys_until(x, true)); }
    double least_after(double x) const { return least(keys_until(x, false)); }
    // The number of keys <= x (< x).
    std::uint32_t keys_until(double x, bool strictly) const {
        return first_where([&](double k) { return !(strictly ? k < x : k <= x); });
    }
    // The first place whose key satisfies what all later ones satisfy too; count() for none.
    template <class Is> std::uint32_t first_where(Is&& is) const {
        std::uint32_t first = 0, last = count_;
        while (first < last) {
            const std::uint32_t middle = first + (last - first) / 2;
            if (is(key_[middle])) {
                last = middle;
            } else {
                first = middle + 1;
            }
        }
        return first;
    }

private:
    double least(std::uint32_t from) const { return from < count_ ? extreme_[from] : infinity; }
    template <class Key, class Of> bool open(std::uint32_t count, Key&& key, Of&& of, Arena& arena, bool ascending);

    double *key_ = nullptr, *extreme_ = nullptr;
    std::uint32_t count_ = 0;
};

template <class Key, class Of>
bool ValueTable::open(std::uint32_t count, Key&& key, Of&& of, Arena& arena, bool ascending) {
    count_ = count;
    key_ = arena.take_high<double>(count);
    extreme_ = arena.take_high<double>(count);
    const std::size_t mark = arena.high_mark();
    std::uint32_t* const from = arena.take_high<std::uint32_t>(count);
    if (key_ == nullptr || extreme_ == nullptr || from == nullptr) return false;
    for (std::uint32_t i = 0; i < count;)
        for (const std::uint64_t piece = arena.piece(i, count, 10); i < piece; ++i) {
            key_[i] = key(i);
        }
    if (!sort_values(key_, from, count, arena)) return false;
    for (std::uint32_t i = 0; i < count && ascending;)
        for (const std::uint64_t piece = arena.piece(i, count, 12); i < piece && ascending; ++i) {
            const double x = of(from[i]);
            extreme_[i] = i > 0 && extreme_[i - 1] > x ? extreme_[i - 1] : x;
        }
    for (std::uint32_t i = ascending ? 0 : count; i-- > 0;) {
        arena.step(i, 12);
        const double x = of(from[i]);
        extreme_[i] = i + 1 < count && extreme_[i + 1] < x ? extreme_[i + 1] : x;
    }
    arena.release_high(mark);
    return true;
}

}  // namespace netmesh
