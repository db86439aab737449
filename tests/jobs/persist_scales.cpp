// The ratio of joined scales, by how it changes when a cluster shrinks.
#include "jobs/persist_scales.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "common/session.hpp"

namespace {

struct Joined {
    double separation, ratio, ratio_best;
};

// A cluster about the first point, `scale` times as wide, and points around it; coordinates are dyadic, so that the
// meshes of both scales are the same but for a power of two.
Joined join(double scale) {
    inputs::Points points = {0, 0};
    for (const double x : {1.0, 0.25, -0.5, 0.75, -0.25, -1.0}) points.push_back(scale * x);
    for (const double x : {16.0, 1.0, -3.0, 17.0, -15.0, -5.0, 4.0, -18.0}) points.push_back(x);
    Session session(2);
    REQUIRE(session.scales(session.scales_request(points)) == NETMESH_OK);
    const netmesh_report r = session.report();
    CHECK(r.scales.count == 2);
    return {r.scales.separation, r.diagram.certified_ratio, r.diagram.certified_ratio_best};
}

}  // namespace

TEST_CASE("a cluster E times its diameter away costs E / (E - 1)") {
    // Gap and radius by hand: to (-15, -5) and to scale * (-0.25, -1).
    const double gap = std::sqrt(15.0 * 15 + 5 * 5), radius = std::sqrt(0.25 * 0.25 + 1.0);
    const Joined far = join(0x1p-30);
    for (const double scale : {1.0, 0.5, 0.125}) {
        CAPTURE(scale);
        const Joined near = join(scale);
        const double e = gap / (2 * scale * radius), factor = 1 + 1 / (e - 1);
        CHECK(near.separation == doctest::Approx(e).epsilon(1e-9));
        CHECK(near.ratio == doctest::Approx(far.ratio * factor).epsilon(1e-7));
        CHECK(near.ratio_best == doctest::Approx(far.ratio_best * factor).epsilon(1e-7));
    }
}
