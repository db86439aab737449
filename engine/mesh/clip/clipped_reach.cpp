#include "mesh/clip/clipped_reach.hpp"

#include "certificate/cells.hpp"
#include "delaunay/cell_list.hpp"
#include "mesh/clip/clipped_cell.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

double larger(double a, double b) { return a > b ? a : b; }
double smaller(double a, double b) { return a < b ? a : b; }

// What a corner is known within.
double doubt_of(const AnyCell& cell) { return static_cast<double>(cell.error) * square_root(cell.radius2) * up; }

// The part of a Voronoi edge in the half-space of u and s, as the head says: calls show(y, most, wrong) for its ends, y
// relative to u. What they stand for of the true edge is within `wrong` of y and no farther from u than `most`.
template <class Show>
void cut_doubtful_edge(const AnyDomain& ball, const double* u, double s, const AnyCell& cell, const AnyCell& other,
                       double doubt_here, double doubt_there, Show&& show) {
    const int dim = ball.dim;
    double a[dimension_max], y[dimension_max], z[dimension_max];
    for (int j = 0; j < dim; ++j) {
        a[j] = u[j] - ball.centre[j];
        y[j] = cell.centre[j] - u[j];
        z[j] = other.centre[j] - u[j];
    }
    const double away2 = dot(dim, a, a), r2 = ball.radius * ball.radius, s2 = s * s;
    const double away = square_root(away2), level = away2 - r2 + s2;
    const double near = square_root(dot(dim, y, y)), apart = square_root(dot(dim, z, z)), both = near + apart;
    const double e = sum_slack * (2 * both * away + away2 + r2 + s2);
    const auto slack = [&](double doubt) { return (2 * away * doubt + 4 * e) * (1 + 0x1p-20); };
    const double here = 2 * dot(dim, y, a) + level - slack(doubt_here);
    const double there = 2 * dot(dim, z, a) + level - slack(doubt_there);
    const auto show_end = [&](const double* x, double distance, double doubt) {
        show(x, (distance + doubt + sum_slack * both) * up, doubt + sum_slack * both);
    };
    if (!(here > 0)) show_end(y, near, doubt_here);
    if (!(there > 0)) show_end(z, apart, doubt_there);
    if ((here > 0) == (there > 0)) return;
    const double t = here / (here - there);
    for (int j = 0; j < dim; ++j) y[j] += t * (z[j] - y[j]);
    show_end(y, square_root(dot(dim, y, y)), doubt_here + t * (doubt_there - doubt_here));
}

// B of the head for every vertex with s >= 0, the others are left alone. O(cells).
void find_far_corners(const AnyStore& store, const AnyDomain& ball, const double* s, double* far) {
    const int dim = store.dim;
    for (VertexId v(0); v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 6); v < piece; ++v) {
            far[v] = 0;
        }
    for (CellId c(0); c < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 150 * dim * dim); c < piece;
             ++c) {
            for (int i = 0; i <= dim; ++i) {
                const AnyCell cell = store.cell(c);
                if (cell.neighbour[i] == none || cell.neighbour[i].cell() < c) continue;
                const AnyCell other = store.cell(cell.neighbour[i].cell());
                const double doubt = larger(doubt_of(cell), doubt_of(other));
                for (int k = 0; k <= dim; ++k) {
                    const VertexId v = cell.vertex[k];
                    if (k == i || !(s[v] >= 0)) continue;
                    cut_doubtful_edge(ball, store.point(v), s[v], cell, other, doubt, doubt,
                                      [&](const double*, double most, double) {
                                          if (!(most <= far[v])) far[v] = most;
                                      });
                }
            }
        }
}

// Distances from the ball's centre to the cells of vertices outside of the ball, at least.
void find_bisectors(const AnyStore& store, const AnyDomain& ball, double* distance_of) {
    const int dim = store.dim;
    for (VertexId v(0); v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 6); v < piece; ++v) {
            distance_of[v] = 0;
        }
    for (CellId c(0); c < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 80 * dim * dim); c < piece; ++c) {
            for (const VertexId v : store.cell(c).vertex) {
                const double away2 = ball.distance2(store.point(v));
                if (!(away2 > ball.radius * ball.radius)) continue;
                for (const VertexId w : store.cell(c).vertex) {
                    const double other2 = ball.distance2(store.point(w));
                    const double up_to = away2 - other2 - sum_slack * (away2 + other2);
                    if (!(up_to > 0)) continue;
                    const double d = up_to / (2 * distance(dim, store.point(v), store.point(w))) * down;
                    if (d > distance_of[v]) distance_of[v] = d;
                }
            }
        }
}

}  // namespace

// Marked: 1, cells with a corner that may be outside; 2, unbounded ones.
template <int D> void CellClipper::mark_cells() {
    Store<D> store = store_.of_dimension<D>();
    const Domain<D> ball = ball_.of_dimension<D>();
    for (CellId c(0); c < store_.state.cell_slots;)
        for (const std::uint64_t piece = store_.arena.piece(c, store_.state.cell_slots, 30 * store.dim); c < piece;
             ++c) {
            const Cell<D>& cell = store.cell(c);
            const double doubt = static_cast<double>(cell.error) * square_root(cell.radius2);
            const bool inside = (square_root(ball.distance2(cell.centre)) + doubt) * up <= ball.radius;
            for (int i = 0; i <= store.dim; ++i) {
                if (!inside) store.vertex(cell.vertex[i]).queued |= 1;
                for (int k = 0; k <= store.dim && cell.neighbour[i] == none; ++k)
                    if (k != i) store.vertex(cell.vertex[k]).queued |= 2;
            }
        }
}

void CellClipper::mark() {
    with_dimension(static_cast<std::uint32_t>(dim),
                   [&](auto d) { mark_cells<shared_dimension<decltype(d)::value>>(); });
    for (VertexId v(0); v < store_.state.vertex_count;)
        for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 10); v < piece; ++v) {
            const AnyVertex vertex = store_.vertex(v);
            const bool is_absent = needed_.present != nullptr && needed_.present[v] == 0;
            vertex.queued = vertex.queued == 1 && vertex.marker != Marker::exempt && !is_absent ? 1 : 0;
        }
}

bool CellClipper::open(VertexId v) {
    v_ = v;
    pass_over(v);
    count_ = list_star(store_, v);
    store_.arena.pass(1 + count_ / 4);
    return count_ > 0;
}

void CellClipper::clip(double* out_radius, double* reach) const {
    const AnyVertex vertex = store_.vertex(v_);
    if (vertex.marker == Marker::input) {
        *out_radius = bound(vertex.x, *out_radius, needed_.cut);
        if (reach != nullptr) *reach = smaller(*reach, *out_radius);
        return;
    }
    const double enough = needed_.least_alone ? 0.5 * distance_to_inputs(store_, v_) : infinity;
    *out_radius = bound(vertex.x, *out_radius, enough);
    *reach = bound(store_.point(nearest_input(store_, v_)), *reach, needed_.cut);
}

// By corners in the ball and crossings of edges, up to the first that is as far as the root of enough2. Corners first:
// few crossings are farther.
template <int D> void CellClipper::measure(const double* u, double enough2, Corner<D>* farthest) const {
    const Store<D> store = store_.of_dimension<D>();
    const Domain<D> ball = ball_.of_dimension<D>();
    const double* const p = store.point(v_);
    if (ball.contains(p)) farthest->offer(p, distance2<D>(store.dim, p, u), store.vertex(v_).cell);
    for (std::uint32_t k = 0; k < count_ && farthest->distance2 < enough2; ++k) {
        const Cell<D>& cell = store.cell(star(k));
        if (cell.radius2 < infinity && ball.contains(cell.centre))
            farthest->offer(cell.centre, distance2<D>(store.dim, cell.centre, u), star(k));
    }
    for (std::uint32_t k = 0; k < count_ && farthest->distance2 < enough2; ++k) {
        const CellId c = star(k);
        const Cell<D>& cell = store.cell(c);
        if (!(cell.radius2 < infinity) || ball.contains(cell.centre)) continue;
        const double here2 = distance2<D>(store.dim, cell.centre, u);
        for (int i = 0; i <= store.dim; ++i) {
            if (cell.vertex[i] == v_) continue;
            const CellId n = cell.neighbour[i].cell();
            const Cell<D>& other = store.cell(n);
            // A crossing is no farther than the farther end.
            const double least2 = farthest->distance2 * (1 - 0x1p-20);
            if (!(other.radius2 < infinity) || (here2 < least2 && distance2<D>(store.dim, other.centre, u) < least2))
                continue;
            if (n < c && !ball.contains(other.centre)) continue;  // seen from there
            double z[2][DimensionOf<D>::most];
            const int crossings = sphere_crossings(ball, cell.centre, other.centre, z);
            for (int j = 0; j < crossings; ++j) farthest->offer(z[j], distance2<D>(store.dim, z[j], u), c);
        }
    }
}

template <class Show>
void CellClipper::show_edge(const double* u, double s, const AnyCell& cell, const AnyCell& other, Show&& show) const {
    const double here = doubt_of(cell), there = doubt_of(other);
    const bool known = here < infinity && there < infinity;
    cut_doubtful_edge(ball_, u, s, cell, other, known ? here : infinity, known ? there : infinity, show);
}

template <class Show> [[gnu::cold]] void CellClipper::cut(const double* u, double s, Show&& show) const {
    store_.arena.pass(1 + count_ * dim);
    for (std::uint32_t k = 0; k < count_; ++k) {
        const CellId c = star(k);
        const AnyCell cell = store_.cell(c);
        for (int i = 0; i <= dim; ++i)
            if (cell.vertex[i] != v_ && !(cell.neighbour[i].cell() < c))
                show_edge(u, s, cell, store_.cell(cell.neighbour[i].cell()), show);
    }
}

// Edges are left out that surely end within s, or surely outside of the half-space: with the errors of corner_error_max
// and all roundings that takes less than 2^-21 of the squares that it is made from.
template <int D> bool CellClipper::is_bound(const double* u, double s) const {
    const Store<D> store = store_.of_dimension<D>();
    const double s2 = s * s, near2 = s2 * (1 - 0x1p-19), r2 = ball_.radius * ball_.radius;
    double a[DimensionOf<D>::most];
    for (int j = 0; j < store.dim; ++j) a[j] = u[j] - ball_.centre[j];
    const double away2 = dot<D>(store.dim, a, a), level = away2 - r2 + s2;
    struct End {
        double height, size2;
        bool is_near;
    };
    const auto look_at = [&](const Cell<D>& cell) {
        double y[DimensionOf<D>::most];
        for (int j = 0; j < store.dim; ++j) y[j] = cell.centre[j] - u[j];
        const double y2 = dot<D>(store.dim, y, y);
        if (!(static_cast<double>(cell.error) <= corner_error_max)) return End{-infinity, infinity, false};
        return End{2 * dot<D>(store.dim, y, a) + level, y2 + cell.radius2, y2 <= near2 && cell.radius2 <= near2};
    };
    bool is_within = true;
    for (std::uint32_t k = 0; k < count_ && is_within; ++k) {
        const CellId c = star(k);
        const Cell<D>& cell = store.cell(c);
        const End here = look_at(cell);
        if (here.is_near) continue;
        for (int i = 0; i <= store.dim && is_within; ++i) {
            if (cell.vertex[i] == v_) continue;
            const CellId n = cell.neighbour[i].cell();
            const End there = look_at(store.cell(n));
            if (n < c && !there.is_near) continue;
            const double slack = 0x1p-20 * (here.size2 + there.size2 + away2 + r2 + s2);
            if (here.height > slack && there.height > slack) continue;
            // From the end that cut() takes it from, so that both say the same to the last bit.
            show_edge(u, s, store_.cell(n < c ? n : c), store_.cell(n < c ? c : n),
                      [&](const double*, double most, double) { is_within = is_within && most <= s; });
        }
    }
    return is_within;
}

bool CellClipper::is_bound(const double* u, double s) const {
    const auto dimension = static_cast<std::uint32_t>(dim);
    store_.arena.pass(1 + count_ * dimension / 4);
    return with_dimension(dimension, [&](auto d) { return is_bound<shared_dimension<decltype(d)::value>>(u, s); });
}

[[gnu::cold]] CellClipper::Beyond CellClipper::look_beyond(const double* u, double s) const {
    Beyond beyond;
    cut(u, s, [&](const double* y, double most, double) {
        if (!(most <= beyond.far)) beyond.far = most;
        const double d = square_root(dot(dim, y, y));
        if (d < beyond.near) beyond.near = d;
        double x[dimension_max];
        for (int k = 0; k < dim; ++k) x[k] = y[k] + (u[k] - ball_.centre[k]);
        const double x2 = dot(dim, x, x);
        if (!(x2 < beyond.first2)) return;
        beyond.first2 = x2;
        copy(dim, x, beyond.first);
    });
    return beyond;
}

// Is there a plane between the ball and the cut cell with the normal w, of any length? *first: the corner that is first
// along w, from c.
[[gnu::cold]] bool CellClipper::is_apart(const double* u, double s, const double* w, double* first) const {
    const double length = square_root(dot(dim, w, w));
    if (!(length > 0)) return false;
    double unit[dimension_max], a[dimension_max], least = infinity;
    bool apart = true;
    for (int k = 0; k < dim; ++k) {
        unit[k] = w[k] / length;
        a[k] = u[k] - ball_.centre[k];
    }
    const double away = square_root(dot(dim, a, a)), along = dot(dim, unit, a);
    cut(u, s, [&](const double* y, double most, double wrong) {
        const double height = dot(dim, unit, y) + along;
        const double surely = height - wrong - sum_slack * (most + away + ball_.radius);
        apart = apart && surely > ball_.radius;
        if (!(height < least)) return;
        least = height;
        for (int k = 0; k < dim; ++k) first[k] = y[k] + a[k];
    });
    return apart;
}

// Is the cut cell outside of the ball? Some point of the clipped cell far from u is `farthest`.
[[gnu::cold]] bool CellClipper::is_outside(const double* u, double s, const double* farthest,
                                           const Beyond& beyond) const {
    double w[dimension_max], first[dimension_max];
    for (int k = 0; k < dim; ++k) w[k] = farthest[k] - ball_.centre[k];
    if (is_apart(u, s, w, first)) return true;
    double x[dimension_max];
    copy(dim, beyond.first, x);
    for (int step = 0; step < 6; ++step) {
        if (is_apart(u, s, x, first)) return true;
        // To the point nearest to c on the way to the first corner.
        double along = 0, length2 = 0;
        for (int k = 0; k < dim; ++k) {
            along += x[k] * (x[k] - first[k]);
            length2 += (x[k] - first[k]) * (x[k] - first[k]);
        }
        if (!(along > 0 && length2 > 0)) return false;
        const double t = along < length2 ? along / length2 : 1;
        for (int k = 0; k < dim; ++k) x[k] += t * (first[k] - x[k]);
    }
    return false;
}

double CellClipper::bound(const double* u, double whole, double enough) const {
    static constexpr double growths[] = {0x1p-38, 0x1p-32, 0x1p-26, 0x1p-20, 0x1p-10, 0.02, 0.25};
    constexpr int growths_count = sizeof growths / sizeof growths[0];
    const double away = square_root(ball_.distance2(u));
    double best = smaller(whole, (away + ball_.radius) * up);
    const auto dimension = static_cast<std::uint32_t>(dim);
    store_.arena.pass(1 + count_ * dimension / 4);
    AnyCorner farthest(dim);
    with_dimension(dimension, [&](auto d) {
        Corner<shared_dimension<decltype(d)::value>> found(dim);
        measure(u, enough * enough, &found);
        farthest = AnyCorner(found);
    });
    if (farthest.distance2 >= enough * enough) return whole;
    bool has_poles = farthest.distance2 < 0;
    if (has_poles) offer_poles(store_, ball_, u, v_, store_.list_top(), count_, &farthest);
    if (farthest.distance2 < 0) {
        // No point is known: outside of the ball, or hardly in it. A point of the ball next to v will do to begin with.
        const double* const p = store_.point(v_);
        const double share = ball_.radius / square_root(ball_.distance2(p));
        double x[dimension_max];
        for (int k = 0; k < dim; ++k) x[k] = ball_.centre[k] + share * (p[k] - ball_.centre[k]);
        farthest.offer(x, distance2(dim, x, u), none);
    }
    for (int i = 0; i < growths_count; ++i) {
        const double s = square_root(farthest.distance2) * (1 + growths[i]);
        if (!(s < best)) break;
        if (is_bound(u, s)) return s;
        const Beyond beyond = look_beyond(u, s);
        best = smaller(best, beyond.far);
        if (best <= s * (1 + 0x1p-32)) break;
        if (beyond.near > s && is_outside(u, s, farthest.x, beyond)) return s;
        if (has_poles) continue;
        has_poles = true;
        const double before2 = farthest.distance2;
        offer_poles(store_, ball_, u, v_, store_.list_top(), count_, &farthest);
        if (farthest.distance2 > before2) i = -1;
    }
    return best;
}

Status clip_cell_bounds(const AnyStore& store, const AnyDomain& ball, const NeededReach& needed, double* out_radius,
                        double* reach, std::uint32_t first) {
    CellClipper clipper(store, ball, needed);
    clipper.mark();
    Status status = Status::ok;
    for (VertexId v(0); v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 6); v < piece; ++v) {
            if (!clipper.is_marked(v)) continue;
            if (clipper.open(v))
                clipper.clip(&out_radius[v], v < first ? nullptr : &reach[v - first]);
            else
                status = Status::out_of_memory;
        }
    return status;
}

[[gnu::cold]] Status bound_clipped_cells(const AnyStore& store, const AnyDomain& ball, double* out_radius, Arena& arena,
                                         ClippedReach* reach) {
    const ArenaScope scope(arena);
    const std::uint32_t count = store.state.vertex_count;
    double* const s = arena.take_high<double>(count);
    double* const far = arena.take_high<double>(count);
    if (s == nullptr || far == nullptr) return Status::out_of_memory;
    const Status status = measure_clipped_cells(store, ball, far);
    if (status != Status::ok) return status;
    const double radius = ball.radius * up, enclosing = (ball.radius + ball.enclosing_radius) * up;
    const auto away_from = [&](VertexId v) { return square_root(ball.distance2(store.point(v))); };
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = store.arena.piece(v, count, 20); v < piece; ++v) {
            if (store.vertex(v).marker == Marker::exempt || !(far[v] < infinity)) out_radius[v] = infinity;
            // What is in the ball is within r + |v - c| of v; and no nearer to v than to an input, in the enclosing
            // ball.
            const double away = away_from(v) * up, most = smaller(enclosing, (away + radius) * up);
            reach[v] = {smaller(out_radius[v], most), away * down > radius ? radius : infinity};
            s[v] = !(out_radius[v] < infinity) || (away + out_radius[v]) * up <= ball.radius
                       ? -1
                       : larger(square_root(far[v]) * (1 + 0x1p-30), away - radius);
        }
    // A cell whose farthest point is the pole of a face may need more than its measured reach.
    static constexpr double growths[] = {1, 1.02, 1.25};
    for (const double growth : growths) {
        for (VertexId v(0); v < count;)
            for (const std::uint64_t piece = store.arena.piece(v, count, 20); v < piece; ++v) {
                s[v] *= growth;
            }
        find_far_corners(store, ball, s, far);
        for (VertexId v(0); v < count;)
            for (const std::uint64_t piece = store.arena.piece(v, count, 20); v < piece; ++v) {
                if (s[v] >= 0) reach[v].from_vertex = smaller(reach[v].from_vertex, larger(s[v], far[v]));
            }
    }
    find_bisectors(store, ball, far);
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = store.arena.piece(v, count, 20); v < piece; ++v) {
            if (!(reach[v].below < infinity)) continue;
            const double away = away_from(v), slack = 0x1p-40 * (radius + away);
            const double below = smaller(reach[v].from_vertex - (away - radius), radius - far[v]) + slack;
            reach[v].below = below > 0 ? below : 0;
        }
    return Status::ok;
}

}  // namespace netmesh
