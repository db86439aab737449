#include "mesh/cage_corner.hpp"

#include "mesh/any_cage.hpp"
#include "mesh/clipped_cell.hpp"

namespace netmesh {
namespace {

// Offers the corner of cell c, on the cage's boundary, where the ball contains it, otherwise where the edges of the
// cage's cell that end in it cross the sphere. True when the ball does not contain it, or when it is not known.
[[gnu::noinline]] bool offer_clipped(const AnyStore& store, const Cage& cage, const AnyDomain& ball, CellId c,
                                     AnyCorner* corner) {
    const int dim = store.dim;
    const AnyCell cell = store.cell(c);
    const double* const centre = store.point(cage.centre);
    if (!(cell.radius2 < infinity)) return true;
    if (ball.contains(cell.centre)) {
        corner->offer(cell.centre, distance2(dim, cell.centre, centre), c);
        return false;
    }
    for (int i = 0; i <= dim; ++i) {
        if (cell.neighbour[i] == none) continue;
        const AnyCell behind = store.cell(cell.neighbour[i].cell());
        if (!(behind.radius2 < infinity) || !is_mixed(store, cage, c, i)) continue;
        double z[2][dimension_max];
        const int crossings = sphere_crossings(ball, cell.centre, behind.centre, z);
        for (int j = 0; j < crossings; ++j) corner->offer(z[j], distance2(dim, z[j], centre), c);
    }
    return true;
}

// Is a vertex inside of the cage nearest to x?
[[gnu::cold]] bool is_in_cage_cell(const AnyStore& store, const Cage& cage, const double* x) {
    const int dim = store.dim;
    const double* nearest = store.point(cage.centre);
    double inside2 = distance2(dim, x, nearest), y[dimension_max];
    for (VertexId v(0); v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 10 * dim); v < piece; ++v) {
            const double* const p = store.point(v);
            if (store.vertex(v).cell == none || !is_inside(store, cage, p) || !(distance2(dim, x, p) < inside2))
                continue;
            inside2 = distance2(dim, x, p);
            nearest = p;
        }
    for (int k = 0; k < dim; ++k) y[k] = x[k] - nearest[k];
    const double length = square_root(inside2);
    for (VertexId v(0); v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 10 * dim); v < piece; ++v) {
            const double* const p = store.point(v);
            if (store.vertex(v).cell == none || is_inside(store, cage, p)) continue;
            if (is_nearer_to(dim, p, nearest, y, length)) return false;
        }
    return true;
}

}  // namespace

bool find_cage_corner(const AnyStore& store, const Cage& cage, const AnyDomain& ball, AnyCorner* corner,
                      bool* leaves_ball) {
    *leaves_ball = false;
    std::uint32_t count;
    if (!list_cage_boundary(store, cage, &count)) return false;
    const CellId* const boundary = store.list_top();
    for (std::uint32_t k = 0; k < count; ++k) {
        store.arena.pass(2 * store.dim);
        *leaves_ball |= offer_clipped(store, cage, ball, boundary[-1 - static_cast<std::ptrdiff_t>(k)], corner);
    }
    return true;
}

// The edges of the cage's cell after the cut are those behind mixed facets: where one with vertices inside of the cage
// alone is cut, the cell goes on to both sides in the plane of the cut, and does not reach farthest.
[[gnu::cold]] void find_cage_pole(const AnyStore& store, const Cage& cage, const AnyDomain& ball, double bound2,
                                  AnyCorner* corner) {
    const double* const centre = store.point(cage.centre);
    const Cut cut(ball, centre, bound2);
    CutCorners corners(store.dim);
    const auto for_each_pair = [&](auto&& visit) {
        for (CellId c(0); c < store.state.cell_slots;)
            for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 60 * store.dim); c < piece;
                 ++c) {
                if (!store.is_live(c) || store.is_ghost(c) || !is_on_boundary(store, cage, c)) continue;
                for (const VertexId w : store.cell(c).vertex)
                    if (is_inside(store, cage, store.point(w))) visit(w, c);
            }
    };
    for_each_pair([&](VertexId w, CellId c) { offer_cut_corners(store, cut, w, c, &corners); });
    if (!corners.reach_beyond(bound2)) return;
    corner->distance2 = bound2;
    const auto contains = [&](const double* x) { return is_in_cage_cell(store, cage, x); };
    for_each_pair([&](VertexId w, CellId c) { offer_poles(store, ball, centre, w, c, 0, contains, corner); });
    if (!(corner->distance2 > bound2)) corner->distance2 = -1;
}

[[gnu::cold]] void raise_to_cage_cell(const AnyStore& store, const Cage& cage, const AnyDomain& ball,
                                      const CellId* boundary, std::uint32_t count, double* out2) {
    AnyCorner farthest(store.dim);
    farthest.distance2 = *out2;
    bool leaves_ball = false;
    for (std::uint32_t k = 0; k < count; ++k)
        leaves_ball |= offer_clipped(store, cage, ball, boundary[-1 - static_cast<std::ptrdiff_t>(k)], &farthest);
    *out2 = farthest.distance2;
    if (!leaves_ball) return;
    const Cut cut(ball, store.point(cage.centre), *out2 * (1 + 0x1p-40));
    CutCorners corners(store.dim);
    for (std::uint32_t k = 0; k < count; ++k) {
        const CellId c = boundary[-1 - static_cast<std::ptrdiff_t>(k)];
        for (const VertexId w : store.cell(c).vertex)
            if (is_inside(store, cage, store.point(w))) offer_cut_corners(store, cut, w, c, &corners);
    }
    if (!corners.reach_beyond(cut.distance2())) return;
    AnyCorner pole(store.dim);
    find_cage_pole(store, cage, ball, cut.distance2(), &pole);
    if (pole.distance2 > *out2) *out2 = pole.distance2;
}

[[gnu::cold]] double distance2_of_cage_pole(const AnyStore& store, const Cage& cage, const AnyDomain& ball,
                                            double bound2) {
    AnyCorner pole(store.dim);
    find_cage_pole(store, cage, ball, bound2, &pole);
    return pole.distance2;
}

}  // namespace netmesh
