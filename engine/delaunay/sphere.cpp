#include "delaunay/sphere.hpp"

#include "predicates/float_stage.hpp"

namespace netmesh {
namespace {

constexpr double u = unit_roundoff;

// Minors of order D of a matrix with D+1 rows and (in use) D columns, from those of order K-1.
template <int D, int K> void minors_from(const double (&a)[D + 1][D + 1], const double* below, double* out) {
    if constexpr (K == D) {
        FloatMinor<D + 1, D>::all(a, below, out);
    } else {
        double minors[binomial(D + 1, K)];
        FloatMinor<D + 1, K>::all(a, below, minors);
        minors_from<D, K + 1>(a, minors, out);
    }
}

// Divides each edge, and with it its equation, by a power of two of its own, so that lengths of any ratio do not meet in
// one product. False when an edge vanishes or all are too short for their squares.
template <int D> bool rescale(double (&a)[D + 1][D + 1], double* lengths2) {
    double longest = 0;
    *lengths2 = 1;
    for (int i = 0; i < D; ++i) {
        double largest = 0;
        for (int j = 0; j < D; ++j)
            if (absolute(a[j][i]) > largest) largest = absolute(a[j][i]);
        if (!(largest > 0x1p-1000 && largest < 0x1p1000)) return false;
        const int exponent = exponent_of(largest);
        const double inverse = power_of_two(-exponent);
        double square = 0;
        for (int j = 0; j < D; ++j) {
            a[j][i] *= inverse;
            square += a[j][i] * a[j][i];
        }
        a[D][i] = 0.5 * square * power_of_two(exponent);
        *lengths2 *= square;
        if (largest > longest) longest = largest;
    }
    return longest > 0x1p-900;
}

// Says that nothing is known: every question about this ball goes to the exact predicates.
template <int D> void forget_sphere(const double* const* p, Cell<D>& cell) {
    for (int j = 0; j < D; ++j) cell.centre[j] = p[0][j];
    cell.radius2 = infinity;
    cell.error = static_cast<float>(infinity);
}

}  // namespace

// The centre is p0 + x, where the edges e_i from p0 satisfy e_i . x = |e_i|^2 / 2: Cramer's rule on the matrix with the
// edges in its columns and their half squares b in its last row. Without a branch, so that it costs little more than its
// products.
template <int D> void solve_sphere(const double* const* p, Cell<D>& cell) {
    double a[D + 1][D + 1], minors[D + 1];
    bool plain = true;
    double lengths2 = 1;
    for (int i = 0; i < D; ++i) {
        double square = 0;
        for (int j = 0; j < D; ++j) {
            a[j][i] = p[i + 1][j] - p[0][j];
            square += a[j][i] * a[j][i];
        }
        a[D][i] = 0.5 * square;
        plain = plain && a[D][i] > edge_square_min && a[D][i] < edge_square_max;
        lengths2 *= 2 * a[D][i];
    }
    if (!plain && !rescale<D>(a, &lengths2)) return forget_sphere<D>(p, cell);
    double first[D + 1];
    for (int j = 0; j <= D; ++j) first[j] = a[j][0];
    minors_from<D, 2>(a, first, minors);  // minors[D - j] is the one without row j

    const double inverse = 1 / minors[0];
    double radius2 = 0, size2 = 0;
    for (int j = 0; j < D; ++j) {
        const double x = minors[D - j] * ((D - 1 - j) % 2 == 0 ? inverse : -inverse);
        cell.centre[j] = p[0][j] + x;
        const double d = p[0][j] - cell.centre[j];
        radius2 += d * d;
        size2 += cell.centre[j] * cell.centre[j];
    }
    // The two terms are the shape's and the rounding of the centre's coordinates.
    constexpr double shape = shape_factor<D>();
    const double error2 = 2.1 * (shape * shape * lengths2 * (inverse * inverse) + 8 * u * u * (size2 / radius2));
    if (!(error2 < 1.0 / 16) || !(radius2 > 0x1p-960)) return forget_sphere<D>(p, cell);
    cell.radius2 = radius2;
    cell.error = static_cast<float>(1.01 * square_root(error2));
}

#define NETMESH_INSTANTIATE(D) template void solve_sphere<D>(const double* const*, Cell<D>&);
NETMESH_INSTANTIATE(2)
NETMESH_INSTANTIATE(3)
NETMESH_INSTANTIATE(4)
NETMESH_INSTANTIATE(5)
NETMESH_INSTANTIATE(6)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
