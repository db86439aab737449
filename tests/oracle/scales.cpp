// Scale by scale (7.6) against the exact diagram of all points, on spreads up to 1e12: the log-bottleneck distance is
// at most 3 theta + eps, and at most the logarithm of the certified ratio; with a ratio asked for, that is at most the
// one asked for. Peak memory is that of the largest scale.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "common/dimensions.hpp"
#include "common/session.hpp"
#include "oracle/log_distance.hpp"

namespace {

// `levels` scales about the origin, each `ratio` times as large as the one before.
inputs::Points nested(int dim, int levels, double ratio, std::size_t each, std::uint64_t seed) {
    inputs::Random random(seed);
    inputs::Points p;
    const std::size_t d = static_cast<std::size_t>(dim);
    double scale = 1;
    for (int level = 0; level < levels; ++level, scale *= ratio) {
        for (std::size_t i = 0; i < each; ++i)
            for (std::size_t a = 0; a < d; ++a) p.push_back(scale * (2 * random.uniform() - 1));
    }
    return p;
}

// Small copies of a set around each of its points, far from the origin.
inputs::Points fractal(int dim, std::size_t each, double ratio, std::uint64_t seed) {
    const inputs::Points base = inputs::uniform(dim, each, seed);
    inputs::Points p;
    const std::size_t d = static_cast<std::size_t>(dim);
    for (std::size_t i = 0; i < each; ++i)
        for (std::size_t j = 0; j < each; ++j)
            for (std::size_t a = 0; a < d; ++a) p.push_back(1 + base[i * d + a] + ratio * base[j * d + a]);
    return p;
}

// The same with bounds by scale: they hold, and say no less than the ratio does, of which the session has the bounds.
std::size_t by_scale(Session& session, netmesh::Request request, const Diagram& truth, std::size_t by_ratio) {
    const std::vector<netmesh_pair> pairs = session.pairs();
    const std::vector<netmesh_bar_bounds> wide = read_all(session.context, netmesh_get_bar_bounds);
    const netmesh_report before = session.report();
    request.bounds = &netmesh_bounds;
    REQUIRE(session.persist_until_it_fits(request) == NETMESH_OK);
    const netmesh_report r = session.report();
    CHECK(r.diagram.certified_ratio == before.diagram.certified_ratio);
    REQUIRE(session.pairs().size() == pairs.size());
    const std::vector<netmesh_bar_bounds> bounds = read_all(session.context, netmesh_get_bar_bounds);
    REQUIRE(bounds.size() == pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const netmesh_pair now = session.pairs()[i];
        CHECK((now.degree == pairs[i].degree && now.birth == pairs[i].birth && now.death == pairs[i].death));
        CHECK(bounds[i].birth_high <= wide[i].birth_high * (1 + 1e-9));
        CHECK(bounds[i].certain_after <= wide[i].certain_after * (1 + 1e-9));
        CHECK(bounds[i].certain_after >= bounds[i].birth_high);
        if (now.death > bounds[i].certain_after) CHECK(bounds[i].certain == 1);
    }
    std::size_t certain = 0;
    CHECK(bounds_hold(session, truth, &certain));
    CHECK(certain >= by_ratio);
    const Curve by_scale = curve(session);
    CHECK(moves_within(by_scale, diagram(session), truth));
    CHECK(by_scale.steps.size() <= 1024);
    double worst = 1;
    for (std::size_t i = 0; i < by_scale.steps.size(); ++i) {
        const netmesh_scale_step& step = by_scale.steps[i];
        CHECK(step.ratio >= 1);
        worst = std::fmax(worst, step.ratio);
        if (i == 0) continue;
        CHECK(step.from > by_scale.steps[i - 1].from);
        CHECK(step.low >= by_scale.steps[i - 1].low);
        CHECK(step.high >= by_scale.steps[i - 1].high);
        CHECK(step.reach >= by_scale.steps[i - 1].reach);
    }
    CHECK(worst <= r.diagram.certified_ratio);
    MESSAGE("certified to exist: " << certain << " bars by scale, " << by_ratio << " by the ratio "
                                   << r.diagram.certified_ratio << "; worst ratio by scale " << worst);
    return certain;
}

// A ring of rings, `ratio` times as wide, with some noise in all directions.
inputs::Points rings(int dim, std::size_t around, std::size_t each, double ratio) {
    inputs::Random random(43);
    inputs::Points p;
    for (std::size_t i = 0; i < around; ++i)
        for (std::size_t k = 0; k < each; ++k) {
            const auto [c, s] = inputs::turn(i, around);
            const auto [x, y] = inputs::turn(k, each);
            p.insert(p.end(), {c + ratio * x, s + ratio * y});
            for (int a = 2; a < dim; ++a) p.push_back(0);
            for (int a = 0; a < dim; ++a)
                p[p.size() - 1 - static_cast<std::size_t>(a)] += 0.02 * ratio * random.uniform();
        }
    return p;
}

// How many classes above degree 0 are certified to exist, {by the ratio, by scale}.
template <int D> std::pair<std::size_t, std::size_t> real_rings(const inputs::Points& points, double ratio) {
    Session exact(D);
    REQUIRE(exact.alpha(points) == NETMESH_OK);
    const Diagram truth = diagram(exact);
    Session session(D);
    netmesh::Request request = session.scales_request(points);
    request.goal = {};
    request.goal.ratio = ratio;
    request.goal.theta = 0.1;
    REQUIRE(session.persist_until_it_fits(request) == NETMESH_OK);
    REQUIRE(session.report().scales.count > 1);
    std::size_t by_ratio = 0;
    CHECK(bounds_hold(session, truth, &by_ratio));
    const std::size_t components = points.size() / D;
    return {by_ratio - components, by_scale(session, request, truth, by_ratio) - components};
}

// Joins the scales of the points with both kinds of values, sees that the diagram is as near to the exact one as it
// certifies and that bars are where their bounds say, and calls check(request, report, distance, certain).
template <int D, class Check>
void join(const inputs::Points& points, double theta, double eps, double ratio, Check&& check) {
    Session exact(D);
    REQUIRE(exact.alpha(points) == NETMESH_OK);
    const Diagram truth = diagram(exact);
    Session session(D);
    netmesh::Request request = session.scales_request(points);
    request.goal.theta = theta;
    request.goal.eps = eps;
    request.goal.ratio = ratio;
    for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
        request.values = values;
        REQUIRE(session.persist_until_it_fits(request) == NETMESH_OK);
        const netmesh_report r = session.report();
        const double distance = log_distance(diagram(session), truth, D);
        CHECK(distance <= std::log(r.diagram.certified_ratio));
        std::size_t certain = 0;
        CHECK(bounds_hold(session, truth, &certain));
        check(request, r, distance, certain);
        by_scale(session, request, truth, certain);
        MESSAGE("D=" << D << ", theta " << theta << ", eps " << eps << ", ratio " << ratio << ": " << r.scales.count
                     << " scales, separation " << r.scales.separation << ", log distance " << distance
                     << ", certified ratio " << r.diagram.certified_ratio << ", " << r.scales.vertices
                     << " vertices, in the largest mesh " << r.scales.vertices_max << ", peak " << r.memory.peak_bytes
                     << " bytes");
    }
}

template <int D> void within_promise(const std::string& name, const inputs::Points& points, double theta, double eps) {
    CAPTURE(name);
    join<D>(points, theta, eps, 0,
            [&](const netmesh::Request&, const netmesh_report& r, double distance, std::size_t certain) {
                CHECK(r.scales.count > 1);
                CHECK(r.scales.separation >= (1 - theta) / (2 * theta) * (1 - 1e-9));
                CHECK(distance <= 3 * theta + eps);
                CHECK(std::log(r.diagram.certified_ratio) <= 3 * theta + eps);
                CHECK(certain > 0);
            });
}

template <int D> void within_ratio(const inputs::Points& points, double theta, double ratio, bool has_scales) {
    CAPTURE(D);
    join<D>(points, theta, 0, ratio,
            [&](const netmesh::Request& request, const netmesh_report& r, double, std::size_t) {
                CHECK((r.scales.count > 1) == has_scales);
                if (request.values == NETMESH_VALUES_CERTIFIED) CHECK(r.diagram.certified_ratio <= ratio);
                CHECK(r.diagram.certified_ratio_best <= ratio);
            });
}

}  // namespace

TEST_CASE("a ratio for the joined diagram, in every dimension") {
    within_ratio<2>(nested(2, 8, 0.02, 4, 33), 1.0 / 9, 1.9, true);
    within_ratio<2>(inputs::uniform(2, 60), 1.0 / 9, 1.9, false);
    within_ratio<3>(nested(3, 4, 1e-4, 8, 36), 0.05, 1.8, true);
    for_each_dimension<4, 4>([](auto dim) { within_ratio<dim>(inputs::uniform(4, 200), 1.0 / 9, 3, false); });
    for_each_dimension<4, 4>([](auto dim) { within_ratio<dim>(nested(4, 4, 0.02, 12, 37), 1.0 / 9, 2.2, true); });
    for_each_dimension<5, 5>([](auto dim) { within_ratio<dim>(inputs::uniform(5, 60), 1.0 / 9, 3, false); });
    for_each_dimension<5, 5>([](auto dim) { within_ratio<dim>(fractal(5, 5, 1e-6, 38), 0.05, 2.2, true); });
    for_each_dimension<6, 6>([](auto dim) { within_ratio<dim>(nested(6, 3, 1e-3, 7, 39), 1.0 / 9, 2.4, true); });
}

TEST_CASE("rings of two scales are certified to exist by scale, where the ratio does not tell") {
    const auto plane = real_rings<2>(rings(2, 12, 12, 0.02), 1.9);
    CHECK(plane.second == 13);
    CHECK(plane.first < 13);
    const auto space = real_rings<3>(rings(3, 12, 14, 0.02), 1.9);
    CHECK(space.second == 13);
    CHECK(space.first < 13);
    const auto four = real_rings<4>(rings(4, 12, 14, 0.02), 2);
    CHECK(four.second > four.first);
}

TEST_CASE("plane") {
    within_promise<2>("spread 1e12", nested(2, 5, 1e-3, 8, 31), 1.0 / 9, 0.5);
    within_promise<2>("spread 1e12", nested(2, 5, 1e-3, 8, 32), 0.05, 0.25);
    within_promise<2>("spread 1e12, close scales", nested(2, 8, 0.02, 4, 33), 1.0 / 9, 0.5);
    within_promise<2>("fractal", fractal(2, 6, 1e-2, 34), 1.0 / 9, 0.5);
    within_promise<2>("fractal, far from the origin", fractal(2, 6, 1e-9, 35), 1.0 / 9, 0.5);
    within_promise<2>("clusters", inputs::clusters(2, 60), 1.0 / 9, 0.5);
}

TEST_CASE("space") { within_promise<3>("spread 1e12", nested(3, 4, 1e-4, 5, 36), 1.0 / 9, 0.5); }

TEST_CASE("peak memory is that of the largest scale") {
    // One scale of 40 points, and the same with four smaller scales within it.
    const inputs::Points large = inputs::uniform(2, 40, 41);
    inputs::Points all = large;
    for (const double scale : {1e-3, 1e-6, 1e-9, 1e-12})
        for (const double x : inputs::uniform(2, 10, 42)) all.push_back(large[0] + scale * x);
    Session one(2), many(2);
    REQUIRE(one.persist_until_it_fits(one.scales_request(large)) == NETMESH_OK);
    REQUIRE(many.persist_until_it_fits(many.scales_request(all)) == NETMESH_OK);
    const netmesh_report a = one.report(), b = many.report();
    CHECK(b.scales.count > a.scales.count);
    CHECK(b.scales.vertices > a.scales.vertices);
    const double ratio = static_cast<double>(b.memory.peak_bytes) / static_cast<double>(a.memory.peak_bytes);
    CHECK(ratio <= 1.1);
    MESSAGE("largest scale alone " << a.memory.peak_bytes << " bytes, all " << b.scales.count << " scales "
                                   << b.memory.peak_bytes << " bytes: " << ratio);
}
