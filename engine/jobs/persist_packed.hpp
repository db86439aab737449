// Lower-star persistence of a finished mesh in the memory that its balls take otherwise.
#pragma once
#include "delaunay/packed_cells.hpp"
#include "homology/lower_star/lower_star.hpp"

namespace netmesh {

// What persist_lower_star does, for the whole mesh in `store` or a part of it. behind: the arena's low mark when the
// mesh was the last thing there; since then tables have come behind it, value[vertices] among them. The pairs come to
// stand behind those. The mesh is as before whatever is returned; without ok the tables may be gone.
inline Status persist_packed(const AnyStore& store, std::size_t behind, LowerStarFiltration<any_dimension> filtration,
                             DiagramRequest request, const Work& work, CountedPairs* out) {
    PackedCells packed(store, behind);
    filtration.complex = packed.view();
    filtration.value = packed.packed_place(filtration.value);
    const Status status = persist_lower_star(filtration, request, work, out);
    const bool fits = packed.unpack();
    if (status != Status::ok) return status;
    out->pairs.pairs = packed.place(out->pairs.pairs);
    return fits ? Status::ok : Status::out_of_memory;
}

}  // namespace netmesh
