// Few points in the plane, triangulated and kept in short words.
#pragma once
#include "api/context.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

constexpr bool keeps_plane = serves_dimension(2);

// Reads what the context keeps of them.
class PlaneReader {
public:
    explicit PlaneReader(const netmesh_context* context)
        : cells_(context->plane.cells.in(context)), points_(context->plane.points.in(context)),
          place_(context->plane.place.in(context)) {}
    const double* point(std::uint32_t v) const { return points_ + 2 * std::size_t{place_[v]}; }
    VertexId vertex(std::uint32_t cell, int i) const { return cells_[cell].vertex[i]; }
    // none on the hull.
    CellId neighbour(std::uint32_t cell, int i) const {
        const FacetId facet = cells_[cell].neighbour[i];
        return facet == none ? CellId(none) : facet.cell();
    }

private:
    const PlaneCell<NarrowWords>* cells_;
    const double* points_;
    const std::uint16_t* place_;
};

}  // namespace netmesh
