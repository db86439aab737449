// The kernel, what it has found, whether cells are in conflict with a point, and balls, with the dimension as a number.
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
inline std::uint32_t cavity_position(const AnyStore& store, std::uint32_t k) {
    if (store.dim == 2 || k == 0) return none;
    const std::ptrdiff_t at = -1 - static_cast<std::ptrdiff_t>(k);
    const void* const end = store.list_top();
    return static_cast<const CavityLine*>(end)[at].entry.position();
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

template <> inline void recompute_balls<any_dimension>(AnyStore& store) {
    recompute_balls(static_cast<const AnyStore&>(store));
}

// Each call is made by a kernel of the dimension.
template <> class Kernel<any_dimension> {
    template <class F> auto call(F&& f) {
        return with_dimension(static_cast<std::uint32_t>(store_.dim), [&](auto dimension) {
            constexpr int D = decltype(dimension)::value;
            Store<D> store = store_.of_dimension<D>();
            Kernel<D> kernel(store, error_max_, vertex_cells_);
            const auto result = f(kernel);
            steps_ += kernel.steps();
            return result;
        });
    }

public:
    Kernel(const AnyStore& store, double error_max, VertexCells vertex_cells)
        : store_(store), error_max_(error_max), vertex_cells_(vertex_cells) {}

    Status start(const VertexId* ids) {
        return call([&](auto& kernel) { return kernel.start(ids); });
    }
    CellId locate(const double* q, VertexId id, CellId from) {
        return call([&](auto& kernel) { return kernel.locate(q, id, from); });
    }
    std::uint64_t steps() const { return steps_; }
    bool find_cavity(const double* q, VertexId id, CellId first, Cavity* cavity) {
        return call([&](auto& kernel) { return kernel.find_cavity(q, id, first, cavity); });
    }
    CellId cavity_cell(std::uint32_t k) const { return netmesh::cavity_cell(store_, k); }
    std::uint32_t cavity_position(std::uint32_t k) const { return netmesh::cavity_position(store_, k); }
    bool can_fill(const Cavity& cavity, std::uint32_t vertices) {
        const std::size_t lines = cavity.cells > cavity.facets ? cavity.cells : cavity.facets;
        const std::size_t line_bytes = store_.dim == 2 ? sizeof(PlanarLine) : sizeof(CavityLine);
        return store_.has_room(cavity.facets, vertices, (lines + 1) * line_bytes);
    }
    void fill(const Cavity& cavity, VertexId id) {
        call([&](auto& kernel) {
            kernel.fill(cavity, id);
            return true;
        });
    }
    CellId new_cell(std::uint32_t k) const { return netmesh::new_cell(store_, k); }
    template <class Visit> void visit_neighbours(const Cavity& cavity, VertexId v, Visit&& visit) const {
        for (std::uint32_t k = 0; k < cavity.facets; ++k)
            for (const VertexId w : store_.cell(new_cell(k)).vertex)
                if (w != v && w != none && store_.vertex(w).cell == new_cell(k)) visit(w);
    }
    template <class Visit> bool visit_star(VertexId v, Visit&& visit) { return visit_any_star(store_, v, visit); }

private:
    const AnyStore& store_;
    double error_max_;
    std::uint64_t steps_ = 0;
    VertexCells vertex_cells_;
};

}  // namespace netmesh
