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
        const std::uint32_t triangle[] = {0, 1, 2};
        Block block(std::size_t{1} << 16);
        StoreState state = {};
        Store<2> store(block.arena, state);
        CheckResult why;
        REQUIRE(load_cells<2>(store, points, 3, triangle, 1, &why) == Status::ok);
        double out_radius[3];
        measure_cells<2>(store, out_radius, nullptr);
        const long double exact = circumradius(points, points + 2, points + 4);
        for (const double r : out_radius) CHECK(r >= exact * (1 - 1e-18L));
        if (!(store.cell(0).radius2 < infinity)) continue;
        ++solved;
        short_by_rounding += std::sqrt(store.cell(0).radius2) * up < exact;
    }
    CHECK(solved > 10000);
    CHECK(short_by_rounding > 10);
}
