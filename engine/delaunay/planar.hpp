// The plane's own way of finding and filling a cavity: its boundary is a cycle, so nothing has to be searched for. For
// meshes, whose cells have circles; triangulations of points have plane.hpp. A part of kernel.cpp; templates, so that
// nothing of it is made where the plane is not served.
#pragma once
#include "delaunay/kernel.hpp"

namespace netmesh {

#ifndef __OPTIMIZE_SIZE__
// An edge from the new point, used by two new cells.
struct PlanarEdge {
    double x, y, half_square;
    bool plain;  // nothing underflows or overflows
};

inline PlanarEdge edge_to(const double* q, const double* a) {
    const double x = a[0] - q[0], y = a[1] - q[1], half_square = 0.5 * (x * x + y * y);
    return {x, y, half_square, half_square > edge_square_min && half_square < edge_square_max};
}

// What solve_sphere does, for q and the ends of two edges. False when it has to be asked.
inline bool circumscribe(const double* q, const PlanarEdge& a, const PlanarEdge& b, double error_max, Cell<2>& cell) {
    constexpr double shape = shape_factor<2>();
    const double inverse = 1 / (a.x * b.y - a.y * b.x);
    const double x = q[0] + (a.half_square * b.y - a.y * b.half_square) * inverse;
    const double y = q[1] + (a.x * b.half_square - a.half_square * b.x) * inverse;
    const double dx = q[0] - x, dy = q[1] - y;
    const double radius2 = dx * dx + dy * dy;
    const double error2 = 2.1 * (shape * shape * (4 * a.half_square * b.half_square) * (inverse * inverse) +
                                 8 * unit_roundoff * unit_roundoff * ((x * x + y * y) / radius2));
    if (!(a.plain && b.plain && error2 < error_max * error_max)) return false;
    cell.centre[0] = x;
    cell.centre[1] = y;
    cell.radius2 = radius2;
    cell.error = static_cast<float>(1.01 * square_root(error2));
    return true;
}
#endif

// In the plane the cells in conflict form a tree, as no vertex is inside the cavity. It is searched depth first and
// counterclockwise, so no cell is met twice, none has to be marked, and the bounding facets come in their order. Facets
// that are found and facets that wait number two more than the cells.
template <int D>
bool PlanarCavity<D>::find(Kernel<D, NoWeights>& kernel, const double* q, VertexId id, CellId first, Cavity* cavity) {
    constexpr std::uint32_t next[4] = {1, 2, 0, 0};
    const Store<D>& store = kernel.store_;
    const std::size_t capacity = kernel.list_capacity();
    PlanarLine* const end = kernel.list_end();
    if (capacity < 3) return kernel.refuse_list(3);
    const Cell<D>* const cells = &store.cell(0);
    end[0].made = first;
    end[0].waiting = FacetId(first, 2);
    end[-1].waiting = FacetId(first, 1);
    FacetId facet(first, 0);
    std::ptrdiff_t count = 1, facets = 0, waiting = 2;
    for (;;) {
        const Cell<D>& cell = cells[facet.cell()];
        const FacetId beyond = cell.neighbour[facet.position()];
        const CellId n = beyond.cell();
        if (kernel.in_conflict(n, q, id)) {
            if (static_cast<std::size_t>(count) + 3 > capacity)
                return kernel.refuse_list(static_cast<std::size_t>(count) + 3);
            const std::uint32_t i = next[beyond.position()];
            end[-count++].made = n;
            end[-waiting++].waiting = FacetId(n, next[i]);
            facet = FacetId(n, i);
            continue;
        }
        end[-facets].beyond = beyond;
        end[-facets++].start = cell.vertex[next[facet.position()]];
        if (waiting == 0) break;
        facet = end[-(--waiting)].waiting;
    }
    store.arena.use_gap(static_cast<std::size_t>(count + 2) * sizeof(PlanarLine));
    *cavity = {static_cast<std::uint32_t>(count), static_cast<std::uint32_t>(facets), 0, false};
    return true;
}

// In the plane the facets come counterclockwise, so each new cell (id, a, b) has its neighbours before and after it;
// and as its ball is solved from its points, which costs no more than from other balls, it can take the place of an old
// cell at once.
template <int D> void PlanarCavity<D>::fill(Kernel<D, NoWeights>& kernel, const Cavity& cavity, VertexId id) {
    Store<D>& store = kernel.store_;
    Cell<D>* const cells = &store.cell(0);
    PlanarLine* const end = kernel.list_end();
    const std::ptrdiff_t facets = cavity.facets;
    const bool keeps = kernel.vertex_cells_ == VertexCells::kept;
    end[2 - facets].made = store.new_cell();
    end[1 - facets].made = store.new_cell();
    store.state.cells_created += cavity.cells;
    CellId before = end[1 - facets].made;
    VertexId a = end[0].start;
    const double* const q = store.point(id);
#ifndef __OPTIMIZE_SIZE__
    PlanarEdge from = a == none ? PlanarEdge{} : edge_to(q, store.point(a));
#endif
    for (std::ptrdiff_t k = 0; k < facets; ++k) {
        const CellId n = end[-k].made;
        const FacetId beyond = end[-k].beyond;
        const VertexId b = end[k + 1 < facets ? -k - 1 : 0].start;
        Cell<D>& fresh = cells[n];
        fresh.vertex[0] = id;
        fresh.vertex[1] = a;
        fresh.vertex[2] = b;
        fresh.neighbour[0] = beyond;
        fresh.neighbour[2] = FacetId(before, 1);
        fresh.mark = 0;
        cells[before].neighbour[1] = FacetId(n, 2);
        cells[beyond.cell()].neighbour[beyond.position()] = FacetId(n, 0);
        bool known = a == none || b == none;
        if (known) make_ghost<D>(fresh);
#ifndef __OPTIMIZE_SIZE__
        const PlanarEdge to = b == none ? PlanarEdge{} : edge_to(q, store.point(b));
        known = known || circumscribe(q, from, to, kernel.error_max_, fresh);
        from = to;
#endif
        if (!known) {
            const double* const p[3] = {q, store.point(a), store.point(b)};
            solve_sphere<D>(p, kernel.error_max_, fresh);
        }
        if (keeps && a != none) store.vertex(a).cell = n;
        before = n;
        a = b;
    }
    if (keeps) store.vertex(id).cell = before;
    store.state.last_cell = before;
}

}  // namespace netmesh
