#include "diagram/pair.hpp"

namespace netmesh {

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
