// Out-radii of cells whose corners doubles know badly: nearly flat triangles far from the origin, against radii
// computed exactly.
#include "certificate/cells.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "common/block.hpp"
#include "common/inputs.hpp"
#include "delaunay/load.hpp"

using namespace netmesh;

namespace {

// Twice the area and the products of edges of a triangle of integer points fit 128 bits: R^2 = a^2 b^2 c^2 / (2 *
// twice)^2.
long double circumradius(const double* p, const double* q, const double* r) {
    const auto edge2 = [](const double* a, const double* b) {
        const auto x = static_cast<__int128>(a[0]) - static_cast<__int128>(b[0]);
        const auto y = static_cast<__int128>(a[1]) - static_cast<__int128>(b[1]);
        return x * x + y * y;
    };
    const auto side = [](double a, double b) { return static_cast<__int128>(a) - static_cast<__int128>(b); };
    const __int128 twice = side(q[0], p[0]) * side(r[1], p[1]) - side(q[1], p[1]) * side(r[0], p[0]);
    return std::sqrt(static_cast<long double>(edge2(p, q))) * std::sqrt(static_cast<long double>(edge2(q, r))) *
           std::sqrt(static_cast<long double>(edge2(r, p))) / (2 * std::fabs(static_cast<long double>(twice)));
}

// The third vertex counts as a Steiner vertex that is nearest to the first: its corner is as far from that.
struct Measured {
    double radius2, out_radius[3], reach;
};
Measured measure(const double* points) {
    const std::uint32_t triangle[] = {0, 1, 2};
    Block block(std::size_t{1} << 16);
    StoreState state = {};
    Store<2> store(block.arena, state);
    CheckResult why;
    REQUIRE(load_cells<2>(store, points, 3, triangle, 1, &why) == Status::ok);
    store.vertex(2).marker = Marker::steiner;
    store.vertex(2).origin = 0;
    Measured measured;
    measure_cells<2>(store, measured.out_radius, &measured.reach, 2);
    measured.radius2 = store.cell(0).radius2;
    return measured;
}

}  // namespace

TEST_CASE("out-radii are no less than the exact distances to corners, though the computed ones are") {
    inputs::Random random(3);
    int solved = 0, short_by_rounding = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        // Three points on a line of a direction of some digits, one moved off by a little; all far from the origin.
        const double x = 1 + static_cast<double>(random.below(1 << 20)),
                     y = 1 + static_cast<double>(random.below(1 << 20));
        const double far = trial % 3 == 0 ? 0 : std::ldexp(1.0, static_cast<int>(30 + random.below(12)));
        const double s = 1 + static_cast<double>(random.below(50)), t = -1 - static_cast<double>(random.below(50));
        const double off = 1 + static_cast<double>(random.below(std::uint64_t{1} << random.below(20)));
        const double points[] = {far, far - 7, far + s * x, far - 7 + s * y, far + t * x - off, far - 7 + t * y + off};
        const Measured measured = measure(points);
        const long double exact = circumradius(points, points + 2, points + 4);
        for (const double r : measured.out_radius) CHECK(r >= exact * (1 - 1e-18L));
        CHECK(measured.reach >= exact * (1 - 1e-18L));
        if (!(measured.radius2 < infinity)) continue;
        ++solved;
        short_by_rounding += std::sqrt(measured.radius2) * up < exact;
    }
    CHECK(solved > 10000);
    CHECK(short_by_rounding > 10);
}

TEST_CASE("coordinates that hardly resolve a corner leave its distance from the vertices known") {
    inputs::Random random(5);
    int blurred = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const double far = std::ldexp(1.0, 40 + trial % 12);
        double points[6];
        for (double& x : points) x = far + static_cast<double>(random.below(3000));
        const long double exact = circumradius(points, points + 2, points + 4);
        if (!(exact < 1e5L)) continue;  // flat, or nearly so
        const Measured measured = measure(points);
        if (!(measured.radius2 < infinity)) continue;
        for (const double r : measured.out_radius) {
            CHECK(r >= exact * (1 - 1e-18L));
            CHECK(r <= exact * (1 + 1e-6L));
        }
        CHECK(measured.reach >= exact * (1 - 1e-18L));
        blurred +=
            std::fabs(std::sqrt(measured.radius2) - exact) < 1e-8L * exact && measured.reach > exact * (1 + 1e-6L);
    }
    CHECK(blurred > 1000);
}
