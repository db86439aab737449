// Integers as residues modulo primes just below 2^61: exact arithmetic of thousands of bits in a few kilobytes.
#pragma once
#include <cstdint>

#include "numerics/double_double.hpp"
#include "numerics/wide.hpp"

namespace netmesh {

// Enough for the longest determinant of a predicate, 16,808 bits with its sign.
constexpr int residue_prime_count = 276;

// Numbers of at most `bits` bits and a sign are told apart by this many primes: each is above 2^61 - 2^14, so that
// the product of n <= 276 exceeds 2^(61 n - 1), and it has to exceed 2^(bits + 1).
constexpr int primes_for_bits(int bits) { return (bits + 2 + 60) / 61; }

// The prime 2^61 - excess, excess < 2^14.
struct ResiduePrime {
    std::uint64_t value, excess;
};
ResiduePrime residue_prime(int index);

// sum modulo the prime, in [0, prime). sum < 2^125.
inline std::uint64_t reduce(const UnsignedSum& sum, const ResiduePrime& prime) {
    UnsignedSum once(sum.remainder61());  // 2^61 = excess
    once.add_product(sum.quotient61(), prime.excess);
    const std::uint64_t twice = once.quotient61() * prime.excess + once.remainder61();  // below 2^61 + 2^31
    return twice >= prime.value ? twice - prime.value : twice;
}

inline std::uint64_t multiply(std::uint64_t a, std::uint64_t b, const ResiduePrime& prime) {
    UnsignedSum sum;
    sum.add_product(a, b);
    return reduce(sum, prime);
}

// Sign (-1, 0, 1) of the number below half the product of the first n primes in magnitude that has these residues.
// Overwrites them with the number's mixed-radix digits. O(n^2).
int sign_of_residues(std::uint64_t* residues, int n);

// mantissa * 2^exponent.
struct Floating {
    DoubleDouble mantissa;
    int exponent;
};
// The positive number whose n mixed-radix digits these are, to 2^-91 relative; 1 <= mantissa <= 2^61.
Floating floating_of_digits(const std::uint64_t* digits, int n);

}  // namespace netmesh
