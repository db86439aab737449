// Bounds of bars of several filters whose diagrams are joined, and the certificate by scale of all of them, against
// phi, psi and psi^- and the shift of the join as they are defined.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "common/block.hpp"
#include "common/inputs.hpp"
#include "jobs/bar_bounds.hpp"
#include "jobs/join_shift.hpp"
#include "jobs/scale_grid.hpp"

using namespace netmesh;

namespace {

constexpr double near = 1e-9;

struct Cluster {
    double radius, gap;
    double from() const { return gap / 2 - radius; }
};
using Clusters = std::vector<Cluster>;

double after(const Clusters& clusters, double a) {
    double most = 0;
    for (const Cluster& c : clusters)
        if (c.from() <= a) most = std::max(most, c.radius);
    return a + most;
}
double before(const Clusters& clusters, double y) {
    double least = y;
    for (const Cluster& c : clusters) least = std::min(least, std::max(c.from(), y - c.radius));
    return least;
}

struct Filter {
    std::vector<double> t;
    std::vector<Interval> interval;

    double phi(double b) const {
        double most = b;
        for (std::size_t v = 0; v < t.size(); ++v)
            if (t[v] <= b) most = std::max(most, interval[v].hi);
        return most;
    }
    double psi(double a) const {
        double most = a;
        for (std::size_t v = 0; v < t.size(); ++v)
            if (interval[v].lo <= a) most = std::max(most, t[v]);
        return most;
    }
    double psi_inverse(double a) const {
        double least = a;
        for (std::size_t v = 0; v < t.size(); ++v)
            if (t[v] >= a) least = std::min(least, interval[v].lo);
        return least;
    }
};

// Values between 2^-5 and 2, times a power of two.
Filter random_filter(inputs::Random& random) {
    Filter filter;
    const int scale = -static_cast<int>(random.below(10));
    for (std::uint64_t v = 3 + random.below(20); v-- > 0;) {
        const double x = std::ldexp(1 + random.uniform(), scale - static_cast<int>(random.below(6)));
        filter.t.push_back(x);
        filter.interval.push_back({x * (1 - 0.5 * random.uniform() * random.uniform()), x * (1 + random.uniform())});
    }
    return filter;
}

struct Case {
    std::vector<Filter> filters;
    Clusters clusters;
};

Case random_case(inputs::Random& random) {
    Case c;
    for (std::uint64_t i = 1 + random.below(4); i-- > 0;) c.filters.push_back(random_filter(random));
    for (std::uint64_t i = random.below(4); i-- > 0;) {
        const double radius = std::ldexp(1 + random.uniform(), -static_cast<int>(random.below(14)) - 2);
        c.clusters.push_back({radius, radius * (8.5 + 20 * random.uniform())});
    }
    return c;
}

std::vector<Pair> random_bars(const Filter& filter, inputs::Random& random) {
    std::vector<Pair> bars = {{0, HUGE_VAL, 0, 0}};
    for (int i = 0; i < 12; ++i) {
        const double a = filter.t[random.below(filter.t.size())], b = filter.t[random.below(filter.t.size())];
        bars.push_back({i < 3 ? 0 : std::min(a, b), std::max(a, b), 1, 0});
    }
    return bars;
}

void check_bounds(const Case& c, const Filter& filter, const std::vector<Pair>& bars,
                  const std::vector<BarBounds>& bounds) {
    for (std::size_t i = 0; i < bars.size(); ++i) {
        const BarBounds& b = bounds[i];
        CHECK(b.birth_low == (bars[i].birth == 0 ? 0 : filter.psi_inverse(bars[i].birth)));
        CHECK(b.birth_high == filter.phi(bars[i].birth));
        CHECK(b.death_low == filter.psi_inverse(bars[i].death));
        CHECK(b.death_high == (bars[i].death < HUGE_VAL ? filter.phi(bars[i].death) : HUGE_VAL));
        const double due = filter.psi(after(c.clusters, filter.phi(bars[i].birth)));
        CHECK(b.certain_after >= due * (1 - near));
        CHECK(b.certain_after <= filter.psi(after(c.clusters, filter.phi(bars[i].birth)) * (1 + near)) * (1 + near));
        CHECK(b.certain == (bars[i].death > b.certain_after ? 1u : 0u));
        // Then the true death is surely after what the true birth is moved to.
        if (b.certain == 1) CHECK(b.death_low >= after(c.clusters, b.birth_high) * (1 - near));
    }
}

}  // namespace

TEST_CASE("bounds in a join, and steps that hold every filter's") {
    inputs::Random random(3);
    int certain = 0, exact = 0, moved = 0;
    for (int round = 0; round < 200; ++round) {
        CAPTURE(round);
        const Case c = random_case(random);
        Block block(std::size_t{1} << 20);
        JoinShift join;
        for (const Cluster& cluster : c.clusters) REQUIRE(join.add(cluster.radius, cluster.gap, block.arena));
        join.close();
        ScaleGrid grid;
        REQUIRE(grid.open(0x1p-9, 4, block.arena));
        CHECK(grid.count() <= ScaleGrid::cells_max);
        std::set<double> scales;
        for (const Filter& filter : c.filters) {
            const std::vector<Pair> bars = random_bars(filter, random);
            std::vector<BarBounds> bounds(bars.size());
            const FilterBounds cells = {filter.t.data(), filter.interval.data(),
                                        static_cast<std::uint32_t>(filter.t.size())};
            const std::size_t used = block.arena.bytes_used();
            REQUIRE(bound_in_join(cells, {bars.data(), bars.size()}, join, block.arena, bounds.data(), &grid) ==
                    Status::ok);
            CHECK(block.arena.bytes_used() == used);
            check_bounds(c, filter, bars, bounds);
            for (const BarBounds& b : bounds) certain += b.certain == 1;
            for (std::size_t v = 0; v < filter.t.size(); ++v)
                for (const double a : {filter.t[v], filter.interval[v].lo, filter.interval[v].hi})
                    scales.insert({a, std::nextafter(a, 0), std::nextafter(a, HUGE_VAL)});
        }
        for (const Cluster& cluster : c.clusters)
            scales.insert({cluster.from() * (1 + near), cluster.from() + cluster.radius, cluster.gap});
        for (int i = 0; i < 60; ++i)
            scales.insert(std::ldexp(1 + random.uniform(), static_cast<int>(random.below(16)) - 13));
        ScaleCurve curve;
        REQUIRE(grid.finish(join, HUGE_VAL, block.arena, &curve));
        for (const double a : scales) {
            CAPTURE(a);
            double high = a, low = a, reach = a;
            for (const Filter& f : c.filters) {
                high = std::max(high, f.phi(a));
                low = std::min(low, before(c.clusters, f.psi_inverse(a)));
                reach = std::max(reach, f.psi(after(c.clusters, f.phi(a))));
            }
            const ScaleStep* step = nullptr;
            std::size_t next = 0;
            while (next < curve.count && curve.steps[next].from <= a) step = &curve.steps[next++];
            const double ratio = std::max(high / a, a / low);
            if (step == nullptr) {
                CHECK((high == a && low >= a * (1 - near) && reach <= a * (1 + near)));
                continue;
            }
            exact += step->ratio == 1;
            moved += low < a && high == a && !c.clusters.empty();
            CHECK(std::max(step->high, a) >= high);
            CHECK(std::min(step->low, a) <= low * (1 + near));
            CHECK(std::max(step->reach, a) >= reach * (1 - near));
            CHECK(step->ratio >= ratio * (1 - near));
            // And no more than holds somewhere in the step, or of a and the end of its cell.
            const double end = next < curve.count ? curve.steps[next].from : HUGE_VAL;
            double most = 0, least = HUGE_VAL;
            for (const Filter& f : c.filters) {
                most = std::max(most, f.phi(end));
                least = std::min(least, before(c.clusters, f.psi_inverse(step->from)));
            }
            CHECK(step->high <= most);
            CHECK(step->low >= least * (1 - near));
        }
        for (std::size_t i = 1; i < curve.count; ++i) {
            CHECK(curve.steps[i].from > curve.steps[i - 1].from);
            CHECK(curve.steps[i].low >= curve.steps[i - 1].low);
            CHECK(curve.steps[i].high >= curve.steps[i - 1].high);
            CHECK(curve.steps[i].reach >= curve.steps[i - 1].reach);
        }
        REQUIRE(grid.finish(join, 1.25, block.arena, &curve));
        for (std::size_t i = 0; i < curve.count; ++i) CHECK(curve.steps[i].ratio <= 1.25);
    }
    CHECK(certain > 100);
    CHECK(exact > 100);
    CHECK(moved > 100);
}

TEST_CASE("a grid of scales has no more cells than its room, however wide it is") {
    Block block(std::size_t{1} << 20);
    for (const double least : {5e-324, 1e-300, 1e-20, 0.25, 1.0})
        for (const double most : {1.0, 1e6, 1e300}) {
            ScaleGrid grid;
            REQUIRE(grid.open(least, most, block.arena));
            CHECK(grid.count() >= 1);
            CHECK(grid.count() <= ScaleGrid::cells_max);
            CHECK(grid.from(0) <= least);
            CHECK(grid.next(grid.count() - 1) == HUGE_VAL);
            for (std::uint32_t i = 0; i < grid.count(); ++i) {
                CHECK(grid.from(i) < grid.next(i));
                CHECK(grid.cell_of(grid.from(i)) == i);
                if (i > 0) CHECK(grid.cell_of(std::nextafter(grid.from(i), 0)) == i - 1);
            }
            CHECK(grid.cell_of(0) == 0);
            CHECK(grid.cell_of(HUGE_VAL) == grid.count() - 1);
        }
}
