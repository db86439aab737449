#include "mesh/cage_corner.hpp"

#include "mesh/clipped_cell.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Offers the corner of cell c, on the cage's boundary, where the ball contains it, otherwise where the edges of the
// cage's cell that end in it cross the sphere. True when the ball does not contain it, or when it is not known.
template <int D>
[[gnu::noinline]] bool offer_clipped(const Store<D>& store, const Cage& cage, const Domain<D>& ball, CellId c,
                                     Corner<D>* corner) {
    const Cell<D>& cell = store.cell(c);
    const double* const centre = store.point(cage.centre);
    if (!(cell.radius2 < infinity)) return true;
    if (ball.contains(cell.centre)) {
        corner->offer(cell.centre, distance2<D>(cell.centre, centre), c);
        return false;
    }
    for (int i = 0; i <= D; ++i) {
        if (cell.neighbour[i] == none) continue;
        const Cell<D>& behind = store.cell(cell.neighbour[i].cell());
        if (!(behind.radius2 < infinity) || !is_mixed<D>(store, cage, c, i)) continue;
        double z[2][D];
        const int crossings = sphere_crossings(D, ball.centre, ball.radius, cell.centre, behind.centre, {z[0], z[1]});
        for (int j = 0; j < crossings; ++j) corner->offer(z[j], distance2<D>(z[j], centre), c);
    }
    return true;
}

// Is a vertex inside of the cage nearest to x?
template <int D> [[gnu::cold]] bool is_in_cage_cell(const Store<D>& store, const Cage& cage, const double* x) {
    const double* nearest = store.point(cage.centre);
    double inside2 = distance2<D>(x, nearest), y[D];
    for (VertexId v(0); v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 10 * D); v < piece; ++v) {
            const double* const p = store.point(v);
            if (store.vertex(v).cell == none || !is_inside<D>(store, cage, p) || !(distance2<D>(x, p) < inside2))
                continue;
            inside2 = distance2<D>(x, p);
            nearest = p;
        }
    for (int k = 0; k < D; ++k) y[k] = x[k] - nearest[k];
    const double length = square_root(inside2);
    for (VertexId v(0); v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 10 * D); v < piece; ++v) {
            const double* const p = store.point(v);
            if (store.vertex(v).cell == none || is_inside<D>(store, cage, p)) continue;
            if (is_nearer_to<D>(p, nearest, y, length)) return false;
        }
    return true;
}

}  // namespace

template <int D>
bool find_cage_corner(Store<D>& store, const Cage& cage, const Domain<D>& ball, Corner<D>* corner, bool* leaves_ball) {
    *leaves_ball = false;
    return visit_cage_boundary(store, cage, [&](CellId c) {
        store.arena.pass(2 * D);
        *leaves_ball |= offer_clipped<D>(store, cage, ball, c, corner);
    });
}

// The edges of the cage's cell after the cut are those behind mixed facets: where one with vertices inside of the cage
// alone is cut, the cell goes on to both sides in the plane of the cut, and does not reach farthest.
template <int D>
[[gnu::cold]] void find_cage_pole(const Store<D>& store, const Cage& cage, const Domain<D>& ball, double bound2,
                                  Corner<D>* corner) {
    const double* const centre = store.point(cage.centre);
    const Cut<D> cut(ball, centre, bound2);
    CutCorners<D> corners;
    const auto for_each_pair = [&](auto&& visit) {
        for (CellId c(0); c < store.state.cell_slots;)
            for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 60 * D); c < piece; ++c) {
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

template <int D>
[[gnu::cold]] void raise_to_cage_cell(const Store<D>& store, const Cage& cage, const Domain<D>& ball,
                                      const CellId* boundary, std::uint32_t count, double* out2) {
    Corner<D> farthest;
    farthest.distance2 = *out2;
    bool leaves_ball = false;
    for (std::uint32_t k = 0; k < count; ++k)
        leaves_ball |= offer_clipped<D>(store, cage, ball, boundary[-1 - static_cast<std::ptrdiff_t>(k)], &farthest);
    *out2 = farthest.distance2;
    if (!leaves_ball) return;
    const Cut<D> cut(ball, store.point(cage.centre), *out2 * (1 + 0x1p-40));
    CutCorners<D> corners;
    for (std::uint32_t k = 0; k < count; ++k) {
        const CellId c = boundary[-1 - static_cast<std::ptrdiff_t>(k)];
        for (const VertexId w : store.cell(c).vertex)
            if (is_inside<D>(store, cage, store.point(w))) offer_cut_corners<D>(store, cut, w, c, &corners);
    }
    if (!corners.reach_beyond(cut.distance2())) return;
    Corner<D> pole;
    find_cage_pole<D>(store, cage, ball, cut.distance2(), &pole);
    if (pole.distance2 > *out2) *out2 = pole.distance2;
}

[[gnu::cold]] void raise_to_cage_cell(const AnyStore& store, const Cage& cage, const AnyDomain& ball,
                                      const CellId* boundary, std::uint32_t count, double* out2) {
    with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        raise_to_cage_cell<D>(store.of_dimension<D>(), cage, ball.of_dimension<D>(), boundary, count, out2);
    });
}

[[gnu::cold]] double distance2_of_cage_pole(const AnyStore& store, const Cage& cage, const AnyDomain& ball,
                                            double bound2) {
    return with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Corner<D> pole;
        find_cage_pole<D>(store.of_dimension<D>(), cage, ball.of_dimension<D>(), bound2, &pole);
        return pole.distance2;
    });
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template bool find_cage_corner<D>(Store<D>&, const Cage&, const Domain<D>&, Corner<D>*, bool*);                    \
    template void raise_to_cage_cell<D>(const Store<D>&, const Cage&, const Domain<D>&, const CellId*, std::uint32_t,  \
                                        double*);                                                                      \
    template void find_cage_pole<D>(const Store<D>&, const Cage&, const Domain<D>&, double, Corner<D>*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
