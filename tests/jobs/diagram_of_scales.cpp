// The ratio of joined scales, by how it changes when a cluster shrinks.
#include "jobs/diagram_of_scales.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/read.hpp"
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
    REQUIRE(session.persist_until_it_fits(session.scales_request(points)) == NETMESH_OK);
    const netmesh_report r = session.report();
    CHECK(r.scales.count == 2);
    CHECK(r.diagram.essential[0] == 1);
    CHECK(r.diagram.pairs[0] == points.size() / 2);
    return {r.scales.separation, r.diagram.certified_ratio, r.diagram.certified_ratio_best};
}

struct KnownBar {
    netmesh_pair pair;
    netmesh_bar_bounds bounds;
};

// The bars of `large` around `scale` times as large ones of `small`, those below 2^-5 first and apart, with bounds.
std::vector<KnownBar> known(double scale, bool of_large) {
    inputs::Points points = {0, 0};
    for (const double x : small) points.push_back(scale * x);
    points.insert(points.end(), large.begin(), large.end());
    Session session(2);
    netmesh::Request request = session.scales_request(points);
    request.bounds = &netmesh_bounds;
    REQUIRE(session.persist_until_it_fits(request) == NETMESH_OK);
    const std::vector<netmesh_pair> pairs = session.pairs();
    const std::vector<netmesh_bar_bounds> bounds = read_all(session.context, netmesh_get_bar_bounds);
    std::vector<KnownBar> bars;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (pairs[i].death < HUGE_VAL && (pairs[i].death > 2 * scale) == of_large)
            bars.push_back({pairs[i], bounds[i]});
    return bars;
}

}  // namespace

TEST_CASE("a bar is bounded by its own scale's mesh, and from a gap on by the cluster's radius") {
    const double gap = std::sqrt(15.0 * 15 + 5 * 5) / 16;
    const std::vector<KnownBar> far = known(0x1p-40, true), far_small = known(0x1p-40, false);
    REQUIRE(!far.empty());
    REQUIRE(!far_small.empty());
    int moved = 0;
    for (const double scale : {0x1p-4, 0x1p-5, 0x1p-7}) {
        CAPTURE(scale);
        const double radius = scale * std::sqrt(0.25 * 0.25 + 1.0), from = gap / 2 - radius;
        const auto before = [&](double y) { return std::min(y, std::max(from, y - radius)); };
        const auto is = [](double y) { return doctest::Approx(y).epsilon(1e-9); };
        const std::vector<KnownBar> near = known(scale, true), near_small = known(scale, false);
        REQUIRE(near.size() == far.size());
        for (std::size_t i = 0; i < near.size(); ++i) {
            const netmesh_bar_bounds &a = near[i].bounds, &b = far[i].bounds;
            CHECK(near[i].pair.birth == far[i].pair.birth);
            CHECK(near[i].pair.death == far[i].pair.death);
            CHECK(a.birth_high == b.birth_high);
            CHECK(a.death_high == b.death_high);
            CHECK(a.birth_low == is(before(b.birth_low)));
            CHECK(a.death_low == is(before(b.death_low)));
            CHECK(a.certain_after >= b.certain_after * (1 - 1e-9));
            CHECK(a.certain <= b.certain);
            moved += a.death_low < b.death_low * (1 - 1e-6);
        }
        REQUIRE(near_small.size() == far_small.size());
        for (std::size_t i = 0; i < near_small.size(); ++i) {
            const double times = scale / 0x1p-40;
            CHECK(near_small[i].bounds.birth_low == far_small[i].bounds.birth_low * times);
            CHECK(near_small[i].bounds.death_low == far_small[i].bounds.death_low * times);
            CHECK(near_small[i].bounds.death_high == far_small[i].bounds.death_high * times);
            CHECK(near_small[i].bounds.certain == far_small[i].bounds.certain);
        }
    }
    CHECK(moved > 3);
}

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
            netmesh::Request request = session.scales_request(points);
            request.goal.eps = 0;
            request.goal.ratio = ratio;
            REQUIRE(session.persist_until_it_fits(request) == NETMESH_OK);
            const netmesh_report r = session.report();
            CHECK(r.scales.count > 1);
            CHECK(r.diagram.certified_ratio <= ratio);
            nearest = std::fmax(nearest, r.diagram.certified_ratio / ratio);
        }
        CHECK(nearest > 0.95);
    }
}
