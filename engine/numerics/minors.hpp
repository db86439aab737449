// Which minors a determinant of order N needs when it is expanded column by column.
//
// A minor of order K belongs to K of the N rows and to columns 0..K-1. Expanded along its last column it is
//     sum over members j of  (-1)^(K-1-j) * entry(row of member j, K-1) * minor of order K-1 without that row,
// so that all minors of one order come from those of the order below: N * 2^(N-1) products in all, no division.
// Minors of one order are numbered by their row sets, read as binary numbers, in ascending order.
#pragma once
#include <cstdint>

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

}  // namespace netmesh
