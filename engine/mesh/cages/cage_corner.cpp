#include "mesh/cages/cage_corner.hpp"

#include "mesh/cages/any_cage.hpp"
#include "mesh/clip/clipped_cell.hpp"

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

// Calls visit(v) for the vertices on the boundary, some of them often, or for all in the mesh where those are fewer.
template <class Visit> void visit_boundary(const AnyStore& store, const CageBoundary& boundary, Visit&& visit) {
    const std::uint32_t width = static_cast<std::uint32_t>(store.dim) + 1;
    if (std::uint64_t{boundary.count} * width < store.state.vertex_count) {
        for (std::uint32_t k = 0; k < boundary.count;)
            for (const std::uint64_t piece = store.arena.piece(k, boundary.count, 10 * width * width); k < piece; ++k)
                for (const VertexId v : store.cell(boundary[k]).vertex)
                    if (v != none) visit(v);
    } else {
        for (VertexId v(0); v < store.state.vertex_count;)
            for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 10 * width); v < piece; ++v)
                if (store.vertex(v).cell != none) visit(v);
    }
}

// Is a vertex inside of the cage nearest to x, relative to its centre? Those on its boundary tell: between cells of
// vertices inside and outside there are facets of two of them. If x is in the cell of a vertex outside, the way from x
// to a vertex u on the boundary, inside, meets such a facet, at a point y that is as far from a w outside as from one
// inside, |y - w| <= |y - u|: w is no farther from x than u. And the other way round.
[[gnu::cold]] bool is_in_cage_cell(const AnyStore& store, const Cage& cage, const CageBoundary& boundary,
                                   const double* x) {
    const int dim = store.dim;
    const double* const centre = store.point(cage.centre);
    const double* nearest = centre;
    double inside2 = dot(dim, x, x), y[dimension_max];
    copy(dim, x, y);
    visit_boundary(store, boundary, [&](VertexId v) {
        const double* const p = store.point(v);
        if (!is_inside(store, cage, p)) return;
        double from[dimension_max];
        for (int i = 0; i < dim; ++i) from[i] = x[i] - (p[i] - centre[i]);
        const double d2 = dot(dim, from, from);
        if (!(d2 < inside2)) return;
        inside2 = d2;
        nearest = p;
        copy(dim, from, y);
    });
    const double length = square_root(inside2);
    bool is_nearest = true;
    visit_boundary(store, boundary, [&](VertexId v) {
        const double* const p = store.point(v);
        if (is_nearest && !is_inside(store, cage, p)) is_nearest = !is_nearer_to(dim, p, nearest, y, length);
    });
    return is_nearest;
}

}  // namespace

bool find_cage_corner(const AnyStore& store, const Cage& cage, const AnyDomain& ball, AnyCorner* corner,
                      bool* leaves_ball, CageBoundary* boundary) {
    *leaves_ball = false;
    if (!list_cage_boundary(store, cage, &boundary->count)) return false;
    boundary->cells = store.list_top();
    for (std::uint32_t k = 0; k < boundary->count; ++k) {
        store.arena.pass(2 * store.dim);
        *leaves_ball |= offer_clipped(store, cage, ball, (*boundary)[k], corner);
    }
    return true;
}

// The edges of the cage's cell after the cut are those behind mixed facets: where one with vertices inside of the cage
// alone is cut, the cell goes on to both sides in the plane of the cut, and does not reach farthest.
[[gnu::cold]] void find_cage_pole(const AnyStore& store, const Cage& cage, const AnyDomain& ball,
                                  const CageBoundary& boundary, double bound2, AnyCorner* corner) {
    const double* const centre = store.point(cage.centre);
    const Cut cut(ball, centre, bound2);
    CutCorners corners(store.dim);
    const auto for_each_pair = [&](auto&& visit) {
        for (std::uint32_t k = 0; k < boundary.count; ++k) {
            store.arena.pass(4 * store.dim);
            if (store.is_ghost(boundary[k])) continue;
            for (const VertexId w : store.cell(boundary[k]).vertex)
                if (is_inside(store, cage, store.point(w))) visit(w, boundary[k]);
        }
    };
    for_each_pair([&](VertexId w, CellId c) { offer_cut_corners(store, cut, w, c, &corners); });
    if (!corners.reach_beyond(bound2)) return;
    corner->distance2 = bound2;
    const auto contains = [&](const double* x) { return is_in_cage_cell(store, cage, boundary, x); };
    for_each_pair([&](VertexId w, CellId c) { offer_poles(store, ball, centre, w, c, 0, contains, corner); });
    if (!(corner->distance2 > bound2)) corner->distance2 = -1;
}

[[gnu::cold]] void raise_to_cage_cell(const AnyStore& store, const Cage& cage, const AnyDomain& ball,
                                      const CageBoundary& boundary, double* out2) {
    AnyCorner farthest(store.dim);
    farthest.distance2 = *out2;
    bool leaves_ball = false;
    for (std::uint32_t k = 0; k < boundary.count; ++k)
        leaves_ball |= offer_clipped(store, cage, ball, boundary[k], &farthest);
    *out2 = farthest.distance2;
    if (!leaves_ball) return;
    const Cut cut(ball, store.point(cage.centre), *out2 * (1 + 0x1p-40));
    CutCorners corners(store.dim);
    for (std::uint32_t k = 0; k < boundary.count; ++k)
        for (const VertexId w : store.cell(boundary[k]).vertex)
            if (is_inside(store, cage, store.point(w))) offer_cut_corners(store, cut, w, boundary[k], &corners);
    if (!corners.reach_beyond(cut.distance2())) return;
    AnyCorner pole(store.dim);
    find_cage_pole(store, cage, ball, boundary, cut.distance2(), &pole);
    if (pole.distance2 > *out2) *out2 = pole.distance2;
}

[[gnu::cold]] double distance2_of_cage_pole(const AnyStore& store, const Cage& cage, const AnyDomain& ball,
                                            const CageBoundary& boundary, double bound2) {
    AnyCorner pole(store.dim);
    find_cage_pole(store, cage, ball, boundary, bound2, &pole);
    return pole.distance2;
}

}  // namespace netmesh
