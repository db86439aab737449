#include "homology/rank.hpp"

#include "memory/arena.hpp"
#include "numerics/bits.hpp"
#include "numerics/radix_sort.hpp"

namespace netmesh {
namespace {

// An unsigned key in the order of the doubles.
std::uint64_t rank_key(double value) {
    const double x = value + 0.0;  // -0.0 becomes 0.0
    const std::uint64_t bits = bits_of(x);
    return (bits >> 63) != 0 ? ~bits : bits | (std::uint64_t{1} << 63);
}

}  // namespace

bool rank_vertices(const double* value, std::uint32_t count, Arena& arena, std::uint32_t* order, std::uint32_t* rank) {
    const HighScope scope(arena);
    std::uint64_t* keys = arena.take_high<std::uint64_t>(count);
    std::uint64_t* spare = arena.take_high<std::uint64_t>(count);
    if (keys == nullptr || spare == nullptr) return false;
    for (std::uint32_t v = 0; v < count;)
        for (const std::uint64_t piece = arena.piece(v, count, 8); v < piece; ++v) {
            keys[v] = rank_key(value[v]);
            order[v] = v;
        }
    radix_sort(keys, order, spare, rank, count, arena);
    for (std::uint32_t i = 0; i < count;)
        for (const std::uint64_t piece = arena.piece(i, count, 5); i < piece; ++i) {
            rank[order[i]] = i;
        }
    return true;
}

}  // namespace netmesh
