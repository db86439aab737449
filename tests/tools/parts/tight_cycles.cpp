// Which bars stand apart, and cycles pulled tight: still cycles of their class, and no longer.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <random>

#include "netmesh.hpp"
#include "tools/plot/apart.hpp"
#include "tools/plot/tight_cycle.hpp"

using namespace netmesh::tool;

namespace {

using Edges = std::vector<std::vector<std::uint32_t>>;
using Place = const double*;

const double* place(const CyclePlaces& places, std::uint32_t v) { return &places.coordinates[std::size_t{v} * 2]; }

double length_of(const Edges& edges, const CyclePlaces& places) {
    double sum = 0;
    for (const auto& edge : edges)
        sum += std::hypot(place(places, edge[0])[0] - place(places, edge[1])[0],
                          place(places, edge[0])[1] - place(places, edge[1])[1]);
    return sum;
}

// Whether a ray from (x, y) crosses the edges an odd number of times.
bool is_inside(double x, double y, const Edges& edges, const CyclePlaces& places) {
    bool odd = false;
    for (const auto& edge : edges) {
        const Place a = place(places, edge[0]), b = place(places, edge[1]);
        if ((a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) odd = !odd;
    }
    return odd;
}

double radius_of(Place a, Place b, Place c) {
    const double ab = std::hypot(a[0] - b[0], a[1] - b[1]), bc = std::hypot(b[0] - c[0], b[1] - c[1]),
                 ca = std::hypot(c[0] - a[0], c[1] - a[1]);
    const double area = std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    return ab * bc * ca / (4 * area);
}

}  // namespace

TEST_CASE("bars stand apart above the largest gap between their lengths") {
    CHECK(count_apart({}) == 0);
    CHECK(count_apart({1}) == 1);
    CHECK(count_apart({3, 2.9, 1, .9, .8}) == 2);
    CHECK(count_apart({3, 2.5, 2, 1.6}) == 4);  // so few, and none is much shorter
    CHECK(count_apart({1, .5}) == 2);
    CHECK(count_apart({1, .3}) == 1);
    CHECK(count_apart({3, 2.9, 2.8, 2.7, 2.6, 2.5, 2.4, 2.3, 2.2}) == 0);
    CHECK(count_apart({HUGE_VAL, HUGE_VAL, 2, 1.9}) == 4);
    CHECK(count_apart({HUGE_VAL, 2, 1.9, 1.8, 1.7, 1.6, 1.5, 1.4, 1.3}) == 1);
    CHECK(count_apart({HUGE_VAL, 5, 1, .9}) == 2);
    CHECK(count_apart({9, 6, 1, 0, 0}) == 2);
    CHECK(count_apart({9, 0, 0}) == 1);
    CHECK(length_of(Bar{1, 2, HUGE_VAL}) == HUGE_VAL);
    CHECK(length_of(Bar{1, 2, 5}) == 3);
}

TEST_CASE("a cycle that is pulled tight is a cycle of its class, of allowed edges, and no longer") {
    std::size_t shorter = 0, seen = 0;
    for (std::uint32_t seed = 1; seed <= 12; seed++) {
        std::mt19937 bits(seed);
        std::uniform_real_distribution<double> uniform(0, 10);
        std::vector<double> points;
        while (points.size() < 500) {  // but for two discs
            const double x = uniform(bits), y = uniform(bits);
            if (std::hypot(x - 3, y - 3) > 1.8 && std::hypot(x - 7, y - 6) > 1.4) points.insert(points.end(), {x, y});
        }
        std::vector<double> block(1 << 18);
        netmesh::Engine engine(block.data(), block.size() * sizeof(double));
        netmesh::Request request(&netmesh_filter_alpha);
        request.set_points(2, points);
        request.cycles = &netmesh_cycles;
        REQUIRE(engine.persist(request) == NETMESH_OK);
        CyclePlaces places;
        places.dim = 2;
        engine.for_each_vertex([&](std::uint64_t, const netmesh_vertex& vertex) {
            places.coordinates.insert(places.coordinates.end(), vertex.coordinates, vertex.coordinates + 2);
        });
        engine.for_each_cell([&](std::uint64_t, const netmesh_cell& cell) {
            places.cells.insert(places.cells.end(), cell.vertices, cell.vertices + 3);
        });
        engine.for_each_pair([&](std::uint64_t i, const netmesh_pair& pair) {
            if (pair.degree != 1 || pair.death < 1.3 * pair.birth) return;
            Edges cycle;
            engine.for_each_in_cycle(i, [&](std::uint64_t, const netmesh_simplex& simplex) {
                cycle.emplace_back(simplex.vertices, simplex.vertices + 2);
            });
            const double radius = std::min(1.6 * pair.birth, pair.death);
            const Edges tight = tightened(cycle, radius, places);
            CAPTURE(seed);
            CAPTURE(pair.birth);
            seen++;
            shorter += length_of(tight, places) < 0.95 * length_of(cycle, places);
            CHECK(length_of(tight, places) <= length_of(cycle, places) * (1 + 1e-12));
            std::map<std::uint32_t, int> ends;
            for (const auto& edge : tight) {
                for (const std::uint32_t v : edge) ends[v]++;
                CHECK(length_of({edge}, places) <= 2 * radius);
            }
            for (const auto& [v, count] : ends) CHECK(count % 2 == 0);
            for (std::size_t c = 0; c < places.cells.size(); c += 3) {
                const Place a = place(places, places.cells[c]), b = place(places, places.cells[c + 1]),
                            d = place(places, places.cells[c + 2]);
                if (radius_of(a, b, d) < radius) continue;  // filled
                const double x = (a[0] + b[0] + d[0]) / 3, y = (a[1] + b[1] + d[1]) / 3;
                CHECK(is_inside(x, y, tight, places) == is_inside(x, y, cycle, places));
            }
        });
    }
    CHECK(seen > 100);
    CHECK(shorter > 20);
    const CyclePlaces nowhere = {2, {0, 0, 1, 0, 0, 1}, 3, {}, false};
    const Edges triangle = {{0, 1}, {0, 2}, {1, 2}};
    CHECK(tightened(triangle, 10, nowhere) == triangle);
    CHECK(tightened({{0, 1, 2}}, 10, nowhere) == Edges{{0, 1, 2}});
}
