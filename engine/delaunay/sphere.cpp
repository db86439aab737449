#include "delaunay/sphere.hpp"

namespace netmesh {
namespace {

constexpr double u = unit_roundoff;

// Solves A x = b by cofactors, without a branch, and bounds the error of x in the maximum norm (infinite or NaN when A
// is too close to singular). Every term of a determinant is a product of one entry from each row, so the rounding of a
// determinant with rows a_k is at most a small multiple of u times the product of their 1-norms; entries of A carry one
// relative u each, those of b a few. D = 2, 3, 4.
template <int D> double solve_by_cofactors(const double (&a)[D][D], const double (&b)[D], double (&x)[D]) {
    double det;
    double numerator[D];
    if constexpr (D == 2) {
        det = a[0][0] * a[1][1] - a[0][1] * a[1][0];
        numerator[0] = b[0] * a[1][1] - b[1] * a[0][1];
        numerator[1] = b[1] * a[0][0] - b[0] * a[1][0];
    } else if constexpr (D == 3) {
        double c[3][3];  // cofactors of the entries
        for (int i = 0; i < 3; ++i) {
            const double* const p = a[(i + 1) % 3];
            const double* const q = a[(i + 2) % 3];
            for (int j = 0; j < 3; ++j)
                c[i][j] = p[(j + 1) % 3] * q[(j + 2) % 3] - p[(j + 2) % 3] * q[(j + 1) % 3];
        }
        det = a[0][0] * c[0][0] + a[0][1] * c[0][1] + a[0][2] * c[0][2];
        for (int j = 0; j < 3; ++j) numerator[j] = b[0] * c[0][j] + b[1] * c[1][j] + b[2] * c[2][j];
    } else {
        // Two-row minors of the upper and of the lower rows; m[k] belongs to columns pair[k].
        constexpr int pair[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
        double upper[6], lower[6], upper_b[4], lower_b[4];
        for (int k = 0; k < 6; ++k) {
            const int i = pair[k][0], j = pair[k][1];
            upper[k] = a[0][i] * a[1][j] - a[0][j] * a[1][i];
            lower[k] = a[2][i] * a[3][j] - a[2][j] * a[3][i];
        }
        for (int j = 0; j < 4; ++j) {  // minors of column b with column j
            upper_b[j] = b[0] * a[1][j] - b[1] * a[0][j];
            lower_b[j] = b[2] * a[3][j] - b[3] * a[2][j];
        }
        det = upper[0] * lower[5] - upper[1] * lower[4] + upper[2] * lower[3] + upper[3] * lower[2] -
              upper[4] * lower[1] + upper[5] * lower[0];
        // Laplace expansion of A with b in place of one column, b moved to the front: columns b, p, q, r.
        const auto replaced = [&](int p, int q, int r, int pq, int pr, int qr) {
            return upper_b[p] * lower[qr] - upper_b[q] * lower[pr] + upper_b[r] * lower[pq] + upper[pq] * lower_b[r] -
                   upper[pr] * lower_b[q] + upper[qr] * lower_b[p];
        };
        numerator[0] = replaced(1, 2, 3, 3, 4, 5);
        numerator[1] = -replaced(0, 2, 3, 1, 2, 5);
        numerator[2] = replaced(0, 1, 3, 0, 2, 4);
        numerator[3] = -replaced(0, 1, 2, 0, 1, 3);
    }
    double product = 1, ratios = 0;
    for (int i = 0; i < D; ++i) {
        double norm = 0;
        for (int j = 0; j < D; ++j) norm += absolute(a[i][j]);
        product *= norm;
        ratios += absolute(b[i]) / norm;
    }
    constexpr double k = (4 * D + 8) * u;
    const double det_error = k * product, numerator_error = k * product * ratios;
    const double inverse = 1 / det;
    double largest = 0;
    for (int j = 0; j < D; ++j) {
        x[j] = numerator[j] * inverse;
        if (absolute(x[j]) > largest) largest = absolute(x[j]);
    }
    const double det_least = absolute(det) - det_error;
    if (!(det_least > 0x1p-900) || !(product > 0x1p-900)) return infinity;
    return (numerator_error + largest * det_error) / det_least + 4 * u * largest;
}

// The same for D = 5, 6 by Gauss-Jordan elimination with row pivoting. With Z about A^-1 and g = |I - ZA| < 1, the error
// of a computed x is at most |Z| |residual| / (1 - g); the roundings of A and b are part of the residual's bound.
template <int D> double solve_by_elimination(const double (&a)[D][D], const double (&b)[D], double (&x)[D]) {
    double work[D][D], z[D][D];
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j) {
            work[i][j] = a[i][j];
            z[i][j] = i == j ? 1 : 0;
        }
    for (int k = 0; k < D; ++k) {
        int pivot = k;
        for (int i = k + 1; i < D; ++i)
            if (absolute(work[i][k]) > absolute(work[pivot][k])) pivot = i;
        if (!(absolute(work[pivot][k]) > 0)) return infinity;
        for (int j = 0; j < D; ++j) {
            const double s = work[k][j], t = z[k][j];
            work[k][j] = work[pivot][j];
            z[k][j] = z[pivot][j];
            work[pivot][j] = s;
            z[pivot][j] = t;
        }
        const double inverse = 1 / work[k][k];
        for (int j = 0; j < D; ++j) {
            work[k][j] *= inverse;
            z[k][j] *= inverse;
        }
        for (int i = 0; i < D; ++i) {
            if (i == k) continue;
            const double factor = work[i][k];
            for (int j = 0; j < D; ++j) {
                work[i][j] -= factor * work[k][j];
                z[i][j] -= factor * z[k][j];
            }
        }
    }
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
                const double term = z[i][k] * a[k][j];
                entry += term;
                size += absolute(term);
            }
            defect += absolute(entry) + (2 * D + 8) * u * size;
        }
        known = known && row < infinity && defect < 0.5;
        if (row > worst) worst = row;
        if (defect > g) g = defect;
    }
    return known ? worst / (1 - g) : infinity;
}

// Halves of squared edge lengths between which no product of up to D+1 entries of A and b underflows or overflows by
// more than the error bounds allow for.
constexpr double edge_square_min = 0x1p-200;
constexpr double edge_square_max = 0x1p200;

// Divides by a power of two so that the largest entry of A is in [1, 2). False when an edge is too short beside it.
template <int D> bool rescale(double (&a)[D][D], double (&b)[D], double* unit) {
    double largest = 0;
    for (int i = 0; i < D; ++i)
        for (int j = 0; j < D; ++j)
            if (absolute(a[i][j]) > largest) largest = absolute(a[i][j]);
    if (!(largest > 0x1p-1000 && largest < 0x1p1000)) return false;
    const int exponent = exponent_of(largest);
    const double inverse = power_of_two(-exponent);
    *unit = power_of_two(exponent);
    for (int i = 0; i < D; ++i) {
        double square = 0;
        for (int j = 0; j < D; ++j) {
            a[i][j] *= inverse;
            square += a[i][j] * a[i][j];
        }
        b[i] = 0.5 * square;
        if (!(b[i] > edge_square_min)) return false;
    }
    return true;
}

// Says that nothing is known: every question about this ball goes to the exact predicates.
template <int D> void forget_sphere(const double* const* p, Cell<D>& cell) {
    for (int j = 0; j < D; ++j) cell.centre[j] = p[0][j];
    cell.radius2 = infinity;
    cell.error = static_cast<float>(infinity);
}

}  // namespace

// The centre is p0 + x with A x = b, A's rows the edges from p0, b half their squares.
template <int D> void solve_sphere(const double* const* p, Cell<D>& cell) {
    double a[D][D], b[D], x[D];
    bool plain = true;
    for (int i = 0; i < D; ++i) {
        double square = 0;
        for (int j = 0; j < D; ++j) {
            a[i][j] = p[i + 1][j] - p[0][j];
            square += a[i][j] * a[i][j];
        }
        b[i] = 0.5 * square;
        plain = plain && b[i] > edge_square_min && b[i] < edge_square_max;
    }
    double unit = 1;
    if (!plain && !rescale<D>(a, b, &unit)) return forget_sphere<D>(p, cell);
    double solved;
    if constexpr (D <= 4)
        solved = solve_by_cofactors<D>(a, b, x);
    else
        solved = solve_by_elimination<D>(a, b, x);
    if (!plain) {
        solved *= unit;
        for (int j = 0; j < D; ++j) x[j] *= unit;
    }

    double radius2 = 0, centre_size = 0;
    for (int j = 0; j < D; ++j) {
        cell.centre[j] = p[0][j] + x[j];
        const double d = p[0][j] - cell.centre[j];
        radius2 += d * d;
        const double s = absolute(cell.centre[j]);
        if (s > centre_size) centre_size = s;
    }
    // sqrt(D) turns the maximum norm into the Euclidean one; 1.01 absorbs the roundings of these lines.
    const double distance = 1.01 * square_root(static_cast<double>(D)) * (solved + 2 * u * centre_size);
    const double error = 1.01 * distance / square_root(radius2);
    if (!(error < 1) || !(radius2 > 0x1p-960)) return forget_sphere<D>(p, cell);
    cell.radius2 = radius2;
    cell.error = static_cast<float>(error);
}

// With a = power of q outside (>= 0) and b = -power inside, the new centre is w c_in + (1-w) c_out, w = a / (a + b). Its
// error is at most the larger of the two centres' errors, plus the error of w (doubt / (a + b)) times their distance, plus
// rounding; the sum of three terms is bounded by the root of three times the sum of their squares.
template <int D>
bool pencil_sphere(const Cell<D>& inside, const Cell<D>& outside, const double* q, double error_max, Cell<D>& cell) {
    double bound_in, bound_out;
    const double b = -power<D>(inside, q, &bound_in);
    const double a = power<D>(outside, q, &bound_out);
    const double sum = a + b, doubt = bound_in + bound_out;
    if (!(doubt < 0x1p-12 * sum)) return false;
    const double inverse = 1 / sum;
    const double w = a * inverse;
    double apart2 = 0, radius2 = 0, size2 = 0;
    double centre[D];
    for (int i = 0; i < D; ++i) {
        const double d = inside.centre[i] - outside.centre[i];
        centre[i] = outside.centre[i] + w * d;
        apart2 += d * d;
        size2 += inside.centre[i] * inside.centre[i] + outside.centre[i] * outside.centre[i];
        const double e = q[i] - centre[i];
        radius2 += e * e;
    }
    const double in2 = static_cast<double>(inside.error) * inside.error * inside.radius2;
    const double out2 = static_cast<double>(outside.error) * outside.error * outside.radius2;
    const double w_error = doubt * inverse + 4 * u;
    const double distance2 =
        3.1 * ((in2 > out2 ? in2 : out2) + w_error * w_error * apart2 + (32 * u * u) * size2);
    const double error2 = distance2 / radius2;
    if (!(error2 < error_max * error_max) || !(radius2 > 0x1p-800)) return false;
    for (int i = 0; i < D; ++i) cell.centre[i] = centre[i];
    cell.radius2 = radius2;
    cell.error = static_cast<float>(1.01 * square_root(error2));
    return true;
}

#define NETMESH_INSTANTIATE(D)                                   \
    template void solve_sphere<D>(const double* const*, Cell<D>&); \
    template bool pencil_sphere<D>(const Cell<D>&, const Cell<D>&, const double*, double, Cell<D>&);
NETMESH_INSTANTIATE(2)
NETMESH_INSTANTIATE(3)
NETMESH_INSTANTIATE(4)
NETMESH_INSTANTIATE(5)
NETMESH_INSTANTIATE(6)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
