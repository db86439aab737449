// Square roots in integers, as processors without a unit for doubles take them, against the host's own.
#include "numerics/square_root.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

#include "numerics/bits.hpp"

using namespace netmesh;

namespace {

bool is_same(double a, double b) { return std::isnan(a) ? std::isnan(b) : bits_of(a) == bits_of(b); }

}  // namespace

TEST_CASE("square roots in integers are rounded correctly") {
    using Limits = std::numeric_limits<double>;
    for (const double x :
         {0.0, -0.0, 1.0, 2.0, 3.0, 4.0, 0.25, -1.0, -0x1p-1074, Limits::max(), Limits::min(), Limits::denorm_min(),
          0x1.fffffffffffffp0, 0x1.fffffffffffffp1, Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()})
        CHECK_MESSAGE(is_same(integer_square_root(x), std::sqrt(x)), x);
    std::uint64_t state = 7;
    std::uint32_t different = 0;
    for (int i = 0; i < 300000; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        const double any = double_of_bits(state ^ (state >> 31));           // of every size and sign
        const double tiny = double_of_bits((state >> 12) >> (state % 50));  // denormal
        const double root = 1 + static_cast<double>(state >> 38) * 0x1p-26;
        const double square = root * root;  // of 53 bits: a root of 27
        for (const double x : {any, tiny, square, std::nextafter(square, 0.0), std::nextafter(square, 9.0)})
            different += !is_same(integer_square_root(x), std::sqrt(x));
    }
    CHECK(different == 0);
}
