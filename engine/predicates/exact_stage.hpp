// The determinant as residues, for all finite doubles.
#pragma once
#include "numerics/residue_minors.hpp"
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

// r: the residue of |x|.
inline std::uint64_t with_sign_of(const ScaledInteger& x, std::uint64_t r, const ResiduePrime& prime) {
    return x.negative && r != 0 ? prime.value - r : r;
}

// power[k]: 2^(61 k) modulo the prime.
inline std::uint64_t residue_of(const ScaledInteger& x, const std::uint64_t* power, const ResiduePrime& prime) {
    std::uint64_t r = multiply(x.mantissa, std::uint64_t{1} << x.shift, prime);
    if (x.power != 0) r = multiply(r, power[x.power], prime);
    return with_sign_of(x, r, prime);
}

// The powers 2^(61 k), k <= scaled_power_max, modulo a prime, by the bits of k: a fifth of a table of them. Most
// coordinates need none.
class PowersByBits {
public:
    // For k <= power_max.
    PowersByBits(int power_max, const ResiduePrime& prime) {
        std::uint64_t power = prime.excess;
        for (int bit = 0; power_max >> bit != 0; ++bit) {
            of_bit_[bit] = power;
            power = multiply(power, power, prime);
        }
    }
    // r * 2^(61 k).
    std::uint64_t times(std::uint64_t r, int k, const ResiduePrime& prime) const {
        for (int bit = 0; k >> bit != 0; ++bit)
            if ((k >> bit & 1) != 0) r = multiply(r, of_bit_[bit], prime);
        return r;
    }

private:
    static constexpr int bits = 6;
    static_assert(scaled_power_max < 1 << bits, "a table of six");
    std::uint64_t of_bit_[bits];
};

inline std::uint64_t residue_of(const ScaledInteger& x, const PowersByBits& powers, const ResiduePrime& prime) {
    const std::uint64_t r = powers.times(multiply(x.mantissa, std::uint64_t{1} << x.shift, prime), x.power, prime);
    return with_sign_of(x, r, prime);
}

// The least b for which 2^b is at least D^(D/2), or (D+1) D^(1+D/2) for lifted points: compared by squares.
constexpr int hadamard_bits(int dim, bool lifted) {
    const std::uint64_t d = static_cast<std::uint64_t>(dim);
    std::uint64_t square = lifted ? (d + 1) * (d + 1) * d * d : 1;
    for (int k = 0; k < dim; ++k) square *= d;
    int bits = 0;
    while ((std::uint64_t{1} << 2 * bits) < square) ++bits;
    return bits;
}

// A difference of finite doubles is below 2^1025 and a multiple of 2^-1074.
constexpr int exact_primes_max =
    primes_for_bits((dimension_most() + 2) * (1025 + 1074) + hadamard_bits(dimension_most(), true));
static_assert(exact_primes_max <= residue_prime_count, "the table of primes is too short");

// Sign of the determinant, which has at most `bits` bits in quanta. quantum: see integer_stage.
[[gnu::noinline]] inline int exact_stage(const Frame& frame, int dim, bool lifted, const int* quantum, int bits) {
    const int n = frame_rows(dim, lifted);
    ScaledInteger x[dimension_most()][frame_rows_max + 1];
    int power_max = 0;
    for (int c = 0; c < dim; ++c)
        for (int i = 0; i <= n; ++i) {
            x[c][i] = scaled_integer(i < n ? frame.row[i][c] : frame.base[c], quantum[c]);
            power_max = x[c][i].power > power_max ? x[c][i].power : power_max;
        }
    std::uint64_t residues[exact_primes_max];
    const int primes = primes_for_bits(bits);
    for (int k = 0; k < primes; ++k) {
        const ResiduePrime prime = residue_prime(k);
        const PowersByBits power(power_max, prime);
        ResidueMatrix a;
        UnsignedSum lift[frame_rows_max];
        for (int c = 0; c < dim; ++c) {
            const std::uint64_t base = residue_of(x[c][n], power, prime);
            for (int i = 0; i < n; ++i) {
                const std::uint64_t r = residue_of(x[c][i], power, prime);
                const std::uint64_t difference = r >= base ? r - base : r + prime.value - base;
                a.put(c, i, difference, prime);
                lift[i].add_product(difference, difference);
            }
        }
        if (lifted)
            for (int i = 0; i < n; ++i) a.put(dim, i, reduce(lift[i], prime), prime);
        ResidueLevels level;
        residues[k] = *residue_minors(n, n, a, level, prime);
    }
    return sign_of_residues(residues, primes);
}

}  // namespace netmesh
