#include "numerics/bits.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using namespace netmesh;

TEST_CASE("doubles come apart and together") {
    std::mt19937_64 engine(11);
    int wrong = 0;
    for (int t = 0; t < 100000; ++t) {
        double x = double_of_bits(engine());
        if (t % 4 == 0) x = double_of_bits(engine() & 0x800FFFFFFFFFFFFFu);                   // denormal
        if (t % 4 == 1) x = std::ldexp(static_cast<double>(engine() % 8), -1074 + t % 2000);  // few bits
        if (!std::isfinite(x)) continue;
        const Decoded d = decode(x);
        wrong += (d.negative ? -1 : 1) * std::ldexp(static_cast<double>(d.mantissa), d.exponent) != x;
        if (x == 0) continue;
        wrong += exponent_of(std::fabs(x)) != std::ilogb(x);
        const int quantum = quantum_of(x);
        const double n = std::ldexp(std::ldexp(x, -quantum / 2), quantum / 2 - quantum);
        wrong += std::fabs(std::fmod(n, 2)) != 1;
    }
    CHECK(wrong == 0);
}

TEST_CASE("exponents of the ends of the range") {
    CHECK(exponent_of(0x1p-1074) == -1074);
    CHECK(exponent_of(0x1p-1022) == -1022);
    CHECK(exponent_of(INFINITY) == 1024);
    CHECK(exponent_of(0.0) == exponent_of_zero);
    CHECK(quantum_of(-0.0) == 1024);
    CHECK(quantum_of(0x1p-1074) == -1074);
    CHECK(quantum_of(0x1.fffffffffffffp1023) == 971);
    CHECK(power_of_two(-1022) == 0x1p-1022);
    CHECK(power_of_two(1023) == 0x1p1023);
}
