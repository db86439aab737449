// The steps are those of circumsphere_fast.hpp, and so are the errors, with v = 2^-100 for u: each operation of
// double_double.hpp is off by less than v relative to its result. P <= 2^40 keeps v P below 2^-60, so terms of second
// order are small as they are there, and sizes within 2^+-200 keep what underflows below 2^-300 of all. Edges are
// exact.
//  5. The same, with v in a: 5 X^2 where X = a P L bounds |x - z|.
//  6. |x|^2 + sum of b_i e_i . (e_i - 2 x) is summed as it stands. Let S be |x|; Z is the greatest |b_i| l_i, of the
//  b_i
//     as computed, which the identity is of. The square is off by D v S^2. Vertex i is R away from z, so |e_i - 2 x| is
//     at most 2 R + 2 X <= 2 S + 4 X, and e_i . (e_i - 2 x), a difference, a product, D - 1 sums in each coordinate, is
//     off by (D + 1.01) v l_i (2 S + 4 X). It is -2 e_i . (x - z), so its product with b_i is at most 2.1 Z X and what
//     it is off by, and is off by v times that more; K sums of numbers up to S^2 + K 2.1 Z X are off by K v times that.
//     In all below v ((D + K) S^2 + K (D + 1.01) Z (2 S + 4 X) + K (K + 1) 2.1 Z X), with a tenth for second order.
#include "geometry/circumsphere_close.hpp"

#include "geometry/circumsphere_fast.hpp"
#include "numerics/double_double.hpp"

namespace netmesh {
namespace {

constexpr double close_roundoff = 0x1p-100, close_volume_min = 0x1p-80;

DoubleDouble close_product(std::uint32_t dim, const DoubleDouble* a, const DoubleDouble* b) {
    DoubleDouble sum = a[0] * b[0];
    for (std::uint32_t d = 1; d < dim; ++d) sum = sum + a[d] * b[d];
    return sum;
}

template <class T> void exchange_places(T& a, T& b) {
    const T t = a;
    a = b;
    b = t;
}

}  // namespace

// Flattened, as operators that are not inlined take twice the time.
[[gnu::flatten]] Certainty look_closely(std::uint32_t k, std::uint32_t dim, const double* const* point,
                                        Circumsphere* out) {
    DoubleDouble e[dimension_most()][dimension_most()], b[dimension_most()], n[dimension_most()],
        r[dimension_most()][dimension_most()], y[dimension_most()], weight[dimension_most()], x[dimension_most()];
    double whole[dimension_most()], least = 0x1p200, volume = 1, largest = 0;
    std::uint32_t at[dimension_most()];
    for (std::uint32_t i = 0; i < k; ++i) {
        for (std::uint32_t d = 0; d < dim; ++d) e[i][d] = exact_difference(point[i + 1][d], point[0][d]);
        n[i] = close_product(dim, e[i], e[i]);
        if (!(n[i].high > 0x1p-200 && n[i].high < 0x1p200)) return {0, 0};
        whole[i] = n[i].high;
        least = whole[i] < least ? whole[i] : least;
        b[i] = scaled(n[i], 0.5);
        at[i] = i;
    }
    for (std::uint32_t j = 0; j < k; ++j) {
        std::uint32_t pivot = j;
        for (std::uint32_t i = j + 1; i < k; ++i) pivot = n[i].high > n[pivot].high ? i : pivot;
        if (pivot != j) {
            for (std::uint32_t d = 0; d < dim; ++d) exchange_places(e[j][d], e[pivot][d]);
            for (std::uint32_t m = 0; m < j; ++m) exchange_places(r[m][j], r[m][pivot]);
            exchange_places(b[j], b[pivot]);
            exchange_places(n[j], n[pivot]);
            exchange_places(whole[j], whole[pivot]);
            exchange_places(at[j], at[pivot]);
        }
        volume *= n[j].high / whole[j];
        if (!(volume > close_volume_min)) return {0, 0};
        y[j] = b[j] / n[j];
        largest += (b[j] * y[j]).high;
        for (std::uint32_t i = j + 1; i < k; ++i) {
            const DoubleDouble c = close_product(dim, e[i], e[j]) / n[j];
            r[j][i] = c;
            for (std::uint32_t d = 0; d < dim; ++d) e[i][d] = e[i][d] - c * e[j][d];
            b[i] = b[i] - c * b[j];
            n[i] = close_product(dim, e[i], e[i]);
        }
    }
    for (std::uint32_t d = 0; d < dim; ++d) {
        x[d] = y[0] * e[0][d];
        for (std::uint32_t j = 1; j < k; ++j) x[d] = x[d] + y[j] * e[j][d];
    }
    DoubleDouble first = {1, 0};
    double smallest = 0x1p1000;
    for (std::uint32_t j = k; j-- > 0;) {
        for (std::uint32_t i = j + 1; i < k; ++i) y[j] = y[j] - r[j][i] * y[i];
        first = first - y[j];
        const double length2 = y[j].high * y[j].high * whole[j];
        largest = length2 > largest ? length2 : largest;
        smallest = length2 < smallest ? length2 : smallest;
        weight[at[j]] = y[j];
    }
    const CircumsphereBounds bounds(static_cast<int>(k), static_cast<int>(dim));
    constexpr double finer = close_roundoff / unit_roundoff;
    const double spread = 1 / volume, error = finer * bounds.beta_error * spread, slack = error * error * largest;
    const bool has_signs = slack < smallest && slack * (k * k) < first.high * first.high * least;
    out->within = first.high < 0;
    for (std::uint32_t i = 0; i < k; ++i) out->within |= static_cast<std::uint32_t>(weight[i].high < 0) << (i + 1);

    DoubleDouble square = close_product(dim, x, x);
    const double centre = finer * bounds.centre_error, off = square_root(centre * centre * spread * largest) * 1.01,
                 size = square_root(square.high) * 1.01, weights = square_root(largest) * 1.01;
    const double sums =
        (dim + k) * size * size + k * (dim + 1.01) * weights * (2 * size + 4 * off) + k * (k + 1) * 2.1 * weights * off;
    for (std::uint32_t i = 0; i < k; ++i) {
        DoubleDouble edge[dimension_most()], away[dimension_most()];
        for (std::uint32_t d = 0; d < dim; ++d) {
            edge[d] = exact_difference(point[i + 1][d], point[0][d]);
            away[d] = edge[d] - scaled(x[d], 2);
        }
        square = square + weight[i] * close_product(dim, edge, away);
    }
    const NearestRoot<double> nearest =
        nearest_root(square.high, square.low, 5 * off * off + 1.1 * close_roundoff * sums);
    out->radius = nearest.root;
    return {has_signs ? 1u : 0u, nearest.known != 0 ? 1u : 0u};
}

}  // namespace netmesh
