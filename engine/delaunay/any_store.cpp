#include "delaunay/any_store.hpp"

#include "delaunay/cell_list.hpp"

namespace netmesh {

void AnyStore::locate_arrays() {
    cells_ = static_cast<unsigned char*>(arena.at(state.cells_offset));
    vertices_ = static_cast<unsigned char*>(arena.at(state.vertices_end)) - vertex_bytes(dim);
}

std::uint32_t AnyStore::new_stamp() const {
    if (state.stamp > 0xFFFFFFF0u) {
        for (std::uint32_t c = 0; c < state.cell_slots; ++c) cell(c).mark = 0;
        state.stamp = 2;
    }
    return state.stamp += 2;
}

Status AnyStore::open_vertices(std::uint32_t vertex_count) {
    const Status status = open_vertices_of(arena, state, vertex_count, vertex_bytes(dim));
    locate_arrays();
    return status;
}

Status AnyStore::open_cells() {
    const Status status = open_cells_of(arena, state);
    locate_arrays();
    return status;
}

void AnyStore::compact(std::size_t offset) {
    with_dimension(static_cast<std::uint32_t>(dim),
                   [&](auto dimension) { of_dimension<decltype(dimension)::value>().compact(offset); });
    locate_arrays();
}

AnyCellList::AnyCellList(const AnyStore& store)
    : store_(store), end_(store.list_top()), capacity_(store.list_capacity()), below_(store.arena.bytes_used()),
      stamp_(store.new_stamp()) {}

bool AnyCellList::add(CellId c) {
    std::uint32_t& mark = store_.cell(c).mark;
    if (mark == stamp_) return true;
    if (size_ >= capacity_) {
        store_.arena.refuse(sizeof(CellId));
        return false;
    }
    mark = stamp_;
    end_[-1 - static_cast<std::ptrdiff_t>(size_++)] = c;
    return true;
}

std::uint32_t list_star(const AnyStore& any, VertexId v) {
    return with_dimension(static_cast<std::uint32_t>(any.dim), [&](auto dimension) -> std::uint32_t {
        constexpr int D = decltype(dimension)::value;
        Store<D> store = any.of_dimension<D>();
        CellList<D> star(store);
        if (!star.add(store.vertex(v).cell)) return 0;
        for (std::uint32_t k = 0; k < star.size(); ++k) {
            const Cell<D>& cell = store.cell(star[k]);
            if (k + 2 < star.size()) ask_for_marks(store, v, star[k + 2]);
            for (int i = 0; i <= D; ++i) {
                const FacetId facet = cell.neighbour[i];
                if (cell.vertex[i] != v && facet != none && !star.add(facet.cell())) return 0;
            }
        }
        return star.size();
    });
}

}  // namespace netmesh
