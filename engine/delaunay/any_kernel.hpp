// What a kernel has found, whether cells are in conflict with a point, and balls, with the dimension as a number.
#pragma once
#include "delaunay/any_store.hpp"
#include "delaunay/kernel.hpp"

namespace netmesh {

// Cells of the cavity, until it is filled, and then those that fill it, until the next search: as Kernel has them.
inline CellId cavity_cell(const AnyStore& store, std::uint32_t k) {
    const std::ptrdiff_t at = -1 - static_cast<std::ptrdiff_t>(k);
    const void* const end = store.list_top();
    return store.dim == 2 ? static_cast<const PlanarLine*>(end)[at].made
                          : static_cast<const CavityLine*>(end)[at].entry.cell();
}
inline CellId new_cell(const AnyStore& store, std::uint32_t k) {
    const std::ptrdiff_t at = -1 - static_cast<std::ptrdiff_t>(k);
    const void* const end = store.list_top();
    return store.dim == 2 ? static_cast<const PlanarLine*>(end)[at].made : static_cast<const CavityLine*>(end)[at].made;
}

// As Kernel::in_conflict, for a point that is a vertex of the store, inserted or not.
inline bool in_conflict(const AnyStore& store, CellId c, VertexId id) {
    return with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Store<D> of_dimension = store.of_dimension<D>();
        return Kernel<D>(of_dimension, infinity, VertexCells::ignored).in_conflict(c, store.point(id), id);
    });
}

// As recompute_balls of sphere.hpp.
inline void recompute_balls(const AnyStore& store) {
    with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        Store<decltype(dimension)::value> of_dimension = store.of_dimension<decltype(dimension)::value>();
        recompute_balls<decltype(dimension)::value>(of_dimension);
    });
}

}  // namespace netmesh
