// What a join of scales moves: the distance to the points of a scale against that to all, sampled, and the functions of
// scale against their definitions.
#include "jobs/join_shift.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "filtration/scale_partition.hpp"

using namespace netmesh;

namespace {

struct Cluster {
    double radius, gap;
    double from() const { return gap / 2 - radius; }
};

// By definition: a + R(a), and the least a with a + R(a) >= y, which is y, or y - r, or a place where R jumps.
double after(const std::vector<Cluster>& clusters, double a) {
    double most = 0;
    for (const Cluster& c : clusters)
        if (c.from() <= a) most = std::max(most, c.radius);
    return a + most;
}
double before(const std::vector<Cluster>& clusters, double y) {
    double least = y;
    for (const Cluster& c : clusters) least = std::min(least, std::max(c.from(), y - c.radius));
    return least;
}

std::vector<Cluster> random_clusters(inputs::Random& random) {
    std::vector<Cluster> clusters(random.below(9));
    for (Cluster& c : clusters) {
        c.radius = std::pow(10, -4 * random.uniform());
        c.gap = c.radius * (8 + std::pow(10, 2 * random.uniform()));
    }
    return clusters;
}

// Points about points about points.
template <int D> inputs::Points several_scales(inputs::Random& random, int count) {
    inputs::Points points;
    for (int i = 0; i < count; ++i) {
        double x[D] = {};
        const std::size_t old = points.size() / D;
        const double scale = std::pow(0.02, static_cast<double>(random.below(3)));
        if (old > 0 && scale < 1) std::copy_n(&points[random.below(old) * D], D, x);
        for (double& c : x) c += scale * (2 * random.uniform() - 1);
        points.insert(points.end(), x, x + D);
    }
    return points;
}

// A cluster as the partition found it.
struct Scale {
    std::vector<std::uint32_t> points;
    double reach;  // of its ball
};

}  // namespace

TEST_CASE("the shift, its inverse and its factor are as defined") {
    inputs::Random random(5);
    for (int round = 0; round < 300; ++round) {
        CAPTURE(round);
        const std::vector<Cluster> clusters = random_clusters(random);
        Block block{std::size_t{1} << 16};
        JoinShift join;
        double first = HUGE_VAL;
        for (const Cluster& c : clusters) {
            REQUIRE(join.add(c.radius, c.gap, block.arena));
            first = std::min(first, c.from());
        }
        join.close();
        const double near = 1e-10;
        for (int i = 0; i < 60; ++i) {
            const double a = std::pow(10, 3 - 8 * random.uniform());
            CHECK(join.is_exact_until(a) == (a < first));
            CHECK(join.after(a) >= after(clusters, a) * (1 - near));
            CHECK(join.after(a) <= after(clusters, a) * (1 + near));
            CHECK(join.before(a) <= before(clusters, a));
            CHECK(join.before(a) >= before(clusters, a) * (1 - near));
            CHECK(join.before(join.after(a)) <= a * (1 + near));
            if (join.is_exact_until(a)) CHECK((join.after(a) == a && join.before(a) == a));
            // The factor is that of some place, and no place has more.
            const double to = a * (1 + random.uniform());
            double most = 1;
            for (int k = 0; k <= 400; ++k) {
                const double y = a + (to - a) * k / 400;
                most = std::max(most, y / before(clusters, y));
            }
            for (const Cluster& c : clusters) {
                const double top = c.from() + c.radius;
                if (top >= a && top <= to) most = std::max(most, top / before(clusters, top));
            }
            CHECK(join.factor(a, to) >= most * (1 - near));
            CHECK(join.factor(a, to) <= most * (1 + 1e-3));
            CHECK(join.factor(a, HUGE_VAL) >= join.factor(a, to) * (1 - near));
        }
        CHECK(join.after(HUGE_VAL) == HUGE_VAL);
        CHECK(join.before(HUGE_VAL) == HUGE_VAL);
        CHECK(join.before(0) == 0);
    }
}

TEST_CASE_TEMPLATE_DEFINE("a scale's points are no farther than the join says", T, sampled) {
    constexpr int D = T::value;
    inputs::Random random(11);
    double nearest = 0;  // share of what is allowed
    for (int round = 0; round < 8; ++round) {
        CAPTURE(round);
        const inputs::Points points = several_scales<D>(random, 60);
        const auto count = static_cast<std::uint32_t>(points.size() / D);
        Block block{std::size_t{1} << 20};
        StoreState state = {};
        Store<D> store{block.arena, state};
        REQUIRE(store.open_vertices(count) == Status::ok);
        for (std::uint32_t v = 0; v < count; ++v) std::copy_n(&points[std::size_t{v} * D], D, store.vertex(v).x);
        Monitor monitor;
        const AnyStore any(store);
        ScalePartition partition;
        JoinShift join;
        std::vector<Scale> scales;
        bool stopped = false;
        REQUIRE(partition.open(any, count, 1.0 / 9, block.arena) == Status::ok);
        while (partition.next(monitor, &stopped)) {
            const std::uint32_t* const p = partition.chosen();
            scales.push_back({{p, p + partition.chosen_count()}, scales.empty() ? HUGE_VAL : partition.gap() / 2});
            if (scales.size() > 1) REQUIRE(join.add(partition.radius(), partition.gap(), block.arena));
        }
        join.close();
        REQUIRE(scales.size() > 2);
        const auto distance = [&](const double* x, std::uint32_t p) {
            double d2 = 0;
            for (int k = 0; k < D; ++k) d2 += (x[k] - points[p * D + k]) * (x[k] - points[p * D + k]);
            return std::sqrt(d2);
        };
        for (int i = 0; i < 3000; ++i) {
            // Near a point, at any distance.
            double x[D];
            const double away = std::pow(10, 1 - 7 * random.uniform());
            std::copy_n(&points[random.below(count) * D], D, x);
            for (double& c : x) c += away * (2 * random.uniform() - 1);
            double all = HUGE_VAL, own = HUGE_VAL, smallest = HUGE_VAL;
            for (std::uint32_t p = 0; p < count; ++p) all = std::min(all, distance(x, p));
            const Scale* scale = &scales[0];
            for (const Scale& s : scales) {
                if (!(s.reach < smallest && distance(x, s.points[0]) <= s.reach)) continue;
                smallest = s.reach;
                scale = &s;
            }
            for (const std::uint32_t p : scale->points) own = std::min(own, distance(x, p));
            CHECK(own >= all);
            CHECK(own <= join.after(all) * (1 + 1e-12));
            CHECK(join.before(own) <= all * (1 + 1e-12));
            if (own > all) nearest = std::max(nearest, (own - all) / (join.after(all) - all));
        }
    }
    CHECK(nearest > 0.5);
    CHECK(nearest <= 1);
}
TEST_CASE_TEMPLATE_APPLY(sampled, Dimensions<>);
