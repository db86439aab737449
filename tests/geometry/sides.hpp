// Cells of the plane as what they are: polygons, by their sides.
#pragma once
#include <algorithm>

#include "delaunay/store.hpp"
#include "numerics/vector.hpp"

// Calls visit(v, a, b) for the sides from corner a to corner b of all cells, but for those that are unbounded.
template <class Visit> void for_each_side(const netmesh::Store<2>& store, Visit visit) {
    for (netmesh::CellId c(0); c < store.state.cell_slots; ++c)
        for (int i = 0; i < 3; ++i) {
            const netmesh::FacetId beyond = store.cell(c).neighbour[i];
            if (beyond == netmesh::none) continue;
            for (int j = 0; j < 3; ++j)
                if (j != i) visit(store.cell(c).vertex[j], store.cell(c).centre, store.cell(beyond.cell()).centre);
        }
}

// From q to the segment between a and b.
inline double distance_to_side(const double* q, const double* a, const double* b) {
    const double along[2] = {b[0] - a[0], b[1] - a[1]}, to[2] = {q[0] - a[0], q[1] - a[1]};
    const double length2 = along[0] * along[0] + along[1] * along[1];
    const double t = length2 > 0 ? (to[0] * along[0] + to[1] * along[1]) / length2 : 0;
    const double share = std::min(1.0, std::max(0.0, t));
    const double x[2] = {a[0] + share * along[0], a[1] + share * along[1]};
    return netmesh::distance<2>(x, q);
}
