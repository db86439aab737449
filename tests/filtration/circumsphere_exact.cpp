// Questions about smallest circumspheres in exact arithmetic whose answers are known.
#include "filtration/circumsphere_exact.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

using namespace netmesh;

namespace {

using Point = std::array<double, 3>;

ExactSphere sphere(const std::vector<Point>& points) {
    const double* address[4] = {};
    for (std::size_t i = 0; i < points.size(); ++i) address[i] = points[i].data();
    return ExactSphere(address, static_cast<int>(points.size()) - 1, 3);
}

double excess(const std::vector<Point>& a, const std::vector<Point>& b) {
    std::uint64_t scratch[ExactSphere::room(3)];
    double out = -100;
    REQUIRE(ExactSphere::excess(sphere(a), sphere(b), scratch, &out));
    return out;
}

}  // namespace

TEST_CASE("congruent are simplices with axes exchanged and reversed, each axis once") {
    const auto congruent = [](const Point& a, const Point& b) {
        return ExactSphere::congruent(sphere({{1, 1, 1}, {1 + a[0], 1 + a[1], 1 + a[2]}}), sphere({{0, 0, 0}, b}));
    };
    CHECK(congruent({3, 1, 2}, {3, 1, 2}));
    CHECK(congruent({3, 1, 2}, {2, -1, 3}));
    CHECK(!congruent({3, 1, 2}, {3, 1, 4}));
    CHECK(!congruent({3, 1, 1}, {3, 1, 2}));
    CHECK(!congruent({3, 1, 2}, {3, 1, 1}));
    CHECK(!ExactSphere::congruent(sphere({{0, 0, 0}, {3, 1, 2}, {0, 4, 0}}), sphere({{0, 0, 0}, {3, 1, 2}})));
}

TEST_CASE("squared radii are compared whatever their quanta") {
    CHECK(excess({{0, 0, 0}, {3, 4, 0}}, {{0, 0, 0}, {0, 0, 5}}) == 0);
    CHECK(excess({{0, 0, 0}, {6, 0, 0}}, {{0, 0, 0}, {0, .75, 4}}) == doctest::Approx(36 / 16.5625 - 1));
    CHECK(excess({{0, 0, 0}, {0, .75, 4}}, {{0, 0, 0}, {6, 0, 0}}) == doctest::Approx(16.5625 / 36 - 1));
    CHECK(excess({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, {{0, 0, 0}, {0, 0, 5}}) == 0);
    CHECK(excess({{0, 0, 0}, {1, 0x1p-100, 0}}, {{0, 0, 0}, {1, 0, 0}}) == 0x1p-200);
    for (int e = 400; e < 480; ++e) {
        CAPTURE(e);
        for (double m : {1.0, 1.3}) {  // other mantissas of the quotient
            const double off = std::ldexp(m, -e), due = off * off, least = 0x1p-1000;
            CHECK(excess({{0, 0, 0}, {1, off, 0}}, {{0, 0, 0}, {1, 0, 0}}) ==
                  doctest::Approx(due < 0x1p-900 ? least : due).epsilon(1e-15));
        }
    }
}
