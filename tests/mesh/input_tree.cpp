// Searches among the inputs against looking at all of them, ties and far clusters included; what is refused before a
// mesh begins.
#include "mesh/input_tree.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "mesh/loop/frame.hpp"
#include "mesh/loop/separation.hpp"
#include "numerics/vector.hpp"

using namespace netmesh;

namespace {

template <int D> struct Planted {
    Planted(const inputs::Points& points, bool rings, std::size_t bytes = std::size_t{1} << 20)
        : count(static_cast<std::uint32_t>(points.size() / D)), block(bytes), store(block.arena, state) {
        Monitor monitor;
        std::uint32_t* order;
        status = take_input<D>(store, points.data(), count, 1, monitor, &input, &order);
        if (status == Status::ok) status = tree.build(store, block.arena, state.vertex_count, rings);
        count = state.vertex_count;
    }
    std::uint32_t count;
    Block block;
    StoreState state = {};
    Store<D> store;
    InputReport input;
    InputTree<D> tree;
    Status status;
};

// All inputs by distance from x, then index.
template <int D> std::vector<std::pair<double, std::uint32_t>> by_distance(const Planted<D>& p, const double* x) {
    std::vector<std::pair<double, std::uint32_t>> all;
    for (std::uint32_t v = 0; v < p.count; ++v) all.emplace_back(distance2<D>(x, p.store.point(v)), v);
    std::sort(all.begin(), all.end());
    return all;
}

// A nearest input as a tree with this layout finds it, and how many inputs that takes.
template <int D> struct Tally {
    const Planted<D>& p;
    const double* x;
    double best2 = HUGE_VAL;
    std::uint64_t looks = 0;

    void look(std::uint32_t v) {
        ++looks;
        best2 = std::min(best2, distance2<D>(x, p.store.point(v)));
    }
    void search(TreeRange range, const std::vector<double>& beyond) {
        double least2 = 0;
        for (const double d : beyond) least2 += d * d;
        if (least2 > best2) return;
        if (range.is_leaf()) {
            for (std::uint32_t i = range.begin; i < range.end; ++i) look(p.tree.item(i));
            return;
        }
        const std::uint32_t middle = range.middle(), item = p.tree.item(middle);
        look(item);
        const int axis = p.tree.axis(middle);
        const double offset = x[axis] - p.store.point(item)[axis];
        search(offset < 0 ? range.below() : range.above(), beyond);
        std::vector<double> farther = beyond;
        farther[static_cast<std::size_t>(axis)] = offset;
        search(offset < 0 ? range.above() : range.below(), farther);
    }
};

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("each look at an input is counted", T, counted) {
    constexpr int D = T::value;
    double d2;
    Neighbour nearest[8];
    // A tree of one leaf has no choice.
    for (const bool rings : {true, false})
        for (std::uint32_t n = 2; n <= TreeRange::leaf; ++n) {
            Planted<D> p(inputs::uniform(D, n), rings);
            REQUIRE(p.status == Status::ok);
            CHECK(p.tree.touches() == 0);
            const double* const x = p.store.point(0);
            std::uint64_t looks = 0;
            CHECK(p.tree.nearest(x, none, none, &d2) == 0);
            CHECK(p.tree.touches() == (looks += n));
            CHECK(p.tree.nearest(x, 1, 0, &d2) != 0);
            CHECK(p.tree.touches() == (looks += 1 + (n - 1)));
            CHECK(p.tree.nearest_within(x, 1e-30, &d2) == 0);
            CHECK(p.tree.touches() == (looks += n));
            p.tree.nearest_k(x, n, nearest);
            CHECK(p.tree.touches() == (looks += n));
            if (rings) CHECK(p.tree.farthest_in_ring(x, 0, 10, &d2) != none);
            CHECK(p.tree.touches() == (looks += rings ? n : 0));
        }
    Planted<D> p(inputs::clusters(D, 500), false);
    REQUIRE(p.status == Status::ok);
    inputs::Random random(3);
    std::uint64_t looks = 0;
    for (int trial = 0; trial < 300; ++trial) {
        double x[D];
        for (int k = 0; k < D; ++k) x[k] = random.uniform();
        Tally<D> tally{p, x};
        tally.search(p.tree.root(), std::vector<double>(D, 0.0));
        p.tree.nearest(x, none, none, &d2);
        CHECK(d2 == tally.best2);
        CHECK(p.tree.touches() == (looks += tally.looks));
    }
    CHECK(looks < 300 * 500);
}
TEST_CASE_TEMPLATE_APPLY(counted, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("searches find what looking at all inputs finds", T, searches) {
    constexpr int D = T::value;
    for (const inputs::Points& points : {inputs::clusters(D, 300),
                                         inputs::grid(D, D == 2   ? 12
                                                         : D == 3 ? 6
                                                         : D == 4 ? 4
                                                                  : 2 + (D == 5)),
                                         inputs::zoom(D, 400, 2), inputs::nested(D, 4, 40, 1e6), inputs::uniform(D, 3)})
        for (const bool rings : {true, false}) {
            Planted<D> p(points, rings);
            REQUIRE(p.status == Status::ok);
            inputs::Random random(5);
            std::uint32_t in_rings = 0;
            for (int trial = 0; trial < 200; ++trial) {
                const std::uint32_t near = static_cast<std::uint32_t>(random.below(p.count));
                double x[D], d2;
                for (int k = 0; k < D; ++k) {
                    const double off = std::ldexp(random.uniform() - 0.5, -static_cast<int>(random.below(30)));
                    x[k] = p.store.point(near)[k] + (trial % 3 == 0 ? 0 : trial % 3 == 1 ? 0.5 : off);
                }
                const auto all = by_distance<D>(p, x);
                CHECK(p.tree.nearest(x, none, none, &d2) == all[0].second);
                CHECK(d2 == all[0].first);
                const std::uint32_t other = near == 0 ? 1 : 0;
                const auto second = all[all[0].second == near ? 1 : 0];
                CHECK(p.tree.nearest(x, other, near, &d2) == second.second);
                // A bound that some input is exactly as far as, and one beyond.
                const double bound2 = all[random.below(std::min(p.count, 9u))].first;
                CHECK(p.tree.nearest_within(x, bound2, &d2) == (all[0].first < bound2 ? all[0].second : none));
                CHECK(p.tree.nearest_within(x, 2 * bound2 + 1e-300, &d2) == all[0].second);
                Neighbour nearest[20];
                const std::uint32_t k = 1 + static_cast<std::uint32_t>(random.below(std::min(p.count, 20u)));
                p.tree.nearest_k(x, k, nearest);
                for (std::uint32_t i = 0; i < k; ++i) {
                    REQUIRE(nearest[i].input == all[i].second);
                    REQUIRE(nearest[i].distance2 == all[i].first);
                }
                if (!rings) continue;
                const double at = trial % 2 == 0 ? std::sqrt(all[random.below(p.count)].first) : random.uniform();
                for (const double outer : {at, 1.5 * at, 8 * at, 1e3 * at}) {
                    double best2 = at * at;
                    std::uint32_t best = none;
                    for (const auto& one : all)
                        if (one.first > best2 && one.first <= outer * outer) {
                            best2 = one.first;
                            best = one.second;
                        }
                    CHECK(p.tree.farthest_in_ring(x, at, outer, &d2) == best);
                    if (best == none) continue;
                    CHECK(d2 == best2);
                    ++in_rings;
                }
            }
            if (rings && p.count > 20) CHECK(in_rings > 50);
            CHECK(p.tree.touches() > 0);
        }
}
TEST_CASE_TEMPLATE_APPLY(searches, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("a tree is refused where it does not fit", T, refused_trees) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::uniform(D, 60);
    bool fits = false;
    for (std::size_t bytes = 60 * sizeof(Vertex<D>); bytes < 60 * sizeof(Vertex<D>) + 2500; bytes += 16) {
        Planted<D> p(points, true, bytes);
        REQUIRE((p.status == Status::ok || (p.status == Status::out_of_memory && !fits)));
        fits = p.status == Status::ok;
    }
    CHECK(fits);
}
TEST_CASE_TEMPLATE_APPLY(refused_trees, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("inputs out of range or below the resolution are named by row", T, separation) {
    constexpr int D = T::value;
    inputs::Points points = inputs::uniform(D, 20);
    const auto check = [&] {
        Planted<D> p(points, false);
        REQUIRE(p.status == Status::ok);
        return std::make_pair(check_separation(p.store, p.tree, resolution, &p.input), p.input);
    };
    CHECK(check().first == Status::ok);
    SUBCASE("too large") {
        points[D * 7 + D - 1] = -0x1p501;
        const auto [status, input] = check();
        CHECK(status == Status::out_of_range);
        CHECK(input.row_a == 7);
    }
    SUBCASE("a unit in the last place apart") {
        std::copy(&points[D * 3], &points[D * 3] + D, &points[D * 11]);
        points[D * 11] = std::nextafter(points[D * 11], 2);
        const auto [status, input] = check();
        CHECK(status == Status::too_close);
        CHECK(input.row_a == 3);
        CHECK(input.row_b == 11);
    }
    SUBCASE("too close for the larger of the two only, which comes later") {
        points.assign(2 * D, 0);
        points[0] = 1;
        points[D] = 1 + resolution;
        const auto [status, input] = check();
        CHECK(status == Status::too_close);
        CHECK(input.row_a == 0);
        CHECK(input.row_b == 1);
    }
    SUBCASE("both so near the origin that their distance is tiny") {
        points.assign(2 * D, 0);
        points[2 * D - 1] = 0x1p-510;
        CHECK(check().first == Status::out_of_range);
    }
    SUBCASE("tiny distances away from the origin are below the resolution") {
        points.assign(2 * D, 0x1p-500);
        points[D] += 0x1p-549;
        CHECK(check().first == Status::too_close);
    }
}
TEST_CASE_TEMPLATE_APPLY(separation, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("segments cross a sphere where they should", T, crossings) {
    constexpr int D = T::value;
    Domain<D> ball = {};
    ball.radius = ball.enclosing_radius = 5;
    for (int k = 0; k < D; ++k) ball.centre[k] = k;
    const auto place = [&](double x, double y, double(&p)[D]) {
        for (int k = 0; k < D; ++k) p[k] = k;
        p[0] += x;
        p[1] += y;
    };
    double a[D], b[D], z[2][D];
    place(3, 0, a);
    place(3, 9, b);
    REQUIRE(sphere_crossings<D>(ball, a, b, z) == 1);
    CHECK(std::fabs(z[0][1] - 1 - 4) < 1e-12);
    place(3, -9, a);
    REQUIRE(sphere_crossings<D>(ball, b, a, z) == 2);
    CHECK(std::fabs(z[0][1] + z[1][1] - 2) < 1e-12);
    CHECK(sphere_crossings<D>(ball, b, b, z) == 0);  // no segment
    place(1, 1, a);
    CHECK(sphere_crossings<D>(ball, a, a, z) == 0);
    place(5, 0, a);
    place(5, 4, b);
    CHECK(sphere_crossings<D>(ball, a, b, z) == 0);  // touches at its end and leads away
    place(6, -4, a);
    place(6, 3, b);
    CHECK(sphere_crossings<D>(ball, a, b, z) == 0);  // passes by
    place(9, 0, a);
    place(6, 0, b);
    CHECK(sphere_crossings<D>(ball, a, b, z) == 0);  // ends before
    place(1, 0, a);
    place(2, 0, b);
    CHECK(sphere_crossings<D>(ball, a, b, z) == 0);  // inside
    place(4.5, 0, b);
    CHECK(sphere_crossings<D>(ball, a, b, z) == 0);  // inside, the sphere close behind its end
    // Any segment crosses as often as its ends and its point nearest to the centre tell.
    inputs::Random random(21);
    for (int i = 0; i < 2000; ++i) {
        double u = 0, length2 = 0, nearest[D];
        for (int k = 0; k < D; ++k) {
            a[k] = k + 8 * (2 * random.uniform() - 1);
            b[k] = a[k] + 10 * (2 * random.uniform() - 1) * (i % 2 == 0 ? 1 : 0.1);
            u += (ball.centre[k] - a[k]) * (b[k] - a[k]);
            length2 += (b[k] - a[k]) * (b[k] - a[k]);
        }
        const double share = std::min(1.0, std::max(0.0, u / length2));
        for (int k = 0; k < D; ++k) nearest[k] = a[k] + share * (b[k] - a[k]);
        const bool in_a = ball.contains(a), in_b = ball.contains(b), passes = ball.contains(nearest);
        const int found = sphere_crossings<D>(ball, a, b, z);
        CHECK(found == (in_a && in_b ? 0 : in_a || in_b ? 1 : passes ? 2 : 0));
        for (int n = 0; n < found; ++n) {
            CHECK(std::sqrt(ball.distance2(z[n])) == doctest::Approx(5).epsilon(1e-12));
            CHECK(distance<D>(a, z[n]) + distance<D>(z[n], b) == doctest::Approx(std::sqrt(length2)).epsilon(1e-12));
        }
    }
}
TEST_CASE_TEMPLATE_APPLY(crossings, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("a ball around any set contains it and cannot shrink", T, enclosing) {
    constexpr int D = T::value;
    for (const inputs::Points& points :
         {inputs::grid(D, 2), inputs::uniform(D, 40), inputs::shell(D, 60, 1, 1, 3), inputs::geometric(D, 1e5, 20),
          inputs::close_pairs(D, 4, 0x1p-40), inputs::uniform(D, 1)}) {
        double centre[D], radius;
        const std::uint32_t count = static_cast<std::uint32_t>(points.size() / D);
        smallest_enclosing_ball<D>(points.data(), count, centre, &radius);
        const auto farthest = [&](const double* from) {
            double far2 = 0;
            for (std::uint32_t i = 0; i < count; ++i) far2 = std::max(far2, distance2<D>(from, &points[D * i]));
            return std::sqrt(far2);
        };
        CHECK(farthest(centre) <= radius);
        CHECK(farthest(centre) >= radius * (1 - 1e-9));
        inputs::Random random(2);
        for (int trial = 0; trial < 100; ++trial) {
            double moved[D];
            for (int k = 0; k < D; ++k) moved[k] = centre[k] + 1e-3 * (random.uniform() - 0.5);
            CHECK(farthest(moved) >= radius * (1 - 1e-9));
        }
    }
}
TEST_CASE_TEMPLATE_APPLY(enclosing, Dimensions<>);
