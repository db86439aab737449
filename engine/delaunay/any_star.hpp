// The cells at any vertex of a compact store.
#pragma once
#include "delaunay/cell_list.hpp"

namespace netmesh {

// visit_star for vertices of the hull as well: their cells hang together through facets too.
template <int D, class Visit> bool visit_any_star(Store<D>& store, VertexId v, Visit&& visit) {
    CellList<D> star(store);
    if (!star.add(store.vertex(v).cell)) return false;
    for (std::uint32_t k = 0; k < star.size(); ++k) {
        const CellId c = star[k];
        visit(c);
        for (int i = 0; i <= D; ++i) {
            const FacetId facet = store.cell(c).neighbour[i];
            if (store.cell(c).vertex[i] != v && facet != none && !star.add(facet.cell())) return false;
        }
    }
    return true;
}

}  // namespace netmesh
