#include "homology/rank.hpp"

#include "memory/high_scope.hpp"

namespace netmesh {
namespace {

constexpr int digit_bits = 11;
constexpr std::uint32_t digit_count = 1u << digit_bits;

// An unsigned key in the order of the doubles.
std::uint64_t key_of(double value) {
    const double x = value + 0.0;  // -0.0 becomes 0.0
    std::uint64_t bits;
    __builtin_memcpy(&bits, &x, sizeof bits);
    return (bits >> 63) != 0 ? ~bits : bits | (std::uint64_t{1} << 63);
}

}  // namespace

bool rank_vertices(const double* value, std::uint32_t count, Arena& arena, std::uint32_t* order, std::uint32_t* rank) {
    const HighScope scope(arena);
    std::uint64_t* keys = arena.take_high<std::uint64_t>(count);
    std::uint64_t* keys_next = arena.take_high<std::uint64_t>(count);
    std::uint32_t* start = arena.take_high<std::uint32_t>(digit_count);
    if (keys == nullptr || keys_next == nullptr || start == nullptr) return false;
    std::uint32_t* items = order;
    std::uint32_t* items_next = rank;
    for (std::uint32_t v = 0; v < count; ++v) {
        keys[v] = key_of(value[v]);
        items[v] = v;
    }
    for (int shift = 0; shift < 64; shift += digit_bits) {
        for (std::uint32_t d = 0; d < digit_count; ++d) start[d] = 0;
        for (std::uint32_t i = 0; i < count; ++i) ++start[keys[i] >> shift & (digit_count - 1)];
        if (count > 0 && start[keys[0] >> shift & (digit_count - 1)] == count) continue;  // all digits equal
        std::uint32_t sum = 0;
        for (std::uint32_t d = 0; d < digit_count; ++d) {
            const std::uint32_t n = start[d];
            start[d] = sum;
            sum += n;
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t to = start[keys[i] >> shift & (digit_count - 1)]++;
            keys_next[to] = keys[i];
            items_next[to] = items[i];
        }
        std::uint64_t* k = keys;
        keys = keys_next;
        keys_next = k;
        std::uint32_t* t = items;
        items = items_next;
        items_next = t;
    }
    if (items != order) {
        for (std::uint32_t i = 0; i < count; ++i) order[i] = items[i];
    }
    for (std::uint32_t i = 0; i < count; ++i) rank[order[i]] = i;
    return true;
}

}  // namespace netmesh
