// Which minors a determinant of order N needs when it is expanded column by column.
//
// A minor of order K belongs to K of the N rows and to columns 0..K-1. Expanded along its last column it is
//     sum over members j of  (-1)^(K-1-j) * entry(row of member j, K-1) * minor of order K-1 without that row,
// so that all minors of one order come from those of the order below: N * 2^(N-1) products in all, no division.
// Minors of one order are numbered by their row sets, read as binary numbers, in ascending order.
#pragma once
#include <cstdint>
#include <utility>

namespace netmesh {

constexpr int binomial(int n, int k) {
    int value = 1;
    for (int i = 1; i <= k; ++i) value = value * (n - k + i) / i;
    return value;
}

constexpr int widest_level(int n) { return binomial(n, n / 2); }

template <int N, int K> struct MinorLevel {
    static constexpr int count = binomial(N, K);
    struct Term {
        std::uint8_t row, below;  // the row of a member, the number of the minor without it
    };
    Term term[count][K];

    constexpr MinorLevel() : term() {
        int rank_below[1 << N] = {};
        for (int mask = 0, next = 0; mask < (1 << N); ++mask) {
            rank_below[mask] = next;
            if (size(mask) == K - 1) ++next;
        }
        for (int mask = 0, index = 0; mask < (1 << N); ++mask) {
            if (size(mask) != K) continue;
            for (int row = 0, j = 0; row < N; ++row) {
                if ((mask >> row & 1) == 0) continue;
                term[index][j].row = static_cast<std::uint8_t>(row);
                term[index][j].below = static_cast<std::uint8_t>(rank_below[mask & ~(1 << row)]);
                ++j;
            }
            ++index;
        }
    }

private:
    static constexpr int size(int mask) {
        int bits = 0;
        for (; mask != 0; mask &= mask - 1) ++bits;
        return bits;
    }
};

template <int N, int K> inline constexpr MinorLevel<N, K> minor_level{};

// All minors of order K from those of order K-1. Member K-1-J of a sum comes with sign (-1)^J, so that a sum starts
// with a term that is not negated. T: double, straight-line code without a loop or a branch; or numbers of more digits,
// in loops.
template <int N, int K, class T> struct Minors {
    static constexpr const MinorLevel<N, K>& level = minor_level<N, K>;

    static T term(const T (&a)[N][N], const T* below, int s, int j) {
        return a[level.term[s][K - 1 - j].row][K - 1] * below[level.term[s][K - 1 - j].below];
    }
    [[gnu::noinline]] static void all(const T (&a)[N][N], const T* below, T* out) {
        for (int s = 0; s < level.count; ++s) {
            out[s] = term(a, below, s, 0);
            for (int j = 1; j < K; ++j)
                out[s] = (j & 1) != 0 ? out[s] - term(a, below, s, j) : out[s] + term(a, below, s, j);
        }
    }
};
template <int N, int K> struct Minors<N, K, double> {
    static constexpr const MinorLevel<N, K>& level = minor_level<N, K>;

    template <int S, int J> static double term(const double (&a)[N][N], const double* below) {
        return a[level.term[S][K - 1 - J].row][K - 1] * below[level.term[S][K - 1 - J].below];
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
template <int N, int K, int L, class T> void minors_of_order(const T (&a)[N][N], const T* below, T* out) {
    if constexpr (K == L) {
        Minors<N, K, T>::all(a, below, out);
    } else {
        T minors[binomial(N, K)];
        Minors<N, K, T>::all(a, below, minors);
        minors_of_order<N, K + 1, L>(a, minors, out);
    }
}
// The minors of order L of the first L columns.
template <int L, int N, class T> void minors_of_order(const T (&a)[N][N], T* out) {
    T first[N];
    for (int i = 0; i < N; ++i) first[i] = a[i][0];
    minors_of_order<N, 2, L>(a, first, out);
}

}  // namespace netmesh
