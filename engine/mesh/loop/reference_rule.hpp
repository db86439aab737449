// VoronoiRefine (thesis 3.2) in the bounding domain and with the boundary net of 3.5, the reference for everything
// else.
#pragma once
#include <cstdint>

#include "mesh/loop/refinement.hpp"

namespace netmesh {

// The cells that are bad are those of quality_rule.hpp; they are split at their farthest corners, whole, and all
// inputs are inserted before the first is. domain_factor and certify_filter do not matter. The domain has the centre of
// the smallest enclosing ball; a delta-net of exempt vertices on its sphere, the boundary net, begins with the frame.
// It has about (radius / delta)^(D-1) vertices, with the thesis's delta too many to be of use in D = 5 and 6.
//
// With rho the enclosing ball's radius, K = 2 tau / (tau - 2) and r the domain's radius, this is what delta may be:
// - r >= 3 rho. The net is then as far from every input as other inputs are, 2 rho, as 3.3.2 requires.
// - r >= (K sqrt 2 + 1) delta + rho. A corner x less than delta below the sphere would be within sqrt 2 delta of the
//   net: with h its depth and z the net's vertex nearest to the point above it, |x - z|^2 <= h^2 + delta^2 (1 - h / r).
//   It is farther than r - delta - rho from all inputs, so than (r - delta - rho) / K from all vertices (3.3.2), and
//   that is no less. So no vertex enters the outer annulus, and no corner leaves the domain (3.5.1), for any delta > 0.
// Cells are clipped to the domain as well, so that refinement ends whatever roundings do, and with sizes, for which the
// second is not so. The thesis's delta is the diameter of P; ours is `spacing` times 2 rho, which is no less for 1, and
// r the larger of 3 rho and (K sqrt 2 + 1) delta + 2 rho, (K sqrt 2 + 2) delta as in the thesis for 1.
inline double reference_radius(double tau, double spacing, double enclosing_radius) {
    const double k = 2 * tau / (tau - 2), width = 2 * enclosing_radius;
    const double radius = (k * square_root(2) + 2) * width + (spacing - 1) * (k * square_root(2) + 1) * width;
    return radius > 1.5 * width ? radius : 1.5 * width;
}

// Do coordinates resolve the net, and do squares of the domain's radius fit a double? A place of the net is in the
// direction of a facet delta wide, so off by the radius over delta times what its vertices are: by half of delta at
// most, and no place is taken twice.
template <int D> inline bool has_resolved_net(const Domain<D>& domain, double spacing) {
    double most = domain.radius;
    for (int k = 0; k < domain.dim; ++k)
        if (absolute(domain.centre[k]) > most) most = absolute(domain.centre[k]);
    const double delta = 2 * spacing * domain.enclosing_radius;
    return domain.radius <= 0x1p511 && delta >= 0x1p-51 * most * (domain.radius / delta);
}

// A point of the boundary net that is missing because of cell c, one of whose vertices is input `inside`; false when
// none is. With an input inside, each cell joins it to a facet of the net's hull, and the point of the sphere farthest
// from the facet's vertices, which is where the line from the centre through the cell's corner meets the sphere, is
// missing while it is farther than delta.
template <int D>
inline bool lacks_net_vertex(const Store<D>& store, const Domain<D>& domain, double delta, CellId c, VertexId inside,
                             double* z) {
    if (!store.is_live(c) || store.is_ghost(c) || !(store.cell(c).radius2 < infinity)) return false;
    const Cell<D>& cell = store.cell(c);
    const VertexId w = cell.vertex[cell.vertex[0] == inside ? 1 : 0];
    const double length = square_root(domain.distance2(cell.centre));
    if (!(length > 0)) return false;
    for (int k = 0; k < store.dim; ++k)
        z[k] = domain.centre[k] + domain.radius / length * (cell.centre[k] - domain.centre[k]);
    return distance2<D>(store.dim, z, store.point(w)) > delta * delta;
}

}  // namespace netmesh
