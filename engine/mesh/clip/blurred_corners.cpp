#include "mesh/clip/blurred_corners.hpp"

namespace netmesh {
namespace {

// Where edges of v's cell that end in corner c, which is outside of the ball, cross its sphere, but for those that are
// seen from the other end.
[[gnu::cold]] void offer_crossings_from(const AnyStore& store, const AnyDomain& ball, VertexId v, CellId c,
                                        AnyCorner* farthest) {
    const AnyCell cell = store.cell(c);
    for (int i = 0; i <= store.dim; ++i) {
        if (cell.vertex[i] == v) continue;
        const CellId n = cell.neighbour[i].cell();
        const AnyCell other = store.cell(n);
        // A crossing is no farther from v than the farther end.
        const double bound2 = cell.radius2 > other.radius2 ? cell.radius2 : other.radius2;
        if (!(other.radius2 < infinity) || !(bound2 > farthest->distance2)) continue;
        if (n < c && !ball.contains(other.centre)) continue;
        double z[2][dimension_max];
        const int crossings = sphere_crossings(ball, cell.centre, other.centre, z);
        for (int j = 0; j < crossings; ++j) farthest->offer(z[j], distance2(store.dim, z[j], store.point(v)), c);
    }
}

}  // namespace

[[gnu::cold]] bool find_blur(const AnyStore& store, VertexId v, double* blur) {
    *blur = 0;
    return visit_any_star(store, v, [&](CellId c) {
        const AnyCell cell = store.cell(c);
        const double share = static_cast<double>(cell.error);
        if (!(cell.radius2 < infinity) || !(share > corner_error_max)) return;
        const double wrong = share * square_root(cell.radius2);
        if (wrong > *blur) *blur = wrong;
    });
}

[[gnu::cold]] std::uint32_t offer_corners(const AnyStore& store, const AnyDomain& ball, VertexId v,
                                          AnyCorner* farthest) {
    std::uint32_t cells = 0;
    const bool fits = visit_any_star(store, v, [&](CellId c) {
        const AnyCell cell = store.cell(c);
        ++cells;
        if (!(cell.radius2 < infinity)) return;
        if (ball.contains(cell.centre))
            farthest->offer(cell.centre, distance2(store.dim, cell.centre, store.point(v)), c);
        else
            offer_crossings_from(store, ball, v, c, farthest);
    });
    return fits ? cells : 0;
}

}  // namespace netmesh
