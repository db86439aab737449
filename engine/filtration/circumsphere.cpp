#include "filtration/circumsphere.hpp"

#include "numerics/double_double.hpp"
#include "numerics/real.hpp"

namespace netmesh {
namespace {

constexpr int dim_max = 6;
constexpr double largest_double = 0x1.fffffffffffffp1023;
constexpr double pivot_min = 0x1p-400;  // squared height over squared length below which a simplex is flat
constexpr double tie = 0x1p-80;         // of a facet's distance from the centre, over the radius

double magnitude(double x) { return x < 0 ? -x : x; }

// 2^e for |e| <= 1000, the nearer bound outside.
double power_within(int e) {
    const int within = e < -1000 ? -1000 : e > 1000 ? 1000 : e;
    const std::uint64_t bits = static_cast<std::uint64_t>(within + 1023) << 52;
    double x;
    __builtin_memcpy(&x, &bits, sizeof x);
    return x;
}

// Exponent of x >= 0, within [-1000, 1000].
int exponent(double x) {
    std::uint64_t bits;
    __builtin_memcpy(&bits, &x, sizeof bits);
    const int e = static_cast<int>(bits >> 52) - 1023;
    return e < -1000 ? -1000 : e > 1000 ? 1000 : e;
}

// The rows of the solve, each with its own power of two so that vertices at very different distances do no harm.
struct Rows {
    int k, dim;
    DoubleDouble e[dim_max][dim_max];  // edge vector / 2^size
    DoubleDouble b[dim_max];           // |e|^2 / 2 in units of 2^largest: the centre is sought in those
    DoubleDouble r[dim_max][dim_max];
    double n[dim_max];
    int size[dim_max], at[dim_max];
    int largest;
};

DoubleDouble inner(const DoubleDouble* a, const DoubleDouble* b, int dim) {
    DoubleDouble s = a[0] * b[0];
    for (int d = 1; d < dim; ++d) s = s + a[d] * b[d];
    return s;
}

void load(const double* const* point, double shrink, Rows& rows) {
    rows.largest = -1000;
    for (int i = 0; i < rows.k; ++i) {
        double reach = 0;
        for (int d = 0; d < rows.dim; ++d) {
            rows.e[i][d] = two_difference(point[i + 1][d] * shrink, point[0][d] * shrink);
            const double x = magnitude(rows.e[i][d].high);
            if (x > reach) reach = x;
        }
        rows.at[i] = i;
        rows.size[i] = exponent(reach);
        if (rows.size[i] > rows.largest) rows.largest = rows.size[i];
        const double unit = power_within(-rows.size[i]);
        for (int d = 0; d < rows.dim; ++d) rows.e[i][d] = scaled(rows.e[i][d], unit);
    }
    for (int i = 0; i < rows.k; ++i) {
        const DoubleDouble n = inner(rows.e[i], rows.e[i], rows.dim);
        rows.n[i] = n.high;
        rows.b[i] = scaled(n, power_within(rows.size[i] - rows.largest - 1));
    }
}

template <class T> void exchange(T& a, T& b) {
    const T t = a;
    a = b;
    b = t;
}

void bring_pivot(Rows& rows, int j) {
    int pivot = j;
    for (int i = j + 1; i < rows.k; ++i)
        if (rows.n[i] > rows.n[pivot]) pivot = i;
    if (pivot == j) return;
    for (int d = 0; d < rows.dim; ++d) exchange(rows.e[j][d], rows.e[pivot][d]);
    for (int i = 0; i < j; ++i) exchange(rows.r[i][j], rows.r[i][pivot]);
    exchange(rows.b[j], rows.b[pivot]);
    exchange(rows.n[j], rows.n[pivot]);
    exchange(rows.size[j], rows.size[pivot]);
    exchange(rows.at[j], rows.at[pivot]);
}

// weight, where it is asked for, [k + 1]: barycentric coordinates of the centre.
Circumsphere solve(const double* const* point, int k, int dim, double* weight) {
    double reach = 0;
    for (int i = 0; i <= k; ++i)
        for (int d = 0; d < dim; ++d)
            if (magnitude(point[i][d]) > reach) reach = magnitude(point[i][d]);
    const double shrink = reach > 0x1p980 ? 0x1p-50 : 1;

    Rows rows;
    rows.k = k;
    rows.dim = dim;
    load(point, shrink, rows);
    DoubleDouble y[dim_max], radius_squared = {0, 0};
    for (int j = 0; j < k; ++j) {
        bring_pivot(rows, j);
        const DoubleDouble* q = rows.e[j];
        DoubleDouble n = inner(q, q, dim);
        if (!(n.high > pivot_min)) n = {pivot_min, 0};
        y[j] = rows.b[j] / n;
        radius_squared = radius_squared + rows.b[j] * y[j];
        for (int i = j + 1; i < k; ++i) {
            const DoubleDouble c = inner(rows.e[i], q, dim) / n;
            rows.r[j][i] = c;
            for (int d = 0; d < dim; ++d) rows.e[i][d] = rows.e[i][d] - c * q[d];
            rows.b[i] = rows.b[i] - c * rows.b[j];
            rows.n[i] = inner(rows.e[i], rows.e[i], dim).high;
        }
    }

    const double reach_of_tie = tie * square_root(radius_squared.high);
    double spread = 0;
    DoubleDouble first = {1, 0};
    std::uint32_t within = 0;
    for (int j = k - 1; j >= 0; --j) {
        for (int i = j + 1; i < k; ++i) y[j] = y[j] - rows.r[j][i] * y[i];
        const int shorter = rows.largest - rows.size[j];
        const double stretch = power_within(shorter > 500 ? 500 : shorter);
        first = first - scaled(y[j], stretch);
        if (weight != nullptr) weight[rows.at[j] + 1] = y[j].high * stretch;
        spread += stretch;
        if (y[j].high <= reach_of_tie) within |= 2u << rows.at[j];
    }
    if (first.high <= reach_of_tie * spread) within |= 1u;
    double radius = square_root(radius_squared) * power_within(rows.largest);
    if (!(radius <= largest_double * shrink)) radius = largest_double * shrink;
    if (weight != nullptr) weight[0] = first.high;
    return {radius / shrink, within, 0};
}

// The distance of q from the point with these weights, in units: a power of two near the size of the simplex.
double distance_to(const double* q, const double* const* point, const double* weight, int k, int dim, double unit) {
    DoubleDouble sum = {0, 0};
    for (int d = 0; d < dim; ++d) {
        DoubleDouble x = scaled(two_difference(q[d], point[0][d]), unit);
        for (int i = 1; i <= k; ++i)
            x = x - scaled(two_difference(point[i][d], point[0][d]), unit) * DoubleDouble{weight[i], 0};
        sum = sum + x * x;
    }
    return square_root(sum);
}

}  // namespace

Circumsphere circumsphere_precise(const double* const* point, int k, int dim) { return solve(point, k, dim, nullptr); }

// All vertices are in the ball about any point c out to the farthest of them: the smallest enclosing ball is no larger.
// If c is in the simplex of some of the vertices, it is no smaller than the distance of the nearest of these: for any
// other centre c' one of them, p, has (p - c) . (c' - c) <= 0, and is no nearer to c' than to c. As c serve the centres
// of the smallest circumspheres of all sets of vertices that have theirs inside, with weights rounded to doubles: what
// they are in truth is not asked. A distance is computed to 2^-52 and 2^-90 times the size of the simplex, which is at
// most four times the radius.
double enclosing_error(const double* const* point, int k, int dim, double radius) {
    double reach = 0, coordinate = 0, lower = 0, upper = infinity;
    for (int i = 0; i <= k; ++i)
        for (int d = 0; d < dim; ++d) {
            const double along = magnitude(point[i][d] - point[0][d]);
            if (along > reach) reach = along;
            if (magnitude(point[i][d]) > coordinate) coordinate = magnitude(point[i][d]);
        }
    if (!(reach > 0x1p-900 && coordinate < 0x1p980)) return infinity;
    const double unit = power_within(-exponent(reach)), size = radius * unit;
    double error = infinity;
    for (unsigned set = 3; set < (2u << k) && error > 0x1p-50; ++set) {
        const double* some[dim_max + 1];
        int count = 0;
        for (int i = 0; i <= k; ++i)
            if ((set >> i & 1u) != 0) some[count++] = point[i];
        if (count < 2) continue;
        double weight[dim_max + 1], rest = 1, nearest = infinity, farthest = 0;
        solve(some, count - 1, dim, weight);
        bool inside = true;
        for (int i = 1; i < count; ++i) {
            inside = inside && weight[i] >= 0 && weight[i] <= rest;
            rest = (rest - weight[i]) * (1 - 0x1p-52);
        }
        if (!inside) continue;
        for (int i = 0; i < count; ++i) {
            const double d = distance_to(some[i], some, weight, count - 1, dim, unit);
            if (d < nearest) nearest = d;
        }
        for (int i = 0; i <= k; ++i) {
            const double d = distance_to(point[i], some, weight, count - 1, dim, unit);
            if (d > farthest) farthest = d;
        }
        if (nearest > lower) lower = nearest;
        if (farthest < upper) upper = farthest;
        const double above = size / lower - 1, below = 1 - size / upper;
        error = (above > below ? above : below) + 0x1p-51;
    }
    return error;
}

}  // namespace netmesh
