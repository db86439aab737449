// The determinant in integers, for differences below 2^61 quanta.
//
// A number of k digits is sum of digit[t] * 2^(64 t), each digit in [-2^63, 2^63). Minors of order k fit k digits,
// since k! 2^(61 k) < 2^(64 k - 1), the lift fits two, as 6 * 2^122 < 2^125. Digits are settled once a minor: a sum of
// seven products of a digit with a difference, and a carry, is below 7 * 2^124 + 2^65 < 2^127. The sign is that of the
// highest digit that is not zero.
#pragma once
#include "numerics/minors.hpp"
#include "numerics/wide.hpp"
#include "predicates/frame.hpp"

namespace netmesh {

constexpr int integer_stage_bits = 61;

// Coordinates in quanta, modulo 2^64: differences come out right even where coordinates are too large.
class Quanta {
public:
    explicit Quanta(int quantum)
        : quantum_(quantum), per_unit_(quantum < -1022 || quantum > 1022 ? 0 : power_of_two(-quantum)) {}

    // x: a multiple of the quantum.
    std::uint64_t of(double x) const {
        const double y = x * per_unit_;  // exact: an integer, or out of range, or 0 without a factor
        if (y != 0 && __builtin_fabs(y) < 0x1p62) return static_cast<std::uint64_t>(static_cast<std::int64_t>(y));
        const Decoded d = decode(x);
        const int shift = d.exponent - quantum_;
        if (d.mantissa == 0 || shift >= 64) return 0;
        const std::uint64_t m = shift >= 0 ? d.mantissa << shift : d.mantissa >> -shift;
        return d.negative ? ~m + 1 : m;
    }

private:
    int quantum_;
    double per_unit_;
};

// The matrix by columns, [1] with its signs changed.
struct IntegerMatrix {
    std::int64_t entry[frame_rows_max][2][frame_rows_max];
};

// All minors of order K, K digits each, from those of order K-1. entry: [0] the matrix's column K-1, [1] its negative.
// K is known when compiling, for the loops over digits and members are as short as it.
template <int K>
void integer_minors(int n, const std::int64_t (&entry)[2][frame_rows_max], const std::int64_t* below,
                    std::int64_t* out) {
    const MinorTerm* term = minor_table.term + minor_terms_at(K);
    for (int left = binomial(n, K); left > 0; --left, term += K, out += K) {
        SignedSum carry;
        for (int t = 0; t < K - 1; ++t) {
            SignedSum sum = carry;
            for (int j = 0; j < K; ++j)
                sum.add_product(entry[(K - 1 - j) & 1][term[j].row], below[term[j].below * (K - 1) + t]);
            out[t] = sum.take_digit();
            carry = sum;
        }
        out[K - 1] = carry.take_digit();
    }
}

// Digits of all minors of one order, at most.
constexpr int integer_digits_most() {
    int most = 0;
    for (int k = 2; k <= frame_rows_max; ++k)
        most = binomial(frame_rows_max, k) * k > most ? binomial(frame_rows_max, k) * k : most;
    return most;
}

// The minors of order `top` in one of two levels, from those of order K-1.
template <int K>
const std::int64_t* integer_minors_up(int n, int top, const IntegerMatrix& a, const std::int64_t* below,
                                      std::int64_t (&level)[2][integer_digits_most()]) {
    if (K > top) return below;
    if constexpr (K <= dimension_most()) {
        integer_minors<K>(n, a.entry[K - 1], below, level[K & 1]);
        below = integer_minors_up<K + 1>(n, top, a, level[K & 1], level);
    }
    return below;
}

inline int sign_of_digits(const std::int64_t* digit, int count) {
    for (int t = count - 1; t >= 0; --t)
        if (digit[t] != 0) return digit[t] > 0 ? 1 : -1;
    return 0;
}

// Sign of the determinant. quantum[c]: all coordinates c are multiples of 2^quantum[c] (with a lift: all equal).
template <class Dim, class Lifted> int integer_stage(const Frame& frame, Dim dim, Lifted lifted, const int* quantum) {
    const int n = frame_rows(dim, lifted);
    IntegerMatrix a;
    for (int c = 0; c < dim; ++c) {
        const Quanta quanta(quantum[c]);
        const std::uint64_t base = quanta.of(frame.base[c]);
        for (int i = 0; i < n; ++i) {
            a.entry[c][0][i] = static_cast<std::int64_t>(quanta.of(frame.row[i][c]) - base);
            a.entry[c][1][i] = -a.entry[c][0][i];
        }
    }
    // The minors of order D: one for orient, those of all but one row for in_ball.
    std::int64_t level[2][integer_digits_most()];
    const std::int64_t* const top = integer_minors_up<2>(n, dim, a, a.entry[0][0], level);
    if (!lifted) return sign_of_digits(top, dim);

    std::int64_t determinant[dimension_most() + 2] = {};
    for (int i = 0; i < n; ++i) {
        // The minor without row i is number n-1-i; a negated lift makes up for its sign.
        const std::int64_t* minor = top + (n - 1 - i) * dim;
        SignedSum square;
        for (int c = 0; c < dim; ++c) square.add_product(a.entry[c][0][i], a.entry[c][(n - 1 - i) & 1][i]);
        const std::int64_t low = square.take_digit(), high = square.take_digit();
        SignedSum carry;
        for (int t = 0; t < dim + 2; ++t) {
            SignedSum sum = carry;
            sum.add_product(determinant[t], 1);
            if (t < dim) sum.add_product(low, minor[t]);
            if (t > 0 && t <= dim) sum.add_product(high, minor[t - 1]);
            determinant[t] = sum.take_digit();
            carry = sum;
        }
    }
    return sign_of_digits(determinant, dim + 2);
}

}  // namespace netmesh
