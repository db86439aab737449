// Recursively well-paced subsets: a partition of the points, parents first, each scale as far from the next as theta
// says.
#include "filtration/scale_partition.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"

using namespace netmesh;

namespace {

template <int D> struct Held {
    explicit Held(const inputs::Points& points) : count(static_cast<std::uint32_t>(points.size() / D)) {
        REQUIRE(store.open_vertices(count) == Status::ok);
        for (std::uint32_t v = 0; v < count; ++v) std::copy_n(&points[std::size_t{v} * D], D, store.vertex(v).x);
    }
    Block block{std::size_t{1} << 22};
    StoreState state = {};
    Store<D> store{block.arena, state};
    std::uint32_t count;
};

// Copies of a grid's corners and its middle, each `ratio` times as large, about two of its own points.
template <int D> inputs::Points clumps(double ratio) {
    inputs::Points base = inputs::grid(D, 2);
    base.insert(base.end(), D, 0.5);
    inputs::Points all = base;
    for (const std::size_t about : {std::size_t{0}, std::size_t{D}})
        for (std::size_t i = 0; i < base.size(); ++i) all.push_back(base[about + i % D] + ratio * (base[i] + 0.125));
    return all;
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("points of three scales", T, three) {
    constexpr int D = T::value;
    for (const double theta : {1.0 / 9, 0.02}) {
        const inputs::Points points = clumps<D>(0x1p-20);
        Held<D> held(points);
        Monitor monitor;
        const AnyStore any(held.store);
        ScalePartition partition;
        REQUIRE(partition.open(any, held.count, theta, held.block.arena) == Status::ok);
        std::vector<int> chosen(held.count, 0);
        bool stopped = true;
        std::uint32_t clusters = 0;
        for (; partition.next(monitor, &stopped); ++clusters) {
            CHECK(!stopped);
            const std::uint32_t* const p = partition.chosen();
            CHECK(chosen[p[0]] == (clusters == 0 ? 0 : 1));  // the representative is its parent's
            for (std::uint32_t i = clusters == 0 ? 0 : 1; i < partition.chosen_count(); ++i) CHECK(chosen[p[i]]++ == 0);
            CHECK(partition.chosen_count() > 1);
        }
        CHECK(!stopped);
        CHECK(clusters == 3);
        CHECK(partition.clusters() == 3);
        CHECK(std::count(chosen.begin(), chosen.end(), 1) == static_cast<std::ptrdiff_t>(held.count));
        CHECK(partition.separation() >= (1 - theta) / (2 * theta) * (1 - 1e-9));
        CHECK(partition.separation() < 0x1p20);
    }
}
TEST_CASE_TEMPLATE_APPLY(three, Dimensions<>);

// The definition followed step by step: what is chosen is the farthest medial point, nothing medial is left, what is
// left goes to the nearest chosen one, and the separation is the least of all E_j.
TEST_CASE_TEMPLATE_DEFINE("clusters are chosen, left and set apart as they are defined", T, defined) {
    constexpr int D = T::value;
    inputs::Random random(17);
    int inner = 0;
    for (int round = 0; round < 12; ++round) {
        CAPTURE(round);
        const double theta = round % 3 == 0 ? 1.0 / 9 : 0.02 + 0.08 * random.uniform();
        // Points about points about points, at distances that differ by any factor.
        inputs::Points points;
        for (int i = 0; i < 60; ++i) {
            double x[D] = {};
            const std::size_t old = points.size() / D;
            const double scale = std::pow(0.1, 3 * random.uniform() * (old % 4 == 0 ? 0 : 1));
            if (old > 0) std::copy_n(&points[random.below(old) * D], D, x);
            for (double& c : x) c += scale * (2 * random.uniform() - 1);
            points.insert(points.end(), x, x + D);
        }
        Held<D> held(points);
        const auto apart = [&](std::uint32_t a, std::uint32_t b) {
            double d2 = 0;
            for (int k = 0; k < D; ++k)
                d2 += (points[a * D + k] - points[b * D + k]) * (points[a * D + k] - points[b * D + k]);
            return std::sqrt(d2);
        };
        // Distances to the nearest and the second nearest of the first `count` of P.
        const auto nearest = [&](std::uint32_t x, const std::vector<std::uint32_t>& p, std::size_t count) {
            std::vector<double> d;
            for (std::size_t i = 0; i < count; ++i) d.push_back(apart(x, p[i]));
            std::sort(d.begin(), d.end());
            return std::make_pair(d[0], count > 1 ? d[1] : HUGE_VAL);
        };
        const auto is_medial = [&](const std::pair<double, double>& d) {
            return !(d.second < HUGE_VAL) || d.first >= theta * d.second;
        };
        std::vector<std::vector<std::uint32_t>> cluster(held.count);  // by representative, without it
        for (std::uint32_t i = 1; i < held.count; ++i) cluster[0].push_back(i);
        double separation = HUGE_VAL;
        Monitor monitor;
        const AnyStore any(held.store);
        ScalePartition partition;
        REQUIRE(partition.open(any, held.count, theta, held.block.arena) == Status::ok);
        for (bool stopped; partition.next(monitor, &stopped);) {
            const std::vector<std::uint32_t> p(partition.chosen(), partition.chosen() + partition.chosen_count());
            std::vector<std::uint32_t> left;
            left.swap(cluster[p[0]]);
            REQUIRE(!left.empty());
            for (std::size_t n = 1; n < p.size(); ++n) {
                const auto taken = std::find(left.begin(), left.end(), p[n]);
                REQUIRE(taken != left.end());
                const auto own = nearest(p[n], p, n);
                CHECK(is_medial(own));
                for (const std::uint32_t x : left) {
                    const auto d = nearest(x, p, n);
                    if (is_medial(d)) CHECK(d.first <= own.first);
                }
                left.erase(taken);
            }
            for (const std::uint32_t x : left) {
                CHECK(!is_medial(nearest(x, p, p.size())));
                std::size_t owner = 0;
                for (std::size_t i = 1; i < p.size(); ++i)
                    if (apart(x, p[i]) < apart(x, p[owner])) owner = i;
                cluster[p[owner]].push_back(x);
            }
            for (const std::uint32_t j : p) {
                double gap = HUGE_VAL, radius = 0;
                for (const std::uint32_t other : p)
                    if (other != j) gap = std::min(gap, apart(j, other));
                for (const std::uint32_t x : cluster[j]) radius = std::max(radius, apart(j, x));
                if (radius > 0) separation = std::min(separation, gap / (2 * radius));
            }
            if (separation < HUGE_VAL) CHECK(partition.separation() == doctest::Approx(separation).epsilon(1e-10));
            CHECK(partition.separation() <= separation);
        }
        for (const auto& c : cluster) CHECK(c.empty());
        inner += partition.clusters() > 3;
    }
    CHECK(inner > 3);
}
TEST_CASE_TEMPLATE_APPLY(defined, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("one scale, what does not fit, and what is stopped", T, refused) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::uniform(D, 1800);
    Held<D> held(points);
    Monitor monitor;
    const AnyStore any(held.store);
    ScalePartition partition;
    REQUIRE(partition.open(any, 10, 1.0 / 9, held.block.arena) == Status::ok);
    bool stopped;
    REQUIRE(partition.next(monitor, &stopped));
    CHECK(partition.chosen_count() == 10);
    CHECK(!partition.next(monitor, &stopped));
    CHECK(partition.separation() == infinity);

    const std::size_t low = held.block.arena.low_mark();
    REQUIRE(held.block.arena.template take_low<unsigned char>(held.block.arena.bytes_free() - 64) != nullptr);
    CHECK(partition.open(any, held.count, 1.0 / 9, held.block.arena) == Status::out_of_memory);
    held.block.arena.release_low(low);

    Monitor stopping([](void*, const netmesh_progress*) { return 1; }, nullptr);
    REQUIRE(partition.open(any, held.count, 1.0 / 9, held.block.arena) == Status::ok);
    CHECK(!partition.next(stopping, &stopped));
    CHECK(stopped);
}
TEST_CASE_TEMPLATE_APPLY(refused, Dimensions<>);
