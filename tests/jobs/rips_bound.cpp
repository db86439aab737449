// Rips diagrams of degrees 0 and 1 with no more edges than the bound by alpha wants, against all edges; graphs with
// lists against those with a table.
#include "jobs/rips_bound.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "common/block.hpp"
#include "exact/families.hpp"
#include "filtration/rips_graph.hpp"
#include "geometry/half_distance.hpp"
#include "homology/disturbed.hpp"
#include "jobs/diagram_of_points.hpp"

using namespace netmesh;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

using Bars = std::vector<std::tuple<std::uint32_t, double, double>>;
Bars bars_of(const PairList& list) {
    Bars bars;
    for (std::uint64_t i = 0; i < list.count; ++i)
        bars.push_back({list.pairs[i].degree, list.pairs[i].birth, list.pairs[i].death});
    return bars;
}

PointsRequest rips_of(std::uint32_t dim, const families::Points& x, double threshold) {
    return {{NETMESH_FILTER_RIPS, {}, 0, 1},
            {x.data(), sizeof(double) * dim, false},
            static_cast<std::uint32_t>(x.size() / dim),
            dim,
            threshold,
            false,
            false};
}

// What edges are looked at, of those that there are.
double compare(std::uint32_t dim, const families::Points& x, double threshold) {
    Block block(std::size_t{64} << 20);
    Monitor monitor;
    PointsDiagram bounded, whole;
    const PointsRequest request = rips_of(dim, x, threshold);
    REQUIRE(diagram_of_points(request, {block.arena, monitor}, &whole) == Status::ok);
    const Bars expected = bars_of(whole.diagram.pairs);
    block.arena.release_low(0);
    REQUIRE(bounded_diagram_of_points(request, {block.arena, monitor}, &bounded) == Status::ok);
    CHECK(bars_of(bounded.diagram.pairs) == expected);
    CHECK(bounded.diagram.simplices <= whole.diagram.simplices);
    return static_cast<double>(bounded.diagram.simplices) / static_cast<double>(whole.diagram.simplices);
}

}  // namespace

TEST_CASE("the bound changes no bar: all families, moved by units in the last place, and thresholds") {
    families::Random random(7);
    for (const std::uint32_t dim : {2u, 3u})
        for (const families::Family& family : families::all()) {
            CAPTURE(dim);
            CAPTURE(family.name);
            families::Points x = family.make(random, static_cast<int>(dim), 230);
            if (x.size() / dim > 500) x.resize(500 * dim);
            compare(dim, x, infinite);
            families::move_units(random, 3, &x);
            compare(dim, x, infinite);
            double least = infinite, most = -infinite;
            for (std::size_t i = 0; i < x.size(); i += dim) {
                least = std::min(least, x[i]);
                most = std::max(most, x[i]);
            }
            if (most / 2 - least / 2 < infinite)
                for (const double part : {0.02, 0.05, 0.1, 0.3}) compare(dim, x, part * (most - least));
        }
}

TEST_CASE("far apart clusters are joined when they are, and a threshold parts them") {
    for (const std::uint32_t dim : {2u, 3u}) {
        families::Random random(8);
        families::Points x = families::uniform(random, static_cast<int>(dim), 400);
        for (std::size_t i = 0; i < x.size(); i += dim) x[i] += 50.0 * static_cast<double>(i / dim % 5 * (i / dim % 5));
        CHECK(compare(dim, x, infinite) < 0.5);
        for (const double threshold : {10.0, 24.5, 25.0, 80.0, 1e9}) compare(dim, x, threshold);
    }
}

TEST_CASE("few edges of many points are looked at, and all of a circle") {
    families::Random random(9);
    for (const std::uint32_t dim : {2u, 3u}) {
        CHECK(compare(dim, families::uniform(random, static_cast<int>(dim), 1000), infinite) < 0.1);
        CHECK(compare(dim, families::circle(random, static_cast<int>(dim), 300), infinite) > 0.5);
    }
}

TEST_CASE("the bound: all blocks, all polls") {
    for (const std::uint32_t dim : {2u, 3u}) {
        families::Random random(10);
        const families::Points x = families::uniform(random, static_cast<int>(dim), 260);
        Bars expected;
        const auto once = [&](const Work& work) {
            PointsDiagram out;
            const Status status = bounded_diagram_of_points(rips_of(dim, x, infinite), work, &out);
            if (status != Status::ok) return status;
            if (expected.empty()) expected = bars_of(out.diagram.pairs);
            REQUIRE(bars_of(out.diagram.pairs) == expected);
            return status;
        };
        disturbed::by_size(std::size_t{4} << 20, 5000, once);
        CHECK(disturbed::at_polls(std::size_t{4} << 20, once) > 0);
    }
}

// Cubes against all pairs.
TEST_CASE("edges of a graph are all that are short enough, each once, in order where they are listed") {
    families::Random random(11);
    for (const std::uint32_t dim : {2u, 3u, 4u})
        for (const families::Family& family : families::all()) {
            CAPTURE(dim);
            CAPTURE(family.name);
            families::Points x = family.make(random, static_cast<int>(dim), 300);
            const auto n = static_cast<std::uint32_t>(x.size() / dim);
            std::vector<double> halves;
            for (std::uint32_t i = 1; i < n; ++i)
                for (std::uint32_t j = 0; j < i; ++j)
                    halves.push_back(half_distance(static_cast<int>(dim), &x[i * dim], &x[j * dim]));
            std::sort(halves.begin(), halves.end());
            for (const double part : {0.001, 0.01, 0.03, 0.3}) {
                const double threshold = halves[static_cast<std::size_t>(part * static_cast<double>(halves.size()))];
                Block block(std::size_t{8} << 20);
                Monitor monitor;
                RipsGraph graph;
                REQUIRE(rips_graph<any_dimension>(static_cast<int>(dim), x.data(), n, threshold, {block.arena, monitor},
                                                  &graph) == Status::ok);
                std::vector<double> found(graph.value, graph.value + graph.edge_count);
                std::sort(found.begin(), found.end());
                std::vector<double> expected(halves.begin(), std::upper_bound(halves.begin(), halves.end(), threshold));
                CHECK(found == expected);
                std::uint64_t before = 0;
                bool is_ascending = true;
                graph.each_edge(block.arena, [&](std::uint32_t larger, std::uint32_t smaller, std::uint32_t) {
                    const std::uint64_t edge = (std::uint64_t{larger} << 32 | smaller) + 1;
                    is_ascending &= edge > before && smaller < larger && larger < n;
                    before = edge;
                });
                CHECK(is_ascending);
                CHECK((graph.begin != nullptr) == RipsGraph::takes_lists(n, graph.edge_count));
            }
        }
}
