// The determinant of frame.hpp about the last point, with |x - q|^2 - (w_x - w_q) for lifts: what it differs by from
// |x|^2 - w_x is an affine function of x. Weights as radii are differences of squares, (r - s)(r + s), so no square is
// rounded.
//
// Perturbation: the weight of point i is less by something positive and infinitely small, and infinitely larger than
// that of every point before it: that is the perturbation of predicates.cpp, for lifts, and nothing but lifts is asked
// for here.
//
// Copies of one point have one index, and as much is taken off the weight of each. So on a sphere the sum of lambda_k
// over the copies of a point decides, less 1 where q is a copy of it: the determinant with 1 for its copies in place of
// lifts. Where all these sums are 0, as in a lattice of one point, the form |x|^2 is perturbed, too, by entries of x
// x^T, each infinitely smaller than the one before it and than all weights: the determinant with products of two
// coordinates in place of lifts. A translation changes such heights by an affine function, so copies of a cell are
// cells.
//
// It leaves no tie. Let sum of l_i = 0, sum of l_i x_i = 0, sum of l_i x_i x_i^T = 0 be an affine dependency of points
// of which no part is dependent, P those with l_i > 0, N those with l_i < 0. Let f be linear and 0 on N, the origin in
// the affine hull of N: the sum of l_i f(x_i)^2 over P is 0, so P is in the affine hull of N, and N in that of P. Both
// have |P| - 1 = |N| - 1 dimensions, the dependency has |P| + |N| - 2: one point each, and they are one point.
#include "predicates/weighted.hpp"

#include "predicates/exact_stage.hpp"
#include "predicates/power_stage.hpp"
#include "predicates/undecided.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// The least b for which 2^b is at least (D+1)^2 D^(D/2): D+1 lifts, each of D+1 terms, times minors by Hadamard.
constexpr int power_bits(int dim) {
    const std::uint64_t d = static_cast<std::uint64_t>(dim);
    std::uint64_t square = (d + 1) * (d + 1) * (d + 1) * (d + 1);
    for (int k = 0; k < dim; ++k) square *= d;
    int bits = 0;
    while ((std::uint64_t{1} << 2 * bits) < square) ++bits;
    return bits;
}
// Lifts of any doubles are below 2^4198 times D + 1 (coordinates as in exact_stage.hpp; a weight below 2^1024 has at
// most 2148 binary places; radii r, s: (r - s)(r + s) < 2^2049).
static_assert(primes_for_bits(dimension_most() * (1025 + 1074) + 2 * (1025 + 1074) + power_bits(dimension_most())) <=
                  residue_prime_count,
              "the table of primes is too short");

// Numbers of all points as integers: coordinates and radii in quanta, weights in squared ones.
struct PowerFrame {
    ScaledInteger x[frame_rows_max + 1][dimension_most() + 1];  // the last one the base
    int power_max, bits;

    PowerFrame(int dim, const double* const* points, bool are_radii);
};

PowerFrame::PowerFrame(int dim, const double* const* points, bool are_radii) : power_max(0), bits(0) {
    const int rows = dim + 1;
    int least = 1024, of_weights = 1024, heaviest = exponent_of_zero;
    for (int i = 0; i <= rows; ++i) {
        for (int c = 0; c < dim; ++c) {
            const int k = quantum_of(points[i][c]);
            least = k < least ? k : least;
        }
        const double number = points[i][dim];
        const int k = quantum_of(number), e = exponent_of(__builtin_fabs(number));
        of_weights = k < of_weights ? k : of_weights;
        heaviest = e > heaviest ? e : heaviest;
    }
    // Half of an odd number, rounded down.
    if (!are_radii) of_weights = of_weights >= 0 ? of_weights / 2 : -((1 - of_weights) / 2);
    least = of_weights < least ? of_weights : least;
    int shortest = 1 << 20, longest = 0;
    for (int i = 0; i < rows; ++i) {
        const int row_bits = difference_exponent(dim, points[i], points[rows]) + 1 - least;
        shortest = row_bits < shortest ? row_bits : shortest;
        longest = row_bits > longest ? row_bits : longest;
        bits += row_bits;
    }
    const int weight_bits = heaviest == exponent_of_zero ? 0
                            : are_radii                  ? 2 * (heaviest + 1 - least) + 1
                                                         : heaviest + 2 - 2 * least;
    bits += (2 * longest > weight_bits ? 2 * longest : weight_bits) - shortest + power_bits(dim);
    for (int i = 0; i <= rows; ++i)
        for (int c = 0; c <= dim; ++c) {
            x[i][c] = scaled_integer(points[i][c], c < dim || are_radii ? least : 2 * least);
            power_max = x[i][c].power > power_max ? x[i][c].power : power_max;
        }
}

std::uint64_t difference_of(std::uint64_t a, std::uint64_t b, const ResiduePrime& prime) {
    return a >= b ? a - b : a + prime.value - b;
}

// What stands in the last column: lifts; 1 for copies of a point; products of two coordinates.
struct LastColumn {
    enum Kind { lifts, copies, products } kind;
    const VertexId* ids;  // of all points
    VertexId id;          // copies of this one
    int a, b;             // the two coordinates
};

// Entry `row` of that column, differences of coordinates in a.
std::uint64_t entry_of(const LastColumn& last, const ResidueMatrix& a, int row, int rows, const ResiduePrime& prime) {
    if (last.kind == LastColumn::products) {
        UnsignedSum sum;
        sum.add_product(a.entry[last.a][0][row], a.entry[last.b][0][row]);
        return reduce(sum, prime);
    }
    const bool is_copy = last.ids[row] == last.id, is_base = last.ids[rows] == last.id;
    return is_copy == is_base ? 0 : is_copy ? 1 : prime.value - 1;
}

// The sign of the determinant, which has the answer but for (-1)^dim.
[[gnu::noinline]] int power_sign(int dim, const double* const* points, bool are_radii, const LastColumn& last) {
    const int rows = dim + 1;
    const PowerFrame frame(dim, points, are_radii);
    std::uint64_t residues[exact_primes_max];
    const int primes = primes_for_bits(frame.bits);
    for (int k = 0; k < primes; ++k) {
        const ResiduePrime prime = residue_prime(k);
        const PowersByBits power(frame.power_max, prime);
        ResidueMatrix a;
        std::uint64_t base[dimension_most() + 1];
        for (int c = 0; c <= dim; ++c) base[c] = residue_of(frame.x[rows][c], power, prime);
        for (int i = 0; i < rows; ++i) {
            UnsignedSum lift;
            for (int c = 0; c < dim; ++c) {
                const std::uint64_t d = difference_of(residue_of(frame.x[i][c], power, prime), base[c], prime);
                a.put(c, i, d, prime);
                lift.add_product(d, d);
            }
            if (last.kind != LastColumn::lifts) {
                a.put(dim, i, entry_of(last, a, i, rows, prime), prime);
                continue;
            }
            const std::uint64_t number = residue_of(frame.x[i][dim], power, prime);
            const std::uint64_t less = difference_of(base[dim], number, prime);
            if (are_radii)
                lift.add_product(less, difference_of(number, difference_of(0, base[dim], prime), prime));
            else
                lift.add_product(less, 1);
            a.put(dim, i, reduce(lift, prime), prime);
        }
        ResidueLevels level;
        residues[k] = *residue_minors(rows, rows, a, level, prime);
    }
    return sign_of_residues(residues, primes);
}

// In the plane the question has been put to doubles before (delaunay/plane.hpp).
#ifdef __OPTIMIZE_SIZE__
template <int D> constexpr bool has_power_stage = false;
#else
template <int D> constexpr bool has_power_stage = D > 2;
#endif

// break_tie of predicates.cpp.
template <int D> Sign break_power_tie(const double** points, const VertexId* ids, VertexId q_id) {
    std::uint32_t bound = 0;
    bool bounded = false;
    for (;;) {
        int next = -1;
        VertexId highest = q_id;
        for (int i = 0; i <= D; ++i)
            if (ids[i] > highest && (!bounded || ids[i] < bound)) {
                highest = ids[i];
                next = i;
            }
        if (next < 0) return Sign::negative;
        const double* const kept = points[next];
        points[next] = points[D + 1];
        PredicateCounts counts = {};
        const Sign lambda = orient<D>(points, counts);
        points[next] = kept;
        if (lambda != Sign::zero) return lambda;
        bound = highest;
        bounded = true;
    }
}

template <int D> bool has_copies(const VertexId* ids) {
    for (int i = 0; i <= D; ++i)
        for (int k = i + 1; k <= D + 1; ++k)
            if (ids[i] == ids[k]) return true;
    return false;
}

// break_power_tie where points are copies of others. ids: of all D + 2 points.
template <int D> Sign break_tie_of_copies(const double* const* points, const VertexId* ids, bool are_radii) {
    LastColumn last = {LastColumn::copies, ids, VertexId(none), 0, 0};
    for (;;) {
        bool is_found = false;
        VertexId next(0);
        for (int i = 0; i <= D + 1; ++i)
            if (ids[i] < last.id && (!is_found || ids[i] > next)) {
                next = ids[i];
                is_found = true;
            }
        if (!is_found) break;
        last.id = next;
        const int sign = power_sign(D, points, are_radii, last);
        if (sign != 0) return static_cast<Sign>((D & 1) != 0 ? -sign : sign);
    }
    last.kind = LastColumn::products;
    for (last.a = 0; last.a < D; ++last.a)
        for (last.b = last.a; last.b < D; ++last.b) {
            const int sign = power_sign(D, points, are_radii, last);
            if (sign != 0) return static_cast<Sign>((D & 1) != 0 ? -sign : sign);
        }
    NETMESH_ASSERT(false);
    return Sign::negative;
}

}  // namespace

template <int D>
Sign in_power_perturbed(const double* const* cell, const VertexId* ids, const double* q, VertexId q_id, bool are_radii,
                        PredicateCounts& counts) {
    const double* points[D + 2];
    for (int i = 0; i <= D; ++i) points[i] = cell[i];
    points[D + 1] = q;
    bool are_equal = true;
    for (int i = 0; i <= D; ++i) are_equal &= points[i][D] == q[D];
    if (are_equal) {
        const Sign sign = in_ball<D>(cell, q, counts);
        if (sign != Sign::zero) return sign;
    }
    if constexpr (has_power_stage<D>) {
        Weights weights;
        weights.are_radii = are_radii;
        const int sign = are_equal ? 0 : power_stage<D>(points, weights);
        if (sign != 0) {
            ++counts.calls[stage_float];
            return static_cast<Sign>((D & 1) != 0 ? -sign : sign);
        }
    }
    const int sign =
        are_equal ? 0 : power_sign(D, points, are_radii, {LastColumn::lifts, nullptr, VertexId(none), 0, 0});
    if (sign != 0) {
        ++counts.calls[stage_exact];
        return static_cast<Sign>((D & 1) != 0 ? -sign : sign);
    }
    ++counts.calls[stage_tie];
    VertexId all[D + 2];
    for (int i = 0; i <= D; ++i) all[i] = ids[i];
    all[D + 1] = q_id;
    if (has_copies<D>(all)) return break_tie_of_copies<D>(points, all, are_radii);
    return break_power_tie<D>(points, ids, q_id);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Sign in_power_perturbed<D>(const double* const*, const VertexId*, const double*, VertexId, bool,          \
                                        PredicateCounts&);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
