// How far cells reach within a ball: proven bounds against sampled points, and near to what is measured.
#include "mesh/clip/clipped_reach.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "common/dimensions.hpp"
#include "common/meshed.hpp"
#include "mesh/check/quality.hpp"
#include "mesh/clip/clipped_cell.hpp"

using namespace netmesh;

namespace {

struct Seen {
    std::uint64_t crossing = 0, near = 0, outside = 0, away = 0;
};

// The ball has `share` of the domain's radius.
template <int D> void sample(const inputs::Points& points, double share, int samples, Seen* seen) {
    Meshed<D> mesh(points, by_quality(D == 4 ? 4 : 2.5, 1, true));
    REQUIRE(mesh.status == Status::ok);
    Domain<D> ball = mesh.result.domain;
    ball.radius *= share;
    const std::uint32_t count = mesh.state.vertex_count;
    std::vector<double> out_radius(count), measured(count), farthest(count, 0), deepest(count, 0);
    std::vector<ClippedReach> reach(count);
    measure_cells<D>(mesh.store, out_radius.data(), nullptr);
    REQUIRE(measure_clipped_cells(mesh.store, ball, measured.data()) == Status::ok);
    double worst2 = 0, worst;
    std::uint32_t vertex;
    for (std::uint32_t v = 0; v < count; ++v)
        worst2 = std::max(worst2, 4 * measured[v] / mesh.store.vertex(v).nearest2);
    REQUIRE(worst_aspect_ratio(mesh.store, ball, mesh.block.arena, &worst, &vertex) == Status::ok);
    CHECK(worst == std::sqrt(worst2));
    CHECK(4 * measured[vertex] / mesh.store.vertex(vertex).nearest2 == worst2);
    const std::size_t high = mesh.block.arena.high_mark();
    REQUIRE(bound_clipped_cells(mesh.store, ball, out_radius.data(), mesh.block.arena, reach.data()) == Status::ok);
    CHECK(mesh.block.arena.high_mark() == high);
    inputs::Random random(5);
    for (int s = 0; s < samples; ++s) {
        double x[D], away2 = 0;
        for (int k = 0; k < D; ++k) {
            x[k] = 2 * random.uniform() - 1;
            away2 += x[k] * x[k];
        }
        // Half of them on the sphere, where the farthest points are.
        const double stretch = s % 2 == 0 && away2 > 0 ? ball.radius / std::sqrt(away2) : ball.radius;
        if (s % 2 == 1 && away2 > 1) continue;
        for (int k = 0; k < D; ++k) x[k] = ball.centre[k] + stretch * x[k];
        std::uint32_t nearest = 0;
        for (std::uint32_t v = 1; v < count; ++v)
            if (distance2<D>(mesh.store.point(v), x) < distance2<D>(mesh.store.point(nearest), x)) nearest = v;
        farthest[nearest] = std::max(farthest[nearest], distance<D>(mesh.store.point(nearest), x));
        deepest[nearest] = std::max(deepest[nearest], ball.radius - std::sqrt(ball.distance2(x)));
    }
    for (VertexId v(0); v < count; ++v) {
        CAPTURE(static_cast<std::uint32_t>(v));
        CHECK(std::isfinite(reach[v].from_vertex));
        CHECK(farthest[v] <= reach[v].from_vertex);
        const bool is_outside = ball.distance2(mesh.store.point(v)) > ball.radius * ball.radius * (1 + 1e-9);
        CHECK((reach[v].below < HUGE_VAL) == is_outside);
        CHECK(deepest[v] <= reach[v].below * (1 + 1e-12) + 1e-12 * ball.radius);
        const bool crosses =
            measured[v] > 0 && out_radius[v] < HUGE_VAL && out_radius[v] > 1.001 * std::sqrt(measured[v]);
        seen->outside += is_outside && farthest[v] > 0;
        seen->away += is_outside && reach[v].below == 0;
        if (!crosses || is_outside) continue;
        CHECK(reach[v].from_vertex >= std::sqrt(measured[v]));
        ++seen->crossing;
        seen->near += reach[v].from_vertex <= 1.03 * std::sqrt(measured[v]);
    }
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("no point of a clipped cell is farther than its proven reach", T, clipped_reach) {
    constexpr int D = T::value;
    Seen seen;
    for (std::uint64_t set = 0; set < (D == 2 ? 12 : D == 3 ? 4 : 2); ++set)
        for (const double share : {1.0, 0.5}) {
            CAPTURE(set);
            CAPTURE(share);
            const std::size_t n = set == 0 ? 1 : D == 4 ? 5 : 3 + 5 * set;
            sample<D>(set % 3 == 2 ? inputs::clusters(D, n, set) : inputs::uniform(D, n, set), share,
                      D == 2 ? 4000 : 1500, &seen);
        }
    CHECK(seen.crossing > (D == 4 ? 10 : 20));
    // The bound is what was measured, but for cells whose farthest point is in the middle of a face: more of them in
    // R^4.
    CHECK(static_cast<double>(seen.near) > (D == 4 ? 0.6 : 0.9) * static_cast<double>(seen.crossing));
    CHECK(seen.outside > 0);
    CHECK(seen.away > 0);
}
TEST_CASE_TEMPLATE_APPLY(clipped_reach, Dimensions<2, 4>);
