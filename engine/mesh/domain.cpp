#include "mesh/domain.hpp"
#include "numerics/vector.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Centre of the smallest ball with these m points on its boundary, in their affine hull; false when they are dependent
// or the centre is outside their convex hull (then a smaller set carries the ball).
template <int D> bool boundary_ball(const double* const* p, int m, double* centre) {
    double g[D][D + 1];
    const int n = m - 1;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            double dot = 0;
            for (int k = 0; k < D; ++k) dot += (p[i + 1][k] - p[0][k]) * (p[j + 1][k] - p[0][k]);
            g[i][j] = dot;
        }
        g[i][n] = 0.5 * g[i][i];
    }
    for (int k = 0; k < n; ++k) {
        int pivot = k;
        for (int i = k + 1; i < n; ++i)
            if (absolute(g[i][k]) > absolute(g[pivot][k])) pivot = i;
        if (!(absolute(g[pivot][k]) > 0)) return false;
        for (int j = 0; j <= n; ++j) {
            const double t = g[k][j];
            g[k][j] = g[pivot][j];
            g[pivot][j] = t;
        }
        for (int i = 0; i < n; ++i) {
            if (i == k) continue;
            const double factor = g[i][k] / g[k][k];
            for (int j = k; j <= n; ++j) g[i][j] -= factor * g[k][j];
        }
    }
    double first = 1;
    for (int k = 0; k < D; ++k) centre[k] = p[0][k];
    for (int i = 0; i < n; ++i) {
        const double weight = g[i][n] / g[i][i];
        if (!(weight >= 0)) return false;
        first -= weight;
        for (int k = 0; k < D; ++k) centre[k] += weight * (p[i + 1][k] - p[0][k]);
    }
    return first >= -0x1p-40;
}

// The smallest ball of m <= D+2 points, the last of which lies on its boundary; keeps in p the points that carry it and
// returns their number. 0 when rounding leaves no candidate.
template <int D> int smallest_ball(const double** p, int m, double* centre) {
    double best2 = infinity;
    unsigned best_set = 0;
    for (unsigned set = 0; set < (1u << (m - 1)); ++set) {
        const double* chosen[D + 2];
        int size = 0;
        for (int i = 0; i < m - 1; ++i)
            if (set >> i & 1u) chosen[size++] = p[i];
        chosen[size++] = p[m - 1];
        if (size > D + 1) continue;
        double c[D] = {};
        if (!boundary_ball<D>(chosen, size, c)) continue;
        const double r2 = distance2<D>(c, p[m - 1]);
        bool all = r2 < best2;
        for (int i = 0; i < m && all; ++i) all = distance2<D>(c, p[i]) <= r2 * (1 + 0x1p-40);
        if (!all) continue;
        best2 = r2;
        best_set = set;
        for (int k = 0; k < D; ++k) centre[k] = c[k];
    }
    if (best2 == infinity) return 0;
    int size = 0;
    for (int i = 0; i < m - 1; ++i)
        if (best_set >> i & 1u) p[size++] = p[i];
    p[size++] = p[m - 1];
    return size;
}

// Centre of the smallest ball of points point(0..count-1) and the square of the largest distance from it.
template <int D, class PointOf> double enclose(PointOf&& point, std::uint32_t count, double* best) {
    const double* basis[D + 2];
    int size = 1;
    basis[0] = point(0);
    double centre[D];
    for (int k = 0; k < D; ++k) centre[k] = best[k] = basis[0][k];
    double best2 = infinity;  // smallest covering radius seen, squared
    for (int step = 0; step < 200; ++step) {
        double far2 = -1;
        std::uint32_t far = 0;
        for (std::uint32_t v = 0; v < count; ++v) {
            const double d2 = distance2<D>(centre, point(v));
            if (d2 > far2) {
                far2 = d2;
                far = v;
            }
        }
        if (far2 < best2) {
            best2 = far2;
            for (int k = 0; k < D; ++k) best[k] = centre[k];
        }
        if (far2 <= distance2<D>(centre, basis[0]) * (1 + 0x1p-40)) break;
        basis[size] = point(far);
        size = smallest_ball<D>(basis, size + 1, centre);
        if (size == 0) break;
    }
    return best2;
}

}  // namespace

template <int D> void smallest_enclosing_ball(const Store<D>& store, std::uint32_t count, Domain<D>& domain) {
    const auto point = [&](std::uint32_t v) {
        store.arena.step(v, 8 * D);
        return store.point(v);
    };
    const double best2 = enclose<D>(point, count, domain.centre);
    double magnitude = 1;
    for (int k = 0; k < D; ++k)
        if (absolute(domain.centre[k]) > magnitude) magnitude = absolute(domain.centre[k]);
    domain.enclosing_radius = best2 > 0 ? square_root(best2) * (1 + 8 * unit_roundoff) : magnitude;
    domain.radius = 0;
}

template <int D>
void smallest_enclosing_ball(const double* points, std::uint32_t count, double* centre, double* radius) {
    const double best2 = enclose<D>([&](std::uint32_t i) { return points + std::size_t{i} * D; }, count, centre);
    *radius = square_root(best2) * (1 + 8 * unit_roundoff);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template void smallest_enclosing_ball<D>(const Store<D>&, std::uint32_t, Domain<D>&);                              \
    template void smallest_enclosing_ball<D>(const double*, std::uint32_t, double*, double*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
