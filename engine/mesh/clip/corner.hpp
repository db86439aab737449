// Corners of Voronoi cells clipped to a ball: what refinement inserts.
#pragma once
#include <cstdint>

#include "delaunay/sphere.hpp"
#include "mesh/domain.hpp"
#include "numerics/vector.hpp"

namespace netmesh {

// The farthest corner seen so far.
template <int D> struct Corner {
    static constexpr int dim = D;
    double x[D] = {};
    double distance2 = -1;  // from the vertex; negative: none yet
    CellId cell = none;

    Corner() = default;
    explicit Corner(int) {}

    void offer(const double* at, double d2, CellId from) {
        if (!(d2 > distance2)) return;
        distance2 = d2;
        cell = from;
        for (int k = 0; k < D; ++k) x[k] = at[k];
    }
};

// Is the cell's corner, seen from its vertices, surely no farther than the root of least2?
template <int D> bool is_within(const Cell<D>& cell, double least2) {
    return cell.radius2 * (1 + 0x1p-20) <= least2 && static_cast<double>(cell.error) <= corner_error_max;
}

// Calls visit(z) where edges of v's cell that end in corner c, which is outside the ball, cross its sphere: of edges
// for which is_wanted(cell c, the cell of the other end), but for those seen from the other end: it is outside too, not
// within the root of least2, and has a smaller index. For stores in use and for vertices inside the hull: behind each
// facet of c is a cell, infinite ones too.
template <int D, class IsWanted, class Visit>
void visit_crossings(const Store<D>& store, const Domain<D>& ball, VertexId v, CellId c, double least2,
                     IsWanted&& is_wanted, Visit&& visit) {
    const Cell<D>& cell = store.cell(c);
    for (int i = 0; i <= store.dim; ++i) {
        if (cell.vertex[i] == v) continue;
        const CellId n = cell.neighbour[i].cell();
        const Cell<D>& other = store.cell(n);
        if (!(other.radius2 < infinity) || !is_wanted(cell, other)) continue;
        if (n < c && !is_within(other, least2) && !ball.contains(other.centre)) continue;
        double z[2][DimensionOf<D>::most];
        const int crossings = sphere_crossings(ball, cell.centre, other.centre, z);
        for (int j = 0; j < crossings; ++j) visit(z[j]);
    }
}

// Offers the crossings from there, but for those that cannot be farther than least2 (squared). To be called for all
// corners outside that are not within the root of that.
template <int D>
void offer_crossings(const Store<D>& store, const Domain<D>& ball, VertexId v, CellId c, double least2,
                     Corner<D>* corner) {
    visit_crossings<D>(
        store, ball, v, c, least2,
        [&](const Cell<D>& cell, const Cell<D>& other) {
            // A crossing is no farther from v than the farther end.
            const double bound2 = cell.radius2 > other.radius2 ? cell.radius2 : other.radius2;
            return bound2 > corner->distance2 && bound2 * (1 + 0x1p-20) > least2;
        },
        [&](const double* z) { corner->offer(z, distance2<D>(store.dim, z, store.point(v)), c); });
}

}  // namespace netmesh
