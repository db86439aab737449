#include "mesh/cage_corner.hpp"

#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Offers where the edges of the cage's cell that end in the corner of cell c, which is outside of the ball, cross its sphere.
template <int D>
void offer_crossing(const Store<D>& store, const Domain<D>& ball, const double* centre, std::uint32_t c,
                    std::uint32_t behind, Corner<D>* corner) {
    double z[2][D];
    const int crossings = sphere_crossings<D>(ball, store.cell(c).centre, store.cell(behind).centre, z);
    for (int j = 0; j < crossings; ++j) corner->offer(z[j], distance2<D>(z[j], centre), c);
}

}  // namespace

template <int D>
bool find_cage_corner(Store<D>& store, Kernel<D>& kernel, const Cage& cage, const Domain<D>& ball, Corner<D>* corner) {
    const double* const centre = store.point(cage.centre);
    std::uint32_t first = none;
    if (!kernel.visit_star(cage.shell, [&](std::uint32_t c) {
            if (first == none && is_on_boundary<D>(store, cage, c)) first = c;
        }))
        return false;
    if (first == none) return true;
    const std::uint32_t stamp = store.new_stamp();
    const std::size_t capacity = store.list_capacity();
    std::uint32_t* const list = store.list_top();
    std::uint32_t count = 1;
    list[-1] = first;
    store.cell(first).mark = stamp;
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t c = list[-1 - static_cast<std::ptrdiff_t>(k)];
        const Cell<D>& cell = store.cell(c);
        const bool known = cell.radius2 < infinity, contained = known && ball.contains(cell.centre);
        if (contained) corner->offer(cell.centre, distance2<D>(cell.centre, centre), c);
        for (int i = 0; i <= D; ++i) {
            const std::uint32_t n = cell.neighbour[i] >> 3;
            if (!is_on_boundary<D>(store, cage, n)) continue;
            if (known && !contained && store.cell(n).radius2 < infinity)
                offer_crossing<D>(store, ball, centre, c, n, corner);
            if (store.cell(n).mark == stamp) continue;
            if (count >= capacity) {
                store.arena.refuse(4);
                return false;
            }
            store.cell(n).mark = stamp;
            list[-1 - static_cast<std::ptrdiff_t>(count++)] = n;
        }
    }
    return true;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template bool find_cage_corner<D>(Store<D>&, Kernel<D>&, const Cage&, const Domain<D>&, Corner<D>*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
