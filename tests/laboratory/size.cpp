#include "laboratory/size.hpp"

#include <doctest/doctest.h>

#include "common/dimensions.hpp"
#include "laboratory/common.hpp"
#include "laboratory/pacing.hpp"
#include "mesh/loop/split.hpp"
#include "numerics/elementary.hpp"

using namespace netmesh;

namespace {

// theta_i by looking at all pairs.
std::vector<double> thetas_by_scan(const inputs::Points& points, int dim, const std::vector<std::uint32_t>& order) {
    std::vector<double> theta;
    inputs::Points before;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const double* const x = &points[order[i] * static_cast<std::size_t>(dim)];
        double first = HUGE_VAL, second = HUGE_VAL;
        for (std::size_t j = 0; j < i; ++j) {
            const double d = distance(&points[order[j] * static_cast<std::size_t>(dim)], x, dim);
            second = std::min(second, std::max(first, d));
            first = std::min(first, d);
        }
        theta.push_back(i < 2 ? 1 : first / second);
    }
    return theta;
}

template <int D> struct Ordered {
    explicit Ordered(const inputs::Points& points) {
        REQUIRE(held.mesh(points, 6) == Status::ok);
        REQUIRE(tree.build(held.store, held.block.arena, held.inputs()) == Status::ok);
        order.resize(held.inputs());
        theta.resize(held.inputs());
    }
    Held<D> held;
    InputTree<D> tree;
    std::vector<std::uint32_t> order;
    std::vector<double> theta;
};

template <int D>
SizeAnalysis analyse(Held<D>& held, double tau, const SizeRule& rule = {}, double tolerance = infinity) {
    SizeAnalysis a;
    REQUIRE(analyse_size(held.store, held.domain, held.inputs(), {tau, rule, tolerance, 1u << 20},
                         {held.block.arena, held.monitor}, &a) == Status::ok);
    return a;
}

}  // namespace

TEST_CASE("logarithm and arcsine agree with the system's") {
    inputs::Random random(11);
    for (int i = 0; i < 20000; ++i) {
        const double x = std::ldexp(0.5 + random.uniform(), static_cast<int>(random.below(2090)) - 1070);
        CHECK(logarithm(x) == doctest::Approx(std::log(x)).epsilon(1e-15));
        const double y = 0.5 * random.uniform();
        CHECK(arcsine(y) == doctest::Approx(std::asin(y)).epsilon(1e-15));
    }
    CHECK(logarithm(1) == 0);
    CHECK(logarithm(std::numeric_limits<double>::denorm_min()) == doctest::Approx(std::log(std::ldexp(1.0, -1074))));
}

TEST_CASE_TEMPLATE_DEFINE("paces of an ordering and the farthest-first ordering against all pairs", T, paces) {
    constexpr int D = T::value;
    for (const inputs::Points& points :
         {inputs::uniform(D, 150), inputs::clusters(D, 120), inputs::zoom(D, 60, 1), inputs::grid(D, D == 2 ? 9 : 4)}) {
        Ordered<D> o(points);
        const std::uint32_t n = o.held.inputs();
        for (std::uint32_t i = 0; i < n; ++i) o.order[i] = (i * 7 + 3) % n;
        if (n % 7 != 0) {
            REQUIRE(pace(o.held.store, o.tree, o.order.data(), n, {o.held.block.arena, o.held.monitor},
                         o.theta.data()) == Status::ok);
            const std::vector<double> expected = thetas_by_scan(points, D, o.order);
            for (std::uint32_t i = 0; i < n; ++i) CHECK(o.theta[i] == doctest::Approx(expected[i]).epsilon(1e-14));
        }
        REQUIRE(farthest_first_order(o.held.store, o.tree, n, {o.held.block.arena, o.held.monitor}, o.order.data()) ==
                Status::ok);
        // Each point is one of those farthest from all before it.
        std::vector<double> near(n, HUGE_VAL);
        for (std::uint32_t i = 0; i < n; ++i) {
            const double most = *std::max_element(near.begin(), near.end());
            if (i > 0) CHECK(near[o.order[i]] == most);
            for (std::uint32_t v = 0; v < n; ++v)
                near[v] = std::min(near[v], distance(o.held.store.point(v), o.held.store.point(o.order[i]), D));
            near[o.order[i]] = -1;
        }
        std::vector<std::uint32_t> sorted = o.order;
        std::sort(sorted.begin(), sorted.end());
        for (std::uint32_t i = 0; i < n; ++i) REQUIRE(sorted[i] == i);
    }
}
TEST_CASE_TEMPLATE_APPLY(paces, Dimensions<2, 4>);

TEST_CASE("no ordering of a few points that begins with a diameter beats the limit") {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        inputs::Random random(seed);
        inputs::Points points;  // pairs and triples at several scales
        for (int i = 0; i < 7; ++i)
            for (int k = 0; k < 2; ++k)
                points.push_back((i % 3) * (k + 1) + std::ldexp(random.uniform(), -static_cast<int>(random.below(12))));
        Ordered<2> o(points);
        const SizeAnalysis a = analyse<2>(o.held, 6);
        double diameter = 0;
        std::vector<std::uint32_t> order = {0, 1, 2, 3, 4, 5, 6};
        for (std::uint32_t i : order)
            for (std::uint32_t j : order) diameter = std::max(diameter, distance(&points[2 * i], &points[2 * j], 2));
        double best = 0;
        do {
            if (distance(&points[2 * order[0]], &points[2 * order[1]], 2) < diameter) continue;
            const std::vector<double> theta = thetas_by_scan(points, 2, order);
            best = std::max(best, *std::min_element(theta.begin(), theta.end()));
        } while (std::next_permutation(order.begin(), order.end()));
        CHECK(best <= a.theta_limit);
        CHECK(a.theta <= 1);
        CHECK(a.theta > 0);
    }
}

TEST_CASE("the feature size integral against a fine grid, and its bounds against each other") {
    const inputs::Points points = inputs::uniform(2, 12, 5);
    Ordered<2> o(points);
    const double radius[] = {o.held.domain.radius, 1.3 * o.held.domain.radius, 4 * o.held.domain.radius};
    FeatureIntegral coarse, fine;
    REQUIRE(feature_integral(o.held.store, o.tree, {o.held.domain.centre, radius, 3, infinity, 0},
                             {o.held.block.arena, o.held.monitor}, &coarse) == Status::ok);
    REQUIRE(feature_integral(o.held.store, o.tree, {o.held.domain.centre, radius, 3, 0.05, 1u << 22},
                             {o.held.block.arena, o.held.monitor}, &fine) == Status::ok);
    CHECK(fine.boxes > coarse.boxes);
    double sum[3] = {};
    const int side = 1200;
    const double step = 2 * radius[2] / side;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const double x[2] = {o.held.domain.centre[0] + (i + 0.5 - side / 2) * step,
                                 o.held.domain.centre[1] + (j + 0.5 - side / 2) * step};
            const double f = second_nearest(points, 2, x), d = distance(x, o.held.domain.centre, 2);
            for (int k = 0; k < 3; ++k)
                if (d < radius[k]) sum[k] += step * step / (f * f);
        }
    for (int k = 0; k < 3; ++k) {
        INFO("ball " << k);
        CHECK(coarse.lower[k] < fine.lower[k]);
        CHECK(fine.lower[k] < sum[k]);
        CHECK(sum[k] < fine.upper[k]);
        CHECK(fine.upper[k] < coarse.upper[k]);
        CHECK(fine.upper[k] / fine.lower[k] < 1.08);
    }
}

TEST_CASE("two points: the integral of 3.8.3") {
    // Within |x - p| <= c |p - q| it is at most V_D (1 + D ln 2c).
    Ordered<3> o({0, 0, 0, 1, 0, 0});
    const double centre[3] = {0, 0, 0}, radius[] = {1, 4, 16};
    FeatureIntegral integral;
    REQUIRE(feature_integral(o.held.store, o.tree, {centre, radius, 3, 0.3, 1u << 20},
                             {o.held.block.arena, o.held.monitor}, &integral) == Status::ok);
    for (int k = 0; k < 3; ++k) {
        CHECK(integral.lower[k] < unit_ball_volume(3) * (1 + 3 * std::log(2 * radius[k])));
        // Far away f_P is about the distance: a factor of four in the radius adds 3 V ln 4.
        if (k > 1) CHECK(integral.upper[k] - integral.lower[k - 1] > unit_ball_volume(3) * 3 * std::log(4) * 0.8);
    }
}

TEST_CASE("integrals over balls of which few boxes have a part inside") {
    // Two points a from the origin, f_P(x, y)^2 = x^2 + (|y| + a)^2: the boxes about the origin have sides 1, or 4 when
    // the points are far. Balls end before the centres of four boxes, behind them, or lie inside of one box.
    for (const double a : {2.85, 100.0}) {
        Ordered<2> o({0, -a, 0, a});
        const double centre[2] = {0, 0};
        for (const double radius : {0.3, 0.5, 0.7, 0.708, 1.0}) {
            FeatureIntegral integral;
            REQUIRE(feature_integral(o.held.store, o.tree, {centre, &radius, 1, infinity, 0},
                                     {o.held.block.arena, o.held.monitor}, &integral) == Status::ok);
            double sum = 0;
            const int side = 400;
            const double step = 2 * radius / side;
            for (int i = 0; i < side; ++i)
                for (int j = 0; j < side; ++j) {
                    const double x = (i + 0.5 - side / 2) * step, y = (j + 0.5 - side / 2) * step;
                    const double up = std::fabs(y) + a;
                    if (x * x + y * y < radius * radius) sum += step * step / (x * x + up * up);
                }
            INFO("radius " << radius << ", points " << a << " away");
            CHECK(integral.lower[0] < sum * 1.001);
            CHECK(sum * 0.999 < integral.upper[0]);
        }
    }
}

TEST_CASE("two points in a ball of a million of their distances") {
    // r^2 + 1/4 <= f_P^2 <= (r + 1/2)^2 at r from the middle of points 1 apart. What balls' boundaries add is little.
    Ordered<2> o({-0.5, 0, 0.5, 0});
    const double centre[2] = {0, 0}, radius = 0x1p20, pi = 3.14159265358979324;
    FeatureIntegral integral;
    REQUIRE(feature_integral(o.held.store, o.tree, {centre, &radius, 1, infinity, 0},
                             {o.held.block.arena, o.held.monitor}, &integral) == Status::ok);
    const double most = pi * std::log1p(4 * radius * radius);      // of 2 pi r / (r^2 + 1/4)
    const double least = 2 * pi * (std::log(2 * radius + 1) - 1);  // of 2 pi r / (r + 1/2)^2, up to 1 / radius
    CHECK(integral.lower[0] < most);
    CHECK(integral.upper[0] > least);
}

TEST_CASE_TEMPLATE_DEFINE("bounds of chapter 3 hold on every mesh", T, bounds) {
    constexpr int D = T::value;
    constexpr std::size_t sizes = by_dimension<std::size_t>(D, {400, 100, 30, 12, 4});
    constexpr double taus = by_dimension<double>(D, {2.5, 2.5, 3.08, 4, 4});
    for (const inputs::Points& points : {inputs::uniform(D, sizes), inputs::clusters(D, sizes / 2),
                                         inputs::zoom(D,
                                                      D < 4    ? 40
                                                      : D == 6 ? 4
                                                               : 8,
                                                      1),
                                         inputs::grid(D, D < 4 ? 5 : 2), inputs::Points(inputs::uniform(D, 2))}) {
        Held<D> held;
        REQUIRE(held.mesh(points, taus) == Status::ok);
        const SizeAnalysis a = analyse<D>(held, taus);
        CHECK(violated_size_bound(a) == nullptr);
        CHECK(a.size_lower > 0);
        CHECK(a.size_lower < static_cast<double>(a.size));
        CHECK(static_cast<double>(a.size) < a.size_upper);
        CHECK(a.feature_ratio >= 1);
        CHECK(a.feature_ratio <= a.feature_ratio_bound);
        CHECK(a.feature_ratio_bound < 30);
    }
}
TEST_CASE_TEMPLATE_APPLY(bounds, Dimensions<>);

TEST_CASE("the pace of inputs at geometric distances shows in the integral from below, too") {
    inputs::Points points;
    for (int i = 0; i < 12; ++i) {
        points.push_back(std::ldexp(1.0, -16 * i));
        points.push_back(std::ldexp(0.3, -16 * i));
    }
    Held<2> held;
    REQUIRE(held.mesh(points, 2.5) == Status::ok);
    const SizeAnalysis a = analyse<2>(held, 2.5, {}, 0.2);
    CHECK(violated_size_bound(a) == nullptr);
    CHECK(a.theta == doctest::Approx(std::ldexp(1.0, -16)).epsilon(0.01));
    CHECK(a.pace_lower > 10 * unit_ball_volume(2));
    CHECK(a.pace_lower < a.integral.lower[ball_wide]);
    CHECK(a.integral.upper[ball_wide] < a.pace_upper);
}

TEST_CASE("an over-refined mesh keeps the feature size bound of its sizing function only") {
    Held<2> held;
    SizeRule rule;
    rule.eps = 0.02;
    REQUIRE(held.mesh(inputs::uniform(2, 30), 2.5, rule) == Status::ok);
    CHECK(violated_size_bound(analyse<2>(held, 2.5, rule)) == nullptr);
    CHECK(violated_size_bound(analyse<2>(held, 2.5)) != nullptr);
}

TEST_CASE("one point has no feature size and no bounds") {
    Held<3> held;
    REQUIRE(held.mesh({1, 2, 3}, 3) == Status::ok);
    const SizeAnalysis a = analyse<3>(held, 3);
    CHECK(a.size == 1);
    CHECK(a.size_lower == 0);
    CHECK(a.size_upper == infinity);
    CHECK(violated_size_bound(a) == nullptr);
}

TEST_CASE("figures that break a bound are found out") {
    Held<2> held;
    REQUIRE(held.mesh(inputs::uniform(2, 60), 2.5) == Status::ok);
    const SizeAnalysis good = analyse<2>(held, 2.5);
    REQUIRE(violated_size_bound(good) == nullptr);
    SizeAnalysis a = good;
    a.size = 1;
    CHECK(violated_size_bound(a) != nullptr);
    a = good;
    a.size = static_cast<std::uint64_t>(good.size_upper) + 1;
    CHECK(violated_size_bound(a) != nullptr);
    a = good;
    a.feature_ratio = 29;
    CHECK(violated_size_bound(a) != nullptr);
    a = good;
    a.pace_lower = 2 * good.integral.upper[ball_wide];
    CHECK(violated_size_bound(a) != nullptr);
    a = good;
    a.pace_upper = 0.5 * good.integral.lower[ball_wide];
    CHECK(violated_size_bound(a) != nullptr);
}

TEST_CASE_TEMPLATE_DEFINE("bounds on sizes are those of 3.4.1 and 3.4.2, with all in-balls", T, size_bounds) {
    constexpr int D = T::value;
    const double pi = 3.14159265358979324, volume = D == 2 ? pi : 4 * pi / 3, tau = 2.5;
    for (const inputs::Points& points : {inputs::uniform(D, 30), inputs::clusters(D, 20)}) {
        Held<D> held;
        REQUIRE(held.mesh(points, tau) == Status::ok);
        const SizeAnalysis a = analyse<D>(held, tau);
        double ratio = 0, reach = held.domain.radius;
        for (std::uint32_t v = 0; v < held.state.vertex_count; ++v) {
            if (held.store.vertex(v).marker == Marker::exempt) continue;
            double nearest = HUGE_VAL;
            for (std::uint32_t w = 0; w < held.state.vertex_count; ++w)
                if (w != v) nearest = std::min(nearest, distance(held.store.point(v), held.store.point(w), D));
            ratio = std::max(ratio, second_nearest(points, D, held.store.point(v)) / nearest);
            reach = std::max(reach, distance(held.store.point(v), held.domain.centre, D) + nearest / 2);
        }
        CHECK(a.feature_ratio == doctest::Approx(ratio).epsilon(1e-12));
        CHECK(a.radius[ball_vertices] == doctest::Approx(reach).epsilon(1e-12));
        CHECK(a.radius[ball_vertices] > held.domain.radius);
        // In the in-ball of v, of radius N/2, f_P is at most (ratio + 1/2) N; a clipped cell lies in a ball of radius
        // tau N/2 about v, in which f_P is at least N/2.
        const double most = a.integral.upper[ball_vertices] / volume * std::pow(2 * ratio + 1, D);
        CHECK(a.size_upper >= most);
        CHECK(a.size_upper <= most * 1.001);
        const double least = a.integral.lower[ball_domain] / volume / std::pow(tau, D);
        CHECK(a.size_lower <= least);
        CHECK(a.size_lower >= least * 0.999);
    }
}
TEST_CASE_TEMPLATE_APPLY(size_bounds, Dimensions<2, 3>);

TEST_CASE("the bound on feature ratios is where 3.3.1 ends, step by step") {
    for (const double tau : {2.5, 3.0, 4.0, 8.0}) {
        double inputs = 1;
        for (int step = 0; step < 1000; ++step) {
            const double steiner = 2 * inputs / tau + 2;
            inputs = (steiner - 1) / yield_radius + 2;
        }
        CHECK(feature_ratio_bound(tau, {}) >= inputs * (1 - 1e-12));
        CHECK(feature_ratio_bound(tau, {}) <= inputs * 1.01);
    }
}

TEST_CASE_TEMPLATE_DEFINE("bounds by paces are those of 3.8.3 to 3.8.7", T, pace_bounds) {
    constexpr int D = T::value;
    for (const inputs::Points& points : {inputs::uniform(D, 30), inputs::clusters(D, 20)}) {
        Ordered<D> set(points);
        const SizeAnalysis a = analyse<D>(set.held, 6);
        REQUIRE(farthest_first_order(set.held.store, set.tree, set.held.inputs(),
                                     {set.held.block.arena, set.held.monitor}, set.order.data()) == Status::ok);
        const std::vector<double> theta = thetas_by_scan(points, D, set.order);
        const double* const first = set.held.store.point(set.order[0]);
        const double c = (distance(first, set.held.domain.centre, D) + a.radius[ball_wide]) /
                         distance(first, set.held.store.point(set.order[1]), D);
        const double pi = 3.14159265358979324, volume = D == 2 ? pi : 4 * pi / 3;
        double upper = 1 + D * std::log(2 * c), lower = 0;
        for (std::size_t i = 2; i < theta.size(); ++i) {
            upper += 1 + D * std::log(3 * D / theta[i]);
            lower += std::max(0.0, D * std::log(1 / theta[i]) / std::pow(3, D) + std::pow(theta[i], D) - 1);
        }
        CHECK(a.pace_upper == doctest::Approx(volume * upper).epsilon(1e-4));
        CHECK(a.pace_upper >= volume * upper);
        CHECK(a.pace_lower == doctest::Approx(volume * lower).epsilon(1e-4));
        CHECK(a.pace_lower <= volume * lower);
    }
}
TEST_CASE_TEMPLATE_APPLY(pace_bounds, Dimensions<2, 3>);
