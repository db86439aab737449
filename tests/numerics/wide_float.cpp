#include "numerics/wide_float.hpp"

#include <doctest/doctest.h>
#include <gmpxx.h>

#include <cmath>

#include "common/inputs.hpp"

using namespace netmesh;

namespace {

// A number and what it stands for: exact as long as rationals follow each operation.
struct Both {
    WideFloat wide;
    mpq_class exact;
};

// Any double of a wide range, mostly few bits.
double any(inputs::Random& random) {
    const double x = random.below(4) == 0 ? random.uniform() : static_cast<double>(random.below(9));
    return (random.below(2) == 0 ? x : -x) * std::ldexp(1.0, static_cast<int>(random.below(200)) - 100);
}

// Exactly, by taking off the first 40 bits and more until nothing is left. Numbers below 2^-1000 are rounded to 0.
mpq_class value_of(WideFloat x) {
    const bool is_tiny = x.rounded() == 0;
    if (is_tiny) x = x * WideFloat(0x1p900);
    const double size = x.rounded();
    if (size == 0) return 0;
    mpq_class sum, unit(std::ldexp(1.0, std::ilogb(size)));
    if (is_tiny) unit >>= 900;
    x = x * WideFloat(std::ldexp(1.0, -std::ilogb(size)));
    for (int k = 0; k < 30; ++k) {
        const double d = x.rounded();
        sum += mpq_class(d) * unit;
        x = (x - WideFloat(d)) * WideFloat(0x1p40);
        unit >>= 40;
    }
    return sum;
}

bool agree(const WideFloat& x, const mpq_class& exact) {
    const mpq_class error = abs(value_of(x) - exact);
    mpq_class bound = abs(exact);
    bound >>= 1015;
    return error <= bound;
}

}  // namespace

TEST_CASE("doubles come back as they are") {
    inputs::Random random(3);
    for (int k = 0; k < 2000; ++k) {
        const double x = any(random);
        CHECK(WideFloat(x).rounded() == doctest::Approx(x).epsilon(1e-15));
        CHECK(value_of(WideFloat(x)) == mpq_class(x));
    }
    CHECK(WideFloat(0).rounded() == 0);
    CHECK(WideFloat(0x1p-1074).rounded() == 0);
    CHECK((WideFloat(0x1p-1074) * WideFloat(0x1p600)).rounded() == 0x1p-474);
    CHECK((WideFloat(0x1p900) * WideFloat(-0x1p900)).rounded() == -HUGE_VAL);
}

TEST_CASE("sums, products and quotients by rationals") {
    inputs::Random random(4);
    for (int k = 0; k < 3000; ++k) {
        // Two numbers of a few hundred bits, of which the second is often nearly the first.
        Both a = {WideFloat(any(random)), 0}, b = a;
        a.exact = b.exact = value_of(a.wide);
        for (int step = 0; step < 4; ++step) {
            const double x = any(random), y = any(random), z = random.below(2) == 0 ? y : any(random);
            a = {a.wide * WideFloat(x) + WideFloat(y), a.exact * mpq_class(x) + mpq_class(y)};
            b = {b.wide * WideFloat(x) + WideFloat(z), b.exact * mpq_class(x) + mpq_class(z)};
        }
        CHECK(agree(a.wide, a.exact));
        CHECK(agree(a.wide + b.wide, a.exact + b.exact));
        CHECK(agree(a.wide - b.wide, a.exact - b.exact));
        CHECK(agree(a.wide * b.wide, a.exact * b.exact));
        if (sgn(b.exact) != 0) {
            CHECK(agree(a.wide / b.wide, a.exact / b.exact));
            CHECK(agree(a.wide / b.wide * b.wide, a.exact));
        }
    }
    // Two that differ in their last digits or by a little, and are above and below a power of two.
    for (int k = 0; k < 1000; ++k) {
        const WideFloat x = WideFloat(1 + random.uniform()) / WideFloat(random.uniform() + 1);
        const WideFloat y = x + WideFloat(std::ldexp(random.uniform(), -static_cast<int>(random.below(1020))));
        const WideFloat one(1), z = one - (x - one) * WideFloat(std::ldexp(1.0, -static_cast<int>(random.below(900))));
        CHECK(agree(x - y, value_of(x) - value_of(y)));
        CHECK(agree(z - one, value_of(z) - 1));
        CHECK(agree(x / y - one, value_of(x / y) - 1));
        CHECK(agree(one / x - one / y, value_of(one / x) - value_of(one / y)));
        CHECK(agree(x + z - one, value_of(x + z) - 1));
    }
    const WideFloat third = WideFloat(1) / WideFloat(3);
    const double rest = (WideFloat(1) - third - third - third).rounded();
    CHECK(std::fabs(rest) < 1e-300);
}
