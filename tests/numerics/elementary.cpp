// Elementary functions, and numbers of two doubles where highs cancel, against the library's functions and GMP.
#include "numerics/elementary.hpp"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <cmath>

#include "common/inputs.hpp"
#include "numerics/double_double.hpp"

using namespace netmesh;

namespace {

mpq_class exact(DoubleDouble a) { return mpq_class(a.high) + mpq_class(a.low); }

DoubleDouble random_number(inputs::Random& random, double size) {
    const double high = size * (2 * random.uniform() - 1);
    return quick_two_sum(high, high * (random.uniform() - 0.5) * 0x1p-53);
}

}  // namespace

TEST_CASE("logarithm and arcsine are good to some units in the last place") {
    inputs::Random random(3);
    for (int i = 0; i < 20000; ++i) {
        const double x = std::ldexp(1 + random.uniform(), static_cast<int>(random.below(2090)) - 1070);
        const double y = 0.5 * random.uniform();
        CHECK(std::fabs(logarithm(x) - std::log(x)) <= 0x1p-50 * std::fabs(std::log(x)) + 0x1p-53);
        CHECK(std::fabs(arcsine(y) - std::asin(y)) <= 0x1p-48 * y);
    }
    CHECK(logarithm(1) == 0);
    CHECK(arcsine(0.5) == doctest::Approx(std::acos(-1) / 6).epsilon(1e-15));
}

TEST_CASE("volumes of unit balls") {
    for (int d = 0; d <= 6; ++d)
        CHECK(unit_ball_volume(d) ==
              doctest::Approx(std::pow(std::acos(-1), 0.5 * d) / std::tgamma(0.5 * d + 1)).epsilon(1e-14));
}

TEST_CASE("sums of two doubles are good to 2^-102 of themselves, however much cancels") {
    inputs::Random random(4);
    for (int i = 0; i < 20000; ++i) {
        const DoubleDouble a = random_number(random, 1);
        DoubleDouble b = random_number(random, std::ldexp(1.0, -static_cast<int>(random.below(60))));
        if (i % 2 == 0) b = quick_two_sum(-a.high, -a.low * random.uniform());
        const mpq_class sum = exact(a) + exact(b), error = abs(exact(a + b) - sum);
        CHECK(error <= abs(sum) * mpq_class(0x1p-102));
        const mpq_class product = exact(a) * exact(b);
        CHECK(abs(exact(a * b) - product) <= abs(product) * mpq_class(0x1p-102));
    }
}

TEST_CASE("the root of a number of two doubles is the nearest but for a thousandth of the last place") {
    inputs::Random random(5);
    for (int i = 0; i < 20000; ++i) {
        DoubleDouble a = random_number(random, std::ldexp(1.0, static_cast<int>(random.below(600)) - 300));
        if (a.high < 0) a = -a;
        if (a.high == 0) continue;
        const double root = square_root(a);
        const mpq_class half_step = mpq_class(std::nextafter(root, HUGE_VAL) - root) * mpq_class(0.5 + 0x1p-10);
        const mpq_class below = mpq_class(root) - half_step, above = mpq_class(root) + half_step;
        CHECK(below * below <= exact(a));
        CHECK(exact(a) <= above * above);
    }
}
