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

// All minors of order K, K digits each, from those of order K-1. entry: [0] the matrix's column K-1, [1] its negative.
template <int N, int K>
void integer_minors(const std::int64_t (&entry)[2][N], const std::int64_t* below, std::int64_t* out) {
    for (int s = 0; s < binomial(N, K); ++s) {
        const auto& term = minor_level<N, K>.term[s];
        SignedSum carry;
        for (int t = 0; t < K - 1; ++t) {
            SignedSum sum = carry;
            for (int j = 0; j < K; ++j)
                sum.add_product(entry[(K - 1 - j) & 1][term[j].row], below[term[j].below * (K - 1) + t]);
            out[t] = sum.take_digit();
            carry = sum;
        }
        out[K - 1] = carry.take_digit();
        out += K;
    }
}

template <int N, int D> struct IntegerMatrix { std::int64_t entry[D][2][N]; };

// The minors of order D: one for orient, with N = D; those of all but one row for in_ball, with N = D+1.
template <int N, int D, int K>
void integer_minors_up(const IntegerMatrix<N, D>& a, const std::int64_t* below, std::int64_t* top) {
    if constexpr (K == D) {
        integer_minors<N, K>(a.entry[K - 1], below, top);
    } else {
        std::int64_t minors[binomial(N, K) * K];
        integer_minors<N, K>(a.entry[K - 1], below, minors);
        integer_minors_up<N, D, K + 1>(a, minors, top);
    }
}

inline int sign_of_digits(const std::int64_t* digit, int count) {
    for (int t = count - 1; t >= 0; --t)
        if (digit[t] != 0) return digit[t] > 0 ? 1 : -1;
    return 0;
}

// Sign of the determinant. quantum[c]: all coordinates c are multiples of 2^quantum[c] (with a lift: all equal).
template <int D, bool lifted> int integer_stage(const Frame<D, lifted>& frame, const int (&quantum)[D]) {
    constexpr int n = Frame<D, lifted>::rows;
    IntegerMatrix<n, D> a;
    for (int c = 0; c < D; ++c) {
        const Quanta quanta(quantum[c]);
        const std::uint64_t base = quanta.of(frame.base[c]);
        for (int i = 0; i < n; ++i) {
            a.entry[c][0][i] = static_cast<std::int64_t>(quanta.of(frame.row[i][c]) - base);
            a.entry[c][1][i] = -a.entry[c][0][i];
        }
    }
    std::int64_t top[binomial(n, D) * D];
    integer_minors_up<n, D, 2>(a, a.entry[0][0], top);
    if constexpr (!lifted) return sign_of_digits(top, D);

    std::int64_t determinant[D + 2] = {};
    for (int i = 0; i < n; ++i) {
        // The minor without row i is number n-1-i; a negated lift makes up for its sign.
        const std::int64_t* minor = top + (n - 1 - i) * D;
        SignedSum square;
        for (int c = 0; c < D; ++c) square.add_product(a.entry[c][0][i], a.entry[c][(n - 1 - i) & 1][i]);
        const std::int64_t low = square.take_digit(), high = square.take_digit();
        SignedSum carry;
        for (int t = 0; t < D + 2; ++t) {
            SignedSum sum = carry;
            sum.add_product(determinant[t], 1);
            if (t < D) sum.add_product(low, minor[t]);
            if (t > 0 && t <= D) sum.add_product(high, minor[t - 1]);
            determinant[t] = sum.take_digit();
            carry = sum;
        }
    }
    return sign_of_digits(determinant, D + 2);
}

}  // namespace netmesh
