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

// What the error bound of solve_sphere multiplies. A minor of order k of edges e_i is computed with at most
// (D+1)(D+2)/2 + D + 8 roundings on each of its products, entries and b included, and the products' absolute values add up
// to at most c_k |e_1| ... |e_k|, c_k = k! / k^(k/2) (predicates/float_stage.hpp). With b in one row, b_i = |e_i|^2 / 2, they add
// up to at most c_(D-1) |e_1| ... |e_D| sum |e_i| / 2, and |e_i| <= 2 R. So each coordinate of the centre errs by at most
// R k u (D c_(D-1) + c_D) |e_1| ... |e_D| / |det| (1 + small); sqrt(D) makes that Euclidean, 3 covers a determinant that is up
// to half wrong and a radius that is up to a quarter wrong.
template <int D> constexpr double shape_factor() {
    constexpr double c[7] = {1, 1, 1, 1.15471, 1.5, 2.14664, 3.33334}, root[7] = {0, 1, 1.42, 1.74, 2, 2.24, 2.45};
    return 3 * root[D] * ((D + 1) * (D + 2) / 2 + D + 8) * u * (D * c[D - 1] + c[D]);
}

// Halves of squared edge lengths between which no product of up to D+1 entries of A and b underflows or overflows by
// more than the error bounds allow for.
constexpr double edge_square_min = 0x1p-150;
constexpr double edge_square_max = 0x1p150;

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

// With a = power of q outside (>= 0) and b = -power inside, the new centre is w c_in + (1-w) c_out, w = a / (a + b). Its
// error is at most the larger of the two centres' errors, plus the error of w (doubt / (a + b)) times their distance, plus
// rounding; the sum of three terms is bounded by the root of three times the sum of their squares.
template <int D>
bool pencil_sphere(const Cell<D>& inside, const Cell<D>& outside, const double* q, double error_max, Cell<D>& cell) {
    double bound_in, bound_out;
    const double b = -power<D>(inside, q, &bound_in);
    const double a = power<D>(outside, q, &bound_out);
    const double sum = a + b, doubt = bound_in + bound_out;
    if (!(doubt < 0x1p-6 * sum)) return false;
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
        3.5 * ((in2 > out2 ? in2 : out2) + w_error * w_error * apart2 + (32 * u * u) * size2);
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
