// The ratio of joined scales, by how it changes when a cluster shrinks.
#include "jobs/persist_scales.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "common/session.hpp"

namespace {

struct Joined {
    double separation, ratio, ratio_best;
};

const inputs::Points small = {1, 0.25, -0.5, 0.75, -0.25, -1},
                     large = {1, 0.0625, -0.1875, 1.0625, -0.9375, -0.3125, 0.25, -1.125};

// The origin, points around it and, `scale` times as wide, a cluster; coordinates are dyadic, so that the meshes of
// both are the same for every scale, but for a power of two.
Joined join(const inputs::Points& around, const inputs::Points& cluster, double scale) {
    inputs::Points points = {0, 0};
    for (const double x : cluster) points.push_back(scale * x);
    points.insert(points.end(), around.begin(), around.end());
    Session session(2);
    REQUIRE(session.scales(session.scales_request(points)) == NETMESH_OK);
    const netmesh_report r = session.report();
    CHECK(r.scales.count == 2);
    CHECK(r.diagram.essential[0] == 1);
    CHECK(r.diagram.pairs[0] == points.size() / 2);
    return {r.scales.separation, r.diagram.certified_ratio, r.diagram.certified_ratio_best};
}

}  // namespace

TEST_CASE("the worse of two clusters decides, whichever is around the other") {
    const Joined one = join(large, small, 0x1p-30), other = join(small, large, 0x1p-30);
    CHECK(one.ratio == doctest::Approx(other.ratio).epsilon(1e-7));
    CHECK(one.ratio_best == doctest::Approx(other.ratio_best).epsilon(1e-7));
}

TEST_CASE("a cluster E times its diameter away costs E / (E - 1)") {
    // Gap and radius by hand: to (-15, -5) / 16 and to scale * (-0.25, -1).
    const double gap = std::sqrt(15.0 * 15 + 5 * 5) / 16, radius = std::sqrt(0.25 * 0.25 + 1.0);
    const Joined far = join(large, small, 0x1p-30);
    for (const double scale : {0x1p-4, 0x1p-5, 0x1p-7}) {
        CAPTURE(scale);
        const Joined near = join(large, small, scale);
        const double e = gap / (2 * scale * radius), factor = 1 + 1 / (e - 1);
        CHECK(near.separation == doctest::Approx(e).epsilon(1e-9));
        CHECK(near.ratio == doctest::Approx(far.ratio * factor).epsilon(1e-7));
        CHECK(near.ratio_best == doctest::Approx(far.ratio_best * factor).epsilon(1e-7));
    }
}

TEST_CASE("a ratio is that of the joined diagram, and leaves the meshes no more than the join does") {
    for (std::uint64_t set = 0; set < 6; ++set) {
        CAPTURE(set);
        // Copies of a set around its own points.
        const inputs::Points base = inputs::uniform(2, 12, set);
        inputs::Points points;
        for (std::size_t i = 0; i < base.size(); i += 2)
            for (std::size_t j = 0; j < base.size(); j += 2) {
                points.push_back(base[i] + base[j] / 60);
                points.push_back(base[i + 1] + base[j + 1] / 60);
            }
        double nearest = 0;  // what is certified over what was asked for
        for (double ratio = 2.5; ratio < 4; ratio += 0.25) {
            Session session(2);
            netmesh_scales_request request = session.scales_request(points);
            request.ratio = ratio;
            REQUIRE(session.scales(request) == NETMESH_OK);
            const netmesh_report r = session.report();
            CHECK(r.scales.count > 1);
            CHECK(r.diagram.certified_ratio <= ratio);
            nearest = std::fmax(nearest, r.diagram.certified_ratio / ratio);
        }
        CHECK(nearest > 0.95);
    }
}
