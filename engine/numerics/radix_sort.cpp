#include "numerics/radix_sort.hpp"

namespace netmesh {
namespace {

void sort_few_keys(std::uint64_t* keys, std::uint32_t* items, std::size_t count) {
    for (std::size_t i = 1; i < count; ++i) {
        const std::uint64_t key = keys[i];
        const std::uint32_t item = items[i];
        std::size_t j = i;
        for (; j > 0 && keys[j - 1] > key; --j) {
            keys[j] = keys[j - 1];
            items[j] = items[j - 1];
        }
        keys[j] = key;
        items[j] = item;
    }
}

}  // namespace

void radix_sort(std::uint64_t* keys, std::uint32_t* items, std::uint64_t* spare_keys, std::uint32_t* spare_items,
                std::size_t count, const Arena& arena) {
    if (count <= 48) return sort_few_keys(keys, items, count);
    std::uint64_t differing = 0;
    arena.each(count, 2, [&](std::size_t i) { differing |= keys[i] ^ keys[0]; });

    std::uint64_t* from_keys = keys;
    std::uint32_t* from_items = items;
    std::uint64_t* to_keys = spare_keys;
    std::uint32_t* to_items = spare_items;
    for (int shift = 0; shift < 64; shift += 8) {
        if (((differing >> shift) & 0xFF) == 0) continue;
        std::uint32_t start[256] = {};
        arena.each(count, 5, [&](std::size_t i) { ++start[(from_keys[i] >> shift) & 0xFF]; });
        std::uint32_t sum = 0;
        for (std::uint32_t& s : start) {
            const std::uint32_t n = s;
            s = sum;
            sum += n;
        }
        arena.each(count, 12, [&](std::size_t i) {
            const std::uint32_t to = start[(from_keys[i] >> shift) & 0xFF]++;
            to_keys[to] = from_keys[i];
            to_items[to] = from_items[i];
        });
        std::uint64_t* const k = from_keys;
        from_keys = to_keys;
        to_keys = k;
        std::uint32_t* const t = from_items;
        from_items = to_items;
        to_items = t;
    }
    if (from_keys != keys)
        arena.each(count, 4, [&](std::size_t i) {
            keys[i] = from_keys[i];
            items[i] = from_items[i];
        });
}

}  // namespace netmesh
