// How far clipped cells reach: as measured and as checked against sampling by brute force, and where memory is short.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/dimensions.hpp"
#include "common/meshed.hpp"
#include "delaunay/load.hpp"
#include "delaunay/sphere.hpp"
#include "delaunay/triangulate.hpp"
#include "mesh/check/check_reach.hpp"
#include "mesh/check/quality.hpp"
#include "mesh/clip/clipped_cell.hpp"
#include "mesh/sizing.hpp"
#include "numerics/vector.hpp"

using namespace netmesh;

namespace {

// A point of the ball, every other one on its sphere.
template <int D> void sample(inputs::Random& random, const Domain<D>& ball, bool on_sphere, double* x) {
    double length2;
    do {
        length2 = 0;
        for (int k = 0; k < D; ++k) {
            x[k] = 2 * random.uniform() - 1;
            length2 += x[k] * x[k];
        }
    } while (length2 > 1 || length2 == 0);
    const double scale = on_sphere ? ball.radius / std::sqrt(length2) : ball.radius;
    for (int k = 0; k < D; ++k) x[k] = ball.centre[k] + scale * x[k];
}

// Squared distance of each vertex to the farthest of some points of the ball that it is nearest to.
template <int D> std::vector<double> sampled_reach2(const Store<D>& store, const Domain<D>& ball, int samples) {
    std::vector<double> reach2(store.state.vertex_count, 0);
    inputs::Random random(11);
    for (int s = 0; s < samples; ++s) {
        double x[D], nearest2 = infinity;
        sample<D>(random, ball, s % 2 == 1, x);
        std::uint32_t nearest = 0;
        for (std::uint32_t v = 0; v < store.state.vertex_count; ++v) {
            const double d2 = distance2<D>(x, store.point(v));
            if (!(d2 < nearest2)) continue;
            nearest2 = d2;
            nearest = v;
        }
        reach2[nearest] = std::max(reach2[nearest], nearest2);
    }
    return reach2;
}

// Inputs in few dimensions out of D: their cells end on the sphere, most of them without a corner.
inputs::Points flat(int dim, int within, std::size_t n, std::uint64_t seed) {
    inputs::Points points = inputs::uniform(within, n, seed), all;
    for (std::size_t i = 0; i < n; ++i)
        for (int k = 0; k < dim; ++k)
            all.push_back(k < within ? points[i * static_cast<std::size_t>(within) + static_cast<std::size_t>(k)] : 0);
    return all;
}

inputs::Points on_curve(int dim, std::size_t n) {
    inputs::Points points;
    for (std::size_t i = 0; i < n; ++i) {
        const double t = double(i) / double(n - 1);
        for (int k = 0; k < dim; ++k)
            points.push_back(k == 0 ? std::cos(t) : k == 1 ? std::sin(t) : 0.05 * std::pow(t, k));
    }
    return points;
}

// The triangulation of points and of a frame around them, unrefined, as a mesh has it. away: how many radii its
// vertices are from the centre, 4 by themselves; given, they stand beside the axes.
template <int D> struct Framed {
    explicit Framed(const inputs::Points& points, const std::vector<double>& away = {})
        : block(std::size_t{1} << 26), store(block.arena, state) {
        const std::uint32_t n = static_cast<std::uint32_t>(points.size() / D);
        smallest_enclosing_ball<D>(points.data(), n, domain.centre, &domain.radius);
        domain.enclosing_radius = domain.radius;
        inputs::Points all = points;
        for (int i = 0; i < 2 * D; ++i)
            for (int k = 0; k < D; ++k) {
                const double far = away.empty() ? 4 : away[static_cast<std::size_t>(i)];
                const double beside = away.empty() ? 0 : 0.01 * ((5 * i + 3 * k) % 7 - 3);
                all.push_back(domain.centre[k] +
                              (k == i / 2 ? (i % 2 == 0 ? far : -far) : far * beside) * domain.radius);
            }
        Monitor monitor;
        InputReport input;
        REQUIRE(triangulate<D>(store, all.data(), n + 2 * D, 1, monitor, &input) == Status::ok);
        recompute_balls<D>(store);
        measure_edges(store);
        for (CellId c(0); c < state.cell_slots; ++c)
            for (const VertexId v : store.cell(c).vertex) store.vertex(v).cell = c;
        for (std::uint32_t v = n; v < n + 2 * D; ++v) store.vertex(v).marker = Marker::exempt;
    }
    Block block;
    StoreState state = {};
    Store<D> store;
    Domain<D> domain = {};
};

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("measured and checked reach agree with sampling, on cells that nothing has refined", T,
                          agree) {
    constexpr int D = T::value;
    const int samples = 20000;
    // A check takes seconds in R^6, where a cell that nothing has refined has thousands of corners.
    for (int kind = 0; kind < 8; kind += D < 6 ? 1 : 3) {
        const std::size_t n = kind == 0   ? 2
                              : kind == 1 ? 3
                                          : 3 + static_cast<std::size_t>(D < 5    ? 3 * kind
                                                                         : D == 5 ? kind
                                                                                  : 1);
        const int within = kind < 2 ? D : 1 + kind % D;
        const inputs::Points points = kind == 7 ? on_curve(D, n) : flat(D, within, n, 7 + static_cast<unsigned>(kind));
        Framed<D> m(points);
        INFO("kind " << kind);
        for (const double factor : {1.0, 1.3}) {
            Domain<D> ball = m.domain;
            ball.radius *= factor;
            std::vector<double> out2(m.state.vertex_count);
            REQUIRE(measure_clipped_cells(m.store, ball, out2.data()) == Status::ok);
            const std::vector<double> sampled2 = sampled_reach2<D>(m.store, ball, samples);
            std::vector<double> limit2(m.state.vertex_count, infinity);
            std::uint32_t beyond;
            for (std::uint32_t v = 0; v < n; ++v) {
                CHECK(sampled2[v] <= out2[v] * (1 + 1e-9));
                if (n < 4) CHECK(out2[v] <= sampled2[v] * 1.3);  // half of the ball and more: it is sampled densely
                limit2[v] = out2[v] * (1 + 1e-7);
            }
            REQUIRE(check_reach(m.store, {ball, limit2.data()}, &beyond) == Status::ok);
            CHECK(beyond == none);
            std::fill(limit2.begin(), limit2.end(), infinity);
            for (std::uint32_t v = 0; v < n; v += D < 6 ? 1 : 4) {
                limit2[v] = out2[v] * (1 - 1e-6);
                REQUIRE(check_reach(m.store, {ball, limit2.data()}, &beyond) == Status::ok);
                CHECK(beyond == v);
                limit2[v] = sampled2[v] * (1 - 1e-9);
                REQUIRE(check_reach(m.store, {ball, limit2.data()}, &beyond) == Status::ok);
                if (sampled2[v] > 0) CHECK(beyond == v);
                limit2[v] = infinity;
            }
        }
    }
}
TEST_CASE_TEMPLATE_APPLY(agree, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("checked reach of cells whose corners are as far away as a file likes", T, far_away) {
    constexpr int D = T::value;
    inputs::Random random(3);
    for (int run = 0; run < (D < 4 ? 30 : 8); ++run) {
        // Of two inputs the far corners are beside the middle of the ball, which 106 bits do not tell.
        const std::size_t n = run % 2 == 0 ? 2 : 3 + static_cast<std::size_t>(run % 4);
        std::vector<double> away;
        const double together = std::pow(10, (n == 2 ? 35 : 2) + 20 * random.uniform());
        for (int i = 0; i < 2 * D; ++i)
            away.push_back(run % 4 < 2 ? together : std::pow(10, 2 + 50 * random.uniform()));
        const Framed<D> m(inputs::uniform(D, n, 100 + static_cast<unsigned>(run)), away);
        Domain<D> ball = m.domain;
        ball.radius *= 10;
        const std::vector<double> sampled2 = sampled_reach2<D>(m.store, ball, 4000);
        std::vector<double> limit2(m.state.vertex_count, infinity);
        std::uint32_t beyond;
        INFO("run " << run);
        for (std::uint32_t v = 0; v < n; ++v) {
            if (sampled2[v] == 0) continue;
            limit2[v] = sampled2[v] * (1 - 1e-9);
            REQUIRE(check_reach(m.store, {ball, limit2.data()}, &beyond) == Status::ok);
            CHECK(beyond == v);
            // The ball's diameter is as far as anything reaches.
            limit2[v] = 4.1 * ball.radius * ball.radius;
            REQUIRE(check_reach(m.store, {ball, limit2.data()}, &beyond) == Status::ok);
            CHECK(beyond == none);
        }
    }
}
TEST_CASE_TEMPLATE_APPLY(far_away, Dimensions<2, 4>);

TEST_CASE_TEMPLATE_DEFINE("a corner that no digits tell is not within anything", T, no_corner) {
    constexpr int D = T::value;
    Framed<D> m(inputs::uniform(D, 8, 5));
    std::vector<double> limit2(m.state.vertex_count, infinity);
    const CellId c = m.store.vertex(0).cell;
    limit2[0] = 1e6 * m.domain.radius * m.domain.radius;
    std::uint32_t beyond;
    REQUIRE(check_reach(m.store, {m.domain, limit2.data()}, &beyond) == Status::ok);
    CHECK(beyond == none);
    // Two of its vertices in one place.
    const VertexId other = m.store.cell(c).vertex[m.store.cell(c).vertex[0] == 0 ? 1 : 0];
    copy<D>(D, m.store.point(0), m.store.vertex(other).x);
    REQUIRE(check_reach(m.store, {m.domain, limit2.data()}, &beyond) == Status::ok);
    CHECK(beyond == 0);
}
TEST_CASE_TEMPLATE_APPLY(no_corner, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("a vertex far outside of the ball reaches what its cell has in it", T, from_outside) {
    constexpr int D = T::value;
    // One input in the middle, others around the ball: its own cell is what the ball is cut to.
    for (const double far : {1.2, 2.0, 3.5}) {
        inputs::Points points(D, 0.0);
        for (int i = 0; i < 2 * D; ++i)
            for (int k = 0; k < D; ++k) points.push_back(k == i / 2 ? (i % 2 == 0 ? far : -far) : 0.001 * (i + k));
        const Framed<D> m(points);
        Domain<D> ball = {};
        ball.radius = 1;
        const std::vector<double> sampled2 = sampled_reach2<D>(m.store, ball, 20000);
        std::vector<double> limit2(m.state.vertex_count, infinity);
        std::uint32_t beyond;
        for (std::uint32_t v = 1; v <= 2 * D; ++v) {
            INFO("far " << far << ", vertex " << v);
            // Beyond all of the ball, in the middle of it, before it.
            for (const double limit : {0.25 * (far - 1), 0.5 * (far - 1) + 0.5 * std::sqrt(sampled2[v]), far + 2}) {
                limit2[v] = limit * limit;
                REQUIRE(check_reach(m.store, {ball, limit2.data()}, &beyond) == Status::ok);
                CHECK((beyond == v) == (limit * limit < sampled2[v]));
            }
            limit2[v] = infinity;
        }
    }
}
TEST_CASE_TEMPLATE_APPLY(from_outside, Dimensions<2, 4>);

TEST_CASE_TEMPLATE_DEFINE("a point that reaches a distance is at it, in the ball and in the cell", T, reaching) {
    constexpr int D = T::value;
    int found = 0;
    for (const int within : {1, 2, D}) {
        const std::uint32_t n = 3 * D;
        Framed<D> m(flat(D, within, n, 5));
        const std::vector<double> sampled2 = sampled_reach2<D>(m.store, m.domain, 5000);
        for (VertexId v(0); v < n; ++v)
            for (const double part : {0.3, 0.6, 0.9, 0.99}) {
                const double* const p = m.store.point(v);
                const Cut cut(m.domain, p, part * sampled2[v]);
                CutCorners corners(D);
                for (CellId c(0); c < m.state.cell_slots; ++c)
                    if (std::count(m.store.cell(c).vertex, m.store.cell(c).vertex + D + 1, v) > 0)
                        offer_cut_corners(m.store, cut, v, c, &corners);
                CHECK(corners.reach_beyond(cut.distance2()));
                double x[D];
                if (!find_reaching_point(m.store, cut, v, corners, x)) continue;
                ++found;
                const double d2 = distance2<D>(x, p), slack = 1e-9 * m.domain.radius * m.domain.radius;
                CHECK(d2 == doctest::Approx(part * sampled2[v]).epsilon(1e-9));
                CHECK(distance2<D>(x, m.domain.centre) <= m.domain.radius * m.domain.radius + slack);
                for (std::uint32_t w = 0; w < m.state.vertex_count; ++w)
                    CHECK(distance2<D>(x, m.store.point(w)) >= d2 - slack);
            }
    }
    CHECK(found > 0);
}
TEST_CASE_TEMPLATE_APPLY(reaching, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("sampled cells of flat and curved inputs keep tau", T, keep) {
    constexpr int D = T::value;
    constexpr double tau = D < 4 ? 2.5 : 4;
    for (int within = 1; within <= D; ++within)
        for (const bool certify : {false, true}) {
            const std::size_t n = within == 1 ? 40 : 12;
            const inputs::Points points = certify && within == D ? on_curve(D, 30) : flat(D, within, n, 5);
            for (const MeshRequest& request : {by_quality(tau, 1, certify), by_hierarchy(tau, true)}) {
                Meshed<D> m(points, request);
                REQUIRE(m.status == Status::ok);
                const std::vector<double> reach2 = sampled_reach2<D>(m.store, m.result.domain, D < 4 ? 20000 : 4000);
                double worst = 0;
                for (std::uint32_t v = 0; v < m.state.vertex_count; ++v)
                    if (m.store.vertex(v).marker != Marker::exempt)
                        worst = std::max(worst, 2 * std::sqrt(reach2[v] / m.store.vertex(v).nearest2));
                CHECK(worst <= tau);
                CHECK(worst > 1);
            }
        }
}
TEST_CASE_TEMPLATE_APPLY(keep, Dimensions<2, 4>);

TEST_CASE("quality does not depend on the scale, to the ends of the range") {
    const inputs::Points points = inputs::clusters(3, 30);
    const Meshed<3> plain(points, by_quality(2.5));
    REQUIRE(plain.status == Status::ok);
    for (const int exponent : {-470, -300, 300, 490}) {
        inputs::Points scaled = points;
        for (double& x : scaled) x = std::ldexp(x, exponent);
        Meshed<3> m(scaled, by_quality(2.5));
        INFO("exponent " << exponent);
        REQUIRE(m.status == Status::ok);
        CHECK(m.state.vertex_count == plain.state.vertex_count);
        double worst;
        std::uint32_t v, beyond;
        REQUIRE(worst_aspect_ratio(m.store, m.result.domain, m.block.arena, &worst, &v) == Status::ok);
        CHECK(worst <= 2.5);
        CHECK(worst > 2);
        std::vector<double> limit2(m.state.vertex_count, infinity);
        for (std::uint32_t w = 0; w < m.state.vertex_count; ++w)
            if (m.store.vertex(w).marker != Marker::exempt) limit2[w] = 1.25 * 1.25 * m.store.vertex(w).nearest2;
        REQUIRE(check_reach(m.store, {m.result.domain, limit2.data()}, &beyond) == Status::ok);
        CHECK(beyond == none);
        limit2[v] = 0.9 * 0.25 * worst * worst * m.store.vertex(v).nearest2;
        REQUIRE(check_reach(m.store, {m.result.domain, limit2.data()}, &beyond) == Status::ok);
        CHECK(beyond == v);
    }
}

TEST_CASE_TEMPLATE_DEFINE("the farthest point of half a ball, wherever the ball lies", T, half_ball) {
    constexpr int D = T::value;
    // v at the origin, w beside it, all others far away: in the ball there is only the bisector of v and w.
    inputs::Points points(2 * D, 0.0);
    points[D] = 1;
    for (const double off : {-3.0, -0.5, 0.0, 0.25, 0.4, 0.5}) {
        Meshed<D> m(points, by_quality(1e9, 20));
        REQUIRE(m.status == Status::ok);
        Domain<D> ball = {};
        ball.centre[0] = off;
        ball.radius = 1;
        std::vector<double> out2(m.state.vertex_count);
        REQUIRE(measure_clipped_cells(m.store, ball, out2.data()) == Status::ok);
        // Left of x = 1/2. The point opposite to the origin, when it is there; otherwise where the plane meets the
        // ball.
        const double opposite = off + (off > 0 ? 1 : -1);
        const double rim2 = 0.25 + (1 - (0.5 - off) * (0.5 - off));
        const double expected2 = opposite <= 0.5 ? opposite * opposite : rim2;
        CHECK(out2[0] == doctest::Approx(expected2).epsilon(1e-9));
    }
}
TEST_CASE_TEMPLATE_APPLY(half_ball, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("reach in any gap: the same figure, or none", T, gaps) {
    constexpr int D = T::value;
    const inputs::Points points = flat(D, D - 1, 6, 3);
    Meshed<D> m(points, by_quality(1e9));
    REQUIRE(m.status == Status::ok);
    SizeRule rule;
    rule.eps = 0.5;
    const std::uint32_t n = m.inputs();
    SizeRatio expected, sized;
    REQUIRE(worst_size_ratio(m.store, {m.result.domain, n, rule}, m.block.arena, &expected) == Status::ok);
    CHECK(expected.worst > 0);
    double expected_worst, worst;
    std::uint32_t v, beyond;
    REQUIRE(worst_aspect_ratio(m.store, m.result.domain, m.block.arena, &expected_worst, &v) == Status::ok);
    std::vector<double> limit2(m.state.vertex_count, infinity);
    for (std::uint32_t p = 0; p < n; ++p) limit2[p] = 0.25 * m.store.vertex(p).nearest2;
    const std::size_t low = m.block.arena.low_mark(), top = m.block.arena.high_mark();
    int done[3] = {};
    for (std::size_t bytes = 0; bytes < top - low; bytes += 16) {
        m.block.arena.release_low(top - bytes);
        const Status status[3] = {
            worst_size_ratio(m.store, {m.result.domain, n, rule}, m.block.arena, &sized),
            worst_aspect_ratio(m.store, m.result.domain, m.block.arena, &worst, &v),
            check_reach(m.store, {m.result.domain, limit2.data()}, &beyond),
        };
        m.block.arena.release_low(low);
        for (int i = 0; i < 3; ++i) {
            REQUIRE((status[i] == Status::ok || status[i] == Status::out_of_memory));
            done[i] += status[i] == Status::ok;
        }
        if (status[0] == Status::ok) CHECK(sized.worst == expected.worst);
        if (status[1] == Status::ok) CHECK(worst == expected_worst);
        if (done[0] > 100 && done[1] > 100 && done[2] > 100) break;
    }
    for (const int times : done) CHECK(times > 0);
}
TEST_CASE_TEMPLATE_APPLY(gaps, Dimensions<>);
