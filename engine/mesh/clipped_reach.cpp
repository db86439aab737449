#include "mesh/clipped_reach.hpp"

#include "certificate/rounding.hpp"
#include "mesh/clipped_cell.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

double larger(double a, double b) { return a > b ? a : b; }
double smaller(double a, double b) { return a < b ? a : b; }

// B of the head for every vertex with s >= 0, the others are left alone. O(cells).
template <int D> void find_far_corners(const Store<D>& store, const Domain<D>& ball, const double* s, double* far) {
    for (VertexId v(0); v < store.state.vertex_count; ++v) far[v] = 0;
    for (CellId c(0); c < store.state.cell_slots; ++c)
        for (int i = 0; i <= D; ++i) {
            const Cell<D>& cell = store.cell(c);
            if (cell.neighbour[i] == none || cell.neighbour[i].cell() < c) continue;
            const Cell<D>& other = store.cell(cell.neighbour[i].cell());
            const double doubt = larger(static_cast<double>(cell.error) * square_root(cell.radius2),
                                        static_cast<double>(other.error) * square_root(other.radius2)) *
                                 up;
            for (int k = 0; k <= D; ++k) {
                const VertexId v = cell.vertex[k];
                if (k == i || !(s[v] >= 0)) continue;
                const double* const p = store.point(v);
                double a[D], y[D], z[D];
                for (int j = 0; j < D; ++j) {
                    a[j] = p[j] - ball.centre[j];
                    y[j] = cell.centre[j] - p[j];
                    z[j] = other.centre[j] - p[j];
                }
                const double away2 = dot<D>(a, a), r2 = ball.radius * ball.radius, s2 = s[v] * s[v];
                const double away = square_root(away2), level = away2 - r2 + s2;
                const double near = square_root(dot<D>(y, y)), apart = square_root(dot<D>(z, z)), both = near + apart;
                const double e = sum_slack * (2 * both * away + away2 + r2 + s2);
                const double slack = (2 * away * doubt + 4 * e) * (1 + 0x1p-20);
                const double here = 2 * dot<D>(y, a) + level - slack, there = 2 * dot<D>(z, a) + level - slack;
                const auto show = [&](double distance) {
                    const double most = (distance + doubt + sum_slack * both) * up;
                    if (!(most <= far[v])) far[v] = most;
                };
                if (!(here > 0)) show(near);
                if (!(there > 0)) show(apart);
                if ((here > 0) == (there > 0)) continue;
                const double t = here / (here - there);
                for (int j = 0; j < D; ++j) y[j] += t * (z[j] - y[j]);
                show(square_root(dot<D>(y, y)));
            }
        }
}

// Distances from the ball's centre to the cells of vertices outside of the ball, at least.
template <int D> void find_bisectors(const Store<D>& store, const Domain<D>& ball, double* distance_of) {
    for (VertexId v(0); v < store.state.vertex_count; ++v) distance_of[v] = 0;
    for (CellId c(0); c < store.state.cell_slots; ++c)
        for (const VertexId v : store.cell(c).vertex) {
            const double away2 = ball.distance2(store.point(v));
            if (!(away2 > ball.radius * ball.radius)) continue;
            for (const VertexId w : store.cell(c).vertex) {
                const double other2 = ball.distance2(store.point(w));
                const double up_to = away2 - other2 - sum_slack * (away2 + other2);
                if (!(up_to > 0)) continue;
                const double d = up_to / (2 * distance<D>(store.point(v), store.point(w))) * down;
                if (d > distance_of[v]) distance_of[v] = d;
            }
        }
}

}  // namespace

template <int D>
Status bound_clipped_cells(Store<D>& store, const Domain<D>& ball, double* out_radius, Arena& arena,
                           ClippedReach* reach) {
    const ArenaScope scope(arena);
    const std::uint32_t count = store.state.vertex_count;
    double* const s = arena.take_high<double>(count);
    double* const far = arena.take_high<double>(count);
    if (s == nullptr || far == nullptr) return Status::out_of_memory;
    const Status status = measure_clipped_cells<D>(store, ball, far);
    if (status != Status::ok) return status;
    const double radius = ball.radius * up, enclosing = (ball.radius + ball.enclosing_radius) * up;
    const auto away_from = [&](VertexId v) { return square_root(ball.distance2(store.point(v))); };
    for (VertexId v(0); v < count; ++v) {
        if (store.vertex(v).marker == Marker::exempt || !(far[v] < infinity)) out_radius[v] = infinity;
        // What is in the ball is within r + |v - c| of v; and no nearer to v than to an input, in the enclosing ball.
        const double away = away_from(v) * up, most = smaller(enclosing, (away + radius) * up);
        reach[v] = {smaller(out_radius[v], most), away * down > radius ? radius : infinity};
        s[v] = !(out_radius[v] < infinity) || (away + out_radius[v]) * up <= ball.radius
                   ? -1
                   : larger(square_root(far[v]) * (1 + 0x1p-30), away - radius);
    }
    // A cell whose farthest point is the pole of a face may need more than its measured reach.
    constexpr double growths[] = {1, 1.02, 1.25};
    for (const double growth : growths) {
        for (VertexId v(0); v < count; ++v) s[v] *= growth;
        find_far_corners<D>(store, ball, s, far);
        for (VertexId v(0); v < count; ++v)
            if (s[v] >= 0) reach[v].from_vertex = smaller(reach[v].from_vertex, larger(s[v], far[v]));
    }
    find_bisectors<D>(store, ball, far);
    for (VertexId v(0); v < count; ++v) {
        if (!(reach[v].below < infinity)) continue;
        const double away = away_from(v), slack = 0x1p-40 * (radius + away);
        const double below = smaller(reach[v].from_vertex - (away - radius), radius - far[v]) + slack;
        reach[v].below = below > 0 ? below : 0;
    }
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status bound_clipped_cells<D>(Store<D>&, const Domain<D>&, double*, Arena&, ClippedReach*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
