#include "numerics/residues.hpp"

namespace netmesh {
namespace {

constexpr std::uint16_t prime_excess[residue_prime_count] = {
    1,     31,    45,    229,   259,   283,   339,   391,   403,   465,   531,   579,   675,   759,   799,   819,
    829,   843,   859,   939,   985,   1015,  1153,  1195,  1215,  1281,  1299,  1351,  1371,  1425,  1489,  1525,
    1533,  1543,  1609,  1621,  1669,  1741,  1753,  1813,  1845,  1849,  1855,  1863,  1869,  1909,  1921,  1923,
    1945,  1959,  2023,  2083,  2115,  2133,  2185,  2371,  2373,  2383,  2385,  2401,  2539,  2551,  2595,  2605,
    2665,  2695,  2911,  2919,  3015,  3045,  3069,  3079,  3081,  3105,  3139,  3151,  3153,  3183,  3295,  3325,
    3331,  3361,  3363,  3373,  3409,  3441,  3465,  3625,  3669,  3793,  3799,  3835,  3865,  3895,  3913,  3931,
    3933,  4003,  4015,  4075,  4119,  4141,  4185,  4219,  4243,  4351,  4359,  4393,  4431,  4443,  4459,  4465,
    4473,  4525,  4575,  4599,  4659,  4723,  4729,  4749,  4789,  4795,  4819,  4863,  4885,  4969,  5043,  5079,
    5103,  5169,  5211,  5263,  5283,  5289,  5305,  5349,  5383,  5389,  5473,  5529,  5565,  5593,  5661,  5719,
    5725,  5779,  5793,  5811,  5859,  5941,  5949,  6031,  6049,  6061,  6081,  6103,  6139,  6279,  6345,  6355,
    6375,  6433,  6469,  6471,  6535,  6553,  6583,  6621,  6655,  6705,  6735,  6825,  6829,  6831,  6889,  6891,
    6901,  6903,  6999,  7011,  7015,  7083,  7159,  7221,  7245,  7333,  7395,  7489,  7521,  7549,  7551,  7575,
    7591,  7635,  7771,  7795,  7851,  7941,  7963,  8029,  8061,  8121,  8133,  8223,  8235,  8251,  8383,  8473,
    8511,  8533,  8559,  8565,  8575,  8613,  8635,  8721,  8763,  8851,  8883,  8895,  8905,  8929,  8931,  8973,
    8995,  9079,  9133,  9171,  9181,  9189,  9201,  9285,  9313,  9339,  9393,  9405,  9415,  9435,  9511,  9541,
    9589,  9729,  9783,  9813,  9831,  9849,  9853,  9901,  9925,  9933,  9961,  10021, 10039, 10059, 10063, 10071,
    10081, 10125, 10183, 10239, 10245, 10273, 10329, 10393, 10405, 10431, 10435, 10459, 10479, 10489, 10581, 10591,
    10605, 10633, 10729, 10731,
};

#ifdef __OPTIMIZE_SIZE__

// Halves of the steps from one excess to the next.
struct Steps {
    std::uint8_t half[residue_prime_count];
    constexpr Steps() : half() {
        for (int i = 1; i < residue_prime_count; ++i)
            half[i] = static_cast<std::uint8_t>((prime_excess[i] - prime_excess[i - 1]) / 2);
    }
};
constexpr Steps steps;

// 1 / a modulo the prime: a^(prime - 2).
std::uint64_t inverse(std::uint64_t a, const ResiduePrime& prime) {
    std::uint64_t power = 1;
    for (int bit = 60; bit >= 0; --bit) {
        power = multiply(power, power, prime);
        if (((prime.value - 2) >> bit & 1) != 0) power = multiply(power, a, prime);
    }
    return power;
}

#else

// a * small modulo 2^61 - excess, not quite reduced: below 2^61 + 2^31 when a is, for small < 2^14. In 64 bits,
// as a = high * 2^30 + low and 2^61 = excess.
constexpr std::uint64_t multiply_small(std::uint64_t a, std::uint64_t small, std::uint64_t excess) {
    const std::uint64_t high = (a >> 30) * small, low = (a & 0x3FFFFFFFu) * small;
    const std::uint64_t sum = ((high & 0x7FFFFFFFu) << 30) + low;
    return (sum & ((std::uint64_t{1} << 61) - 1)) + ((sum >> 61) + (high >> 31)) * excess;
}

// 1 / a modulo the prime p, 0 < a < p, by the Euclidean algorithm.
constexpr std::uint64_t inverse(std::uint64_t a, std::uint64_t p) {
    std::int64_t r0 = static_cast<std::int64_t>(p), r1 = static_cast<std::int64_t>(a), t0 = 0, t1 = 1;
    while (r1 != 0) {
        const std::int64_t q = r0 / r1, r2 = r0 - q * r1, t2 = t0 - q * t1;
        r0 = r1;
        r1 = r2;
        t0 = t1;
        t1 = t2;
    }
    return static_cast<std::uint64_t>(t0 < 0 ? t0 + static_cast<std::int64_t>(p) : t0);
}

// The inverse, modulo prime j, of the product of the primes before it. Prime i is excess[j] - excess[i] modulo prime j,
// and positive.
constexpr std::uint64_t prefix_inverse(int j) {
    const std::uint64_t excess = prime_excess[j], p = (std::uint64_t{1} << 61) - excess;
    std::uint64_t product = 1;
    for (int i = 0; i < j; ++i) product = multiply_small(product, excess - prime_excess[i], excess);
    return inverse(product >= p ? product - p : product, p);
}

struct PrefixInverses {
    std::uint64_t value[residue_prime_count];
    constexpr PrefixInverses() : value() {
        for (int j = 0; j < residue_prime_count; ++j) value[j] = prefix_inverse(j);
    }
};
constexpr PrefixInverses prefix_inverses;

#endif

}  // namespace

ResiduePrime residue_prime(int index) {
#ifdef __OPTIMIZE_SIZE__
    std::uint64_t excess = prime_excess[0];
    for (int i = 1; i <= index; ++i) excess += 2u * steps.half[i];
#else
    const std::uint64_t excess = prime_excess[index];
#endif
    return {(std::uint64_t{1} << 61) - excess, excess};
}

int sign_of_residues(std::uint64_t* residues, int n) {
    // Garner: the number is d_0 + p_0 (d_1 + p_1 (d_2 + ...)), so d_j = (residue j - what the digits before say) over
    // the product of the primes before.
    bool all_zero = true;
    for (int j = 0; j < n; ++j) {
        const ResiduePrime prime = residue_prime(j);
        std::uint64_t known = 0;
        const std::uint64_t r = residues[j];
#ifdef __OPTIMIZE_SIZE__
        std::uint64_t before = 1, gap = 0;
        for (int i = j - 1; i >= 0; --i) {
            gap += 2u * steps.half[i + 1];                      // prime i modulo prime j
            known = multiply(known, gap, prime) + residues[i];  // below 2^62
            before = multiply(before, gap, prime);
        }
        residues[j] = multiply(r + 3 * prime.value - known, inverse(before, prime), prime);
#else
        for (int i = j - 1; i >= 0; --i)
            known = multiply_small(known, prime.excess - prime_excess[i], prime.excess) + residues[i];
        UnsignedSum sum(known);
        known = reduce(sum, prime);
        residues[j] = multiply(r >= known ? r - known : r + prime.value - known, prefix_inverses.value[j], prime);
#endif
        all_zero &= residues[j] == 0;
    }
    if (all_zero) return 0;
    // Every digit of half the product, rounded down, is half its prime; a number above it stands for a negative one.
    for (int j = n - 1; j >= 0; --j) {
        const std::uint64_t half = residue_prime(j).value >> 1;
        if (residues[j] != half) return residues[j] > half ? -1 : 1;
    }
    return 1;
}

// From the highest digit down, the number is a * 2^exponent after each step of a -> a p + d, p = 2^61 - excess. Each of
// at most 276 steps takes two operations of at most 2^-102; digits from the fourth on are below 2^-122 of the number.
Floating floating_of_digits(const std::uint64_t* digits, int n) {
    const auto exactly = [](std::uint64_t d) {
        return quick_two_sum(static_cast<double>(static_cast<std::int64_t>(d >> 30)) * 0x1p30,
                             static_cast<double>(static_cast<std::int64_t>(d & 0x3FFFFFFFu)));
    };
    int top = n - 1;
    while (top > 0 && digits[top] == 0) --top;
    DoubleDouble a = exactly(digits[top]);
    double unit = 1;
    for (int j = top - 1; j >= 0; --j) {
        a = a * quick_two_sum(1, -static_cast<double>(static_cast<std::int64_t>(residue_prime(j).excess)) * 0x1p-61);
        unit = top - j > 3 ? 0 : unit * 0x1p-61;
        a = a + scaled(exactly(digits[j]), unit);
    }
    return {a, 61 * top};
}

}  // namespace netmesh
