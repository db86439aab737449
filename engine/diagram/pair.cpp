#include "diagram/pair.hpp"

namespace netmesh {

void shorten_pairs(const PairList& list, Arena& arena) {
    double* to = reinterpret_cast<double*>(list.pairs);
    std::uint64_t* const of = reinterpret_cast<std::uint64_t*>(list.pairs) - BarList::counts;
    for (std::size_t degree = 0; degree < BarList::counts; ++degree) of[degree] = 0;
    for (std::uint64_t i = 0; i < list.count; ++i) {
        arena.step(i, 8);
        const Pair pair = list.pairs[i];
        ++of[pair.degree];
        *to++ = pair.birth;
        *to++ = pair.death;
    }
    arena.release_low(arena.offset_of(to));
}

Status move_pairs_down(std::size_t low, Arena& arena, PairList* list) {
    const std::size_t count = static_cast<std::size_t>(list->count);
    arena.release_low(low);
    Pair* const moved = arena.take_low<Pair>(count);
    if (moved == nullptr) return Status::out_of_memory;
    move_bytes(moved, list->pairs, sizeof(Pair) * count, arena);
    list->pairs = moved;
    return Status::ok;
}

}  // namespace netmesh
