#include "delaunay/store.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

Status open_vertices_of(Arena& arena, StoreState& state, std::uint32_t vertex_count, std::size_t vertex_bytes) {
    const bool is_size = vertex_count <= SIZE_MAX / vertex_bytes;
    const std::size_t bytes = vertex_count * vertex_bytes;
    double* const vertices = arena.take_high<double>(is_size ? bytes / sizeof(double) : SIZE_MAX);
    if (vertices == nullptr) return Status::out_of_memory;
    state = StoreState{};
    // The room that alignment left above the array is not worth a second offset: the array begins where it was put.
    state.vertices_end = arena.offset_of(vertices) + bytes;
    state.free_head = none;
    state.vertex_count = vertex_count;
    state.stamp = 2;
    state.last_cell = none;
    return Status::ok;
}

template <int D> Status Store<D>::open_vertices(std::uint32_t vertex_count) {
    static_assert(alignof(VertexT) == alignof(double));
    const Status status = open_vertices_of(arena, state, vertex_count, sizeof(VertexT));
    locate_arrays();
    return status;
}

Status open_cells_of(Arena& arena, StoreState& state) {
    double* const cells = arena.take_low<double>(0);
    if (cells == nullptr) return Status::out_of_memory;
    state.cells_offset = arena.offset_of(cells);
    return Status::ok;
}

template <int D> Status Store<D>::open_cells() {
    static_assert(alignof(CellT) == alignof(double));
    const Status status = open_cells_of(arena, state);
    locate_arrays();
    return status;
}

template <int D> void Store<D>::truncate_vertices(std::uint32_t vertex_count) {
    state.vertex_count = vertex_count;
    arena.release_high(state.vertices_end - vertex_count * sizeof(VertexT));
}

template <int D> void Store<D>::compact(std::size_t offset) {
    const std::uint32_t end = close_gaps<D>(cells_, state.cell_slots, arena);
    for (CellId c(0); c < end;)
        for (const std::uint64_t piece = arena.piece(c, end, 5 * (D + 1)); c < piece; ++c) {
            for (const VertexId v : cells_[c].vertex) vertex(v).cell = c;
        }
    const std::size_t bytes = end * sizeof(CellT);
    if (offset != state.cells_offset) move_bytes(arena.at(offset), arena.at(state.cells_offset), bytes, arena);
    state.cells_offset = offset;
    state.cell_slots = end;
    state.cells_free = 0;
    state.free_head = none;
    state.last_cell = end > 0 ? CellId(0) : none;
    arena.release_low(offset + bytes);
    locate_arrays();
}

bool has_room_for(Arena& arena, const StoreState& state, const StoreNeeds& needs) {
    const std::uint32_t fresh = needs.cells > state.cells_free ? needs.cells - state.cells_free : 0;
    if (fresh > FacetId::cells_max - state.cell_slots) {
        arena.refuse(SIZE_MAX / 4);
        return false;
    }
    const std::size_t bytes = fresh * needs.cell_bytes + needs.other_bytes + Arena::alignment;
    if (bytes <= arena.bytes_free()) {
        arena.use_gap(bytes);
        return true;
    }
    arena.refuse(bytes);
    return false;
}

template <int D> std::uint32_t Store<D>::new_stamp() {
    if (state.stamp > 0xFFFFFFF0u) {
        for (std::uint32_t c = 0; c < state.cell_slots; ++c) cells_[c].mark = 0;
        state.stamp = 2;
    }
    return state.stamp += 2;
}

#define NETMESH_INSTANTIATE(D) template class Store<D>;
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
