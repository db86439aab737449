#include <doctest/doctest.h>
#include <gmpxx.h>

#include <cmath>
#include <random>

#include "numerics/integer512.hpp"

using namespace netmesh;

namespace {

struct Pair {
    Integer512 ours;
    mpz_class exact;
};

Pair random_number(std::mt19937_64& random, int bits_max) {
    std::uint64_t magnitude = random() >> random() % 64;
    const int shift = static_cast<int>(random() % static_cast<unsigned>(bits_max - 63));
    const bool negative = random() % 2 != 0;
    mpz_class exact = static_cast<unsigned long>(magnitude);
    exact <<= static_cast<unsigned>(shift);
    return {Integer512::of(magnitude, shift, negative), negative ? mpz_class(-exact) : exact};
}

void check_equal(const Integer512& ours, const mpz_class& exact) {
    int exponent;
    const double leading = ours.leading(&exponent);
    long exact_exponent;
    const double exact_leading = mpz_get_d_2exp(&exact_exponent, exact.get_mpz_t());
    CHECK(leading ==
          doctest::Approx(std::ldexp(exact_leading, static_cast<int>(exact_exponent) - exponent)).epsilon(1e-15));
    // Nothing is left when the exact number is taken off digit by digit.
    mpz_class size = abs(exact);
    Integer512 rest = ours;
    for (int shift = 0; size != 0; shift += 32, size >>= 32) {
        const mpz_class digit = size & mpz_class(0xFFFFFFFFu);
        const Integer512 part = Integer512::of(digit.get_ui(), shift, exact < 0);
        rest = rest - part;
    }
    int zero_exponent;
    CHECK(rest.leading(&zero_exponent) == 0);
}

}  // namespace

TEST_CASE("sums and products of 512 bits agree with GMP") {
    std::mt19937_64 random(5);
    for (int k = 0; k < 2000; ++k) {
        const Pair a = random_number(random, 250), b = random_number(random, 250), c = random_number(random, 440);
        check_equal(a.ours * b.ours, a.exact * b.exact);
        check_equal(a.ours * b.ours - c.ours, a.exact * b.exact - c.exact);
        check_equal(a.ours + c.ours, a.exact + c.exact);
    }
}
