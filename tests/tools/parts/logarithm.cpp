#include "tools/commands/logarithm.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

using netmesh::tool::natural_logarithm;

TEST_CASE("the logarithm that results are printed with") {
    CHECK(natural_logarithm(1, 0) == 0);
    CHECK(natural_logarithm(1, 1) == std::log(2.0));
    std::mt19937_64 random(1);
    for (int i = 0; i < 100000; ++i) {
        const int exponent = i % 2 == 0 ? 0 : static_cast<int>(random() % 2100);
        double mantissa = 1 + static_cast<double>(random() >> 12) * 0x1p-52;
        if (i % 5 == 0)
            mantissa = 1 + static_cast<double>(random() >> 12) * std::ldexp(1.0, -52 - static_cast<int>(random() % 50));
        const long double exact = logl(mantissa) + exponent * 0.693147180559945309417232121458176568L;
        const double ours = natural_logarithm(mantissa, exponent);
        if (exact == 0) {
            CHECK(ours == 0);
            continue;
        }
        const double ulp = std::nextafter(static_cast<double>(exact), 1e300) - static_cast<double>(exact);
        CHECK(fabsl(ours - exact) <= 4.0L * ulp);
    }
}
