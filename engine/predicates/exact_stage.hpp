// The determinant as residues, for all finite doubles.
#pragma once
#include "numerics/minors.hpp"
#include "numerics/residues.hpp"
#include "predicates/frame.hpp"

namespace netmesh {

// Coordinates as integers: (-1)^negative * mantissa * 2^(61 power + shift), mantissa < 2^53, 0 <= shift < 61.
struct ScaledInteger {
    std::uint64_t mantissa;
    std::int8_t power, shift;
    bool negative;
};

inline ScaledInteger scaled_integer(double x, int quantum) {
    Decoded d = decode(x);
    int shift = d.exponent - quantum;
    if (d.mantissa == 0) shift = 0;
    if (shift < 0) {
        d.mantissa >>= -shift;
        shift = 0;
    }
    return {d.mantissa, static_cast<std::int8_t>(shift / 61), static_cast<std::int8_t>(shift % 61), d.negative};
}

constexpr int scaled_power_max = (971 + 1074) / 61;

// power[k]: 2^(61 k) modulo the prime.
inline std::uint64_t residue_of(const ScaledInteger& x, const std::uint64_t* power, const ResiduePrime& prime) {
    std::uint64_t r = multiply(x.mantissa, std::uint64_t{1} << x.shift, prime);
    if (x.power != 0) r = multiply(r, power[x.power], prime);
    return x.negative && r != 0 ? prime.value - r : r;
}

// All minors of order K modulo the prime. entry: [0] column K-1, [1] its negative.
template <int N, int K>
void residue_minors(const std::uint64_t (&entry)[2][N], const std::uint64_t* below, std::uint64_t* out,
                    const ResiduePrime& prime) {
    for (int s = 0; s < binomial(N, K); ++s) {
        const auto& term = minor_level<N, K>.term[s];
        UnsignedSum sum;
        for (int j = 0; j < K; ++j) sum.add_product(entry[(K - 1 - j) & 1][term[j].row], below[term[j].below]);
        out[s] = reduce(sum, prime);
    }
}

template <int N, int K>
std::uint64_t residue_determinant(const std::uint64_t (&entry)[N][2][N], const std::uint64_t* below,
                                  const ResiduePrime& prime) {
    std::uint64_t minors[binomial(N, K)];
    residue_minors<N, K>(entry[K - 1], below, minors, prime);
    if constexpr (K == N)
        return minors[0];
    else
        return residue_determinant<N, K + 1>(entry, minors, prime);
}

template <int D, bool lifted> struct ExactBounds {
    // The least b for which 2^b is at least D^(D/2), or (D+1) D^(1+D/2) for lifted points: compared by squares.
    static constexpr int hadamard_bits() {
        std::uint64_t square = lifted ? std::uint64_t{D + 1} * (D + 1) * D * D : 1;
        for (int k = 0; k < D; ++k) square *= D;
        int bits = 0;
        while ((std::uint64_t{1} << 2 * bits) < square) ++bits;
        return bits;
    }
    // A difference of finite doubles is below 2^1025 and a multiple of 2^-1074.
    static constexpr int bits_max = (lifted ? D + 2 : D) * (1025 + 1074) + hadamard_bits();
    static constexpr int primes_max = primes_for_bits(bits_max);
    static_assert(primes_max <= residue_prime_count, "the table of primes is too short");
};

// Sign of the determinant, which has at most `bits` bits in quanta. quantum: see integer_stage.
template <int D, bool lifted> int exact_stage(const Frame<D, lifted>& frame, const int (&quantum)[D], int bits) {
    constexpr int n = Frame<D, lifted>::rows;
    ScaledInteger x[D][n + 1];
    int power_max = 0;
    for (int c = 0; c < D; ++c)
        for (int i = 0; i <= n; ++i) {
            x[c][i] = scaled_integer(i < n ? frame.row[i][c] : frame.base[c], quantum[c]);
            power_max = x[c][i].power > power_max ? x[c][i].power : power_max;
        }
    std::uint64_t residues[ExactBounds<D, lifted>::primes_max];
    const int primes = primes_for_bits(bits);
    for (int k = 0; k < primes; ++k) {
        const ResiduePrime prime = residue_prime(k);
        std::uint64_t power[scaled_power_max + 1];
        power[0] = 1;
        for (int i = 1; i <= power_max; ++i) power[i] = multiply(power[i - 1], prime.excess, prime);
        std::uint64_t entry[n][2][n];
        UnsignedSum lift[n];
        for (int c = 0; c < D; ++c) {
            const std::uint64_t base = residue_of(x[c][n], power, prime);
            for (int i = 0; i < n; ++i) {
                const std::uint64_t r = residue_of(x[c][i], power, prime);
                const std::uint64_t difference = r >= base ? r - base : r + prime.value - base;
                entry[c][0][i] = difference;
                entry[c][1][i] = prime.value - difference;
                if constexpr (lifted) lift[i].add_product(difference, difference);
            }
        }
        if constexpr (lifted)
            for (int i = 0; i < n; ++i) {
                entry[D][0][i] = reduce(lift[i], prime);
                entry[D][1][i] = prime.value - entry[D][0][i];
            }
        residues[k] = residue_determinant<n, 2>(entry, entry[0][0], prime);
    }
    return sign_of_residues(residues, primes);
}

}  // namespace netmesh
