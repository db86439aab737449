// Lower-star persistence of a finished mesh in the memory that its balls take otherwise.
#pragma once
#include "delaunay/packed_cells.hpp"
#include "homology/lower_star/lower_star.hpp"

namespace netmesh {

// Where a mesh ends in the arena: its low mark when the mesh was the last thing at that end, since when tables have
// come behind it; and the high mark when nothing stood there that only the filtration needs.
struct MeshEnds {
    std::size_t low, high;
};

// What persist_lower_star does, for the whole mesh in `store` or a part of it, value[vertices] among the tables behind
// it. The pairs come to stand behind those. is_short: as BarList has them then. The mesh is as before and the arena's
// high end is back at its mark whatever is returned; without ok the tables may be gone.
template <bool is_short>
Status diagram_of_packed(const AnyStore& store, MeshEnds ends, LowerStarFiltration<any_dimension> filtration,
                         DiagramRequest request, const Work& work, CountedPairs* out) {
    Arena& arena = work.arena;
    PackedCells packed(store, ends.low);
    filtration.complex = packed.view();
    filtration.value = packed.packed_place(filtration.value);
    const bool fits = !is_short || arena.take_low<std::uint64_t>(BarList::counts) != nullptr;
    Status status = fits ? persist_lower_star(filtration, request, work, out) : Status::out_of_memory;
    if (is_short && status == Status::ok) shorten_pairs(out->pairs, arena);
    arena.release_high(ends.high);
    if (!packed.unpack() && status == Status::ok) status = Status::out_of_memory;
    if (status == Status::ok) out->pairs.pairs = packed.place(out->pairs.pairs);
    return status;
}

}  // namespace netmesh
