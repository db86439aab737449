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

#ifdef __OPTIMIZE_SIZE__
namespace {

struct KeyedItem {
    std::uint64_t key;
    std::uint32_t item;
    bool operator<(const KeyedItem& other) const { return key != other.key ? key < other.key : item < other.item; }
};

struct KeyedItems {
    unsigned char* keys;
    std::uint32_t* items;

    KeyedItem get(std::size_t i) const {
        KeyedItem x;
        __builtin_memcpy(&x.key, keys + i * sizeof x.key, sizeof x.key);
        x.item = items[i];
        return x;
    }
    void put(std::size_t i, const KeyedItem& x) const {
        __builtin_memcpy(keys + i * sizeof x.key, &x.key, sizeof x.key);
        items[i] = x.item;
    }
};

}  // namespace

// Heapsort, as heap_sort of sort.hpp.
void sort_keys(void* keys, std::uint32_t* items, std::size_t count, const Arena& arena) {
    const KeyedItems all = {static_cast<unsigned char*>(keys), items};
    for (std::size_t left = count / 2, end = count; end > 1;) {
        arena.step(left, 600);
        const KeyedItem moved = all.get(left > 0 ? --left : --end);
        if (left == 0 && end < count) all.put(end, all.get(0));
        std::size_t hole = left;
        for (std::size_t child; (child = 2 * hole + 1) < end; hole = child) {
            KeyedItem above = all.get(child);
            if (child + 1 < end && above < all.get(child + 1)) above = all.get(++child);
            if (!(moved < above)) break;
            all.put(hole, above);
        }
        all.put(hole, moved);
    }
}
#endif

}  // namespace netmesh
