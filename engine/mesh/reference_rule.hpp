// VoronoiRefine (thesis 3.2) in the bounding domain and with the boundary net of 3.5, the reference for everything
// else.
#pragma once
#include <cstdint>

#include "mesh/refinement.hpp"

namespace netmesh {

// The cells that are bad are those of quality_rule.hpp; they are split at their farthest corners, whole, and all
// inputs are inserted before the first is. domain_factor and certify_filter do not matter. With rho the radius of the
// smallest enclosing ball and delta = 2 rho >= diameter(P), the domain has the ball's centre and radius (K sqrt 2 + 2)
// delta, K = 2 tau / (tau - 2); a delta-net of exempt vertices on its sphere, the boundary net, begins with the frame.
// It has about (radius / delta)^(D-1) vertices, too many to be of use in D = 5 and 6.
inline double reference_radius(double tau, double enclosing_radius) {
    const double k = 2 * tau / (tau - 2);
    return (k * square_root(2) + 2) * 2 * enclosing_radius;
}

// A point of the boundary net that is missing because of cell c, one of whose vertices is input `inside`; false when
// none is. With an input inside, each cell joins it to a facet of the net's hull, and the point of the sphere farthest
// from the facet's vertices, which is where the line from the centre through the cell's corner meets the sphere, is
// missing while it is farther than delta.
template <int D>
inline bool lacks_net_vertex(const Store<D>& store, const Domain<D>& domain, CellId c, VertexId inside, double* z) {
    const double delta2 = 4 * domain.enclosing_radius * domain.enclosing_radius;
    if (!store.is_live(c) || store.is_ghost(c) || !(store.cell(c).radius2 < infinity)) return false;
    const Cell<D>& cell = store.cell(c);
    const VertexId w = cell.vertex[cell.vertex[0] == inside ? 1 : 0];
    const double length = square_root(domain.distance2(cell.centre));
    if (!(length > 0)) return false;
    for (int k = 0; k < D; ++k) z[k] = domain.centre[k] + domain.radius / length * (cell.centre[k] - domain.centre[k]);
    return distance2<D>(z, store.point(w)) > delta2;
}

}  // namespace netmesh
