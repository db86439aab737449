#include "numerics/residues.hpp"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <vector>

using namespace netmesh;

namespace {

mpz_class big(std::uint64_t x) {
    mpz_class z;
    mpz_import(z.get_mpz_t(), 1, 1, sizeof x, 0, 0, &x);
    return z;
}

int sign_by_residues(const mpz_class& x, int primes) {
    std::vector<std::uint64_t> residues;
    for (int i = 0; i < primes; ++i) {
        mpz_class r;
        mpz_fdiv_r(r.get_mpz_t(), x.get_mpz_t(), big(residue_prime(i).value).get_mpz_t());
        std::uint64_t word = 0;
        mpz_export(&word, nullptr, 1, sizeof word, 0, 0, r.get_mpz_t());
        residues.push_back(word);
    }
    return sign_of_residues(residues.data(), primes);
}

}  // namespace

TEST_CASE("the moduli are distinct primes just below 2^61") {
    for (int i = 0; i < residue_prime_count; ++i) {
        const ResiduePrime p = residue_prime(i);
        CAPTURE(i);
        CHECK(mpz_probab_prime_p(big(p.value).get_mpz_t(), 25) > 0);
        CHECK(p.value + p.excess == std::uint64_t{1} << 61);
        CHECK(p.excess < 1u << 14);
        if (i > 0) CHECK(p.value < residue_prime(i - 1).value);
    }
}

TEST_CASE("reduction of sums up to the bound") {
    for (int i = 0; i < residue_prime_count; i += 25) {
        const ResiduePrime p = residue_prime(i);
        for (const std::uint64_t a : {std::uint64_t{0}, std::uint64_t{1}, p.excess, p.value / 3, p.value - 1, p.value})
            for (int terms = 1; terms <= 7; ++terms) {
                UnsignedSum sum;
                for (int t = 0; t < terms; ++t) sum.add_product(a, p.value - static_cast<std::uint64_t>(t));
                mpz_class expected = 0;
                for (int t = 0; t < terms; ++t) expected += big(a) * big(p.value - static_cast<std::uint64_t>(t));
                expected %= big(p.value);
                CHECK(big(reduce(sum, p)) == expected);
            }
    }
}

TEST_CASE("signs of numbers given by residues") {
    gmp_randclass random(gmp_randinit_default);
    random.seed(7);
    mpz_class product = 1;
    for (int n = 1; n <= residue_prime_count; ++n) {
        CAPTURE(n);
        product *= big(residue_prime(n - 1).value);
        CHECK(product > mpz_class(1) << static_cast<unsigned>(61 * n - 1));
        const bool look = n < 20 || n == 137 || n == residue_prime_count;
        if (!look) continue;
        const mpz_class greatest = (product - 1) / 2;
        for (const mpz_class& x :
             {mpz_class(0), mpz_class(1), greatest, mpz_class(greatest - 1), mpz_class(product / 4)}) {
            CHECK(sign_by_residues(x, n) == sgn(x));
            CHECK(sign_by_residues(-x, n) == -sgn(x));
        }
        for (unsigned bits = 1; bits < static_cast<unsigned>(61 * n - 2); bits += 1 + bits / 3) {
            const mpz_class x = random.get_z_bits(bits);
            CHECK(sign_by_residues(x, n) == sgn(x));
            CHECK(sign_by_residues(-x, n) == -sgn(x));
        }
    }
}

TEST_CASE("primes for a number of bits") {
    CHECK(primes_for_bits(59) == 1);
    CHECK(primes_for_bits(60) == 2);
    CHECK(primes_for_bits(120) == 2);
    CHECK(primes_for_bits(121) == 3);
    CHECK(primes_for_bits(16806) == residue_prime_count);
}
