// Steps of exact spheres: sums of residues, powers of two, quotients of what residues stand for.
#pragma once
#include "numerics/real.hpp"
#include "numerics/residues.hpp"

namespace netmesh {

#ifdef __OPTIMIZE_SIZE__
[[gnu::noinline]]
#endif
inline std::uint64_t
negative_of(std::uint64_t a, const ResiduePrime& prime) {
    return a == 0 ? 0 : prime.value - a;
}
#ifdef __OPTIMIZE_SIZE__
[[gnu::noinline]]
#endif
inline std::uint64_t
residue_sum(std::uint64_t a, std::uint64_t b, const ResiduePrime& prime) {
    return a + b >= prime.value ? a + b - prime.value : a + b;
}

// 2^e modulo the prime.
inline std::uint64_t power_of_two_modulo(int e, const ResiduePrime& prime) {
    std::uint64_t r = std::uint64_t{1} << (e % 61);
    for (int i = 0; i < e / 61; ++i) r = multiply(r, prime.excess, prime);
    return r;
}

// a / b for b >= 0; infinite where b is 0.
inline Floating quotient(const Floating& a, const Floating& b) {
    if (!(b.mantissa.high > 0)) return {{infinity, 0}, 0};
    return {a.mantissa / b.mantissa, a.exponent - b.exponent};
}

inline Floating floating_of(std::uint64_t* residues, int n) {
    sign_of_residues(residues, n);
    return floating_of_digits(residues, n);
}

}  // namespace netmesh
