#include "mesh/cage_corner.hpp"

#include "delaunay/cell_list.hpp"
#include "mesh/clipped_cell.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Offers where the edge of the cage's cell from the corner of cell c, which is outside of the ball, to that of the cell
// behind it crosses the sphere.
template <int D>
void offer_crossing(const Store<D>& store, const Domain<D>& ball, const double* centre, CellId c, CellId behind,
                    Corner<D>* corner) {
    double z[2][D];
    const int crossings = sphere_crossings<D>(ball, store.cell(c).centre, store.cell(behind).centre, z);
    for (int j = 0; j < crossings; ++j) corner->offer(z[j], distance2<D>(z[j], centre), c);
}

// A cell on the cage's boundary: there is one at any shell vertex. False when the gap is too small for the search.
template <int D> bool find_boundary_cell(Store<D>& store, const Cage& cage, CellId* found) {
    *found = none;
    return visit_star(store, VertexId(cage.shell), [&](CellId c) {
        if (*found == none && is_on_boundary<D>(store, cage, c)) *found = c;
    });
}

// Is a vertex inside of the cage nearest to x?
template <int D> bool is_in_cage_cell(const Store<D>& store, const Cage& cage, const double* x) {
    double inside2 = infinity, outside2 = infinity;
    for (VertexId v(0); v < store.state.vertex_count; ++v) {
        if (store.vertex(v).cell == none) continue;
        const double* const p = store.point(v);
        const double d2 = distance2<D>(x, p);
        double& nearest2 = is_inside<D>(store, cage, p) ? inside2 : outside2;
        if (d2 < nearest2) nearest2 = d2;
    }
    return inside2 <= outside2 * (1 + 0x1p-30);
}

}  // namespace

// Cells on the boundary are connected.
template <int D>
bool find_cage_corner(Store<D>& store, const Cage& cage, const Domain<D>& ball, Corner<D>* corner, bool* leaves_ball) {
    *leaves_ball = false;
    const double* const centre = store.point(cage.centre);
    CellId first;
    if (!find_boundary_cell<D>(store, cage, &first)) return false;
    if (first == none) return true;
    CellList<D> boundary(store);
    if (!boundary.add(first)) return false;
    for (std::uint32_t k = 0; k < boundary.size(); ++k) {
        const CellId c = boundary[k];
        const Cell<D>& cell = store.cell(c);
        const bool known = cell.radius2 < infinity, contained = known && ball.contains(cell.centre);
        *leaves_ball |= !contained;
        if (contained) corner->offer(cell.centre, distance2<D>(cell.centre, centre), c);
        for (int i = 0; i <= D; ++i) {
            const CellId n = cell.neighbour[i].cell();
            if (!is_on_boundary<D>(store, cage, n)) continue;
            if (known && !contained && store.cell(n).radius2 < infinity && is_mixed<D>(store, cage, c, i))
                offer_crossing<D>(store, ball, centre, c, n, corner);
            if (!boundary.add(n)) return false;
        }
    }
    return true;
}

// The edges of the cage's cell after the cut are those behind mixed facets: where one with vertices inside of the cage
// alone is cut, the cell goes on to both sides in the plane of the cut, and does not reach farthest.
template <int D>
void find_cage_pole(const Store<D>& store, const Cage& cage, const Domain<D>& ball, double bound2, Corner<D>* corner) {
    const double* const centre = store.point(cage.centre);
    const Cut<D> cut(ball, centre, bound2);
    CutCorners<D> corners;
    const auto for_each_pair = [&](auto&& visit) {
        for (CellId c(0); c < store.state.cell_slots; ++c) {
            if (!store.is_live(c) || store.is_ghost(c) || !is_on_boundary<D>(store, cage, c)) continue;
            for (const VertexId w : store.cell(c).vertex)
                if (is_inside<D>(store, cage, store.point(w))) visit(w, c);
        }
    };
    for_each_pair([&](VertexId w, CellId c) { offer_cut_corners<D>(store, cut, w, c, &corners); });
    if (!corners.reach_beyond(bound2)) return;
    corner->distance2 = bound2;
    const auto contains = [&](const double* x) { return is_in_cage_cell<D>(store, cage, x); };
    for_each_pair([&](VertexId w, CellId c) { offer_poles<D>(store, ball, centre, w, c, 0, contains, corner); });
    if (!(corner->distance2 > bound2)) corner->distance2 = -1;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template bool find_cage_corner<D>(Store<D>&, const Cage&, const Domain<D>&, Corner<D>*, bool*);                    \
    template void find_cage_pole<D>(const Store<D>&, const Cage&, const Domain<D>&, double, Corner<D>*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
