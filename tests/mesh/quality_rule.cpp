// Sparse Voronoi Refinement and the reference, VoronoiRefine.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "common/dimensions.hpp"
#include "common/hierarchical.hpp"
#include "mesh/check/check_domain.hpp"
#include "mesh/check/quality.hpp"
#include "mesh/input_tree.hpp"
#include "numerics/vector.hpp"

using namespace netmesh;

namespace {

constexpr std::size_t large = std::size_t{1} << 27;

// The worst clipped aspect ratio, from vertices and cells alone.
template <int D> double worst_of(Meshed<D>& m) {
    double ratio;
    std::uint32_t v;
    REQUIRE(worst_aspect_ratio(m.store, m.result.domain, m.block.arena, &ratio, &v) == Status::ok);
    return ratio;
}

inputs::Points grid(int dim, int side) {
    inputs::Points points;
    int n = 1;
    for (int k = 0; k < dim; ++k) n *= side;
    for (int i = 0; i < n; ++i)
        for (int k = 0, j = i; k < dim; ++k, j /= side) points.push_back(j % side);
    return points;
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("meshes are Delaunay, of quality tau, and hold their inputs bit for bit", T, quality) {
    constexpr int D = T::value;
    constexpr std::size_t sizes[] = {0, 0, 500, 200, 40, 12, 5};
    constexpr double taus[] = {0, 0, 2.2, 2.5, 3.08, 4, 4};
    for (const inputs::Points& points :
         {inputs::uniform(D, sizes[D]), inputs::clusters(D, sizes[D] / 2), grid(D, D < 4 ? 5 : 2)}) {
        Meshed<D> m(points, by_quality(taus[D]), large);
        REQUIRE(m.status == Status::ok);
        CHECK(delaunay_violation<D>(m.store) == "");
        const double worst = worst_of(m);
        if (points.size() > 6 * D) CHECK(worst > 1);  // two points have no Voronoi edge that meets the domain
        CHECK(worst <= taus[D]);
        for (std::size_t i = 0; i < points.size(); ++i)
            REQUIRE(m.store.vertex(static_cast<std::uint32_t>(i / D)).x[i % D] == points[i]);
        // nearest2 and origin against brute force
        const std::uint32_t inputs = static_cast<std::uint32_t>(points.size() / D);
        for (std::uint32_t v = 0; v < m.state.vertex_count; v += 7) {
            double nearest2 = infinity, input2 = infinity;
            for (std::uint32_t w = 0; w < m.state.vertex_count; ++w) {
                double d2 = 0;
                for (int k = 0; k < D; ++k) d2 += std::pow(m.store.point(v)[k] - m.store.point(w)[k], 2);
                if (w != v) nearest2 = std::min(nearest2, d2);
                if (w < inputs) input2 = std::min(input2, d2);
            }
            CHECK(m.store.vertex(v).nearest2 == doctest::Approx(nearest2).epsilon(1e-12));
            if (v < inputs) continue;
            double origin2 = 0;
            for (int k = 0; k < D; ++k)
                origin2 += std::pow(m.store.point(v)[k] - m.store.point(m.store.vertex(v).origin)[k], 2);
            CHECK(origin2 == doctest::Approx(input2).epsilon(1e-12));
        }
    }
}
TEST_CASE_TEMPLATE_APPLY(quality, Dimensions<>);

// While an input waits until it is medial cells are held to less; those that it left behind are looked at in the end.
TEST_CASE_TEMPLATE_DEFINE("inputs at all scales wait for each other, and in the end all cells are of quality tau", T,
                          waited) {
    constexpr int D = T::value;
    for (std::uint64_t seed = 1; seed <= (D == 2 ? 8 : 3); ++seed) {
        CAPTURE(seed);
        Meshed<D> m(inputs::geometric(D, D == 2 ? 100 : 30, D == 2 ? 5 : 4, seed), by_quality(4, 1, false, seed),
                    std::size_t{1} << 23);
        REQUIRE(m.status == Status::ok);
        CHECK(worst_of(m) <= 4);
    }
}
TEST_CASE_TEMPLATE_APPLY(waited, Dimensions<2, 3>);

TEST_CASE_TEMPLATE_DEFINE("the reference keeps all corners in the domain of 3.5 and covers its sphere", T, reference) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::uniform(D, D == 2 ? 100 : 20);
    for (const double spacing : {1.0, D == 2 ? 1.0 / 64 : 0.1, 0.35, 4.0}) {
        CAPTURE(spacing);
        MeshRequest request = by_reference(3);
        request.net_spacing = spacing;
        Meshed<D> m(points, request, std::size_t{1} << 25);
        REQUIRE(m.status == Status::ok);
        const Store<D>& store = m.store;
        const Domain<D>& domain = m.result.domain;
        CHECK(delaunay_violation<D>(store) == "");
        const double width = 2 * domain.enclosing_radius, delta = spacing * width;
        CHECK(domain.radius >= ((6 * std::sqrt(2) + 1) * delta + width / 2) * (1 - 1e-9));
        if (spacing == 1) CHECK(domain.radius == doctest::Approx((6 * std::sqrt(2) + 2) * delta).epsilon(1e-14));
        int outside = 0;
        for (std::uint32_t c = 0; c < m.state.cell_slots; ++c) outside += !domain.contains(store.cell(c).centre);
        CHECK(outside == 0);
        std::vector<const double*> net;
        for (std::uint32_t v = 0; v < m.state.vertex_count; ++v)
            if (store.vertex(v).marker == Marker::exempt) net.push_back(store.point(v));
        inputs::Random random(3);
        for (int sample = 0; sample < 2000; ++sample) {
            double x[D], length2 = 0;
            for (double& c : x) {
                c = 2 * random.uniform() - 1;
                length2 += c * c;
            }
            for (int k = 0; k < D; ++k) x[k] = domain.centre[k] + domain.radius / std::sqrt(length2) * x[k];
            double nearest2 = infinity;
            for (const double* p : net) nearest2 = std::min(nearest2, distance2<D>(x, p));
            CHECK(nearest2 <= delta * delta * (1 + 1e-9));
        }
        for (std::size_t i = 0; i < net.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) REQUIRE(distance2<D>(net[i], net[j]) >= delta * delta * (1 - 1e-9));
            for (std::uint32_t p = 0; p < points.size() / D; ++p)
                REQUIRE(distance2<D>(net[i], store.point(p)) >= width * width * (1 - 1e-9));
        }
        CHECK(worst_of(m) <= 3);
        // The checker knows the spacing, and no other one or smaller domain passes.
        Domain<D> smaller = domain;
        smaller.radius *= 0.9;
        const auto passes = [&](const Domain<D>& ball, double tau, double s) {
            return check_domain(store, ball, nullptr, true, {tau, s}).violation == nullptr;
        };
        CHECK(passes(domain, 3, spacing));
        CHECK(!passes(domain, 3, spacing / 2));
        CHECK(!passes(domain, 3, 2 * spacing));
        CHECK(!passes(smaller, 3, spacing));
        if (spacing > 0.1) CHECK(!passes(domain, 2.7, spacing));
    }
}
TEST_CASE_TEMPLATE_APPLY(reference, Dimensions<2, 3>);

TEST_CASE("a boundary net that coordinates on its sphere do not resolve is refused at once") {
    const auto made = [](double tau, double spacing, double far, double scale) {
        inputs::Points points = {0, 0, 1, 0, 0, 1};
        for (double& x : points) x = scale * (far + x);
        MeshRequest request = by_reference(tau);
        request.net_spacing = spacing;
        return Meshed<2>(points, request, std::size_t{1} << 20).status;
    };
    CHECK(made(2.000000000000001, 1, 0, 1) == Status::invalid_argument);
    CHECK(made(3, 1.0 / 64, 1e13, 1) == Status::invalid_argument);
    CHECK(made(3, 1.0 / 64, 1e9, 1) == Status::ok);
    CHECK(made(3, 1, 0, 1e150) == Status::ok);
    CHECK(made(2.001, 8, 0, 1e150) == Status::invalid_argument);
    // Just resolved: the checker heeds how far off the net's places are.
    for (const double far : {1e8, 1e9}) {
        MeshRequest request = by_reference(2.01);
        request.net_spacing = 1.0 / 64;
        Meshed<2> m({far, far, far + 1, far, far, far + 1}, request, std::size_t{1} << 22);
        REQUIRE(m.status == Status::ok);
        const CheckResult found = check_domain(m.store, m.result.domain, nullptr, true, {2.01, 1.0 / 64});
        CHECK(found.violation == nullptr);
    }
}

TEST_CASE("a mesh without a boundary net is none with a spacing") {
    Meshed<2> m(inputs::uniform(2, 30), by_quality(3));
    REQUIRE(m.status == Status::ok);
    CHECK(check_domain(m.store, m.result.domain, nullptr, true, {3, 0}).violation == nullptr);
    CHECK(check_domain(m.store, m.result.domain, nullptr, true, {3, 1}).violation != nullptr);
}

TEST_CASE("the domain and net of points close together and far from the origin are those that the checker wants") {
    // A unit in the last place of the coordinates is a part of 1e-5 of the domain's radius.
    inputs::Points points = inputs::uniform(2, 18);
    for (double& x : points) x = 0.53 + 1e-12 * x;
    Meshed<2> m(points, by_reference(3.98));
    REQUIRE(m.status == Status::ok);
    const NetPromise promise = {3.98, 1};
    CHECK(check_domain(m.store, m.result.domain, nullptr, true, promise).violation == nullptr);
    std::uint32_t net = 0;
    while (m.store.vertex(net).marker != Marker::exempt) ++net;
    double* const x = m.store.vertex(net).x;
    for (int k = 0; k < 2; ++k) x[k] += 0.01 * (x[k] - m.result.domain.centre[k]);
    CHECK(check_domain(m.store, m.result.domain, nullptr, true, promise).violation != nullptr);
}

TEST_CASE_TEMPLATE_DEFINE("the reference in arenas of any size, in 4D up to one that it fits", T, reference_arenas) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::uniform(D, 3);
    std::uint32_t partial = 0, whole = 0;
    for (double bytes = 1000; whole == 0 && (D == 4 || bytes < 1e6); bytes *= 1.2) {
        // A tau that asks for nothing but the net.
        Meshed<D> m(points, by_reference(1e6), static_cast<std::size_t>(bytes));
        const Status status = m.status;
        const Store<D>& store = m.store;
        const Domain<D>& domain = m.result.domain;
        REQUIRE((status == Status::ok || status == Status::out_of_memory));
        if (m.state.cell_slots == 0) continue;
        if (bytes < 1e5 || status == Status::ok) CHECK(delaunay_violation<D>(store) == "");
        ++(status == Status::ok ? whole : partial);
        if (status != Status::ok) continue;
        int outside = 0;
        for (std::uint32_t c = 0; c < m.state.cell_slots; ++c) outside += !domain.contains(store.cell(c).centre);
        CHECK(outside == 0);
        for (std::uint32_t v = 0; v < 3; ++v) CHECK(store.vertex(v).cell != none);
    }
    CHECK(partial > 5);
}
TEST_CASE_TEMPLATE_APPLY(reference_arenas, Dimensions<4, 6>);

TEST_CASE("clipped cells sampled at random keep the bound") {
    const inputs::Points points = inputs::uniform(2, 100, 9);
    Meshed<2> m(points, by_quality(2.2), large);
    REQUIRE(m.status == Status::ok);
    inputs::Random random(3);
    std::vector<double> reach(m.state.vertex_count, 0);
    for (int sample = 0; sample < 200000; ++sample) {
        double x[2];
        do
            for (int k = 0; k < 2; ++k)
                x[k] = m.result.domain.centre[k] + m.result.domain.radius * (2 * random.uniform() - 1);
        while (!m.result.domain.contains(x));
        std::uint32_t nearest = 0;
        double best = infinity;
        for (std::uint32_t v = 0; v < m.state.vertex_count; ++v) {
            const double d = std::hypot(x[0] - m.store.point(v)[0], x[1] - m.store.point(v)[1]);
            if (d < best) {
                best = d;
                nearest = v;
            }
        }
        reach[nearest] = std::max(reach[nearest], best);
    }
    for (std::uint32_t v = 0; v < m.state.vertex_count; ++v)
        if (m.store.vertex(v).marker != Marker::exempt)
            CHECK(2 * reach[v] <= 2.2 * std::sqrt(m.store.vertex(v).nearest2));
}

TEST_CASE("flat inputs, a pair and a single point are meshed") {
    for (const inputs::Points& points : {inputs::Points{3, -1, 2}, inputs::Points{0, 0, 0, 1, 1, 1},
                                         inputs::Points{0, 0, 0, 1, 0, 0, 5, 0, 0, 5.5, 0, 0}}) {
        Meshed<3> m(points, by_quality(3), large);
        REQUIRE(m.status == Status::ok);
        CHECK(delaunay_violation<3>(m.store) == "");
        CHECK(worst_of(m) <= 3);
    }
}

TEST_CASE("points below the resolution and outside the range are refused by row") {
    inputs::Points points = inputs::uniform(2, 50);
    SUBCASE("one unit in the last place apart") {
        points[20] = points[60];
        points[21] = std::nextafter(points[61], 2);
        Meshed<2> m(points, by_quality(3), large);
        CHECK(m.status == Status::too_close);
        CHECK(m.result.input.row_a == 10);
        CHECK(m.result.input.row_b == 30);
    }
    SUBCASE("too large") {
        points[33] = 0x1p501;
        Meshed<2> m(points, by_quality(3), large);
        CHECK(m.status == Status::out_of_range);
        CHECK(m.result.input.row_a == 16);
    }
    SUBCASE("too near each other at the origin") {
        points = {0, 0, 1, 1, 0, 0x1p-510};
        Meshed<2> m(points, by_quality(3), large);
        CHECK(m.status == Status::out_of_range);
    }
}

TEST_CASE("any arena size leaves a Delaunay mesh of what was inserted") {
    const inputs::Points points = inputs::uniform(2, 40);
    std::uint32_t partial = 0, whole = 0;
    for (std::size_t bytes = 0; bytes < 90000; bytes += 208) {
        Meshed<2> m(points, by_quality(2.5, 1, true), bytes);
        REQUIRE((m.status == Status::ok || m.status == Status::out_of_memory));
        if (m.state.cell_slots == 0) continue;
        CHECK(delaunay_violation<2>(m.store) == "");
        ++(m.status == Status::ok ? whole : partial);
    }
    CHECK(partial > 20);
    CHECK(whole > 20);
}

TEST_CASE_TEMPLATE_DEFINE("smallest enclosing balls", T, enclosing_balls) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::uniform(D, 300, 4);
    Meshed<D> m(points, by_quality(6), large);
    REQUIRE(m.status == Status::ok);
    // Contains all, and no smaller ball does: the centre is in the convex hull of the points on its boundary, so that
    // moving it in any direction leaves one of them farther away.
    double far2 = 0;
    for (std::uint32_t v = 0; v < 300; ++v) far2 = std::max(far2, m.result.domain.distance2(m.store.point(v)));
    CHECK(std::sqrt(far2) <= m.result.domain.enclosing_radius);
    CHECK(std::sqrt(far2) >= m.result.domain.enclosing_radius * (1 - 1e-12));
    inputs::Random random(1);
    for (int trial = 0; trial < 200; ++trial) {
        double moved[D], shifted2 = 0;
        for (int k = 0; k < D; ++k) moved[k] = m.result.domain.centre[k] + 1e-3 * (random.uniform() - 0.5);
        for (std::uint32_t v = 0; v < 300; ++v) {
            double d2 = 0;
            for (int k = 0; k < D; ++k) d2 += std::pow(moved[k] - m.store.point(v)[k], 2);
            shifted2 = std::max(shifted2, d2);
        }
        CHECK(shifted2 >= far2 * (1 - 1e-9));
    }
}
TEST_CASE_TEMPLATE_APPLY(enclosing_balls, Dimensions<2, 3>);
