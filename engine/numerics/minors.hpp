// Which minors a determinant of order N needs when it is expanded column by column.
//
// A minor of order K belongs to K of the N rows and to columns 0..K-1. Expanded along its last column it is
//     sum over members j of  (-1)^(K-1-j) * entry(row of member j, K-1) * minor of order K-1 without that row,
// so that all minors of one order come from those of the order below: N * 2^(N-1) products in all, no division.
// Minors of one order are numbered by their row sets, read as binary numbers, in ascending order.
#pragma once
#include <cstdint>
#include <utility>

#include "vocabulary/dimension.hpp"

namespace netmesh {

constexpr int binomial(int n, int k) {
    int value = 1;
    for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
    return value;
}

constexpr int widest_level(int n) { return binomial(n, n / 2); }

struct MinorTerm {
    std::uint8_t row, below;  // the row of a member, the number of the minor without it
};

constexpr int minor_rows_max = dimension_most() + 1;

// The terms of all minors of orders 2 to N of N rows. Row sets are numbered without regard to the rows that come
// later, so the minors of fewer rows are the first of each order: one table serves any number of rows.
template <int N> struct MinorTable {
    static constexpr int terms_before(int order) {
        int terms = 0;
        for (int k = 2; k < order; ++k) terms += binomial(N, k) * k;
        return terms;
    }
    MinorTerm term[terms_before(N + 1)];

    constexpr MinorTable() : term() {
        for (int k = 2, next = 0; k <= N; ++k)
            for (int mask = 0; mask < (1 << N); ++mask) {
                if (size(mask) != k) continue;
                for (int row = 0; row < N; ++row) {
                    if ((mask >> row & 1) == 0) continue;
                    term[next].row = static_cast<std::uint8_t>(row);
                    term[next].below = static_cast<std::uint8_t>(rank(mask & ~(1 << row)));
                    ++next;
                }
            }
    }

private:
    static constexpr int size(int mask) {
        int bits = 0;
        for (; mask != 0; mask &= mask - 1) ++bits;
        return bits;
    }
    // How many sets of the same size come before: the sum of binomial(member j, j + 1).
    static constexpr int rank(int mask) {
        int before = 0;
        for (int row = 0, j = 0; row < N; ++row)
            if ((mask >> row & 1) != 0) before += binomial(row, ++j);
        return before;
    }
};

inline constexpr MinorTable<minor_rows_max> minor_table{};

// Where the terms of order k begin, k for each minor.
constexpr int minor_terms_at(int k) { return MinorTable<minor_rows_max>::terms_before(k); }

// All minors of order K of n rows from those of order K-1. column: the entries of column K-1. Member K-1-j of a sum
// comes with sign (-1)^j, so that a sum starts with a term that is not negated. K is known when compiling, for the loop
// over members is as short as it.
template <int K, class T> void minors_up(int n, const T* column, const T* below, T* out) {
    const MinorTerm* term = minor_table.term + minor_terms_at(K);
    const int count = binomial(n, K);
    for (int s = 0; s < count; ++s, term += K) {
        T sum = column[term[K - 1].row] * below[term[K - 1].below];
        for (int j = 1; j < K; ++j) {
            const T product = column[term[K - 1 - j].row] * below[term[K - 1 - j].below];
            sum = (j & 1) != 0 ? sum - product : sum + product;
        }
        out[s] = sum;
    }
}

// The minors of order k <= most of the first k columns of a matrix of n rows, from those of order K-1, in one of two
// levels.
template <int K, int most, class T>
const T* minors_of_columns(int n, int k, const T (*column)[minor_rows_max], const T* below,
                           T (&level)[2][widest_level(minor_rows_max)]) {
    if (K > k) return below;
    if constexpr (K <= most) {
        minors_up<K>(n, column[K - 1], below, level[K & 1]);
        below = minors_of_columns<K + 1, most>(n, k, column, level[K & 1], level);
    }
    return below;
}

// The same in doubles for numbers of rows and columns known when compiling: straight-line code without a loop or a
// branch.
template <int N, int K> struct Minors {
    static constexpr MinorTerm member(int s, int j) { return minor_table.term[minor_terms_at(K) + s * K + j]; }

    template <int S, int J> static double term(const double (&a)[N][N], const double* below) {
        constexpr MinorTerm m = member(S, K - 1 - J);
        return a[m.row][K - 1] * below[m.below];
    }
    template <int S, int... J>
    static double sum(const double (&a)[N][N], const double* below, std::integer_sequence<int, J...>) {
        double s = term<S, 0>(a, below);
        ((s = (J & 1) == 0 ? s - term<S, J + 1>(a, below) : s + term<S, J + 1>(a, below)), ...);
        return s;
    }
    template <int... S>
    static void all(const double (&a)[N][N], const double* below, double* out, std::integer_sequence<int, S...>) {
        ((out[S] = sum<S>(a, below, std::make_integer_sequence<int, K - 1>{})), ...);
    }
    static void all(const double (&a)[N][N], const double* below, double* out) {
        all(a, below, out, std::make_integer_sequence<int, binomial(N, K)>{});
    }
};

// The minors of order L, from those of order K-1.
template <int N, int K, int L> void minors_of_order(const double (&a)[N][N], const double* below, double* out) {
    if constexpr (K == L) {
        Minors<N, K>::all(a, below, out);
    } else {
        double minors[binomial(N, K)];
        Minors<N, K>::all(a, below, minors);
        minors_of_order<N, K + 1, L>(a, minors, out);
    }
}
// The same by loops, which take less code from 6 rows on. a: [n][n].
inline void minors_by_loops(int n, int order, const double* a, double* out) {
    double column[minor_rows_max][minor_rows_max], level[2][widest_level(minor_rows_max)];
    for (int i = 0; i < n; ++i)
        for (int c = 0; c < order; ++c) column[c][i] = a[i * n + c];
    const double* const minors = minors_of_columns<2, minor_rows_max>(n, order, column, column[0], level);
    for (int s = 0; s < binomial(n, order); ++s) out[s] = minors[s];
}
#ifdef __OPTIMIZE_SIZE__
constexpr int straight_rows_max = 5;
#else
constexpr int straight_rows_max = minor_rows_max;
#endif

// The minors of order L of the first L columns.
template <int L, int N> void minors_of_order(const double (&a)[N][N], double* out) {
    if constexpr (N > straight_rows_max) {
        minors_by_loops(N, L, a[0], out);
    } else {
        double first[N];
        for (int i = 0; i < N; ++i) first[i] = a[i][0];
        minors_of_order<N, 2, L>(a, first, out);
    }
}

}  // namespace netmesh
