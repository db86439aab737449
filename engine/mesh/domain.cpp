#include "mesh/domain.hpp"
#include "numerics/vector.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

constexpr int dim_most = dimension_most();

// Centre of the smallest ball with these m points on its boundary, in their affine hull; false when they are dependent
// or the centre is outside their convex hull (then a smaller set carries the ball).
bool boundary_ball(int dim, const double* const* p, int m, double* centre) {
    double g[dim_most][dim_most + 1];
    const int n = m - 1;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            double dot = 0;
            for (int k = 0; k < dim; ++k) dot += (p[i + 1][k] - p[0][k]) * (p[j + 1][k] - p[0][k]);
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
    for (int k = 0; k < dim; ++k) centre[k] = p[0][k];
    for (int i = 0; i < n; ++i) {
        const double weight = g[i][n] / g[i][i];
        if (!(weight >= 0)) return false;
        first -= weight;
        for (int k = 0; k < dim; ++k) centre[k] += weight * (p[i + 1][k] - p[0][k]);
    }
    return first >= -0x1p-40;
}

// The smallest ball of m <= dim+2 points, the last of which lies on its boundary; keeps in p the points that carry it
// and returns their number. 0 when rounding leaves no candidate.
int smallest_ball(int dim, const double** p, int m, double* centre) {
    double best2 = infinity;
    unsigned best_set = 0;
    for (unsigned set = 0; set < (1u << (m - 1)); ++set) {
        const double* chosen[dim_most + 2];
        int size = 0;
        for (int i = 0; i < m - 1; ++i)
            if (set >> i & 1u) chosen[size++] = p[i];
        chosen[size++] = p[m - 1];
        if (size > dim + 1) continue;
        double c[dim_most] = {};
        if (!boundary_ball(dim, chosen, size, c)) continue;
        const double r2 = distance2(dim, c, p[m - 1]);
        bool all = r2 < best2;
        for (int i = 0; i < m && all; ++i) all = distance2(dim, c, p[i]) <= r2 * (1 + 0x1p-40);
        if (!all) continue;
        best2 = r2;
        best_set = set;
        for (int k = 0; k < dim; ++k) centre[k] = c[k];
    }
    if (best2 == infinity) return 0;
    int size = 0;
    for (int i = 0; i < m - 1; ++i)
        if (best_set >> i & 1u) p[size++] = p[i];
    p[size++] = p[m - 1];
    return size;
}

// Centre of the smallest ball of the points and the square of the largest distance from it. arena: to report to, or
// null.
double enclose(const PointRows& points, const Arena* arena, double* best) {
    const int dim = points.dim;
    const double* basis[dim_most + 2];
    int size = 1;
    basis[0] = points[0];
    double centre[dim_most];
    for (int k = 0; k < dim; ++k) centre[k] = best[k] = basis[0][k];
    double best2 = infinity;  // smallest covering radius seen, squared
    for (int step = 0; step < 200; ++step) {
        double far2 = -1;
        std::uint32_t far = 0;
        for (std::uint32_t v = 0; v < points.count; ++v) {
            if (arena != nullptr) arena->step(v, 8 * static_cast<std::uint32_t>(dim));
            const double d2 = distance2(dim, centre, points[v]);
            if (d2 > far2) {
                far2 = d2;
                far = v;
            }
        }
        if (far2 < best2) {
            best2 = far2;
            for (int k = 0; k < dim; ++k) best[k] = centre[k];
        }
        if (far2 <= distance2(dim, centre, basis[0]) * (1 + 0x1p-40)) break;
        basis[size] = points[far];
        size = smallest_ball(dim, basis, size + 1, centre);
        if (size == 0) break;
    }
    return best2;
}

}  // namespace

double enclosing_radius_of_inputs(const PointRows& points, const Arena& arena, double* centre) {
    const double best2 = enclose(points, &arena, centre);
    double magnitude = 1;
    for (int k = 0; k < points.dim; ++k)
        if (absolute(centre[k]) > magnitude) magnitude = absolute(centre[k]);
    return best2 > 0 ? square_root(best2) * (1 + 8 * unit_roundoff) : magnitude;
}

void smallest_enclosing_ball(int dim, const double* points, std::uint32_t count, double* centre, double* radius) {
    const std::size_t row = static_cast<std::size_t>(dim) * sizeof(double);
    const double best2 =
        enclose({dim, reinterpret_cast<const unsigned char*>(points), static_cast<std::ptrdiff_t>(row), count}, nullptr,
                centre);
    *radius = square_root(best2) * (1 + 8 * unit_roundoff);
}

int any_sphere_crossings(int dim, const double* centre, double radius, const double* a, const double* b,
                         double* const (&z)[2]) {
    return sphere_crossings(dim, centre, radius, a, b, z);
}

}  // namespace netmesh
