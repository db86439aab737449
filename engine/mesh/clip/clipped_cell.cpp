#include "mesh/clip/clipped_cell.hpp"

#include "delaunay/cell_list.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Normals and feet that are shorter than this times what they are made from have lost their direction.
constexpr double lost2 = 0x1p-60;
// Those shorter than this have roundings that are not small beside them.
constexpr double few2 = 0x1p-20;

// Is x, relative to u, as near to v as to all other vertices of its star?
bool is_in_cell(const AnyStore& store, const double* u, VertexId v, const double* x, const CellId* star,
                std::uint32_t count) {
    const int dim = store.dim;
    store.arena.pass(1 + count / 8);
    const double* const p = store.point(v);
    double y[dimension_max];
    for (int k = 0; k < dim; ++k) y[k] = x[k] - (p[k] - u[k]);
    const double length = square_root(dot(dim, y, y));
    for (std::uint32_t s = 0; s < count; ++s)
        for (const VertexId w : store.cell(star[-1 - static_cast<std::ptrdiff_t>(s)]).vertex) {
            if (w != v && w != none && is_nearer_to(dim, store.point(w), p, y, length)) return false;
        }
    return true;
}

// What raise_to_poles does.
template <int D> bool raise_by_star(const Store<D>& store, const Domain<D>& ball, VertexId v, double* out2) {
    const Cut cut(ball, store.point(v), *out2 * (1 + 0x1p-40));
    const std::uint32_t count = list_star(store, v);
    if (count == 0) return false;
    store.arena.pass(count / 2);
    const CellId* const star = store.list_top();
    if (!may_reach_beyond<D>(store, cut, v, cut.distance2(), star, count)) return true;
    AnyCorner farthest(store.dim);
    farthest.distance2 = *out2;
    offer_poles(AnyStore(store), AnyDomain(ball), store.point(v), v, star, count, &farthest);
    *out2 = farthest.distance2;
    return true;
}

// What measure_clipped_cells and measure_worst_cells do.
template <int D> class ClippedMeasure {
public:
    ClippedMeasure(const Store<D>& store, const Domain<D>& ball, double worst, double* out2)
        : store_(store), ball_(ball), worst_(worst), out2_(out2) {}
    Status run();

private:
    // What is within the root of this from v does not count.
    double least2(VertexId v) const { return worst_ * store_.vertex(v).nearest2; }
    void raise(const double* corner, VertexId v);
    void measure_corner(CellId c);
    void mark_poles(CellId c);

    const Store<D>& store_;
    const Domain<D>& ball_;
    double worst_;  // the largest out2 over nearest2 so far; negative: all are asked for
    double* const out2_;
};

template <int D> void ClippedMeasure<D>::raise(const double* corner, VertexId v) {
    const Vertex<D>& vertex = store_.vertex(v);
    const double d2 = distance2<D>(store_.dim, corner, vertex.x);
    if (!(d2 > out2_[v])) return;
    out2_[v] = d2;
    if (worst_ >= 0 && vertex.marker != Marker::exempt && d2 > least2(v)) worst_ = d2 / vertex.nearest2;
}

// A corner inside the ball, or crossings of its edges.
template <int D> void ClippedMeasure<D>::measure_corner(CellId c) {
    const Cell<D>& cell = store_.cell(c);
    for (int i = 0; i <= store_.dim; ++i)
        for (int k = 0; k <= store_.dim && cell.neighbour[i] == none; ++k)
            if (k != i) out2_[cell.vertex[k]] = infinity;
    if (!(cell.radius2 < infinity)) return;
    if (ball_.contains(cell.centre)) {
        for (const VertexId v : cell.vertex)
            if (!is_within(cell, least2(v))) raise(cell.centre, v);
        return;
    }
    for (int i = 0; i <= store_.dim; ++i) {
        if (cell.neighbour[i] == none) continue;
        const CellId n = cell.neighbour[i].cell();
        const Cell<D>& other = store_.cell(n);
        if (!(other.radius2 < infinity) || (n < c && !ball_.contains(other.centre))) continue;
        double z[2][DimensionOf<D>::most];
        const int crossings = sphere_crossings(ball_, cell.centre, other.centre, z);
        for (int j = 0; j < crossings; ++j)
            for (int k = 0; k <= store_.dim; ++k)
                if (k != i) raise(z[j], cell.vertex[k]);
    }
}

// Marks as queued those vertices of c, a corner outside or one that is not known, whose poles may count.
template <int D> void ClippedMeasure<D>::mark_poles(CellId c) {
    const Cell<D>& cell = store_.cell(c);
    if (cell.radius2 < infinity && ball_.contains(cell.centre)) return;
    for (const VertexId v : cell.vertex) {
        auto&& vertex = store_.vertex(v);
        if (vertex.queued != 0 || vertex.marker == Marker::exempt || !(out2_[v] < infinity)) continue;
        const double known2 = out2_[v] > least2(v) ? out2_[v] : least2(v);
        const double s2 = known2 * (1 + 0x1p-40);
        if (is_within(cell, s2)) continue;
        const Cut cut(ball_, vertex.x, s2);
        vertex.queued = may_reach_beyond<D>(store_, cut, v, s2, c) ? 1 : 0;
    }
}

template <int D> Status ClippedMeasure<D>::run() {
    const std::uint32_t vertices = store_.state.vertex_count, cells = store_.state.cell_slots;
    for (std::uint32_t v = 0; v < vertices;)
        for (const std::uint64_t piece = store_.arena.piece(v, vertices, 6); v < piece; ++v) {
            out2_[v] = 0;
        }
    for (CellId c(0); c < cells;)
        for (const std::uint64_t piece = store_.arena.piece(c, cells, 70 * store_.dim); c < piece; ++c) {
            measure_corner(c);
        }
    for (CellId c(0); c < cells;)
        for (const std::uint64_t piece = store_.arena.piece(c, cells, 40 * store_.dim); c < piece; ++c) {
            mark_poles(c);
        }
    Status status = Status::ok;
    for (VertexId v(0); v < vertices;)
        for (const std::uint64_t piece = store_.arena.piece(v, vertices, 30); v < piece; ++v) {
            auto&& vertex = store_.vertex(v);
            if (vertex.cell == none || vertex.marker == Marker::exempt)
                out2_[v] = 0;
            else if (vertex.queued != 0 && status == Status::ok && !raise_by_star(store_, ball_, v, &out2_[v]))
                status = Status::out_of_memory;
            vertex.queued = 0;
        }
    return status;
}

// f(the store, the ball), of the dimension or of any.
template <class F> auto with_store(const AnyStore& store, const AnyDomain& ball, F&& f) {
    return with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        constexpr int D = shared_dimension<decltype(dimension)::value>;
        return f(store.of_dimension<D>(), ball.of_dimension<D>());
    });
}

// Positions of the neighbours of c at v, across facets, that have a smaller index.
unsigned neighbours_before(const AnyStore& store, VertexId v, CellId c) {
    const AnyCell cell = store.cell(c);
    unsigned before = 0;
    for (int i = 0; i <= store.dim; ++i) {
        if (cell.vertex[i] == v) continue;
        const CellId n = cell.neighbour[i].cell();
        if (n < c && !store.is_ghost(n)) before |= 1u << i;
    }
    return before;
}

}  // namespace

void offer_cut_corners(const AnyStore& store, const Cut& cut, VertexId w, CellId c, CutCorners* corners) {
    const int dim = store.dim;
    const AnyCell cell = store.cell(c);
    if (!(cell.radius2 < infinity)) {
        corners->unknown |= !store.is_ghost(c);
        return;
    }
    const double here = cut.height(dim, cell.centre);
    if (!(here > 0)) corners->offer(cell.centre, distance2(dim, cell.centre, cut.origin()), c);
    for (int i = 0; i <= dim; ++i) {
        if (cell.vertex[i] == w || cell.neighbour[i] == none) continue;
        const CellId n = cell.neighbour[i].cell();
        const AnyCell other = store.cell(n);
        if (n < c || !(other.radius2 < infinity)) continue;
        const double there = cut.height(dim, other.centre);
        if (here > 0 ? there > 0 : !(there > 0)) continue;
        double x[dimension_max];
        cut_edge(dim, cell, here, other, there, x);
        corners->offer(x, distance2(dim, x, cut.origin()), c);
    }
}

[[gnu::cold]] bool find_reaching_point(const AnyStore& store, const Cut& cut, VertexId w, const CutCorners& corners,
                                       double* x) {
    const int dim = store.dim;
    const double *const u = cut.origin(), s2 = cut.distance2();
    const double* from = store.point(w);
    if (cut.height(dim, from) > 0 || distance2(dim, from, u) > s2) from = corners.near;
    if (!(corners.far.distance2 > s2) || (from == corners.near && !(corners.near2 <= s2))) return false;
    double along = 0, length2 = 0, from2 = 0;
    for (int k = 0; k < dim; ++k) {
        const double e = corners.far.x[k] - from[k], f = from[k] - u[k];
        along += e * f;
        length2 += e * e;
        from2 += f * f;
    }
    // The larger root, without cancellation, and with no more than squares of lengths on the way.
    const double length = square_root(length2), height = along / length, rest = s2 > from2 ? s2 - from2 : 0;
    const double root = square_root(height * height + rest);
    const double t = (height > 0 ? rest / (height + root) : root - height) / length;
    for (int k = 0; k < dim; ++k) x[k] = from[k] + t * (corners.far.x[k] - from[k]);
    return true;
}

[[gnu::cold]] bool Flat::cut(const double* u, const double* w, const double* x) {
    double* const n = normal[codimension];
    double length2 = 0, rest2 = 0, level = 0;
    for (int k = 0; k < dim; ++k) {
        n[k] = x[k] - w[k];
        length2 += n[k] * n[k];
        level += n[k] * (w[k] - u[k]);
    }
    level += 0.5 * length2;
    // A second time where the first one leaves little: its roundings are then no more small beside the rest.
    for (int pass = 0; pass < 2; ++pass) {
        for (int i = 0; i < codimension; ++i) {
            const double along = dot(dim, n, normal[i]);
            for (int k = 0; k < dim; ++k) n[k] -= along * normal[i][k];
            level -= along * offset[i];
        }
        rest2 = dot(dim, n, n);
        if (rest2 > few2 * length2) break;
    }
    const double rest = square_root(rest2);
    if (!(rest2 > lost2 * length2)) return false;
    for (int k = 0; k < dim; ++k) n[k] /= rest;
    offset[codimension++] = level / rest;
    return true;
}

[[gnu::cold]] void Flat::foot(const double* p, double* at) const {
    copy(dim, p, at);
    for (int i = 0; i < codimension; ++i) {
        double along = -offset[i];
        for (int k = 0; k < dim; ++k) along += p[k] * normal[i][k];
        for (int k = 0; k < dim; ++k) at[k] -= along * normal[i][k];
    }
}

[[gnu::cold]] void Flat::direction(double* along) const {
    double best = 0;
    for (int axis = 0; axis < dim; ++axis) {
        double p[dimension_max] = {};
        p[axis] = 1;
        for (int i = 0; i < codimension; ++i)
            for (int k = 0; k < dim; ++k) p[k] -= normal[i][axis] * normal[i][k];
        const double length2 = dot(dim, p, p);
        if (!(length2 > best)) continue;
        best = length2;
        for (int k = 0; k < dim; ++k) along[k] = p[k] / square_root(length2);
    }
}

[[gnu::cold]] bool Flat::poles(const AnyDomain& ball, const double* u, double (&x)[2][dimension_max]) const {
    const double zero[dimension_max] = {};
    double centre[dimension_max], middle[dimension_max], nearest[dimension_max], away[dimension_max];
    for (int k = 0; k < dim; ++k) centre[k] = ball.centre[k] - u[k];
    foot(centre, middle);
    foot(zero, nearest);
    for (int k = 0; k < dim; ++k) away[k] = middle[k] - nearest[k];
    const double radius2 = ball.radius * ball.radius - distance2(dim, middle, centre);
    if (!(radius2 > 0)) return false;
    double away2 = dot(dim, away, away);
    if (away2 < few2 * ball.radius * ball.radius) {  // what roundings left of the normals is not along the flat
        for (int i = 0; i < codimension; ++i) {
            const double along = dot(dim, away, normal[i]);
            for (int k = 0; k < dim; ++k) away[k] -= along * normal[i][k];
        }
        away2 = dot(dim, away, away);
    }
    if (away2 > lost2 * ball.radius * ball.radius)
        for (int k = 0; k < dim; ++k) away[k] /= square_root(away2);
    else
        direction(away);
    const double radius = square_root(radius2);
    for (int k = 0; k < dim; ++k) {
        x[0][k] = middle[k] + radius * away[k];
        x[1][k] = middle[k] - radius * away[k];
    }
    return true;
}

[[gnu::cold]] void offer_poles(const AnyStore& store, const AnyDomain& ball, const double* u, VertexId v,
                               const CellId* star, std::uint32_t count, AnyCorner* farthest) {
    const auto contains = [&](const double* x) { return is_in_cell(store, u, v, x, star, count); };
    for (std::uint32_t s = 0; s < count; ++s) {
        const CellId c = star[-1 - static_cast<std::ptrdiff_t>(s)];
        if (store.is_ghost(c)) continue;
        store.arena.pass(1 << store.dim);
        offer_poles(store, ball, u, v, c, neighbours_before(store, v, c), contains, farthest);
    }
}

[[gnu::cold]] void find_beyond(const AnyStore& store, const AnyDomain& ball, const double* u, VertexId v, double bound2,
                               std::uint32_t count, AnyCorner* found) {
    const CellId* const star = store.list_top();
    const Cut cut(ball, u, bound2);
    CutCorners corners(store.dim);
    for (std::uint32_t k = 0; k < count; ++k)
        offer_cut_corners(store, cut, v, star[-1 - static_cast<std::ptrdiff_t>(k)], &corners);
    if (!corners.reach_beyond(bound2)) return;
    double x[dimension_max];
    if (find_reaching_point(store, cut, v, corners, x))
        return found->offer(x, distance2(store.dim, x, u), corners.far.cell);
    found->distance2 = bound2;
    offer_poles(store, ball, u, v, star, count, found);
    if (!(found->distance2 > bound2)) found->distance2 = -1;
}

[[gnu::cold]] bool raise_to_poles(const AnyStore& any, const AnyDomain& ball, VertexId v, double* out2) {
    return with_store(any, ball,
                      [&](const auto& store, const auto& its) { return raise_by_star(store, its, v, out2); });
}

Status measure_clipped_cells(const AnyStore& any, const AnyDomain& ball, double* out2) {
    return with_store(any, ball,
                      [&](const auto& store, const auto& its) { return ClippedMeasure(store, its, -1, out2).run(); });
}

Status measure_worst_cells(const AnyStore& any, const AnyDomain& ball, double* out2) {
    return with_store(any, ball,
                      [&](const auto& store, const auto& its) { return ClippedMeasure(store, its, 0, out2).run(); });
}

}  // namespace netmesh
