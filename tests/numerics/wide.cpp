#include "numerics/wide.hpp"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <cstring>
#include <random>

using namespace netmesh;

namespace {

mpz_class big(std::uint64_t x) {
    mpz_class z;
    mpz_import(z.get_mpz_t(), 1, 1, sizeof x, 0, 0, &x);
    return z;
}
mpz_class big(std::int64_t x) {
    return x < 0 ? mpz_class(-big(~static_cast<std::uint64_t>(x)) - 1) : big(static_cast<std::uint64_t>(x));
}

// 64 random bits, often few, often at the ends of the range.
std::uint64_t random_bits(std::mt19937_64& engine) {
    const std::uint64_t x = engine() >> (engine() % 64);
    return (engine() & 1) != 0 ? x : ~x;
}

// Seven products and the carry that is left of an eighth: what a column of digits sums up.
template <class Sum> void check_signed() {
    std::mt19937_64 engine(3);
    int wrong = 0;
    for (int t = 0; t < 20000; ++t) {
        const auto start = static_cast<std::int64_t>(random_bits(engine));
        Sum sum(start);
        mpz_class value = big(start);
        for (int i = 0; i < 7; ++i) {
            const auto a = static_cast<std::int64_t>(random_bits(engine));
            const std::int64_t b = static_cast<std::int64_t>(random_bits(engine)) / 8;
            sum.add_product(a, b);
            value += big(a) * big(b);
        }
        mpz_class digits = 0;
        for (int i = 0; i < 3; ++i) digits += big(sum.take_digit()) << (64 * i);
        wrong += digits != value;
    }
    CHECK(wrong == 0);
}

template <class Sum> void check_unsigned() {
    std::mt19937_64 engine(4);
    int wrong = 0;
    for (int t = 0; t < 20000; ++t) {
        const std::uint64_t start = random_bits(engine);
        Sum sum(start);
        mpz_class value = big(start);
        for (int i = 0; i < 7; ++i) {
            const std::uint64_t a = random_bits(engine) >> 3, b = random_bits(engine) >> 3;
            sum.add_product(a, b);
            value += big(a) * big(b);
        }
        wrong += (big(sum.quotient61()) << 61) + big(sum.remainder61()) != value;
    }
    CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("signed sums of products come apart into balanced digits") {
    check_signed<SignedSum>();
    check_signed<PortableSignedSum>();
}

TEST_CASE("unsigned sums of products") {
    check_unsigned<UnsignedSum>();
    check_unsigned<PortableUnsignedSum>();
}
