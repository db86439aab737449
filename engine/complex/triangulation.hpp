// A triangulated D-ball as topology sees it: cells with their vertices and neighbours, no coordinates.
#pragma once
#include <cstddef>
#include <cstdint>

#include "vocabulary/dimension.hpp"
#include "vocabulary/ids.hpp"

namespace netmesh {

// Record c starts at cells + c * stride_bytes: the D+1 vertices (VertexId), then for each of them the facet opposite
// it as the cell beyond names it (FacetId: that cell and the position in it of its vertex opposite the facet), none on
// the hull.
template <int D> struct TriangulationView {
    const unsigned char* cells;
    std::size_t stride_bytes;
    std::uint32_t cell_count;
    std::uint32_t vertex_count;
    DimensionOf<D> dim = {};

    // The same, its dimension a number or not.
    template <int E> TriangulationView<E> of_dimension(DimensionOf<E> other) const {
        return {cells, stride_bytes, cell_count, vertex_count, other};
    }
    const VertexId* vertices(CellId cell) const {
        return reinterpret_cast<const VertexId*>(cells + cell * stride_bytes);
    }
    // The facet opposite vertex i, as the cell beyond names it.
    FacetId facet_beyond(CellId cell, std::uint32_t i) const {
        return reinterpret_cast<const FacetId*>(vertices(cell) + (dim + 1))[i];
    }
    // The cell beyond that facet, `none` on the hull.
    CellId neighbour(CellId cell, std::uint32_t i) const {
        const FacetId facet = facet_beyond(cell, i);
        return facet == none ? CellId(none) : facet.cell();
    }
};

}  // namespace netmesh
