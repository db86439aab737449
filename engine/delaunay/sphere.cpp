#include "delaunay/sphere.hpp"

namespace netmesh {
namespace {

constexpr double u = unit_roundoff;
constexpr double error_usable = 0x1p-22;  // a bound above this sends a cell to solve_sphere

// Z := A^-1 by Gauss-Jordan elimination with row pivoting, approximately. False when a pivot vanishes or is not finite.
template <int D> bool invert(double (&a)[D][D], double (&z)[D][D]) {
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) z[i][j] = i == j ? 1 : 0;
    for (int k = 0; k < D; ++k) {
        int pivot = k;
        for (int i = k + 1; i < D; ++i)
            if (absolute(a[i][k]) > absolute(a[pivot][k])) pivot = i;
        if (!(absolute(a[pivot][k]) > 0)) return false;
        if (pivot != k)
            for (int j = 0; j < D; ++j) {
                const double s = a[k][j], t = z[k][j];
                a[k][j] = a[pivot][j];
                z[k][j] = z[pivot][j];
                a[pivot][j] = s;
                z[pivot][j] = t;
            }
        const double inverse = 1 / a[k][k];
        for (int j = 0; j < D; ++j) {
            a[k][j] *= inverse;
            z[k][j] *= inverse;
        }
        for (int i = 0; i < D; ++i) {
            if (i == k) continue;
            const double factor = a[i][k];
            for (int j = 0; j < D; ++j) {
                a[i][j] -= factor * a[k][j];
                z[i][j] -= factor * z[k][j];
            }
        }
    }
    return true;
}

}  // namespace

// The centre is p0 + x with A x = b, A's rows the edges from p0, b half their squares. With Z about A^-1 and
// g = |I - ZA| < 1, the error of a computed x is at most |Z| |residual| / (1 - g) in the maximum norm; the roundings of A
// (one relative u an entry) and of b are part of the residual's bound.
template <int D> void solve_sphere(const double* const* p, Cell<D>& cell) {
    double a[D][D], work[D][D], z[D][D], b[D], x[D];
    for (int i = 0; i < D; ++i) {
        double square = 0;
        for (int j = 0; j < D; ++j) {
            a[i][j] = work[i][j] = p[i + 1][j] - p[0][j];
            square += a[i][j] * a[i][j];
        }
        b[i] = 0.5 * square;
    }
    cell.error = static_cast<float>(infinity);
    cell.radius2 = infinity;
    for (int j = 0; j < D; ++j) cell.centre[j] = p[0][j];
    if (!invert(work, z)) return;

    for (int i = 0; i < D; ++i) {
        x[i] = 0;
        for (int j = 0; j < D; ++j) x[i] += z[i][j] * b[j];
    }
    double slack[D];  // bound on the true residual of x
    for (int i = 0; i < D; ++i) {
        double residual = b[i], size = absolute(b[i]);
        for (int j = 0; j < D; ++j) {
            residual -= a[i][j] * x[j];
            size += absolute(a[i][j] * x[j]);
        }
        slack[i] = absolute(residual) + (2 * D + 8) * u * size + 0x1p-1000;
    }
    double worst = 0, g = 0;
    bool known = true;  // no NaN met, which comparisons would lose
    for (int i = 0; i < D; ++i) {
        double row = 0, defect = 0;
        for (int j = 0; j < D; ++j) {
            row += absolute(z[i][j]) * slack[j];
            double entry = i == j ? -1 : 0, size = 1;
            for (int k = 0; k < D; ++k) {
                entry += z[i][k] * a[k][j];
                size += absolute(z[i][k] * a[k][j]);
            }
            defect += absolute(entry) + (2 * D + 8) * u * size;
        }
        known = known && row < infinity && defect < 0.5;
        if (row > worst) worst = row;
        if (defect > g) g = defect;
    }
    double radius2 = 0, centre_size = 0;
    for (int j = 0; j < D; ++j) {
        cell.centre[j] = p[0][j] + x[j];
        const double d = p[0][j] - cell.centre[j];
        radius2 += d * d;
        const double s = absolute(cell.centre[j]);
        if (s > centre_size) centre_size = s;
    }
    if (!known || !(radius2 > 0x1p-960) || !is_finite(radius2)) return;
    cell.radius2 = radius2;
    // sqrt(D) turns the maximum norm into the Euclidean one; 1.01 absorbs the roundings of this line.
    const double distance = 1.01 * square_root(static_cast<double>(D)) * (worst / (1 - g) + 2 * u * centre_size);
    cell.error = static_cast<float>(1.01 * distance / square_root(radius2));
}

// With a = power of q outside (>= 0) and b = -power inside, the new centre is w c_in + (1-w) c_out, w = a / (a + b). Its
// error is at most the larger of the two centres' errors, plus the error of w times their distance, plus rounding.
template <int D> bool pencil_sphere(const Cell<D>& inside, const Cell<D>& outside, const double* q, Cell<D>& cell) {
    double bound_in, bound_out;
    const double b = -power<D>(inside, q, &bound_in);
    const double a = power<D>(outside, q, &bound_out);
    const double sum = a + b, doubt = bound_in + bound_out;
    if (!(doubt < 0x1p-12 * sum)) return false;
    const double w = a / sum;
    double apart2 = 0, radius2 = 0, centre_size = 0;
    double centre[D];
    for (int i = 0; i < D; ++i) {
        const double d = inside.centre[i] - outside.centre[i];
        centre[i] = outside.centre[i] + w * d;
        apart2 += d * d;
        const double s = absolute(inside.centre[i]) + absolute(outside.centre[i]);
        if (s > centre_size) centre_size = s;
        const double e = q[i] - centre[i];
        radius2 += e * e;
    }
    const double error_in = inside.error * square_root(inside.radius2);
    const double error_out = outside.error * square_root(outside.radius2);
    const double carried = error_in > error_out ? error_in : error_out;
    const double distance =
        1.01 * (carried + (doubt / sum + 4 * u) * square_root(apart2) + (2 + D) * u * centre_size);
    const double error = 1.01 * distance / square_root(radius2);
    if (!(error < error_usable) || !(radius2 > 0x1p-960)) return false;
    for (int i = 0; i < D; ++i) cell.centre[i] = centre[i];
    cell.radius2 = radius2;
    cell.error = static_cast<float>(error);
    return true;
}

#define NETMESH_INSTANTIATE(D)                                   \
    template void solve_sphere<D>(const double* const*, Cell<D>&); \
    template bool pencil_sphere<D>(const Cell<D>&, const Cell<D>&, const double*, Cell<D>&);
NETMESH_INSTANTIATE(2)
NETMESH_INSTANTIATE(3)
NETMESH_INSTANTIATE(4)
NETMESH_INSTANTIATE(5)
NETMESH_INSTANTIATE(6)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
