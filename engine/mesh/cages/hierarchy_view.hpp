// A mesh with cages as plain records, for code that knows no dimension.
#pragma once
#include <cstddef>
#include <cstdint>

#include "delaunay/any_store.hpp"
#include "mesh/cages/cage.hpp"

namespace netmesh {

// Vertices and cells of a compact store, read in place.
struct HierarchyView {
    const unsigned char *points, *markers, *cells;  // of the first vertex and cell
    std::ptrdiff_t vertex_stride;
    std::size_t cell_stride;
    std::uint32_t dim, vertex_count, cell_count, cage_count;
    const Cage* cages;
    const std::uint32_t* domains;  // [vertex_count]: the innermost cage of each vertex, or none
    const Arena& arena;            // that is told of work

    const double* point(std::uint32_t v) const { return reinterpret_cast<const double*>(points + offset(v)); }
    bool is_exempt(std::uint32_t v) const { return markers[offset(v)] == static_cast<unsigned char>(Marker::exempt); }
    const VertexId* cell(std::uint32_t c) const { return reinterpret_cast<const VertexId*>(cells + c * cell_stride); }
    double distance(const double* x, const double* y) const {
        double sum = 0;
        for (std::uint32_t k = 0; k < dim; ++k) sum += (x[k] - y[k]) * (x[k] - y[k]);
        return square_root(sum);
    }

private:
    std::ptrdiff_t offset(std::uint32_t v) const { return static_cast<std::ptrdiff_t>(v) * vertex_stride; }
};

inline HierarchyView hierarchy_view(const AnyStore& store, const Cage* cages, std::uint32_t cage_count,
                                    const std::uint32_t* domains) {
    return {store.first_point(),
            reinterpret_cast<const unsigned char*>(&store.vertex(0).marker),
            store.first_cell(),
            store.point_stride(),
            AnyStore::cell_bytes(store.dim),
            static_cast<std::uint32_t>(store.dim),
            store.state.vertex_count,
            store.state.cell_slots,
            cage_count,
            cages,
            domains,
            store.arena};
}

}  // namespace netmesh
