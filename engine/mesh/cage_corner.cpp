#include "mesh/cage_corner.hpp"

#include "delaunay/cell_list.hpp"
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

}  // namespace

// Cells on the boundary are connected.
template <int D> bool find_cage_corner(Store<D>& store, const Cage& cage, const Domain<D>& ball, Corner<D>* corner) {
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
        if (contained) corner->offer(cell.centre, distance2<D>(cell.centre, centre), c);
        for (int i = 0; i <= D; ++i) {
            const CellId n = cell.neighbour[i].cell();
            if (!is_on_boundary<D>(store, cage, n)) continue;
            if (known && !contained && store.cell(n).radius2 < infinity)
                offer_crossing<D>(store, ball, centre, c, n, corner);
            if (!boundary.add(n)) return false;
        }
    }
    return true;
}

#define NETMESH_INSTANTIATE(D) template bool find_cage_corner<D>(Store<D>&, const Cage&, const Domain<D>&, Corner<D>*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
