// Meshes with cages: definition 4.5, sizes that do not depend on gaps, planted violations.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "common/dimensions.hpp"
#include "common/hierarchical.hpp"
#include "mesh/check/quality.hpp"
#include "mesh/input_tree.hpp"

using namespace netmesh;

namespace {

template <int D> std::uint32_t plain_size(const inputs::Points& points, double tau) {
    const Meshed<D> m(points, by_quality(tau), std::size_t{1} << 25);
    REQUIRE(m.status == Status::ok);
    return m.state.vertex_count;
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("hierarchical meshes are Delaunay and of quality tau by definition 4.5", T, quality) {
    constexpr int D = T::value;
    constexpr std::size_t sizes[] = {0, 0, 400, 150, 40, 10, 5};
    constexpr double taus[] = {0, 0, 2.2, 2.5, 3, 4, 4};
    for (const inputs::Points& points :
         {inputs::uniform(D, sizes[D]), inputs::clusters(D, sizes[D] / 2), inputs::nested(D, 5, sizes[D] / 5, 1e3),
          inputs::geometric(D, 1e3, D < 5 ? 100 : 8), inputs::close_pairs(D, sizes[D] / 4, 1e-12),
          inputs::grid(D, D < 4 ? 4 : 2)}) {
        Hierarchical<D> m(points, by_hierarchy(taus[D]));
        REQUIRE(m.status == Status::ok);
        CHECK(delaunay_violation<D>(m.store) == "");
        const HierarchyQuality q = m.quality();
        INFO(doctest::String(q.encroached.violation ? q.encroached.violation : ""), " ", q.encroached.cell, " n ",
             points.size());
        CHECK(found(q.encroached) == "");
        if (points.size() > 8 * D) CHECK(q.worst > 1);
        CHECK(q.worst <= taus[D]);
        CHECK(m.result.hierarchy.cages == m.result.hierarchy.cages_made - m.result.hierarchy.cages_released);
        for (std::size_t i = 0; i < points.size(); ++i)
            REQUIRE(m.store.vertex(static_cast<std::uint32_t>(i / D)).x[i % D] == points[i]);
    }
}
TEST_CASE_TEMPLATE_APPLY(quality, Dimensions<>);

// Groups of a few points far from others, so that each has a cage with several of them in it.
TEST_CASE_TEMPLATE_DEFINE("cells in a cage are of quality tau in the ball of half of its radius", T, in_cages) {
    constexpr int D = T::value;
    constexpr double tau = by_dimension<double>(D, {2.1, 2.3, 3});
    int sampled = 0;
    double worst = 0;
    for (std::uint64_t seed = 1; seed <= by_dimension<std::uint64_t>(D, {40, 16, 6}); ++seed) {
        CAPTURE(seed);
        inputs::Random random(seed);
        inputs::Points points = inputs::uniform(D, 3 + random.below(5), seed);
        const std::size_t group = points.size();
        for (std::size_t i = 0; i < group; ++i) points.push_back(points[i] + (i % D == 0 ? 100 : 0));
        for (int k = 0; k < D; ++k) points.push_back(points[static_cast<std::size_t>(k)] + 0.05 * random.uniform());
        Hierarchical<D> m(points, by_hierarchy(tau, false, seed));
        REQUIRE(m.status == Status::ok);
        for (std::uint32_t d = 0; d < m.result.hierarchy.cages; ++d) {
            const Cage& cage = m.result.cages[d];
            const auto is_deeper = [&](const double* x) {
                return std::any_of(m.result.cages, m.result.cages + m.result.hierarchy.cages, [&](const Cage& c) {
                    return c.radius < cage.radius && distance<D>(x, m.store.point(c.centre)) < c.radius;
                });
            };
            for (int sample = 0; sample < 1500; ++sample) {
                // Most of them on the sphere.
                double x[D], length2 = 0;
                for (double& c : x) {
                    c = 2 * random.uniform() - 1;
                    length2 += c * c;
                }
                if (!(length2 > 0 && length2 <= 1)) continue;
                const double stretch = sample % 4 == 0 ? 0.5 : 0.5 / std::sqrt(length2);
                for (int k = 0; k < D; ++k) x[k] = m.store.point(cage.centre)[k] + stretch * cage.radius * x[k];
                std::uint32_t v = 0;
                for (std::uint32_t w = 1; w < m.state.vertex_count; ++w)
                    if (distance<D>(x, m.store.point(w)) < distance<D>(x, m.store.point(v))) v = w;
                if (m.store.vertex(v).marker == Marker::exempt || is_deeper(m.store.point(v))) continue;
                double nearest = infinity;
                for (std::uint32_t w = 0; w < m.state.vertex_count; ++w)
                    if (w != v) nearest = std::min(nearest, distance<D>(m.store.point(w), m.store.point(v)));
                worst = std::max(worst, distance<D>(x, m.store.point(v)) / (0.5 * nearest));
                ++sampled;
            }
        }
    }
    CHECK(sampled > 1000);
    CHECK(worst <= tau * (1 + 1e-9));
}
TEST_CASE_TEMPLATE_APPLY(in_cages, Dimensions<2, 4>);

TEST_CASE_TEMPLATE_DEFINE("the size per input does not depend on gaps", T, gaps) {
    constexpr int D = T::value;
    double low = infinity, high = 0;
    for (const double ratio : {1e2, 1e3, 1e4, 1e6, 1e9}) {
        Hierarchical<D> m(inputs::geometric(D, ratio, 60), by_hierarchy(3));
        REQUIRE(m.status == Status::ok);
        low = std::min(low, m.vertices_per_input());
        high = std::max(high, m.vertices_per_input());
    }
    constexpr double most[] = {0, 0, 5, 7, 9};
    CHECK(high <= most[D]);
    CHECK(high < 1.2 * low);
    CHECK(Hierarchical<D>(inputs::close_pairs(D, 50, 1e-12), by_hierarchy(3)).vertices_per_input() <= most[D]);
}
TEST_CASE_TEMPLATE_APPLY(gaps, Dimensions<2, 4>);

TEST_CASE("without gaps a hierarchical mesh is no larger than a plain one") {
    std::uint32_t hierarchical = 0, plain = 0;
    for (const double ratio : {2.0, 4.0, 6.5})
        for (const std::uint64_t seed : {1, 2, 3}) {
            const inputs::Points points = inputs::geometric(2, ratio, 50, seed);
            Hierarchical<2> m(points, by_hierarchy(3));
            CHECK(m.result.hierarchy.cages_made == 0);
            hierarchical += m.state.vertex_count;
            plain += plain_size<2>(points, 3);
        }
    CHECK(hierarchical <= 1.05 * plain);
    const inputs::Points points = inputs::uniform(3, 300);
    CHECK(Hierarchical<3>(points, by_hierarchy(3)).state.vertex_count <= 1.05 * plain_size<3>(points, 3));
}

TEST_CASE_TEMPLATE_DEFINE("finished meshes are of quality tau and no larger than by direct refinement", T, finished) {
    constexpr int D = T::value;
    std::uint32_t hierarchical = 0, plain = 0;
    for (const inputs::Points& points :
         {inputs::clusters(D, D == 2 ? 400 : 40), inputs::geometric(D, 1e3, 3), inputs::nested(D, 4, 5, 1e2)}) {
        Hierarchical<D> m(points, by_hierarchy(3, true));
        REQUIRE(m.status == Status::ok);
        CHECK(m.result.hierarchy.cages == 0);
        CHECK(m.result.hierarchy.cages_made > 0);
        CHECK(delaunay_violation<D>(m.store) == "");
        double worst;
        std::uint32_t v;
        REQUIRE(worst_aspect_ratio(m.store, m.result.domain, m.block.arena, &worst, &v) == Status::ok);
        CHECK(worst <= 3);
        hierarchical += m.state.vertex_count;
        plain += plain_size<D>(points, 3);
    }
    CHECK(hierarchical <= 1.05 * plain);
}
TEST_CASE_TEMPLATE_APPLY(finished, Dimensions<2, 3>);

TEST_CASE("Steiner points release cages that have too little room, and the mesh is good without them") {
    Hierarchical<2> m(inputs::uniform(2, 20000, 3), by_hierarchy(2.3), std::size_t{1} << 25);
    REQUIRE(m.status == Status::ok);
    CHECK(m.result.hierarchy.cages_released > 0);
    CHECK(m.result.hierarchy.cages > 0);
    const HierarchyQuality q = m.quality();
    CHECK(found(q.encroached) == "");
    CHECK(q.worst <= 2.3);
}

TEST_CASE("a Steiner point of the cage beside it does not encroach on a cage") {
    // Found by fuzzing: two cages four radii apart, one of them with Steiner points on the near side.
    const inputs::Points points = {
        -0x1.f66a6bc80bd24p-23, -0x1.c29b8d2b625dcp-9,  0x1.4e7b5fa51bb3cp-16,  -0x1.f97f1cdda1d64p-23,
        -0x1.bb848ce610034p-9,  0x1.4e7234e25b3fep-16,  -0x1.07e41b98751acp-22, -0x1.88d749ac47bd4p-1,
        0x1.58b0607498cc6p-16,  0x1.15cf5ecb56dfep-21,  -0x1.88d8cd59c46a5p-1,  -0x1.7c03d789a65c7p-13,
        -0x1.36622561948e2p-14, -0x1.88d749b54e645p-1,  0x1.d4faffab0b9dap-2,   -0x1.b672f33b92706p-10,
        0x1.c09fdc6065854p-9,   0x1.1251ed157296bp-10,  -0x1.8f0c866b43ac7p-13, -0x1.d47b026b8704bp-5,
        0x1.2a8a0f3cdb8cp-14,   -0x1.8f0d2d4daaa01p-13, -0x1.be86f1cf88bebp-5,  0x1.247c0c746b234p-14,
        -0x1.bf80e067922f8p-13, -0x1.d47b0127bffa2p-5,  0x1.3a7c11079e193p-8,   0x1.608f613be518fp-8,
        -0x1.885888dcbedc9p-1,  0x1.4443549e1c63p-16,   -0x1.d57d95db25c17p-12, -0x1.34eed7bcc36d9p-1,
        0x1.019b2513a5b9ap-5,   -0x1.3ee6e46497b79p-3,  -0x1.cf836010891d1p-5,  0x1.3907f88d08835p-8};
    Hierarchical<3> m(points, by_hierarchy(2.2, false, 3480), std::size_t{1} << 22);
    REQUIRE(m.status == Status::ok);
    REQUIRE(m.result.hierarchy.cages >= 2);
    const HierarchyQuality q = m.quality();
    CHECK(found(q.encroached) == "");
    CHECK(q.worst <= 2.2);
    bool near = false;
    for (std::uint32_t d = 0; d < m.result.hierarchy.cages; ++d)
        for (std::uint32_t v = 0; v < m.state.vertex_count; ++v) {
            const double r = std::sqrt(distance2<3>(m.store.point(v), m.store.point(m.result.cages[d].centre)));
            near |= m.store.vertex(v).marker == Marker::steiner && r > m.result.cages[d].radius &&
                    r < cage_clearance * m.result.cages[d].radius;
        }
    CHECK(near);
}

TEST_CASE_TEMPLATE_DEFINE("planted violations of hierarchical quality are found", T, planted) {
    constexpr int D = T::value;
    constexpr std::size_t rings = D < 5 ? 12 : D == 5 ? 4 : 3;
    constexpr std::uint32_t at = D < 5 ? 4 : 1;
    constexpr double tau = D < 5 ? 3 : 8;
    Hierarchical<D> m(inputs::geometric(D, 1e3, rings), by_hierarchy(tau), std::size_t{1} << 23);
    REQUIRE(m.result.hierarchy.cages == rings - 1);
    REQUIRE(found(m.quality().encroached) == "");
    Cage& cage = m.result.cages[at];
    const auto said = [&] {
        const CheckResult r = m.quality().encroached;
        return std::string(r.violation == nullptr ? "nothing" : r.violation);
    };
    const std::string no_ball = "a cage's centre is not an input, or its radius not positive";
    SUBCASE("a cage that is too small for its inputs") {
        cage.radius *= 0.9;
        CHECK(m.quality().encroached.violation != nullptr);
        CHECK(m.quality().encroached.cell == cage.centre);
    }
    SUBCASE("a cage without its clearance") {
        cage.radius *= 1e3;
        CHECK(m.quality().encroached.violation != nullptr);
    }
    SUBCASE("a missing cage") {
        cage = m.result.cages[--m.result.hierarchy.cages];
        CHECK((m.quality().worst > tau || m.quality().encroached.violation != nullptr));
    }
    SUBCASE("a centre that is no input, or that is none at all, or not in the mesh") {
        const std::uint32_t centre = cage.centre;
        cage.centre = m.state.vertex_count - 1;
        CHECK(said() == no_ball);
        cage.centre = m.state.vertex_count;
        CHECK(said() == no_ball);
        cage.centre = centre;
        m.store.vertex(centre).cell = none;
        CHECK(said() == no_ball);
    }
    SUBCASE("a radius that is none") {
        for (const double radius : {0.0, -1.0, infinity, std::nan("")}) {
            cage.radius = radius;
            CHECK(said() == no_ball);
            CHECK_FALSE(m.quality().is_hierarchy);
        }
    }
    SUBCASE("cages of the same radius, in both orders") {
        std::uint32_t larger = 0;
        for (std::uint32_t d = 0; d < m.result.hierarchy.cages; ++d)
            if (m.result.cages[d].radius > m.result.cages[larger].radius) larger = d;
        for (std::uint32_t d = 0; d < m.result.hierarchy.cages; ++d)
            m.result.cages[d].radius = m.result.cages[larger].radius;
        CHECK(said() != "nothing");
        std::swap(m.result.cages[0], m.result.cages[m.result.hierarchy.cages - 1]);
        CHECK(said() != "nothing");
    }
    SUBCASE("a cage that sticks out of the one around it") {
        std::uint32_t inner = 0;
        while (m.result.cages[inner].parent == none) ++inner;
        const Cage& around = m.result.cages[m.result.cages[inner].parent];
        // About another input of the domain around.
        for (std::uint32_t v = 0; v < rings + 1; ++v)
            if (v != around.centre && is_inside<D>(m.store, around, m.store.point(v)) &&
                distance2<D>(m.store.point(v), m.store.point(around.centre)) > 0.01 * around.radius * around.radius)
                m.result.cages[inner].centre = v;
        m.result.cages[inner].radius = 0.99 * around.radius;
        CHECK(said() == "a cage sticks out of the one around it");
    }
    SUBCASE("a shell vertex that is said to be an ordinary one") {
        m.store.vertex(cage.shell).marker = Marker::steiner;
        CHECK(said() == "a cage lacks its shell");
    }
    SUBCASE("a shell vertex among the inputs") {
        Vertex<D>& v = m.store.vertex(cage.shell);
        for (int k = 0; k < D; ++k) v.x[k] = 0.5 * (v.x[k] + m.store.point(cage.centre)[k]);
        CHECK(said() == "a cage lacks its shell");
    }
    // Neighbours of the shell from outside, and inputs, put where they must not be.
    const auto put = [&](std::uint32_t v, const Cage& c, double radii) {
        for (int k = 0; k < D; ++k)
            m.store.vertex(v).x[k] = m.store.point(c.centre)[k] + (k == 1 ? radii * c.radius : 0);
    };
    const auto is_centre = [&](std::uint32_t v) {
        return std::any_of(m.result.cages, m.result.cages + m.result.hierarchy.cages,
                           [v](const Cage& c) { return c.centre == v; });
    };
    const auto next_to_shell = [&](const Cage& c) -> std::uint32_t {
        for (std::uint32_t k = 0; k < m.state.cell_slots; ++k) {
            const Cell<D>& cell = m.store.cell(k);
            if (std::count(cell.vertex, cell.vertex + D + 1, c.shell) == 0) continue;
            for (const std::uint32_t v : cell.vertex)
                if (!is_inside<D>(m.store, c, m.store.point(v)) && !is_centre(v)) return v;
        }
        return none;
    };
    SUBCASE("an input that encroaches from inside") {
        // No cage's centre, in the innermost cage that it is in.
        std::uint32_t v = 0, d = none;
        for (; d == none; ++v) {
            REQUIRE(v <= rings);
            if (is_centre(v)) continue;
            for (std::uint32_t e = 0; e < m.result.hierarchy.cages; ++e)
                if (is_inside<D>(m.store, m.result.cages[e], m.store.point(v)) &&
                    (d == none || m.result.cages[e].radius < m.result.cages[d].radius))
                    d = e;
        }
        --v;
        put(v, m.result.cages[d], 0.7);
        CHECK(said() == "an input encroaches on a cage from inside");
        CHECK(is_centre(m.quality().encroached.cell));
    }
    SUBCASE("any vertex of the domain around that encroaches from outside") {
        std::uint32_t outermost = 0, deeper = 0;
        while (m.result.cages[outermost].parent != none) ++outermost;
        while (m.result.cages[deeper].parent == none) ++deeper;
        for (const std::uint32_t d : {outermost, deeper})
            for (const Marker marker : {Marker::input, Marker::steiner}) {
                const std::uint32_t v = next_to_shell(m.result.cages[d]);
                REQUIRE(v != none);
                const Vertex<D> kept = m.store.vertex(v);
                m.store.vertex(v).marker = marker;
                put(v, m.result.cages[d], 2);
                const std::uint32_t around = m.result.cages[d].parent;
                if (kept.marker == Marker::exempt && around != none &&
                    is_inside<D>(m.store, m.result.cages[around], kept.x))
                    CHECK(said() == "a cage lacks its shell");
                else  // an input may also be too far from the centre around
                    CHECK((said() == "a vertex encroaches on a cage from outside" ||
                           (marker == Marker::input && said() == "an input encroaches on a cage from inside")));
                m.store.vertex(v) = kept;
            }
        CHECK(said() == "nothing");
    }
}
TEST_CASE_TEMPLATE_APPLY(planted, Dimensions<>);

TEST_CASE("parents and nearest distances of cages are those that the mesh implies") {
    Hierarchical<2> m(inputs::nested(2, 6, 8, 1e3), by_hierarchy(3));
    REQUIRE(m.result.hierarchy.cages >= 5);
    std::vector<Cage> made(m.result.cages, m.result.cages + m.result.hierarchy.cages);
    m.quality();
    for (std::uint32_t d = 0; d < m.result.hierarchy.cages; ++d) {
        CHECK(m.result.cages[d].parent == made[d].parent);
        CHECK(m.result.cages[d].nearest2 == doctest::Approx(made[d].nearest2).epsilon(1e-9));
    }
}

// Clusters of clusters at some of many points: cages in cages are left where others were released.
TEST_CASE("parents of cages are those that the mesh implies where cages were released") {
    int released = 0, nested = 0;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        inputs::Points points = inputs::uniform(2, 500, seed);
        const inputs::Points around = inputs::nested(2, 3, 4, 50);
        inputs::Random random(seed);
        for (int c = 0; c < 20; ++c) {
            const std::size_t at = 2 * random.below(500);
            for (std::size_t i = 0; i < around.size(); ++i)
                points.push_back(points[at + i % 2] + 2e-5 * around[i] + 1e-9);
        }
        Hierarchical<2> m(points, by_hierarchy(2.5, false, seed));
        REQUIRE(m.status == Status::ok);
        const std::vector<Cage> made(m.result.cages, m.result.cages + m.result.hierarchy.cages);
        CHECK(found(m.quality().encroached) == "");
        for (std::size_t d = 0; d < made.size(); ++d) {
            CHECK(m.result.cages[d].parent == made[d].parent);
            nested += made[d].parent != none;
        }
        released += static_cast<int>(m.result.hierarchy.cages_released);
    }
    CHECK(released > 0);
    CHECK(nested > 50);
}

// A ball about the centre of which half of the way to the nearest vertex outside, measured from the nearest vertex of
// the shell, is the radius: no vertex outside can have a cell that reaches into it along that way.
TEST_CASE_TEMPLATE_DEFINE("in-radii of cages are no more than the mesh shows", T, in_radii) {
    constexpr int D = T::value;
    Hierarchical<D> m(inputs::nested(D, 3, 5, 1e3), by_hierarchy(3));
    REQUIRE(m.status == Status::ok);
    REQUIRE(m.result.hierarchy.cages > 1);
    for (std::uint32_t d = 0; d < m.result.hierarchy.cages; ++d) {
        const Cage& cage = m.result.cages[d];
        double outside = infinity, shell = infinity;
        int of_shell = 0;
        for (std::uint32_t v = 0; v < m.state.vertex_count; ++v) {
            const double away = distance<D>(m.store.point(v), m.store.point(cage.centre));
            if (!(away < cage.radius)) outside = std::min(outside, away);
            if (!(away < cage.radius) || !(away > cage_epsilon * cage.radius) ||
                m.store.vertex(v).marker != Marker::exempt)
                continue;
            shell = std::min(shell, away);
            ++of_shell;
        }
        CHECK(of_shell == static_cast<int>(shell_size_of(D)));
        CHECK(in_radius(cage) <= 0.5 * (outside + shell) * (1 + 1e-12));
        CHECK(in_radius(cage) >= 0.5 * (outside + 0.8 * cage.radius));
    }
}
TEST_CASE_TEMPLATE_APPLY(in_radii, Dimensions<2, 3>);

TEST_CASE("any arena size leaves a Delaunay mesh of what was inserted") {
    const inputs::Points points = inputs::nested(2, 4, 8, 1e3);
    std::uint32_t partial = 0, whole = 0;
    for (std::size_t bytes = 0; bytes < 60000; bytes += 208) {
        Hierarchical<2> m(points, by_hierarchy(2.5, bytes % 416 == 0), bytes);
        REQUIRE((m.status == Status::ok || m.status == Status::out_of_memory));
        if (m.state.cell_slots == 0) continue;
        CHECK(delaunay_violation<2>(m.store) == "");
        ++(m.status == Status::ok ? whole : partial);
    }
    CHECK(partial > 20);
    CHECK(whole > 20);
}

TEST_CASE("rings are searched as by brute force") {
    const inputs::Points points = inputs::clusters(3, 500);
    Block block(std::size_t{1} << 20);
    StoreState state = {};
    Store<3> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    std::uint32_t* order;
    REQUIRE(take_input<3>(store, points.data(), 500, 1, monitor, &input, &order) == Status::ok);
    InputTree<3> tree;
    REQUIRE(tree.build(store, block.arena, 500, true) == Status::ok);
    inputs::Random random(5);
    int found = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const double* const x = store.point(static_cast<std::uint32_t>(random.below(500)));
        const double inner = std::ldexp(random.uniform(), -static_cast<int>(random.below(20))), outer = 3 * inner;
        double best = -1, d2;
        for (std::uint32_t v = 0; v < 500; ++v) {
            const double d = distance2<3>(x, store.point(v));
            if (d > inner * inner && d <= outer * outer) best = std::max(best, d);
        }
        const std::uint32_t v = tree.farthest_in_ring(x, inner, outer, &d2);
        CHECK((v == none) == (best < 0));
        if (v == none) continue;
        CHECK(d2 == best);
        CHECK(distance2<3>(x, store.point(v)) == best);
        ++found;
    }
    CHECK(found > 100);
}
