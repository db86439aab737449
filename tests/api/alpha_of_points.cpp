// Alpha of points: the diagram of alpha on a triangulation that is kept, in less memory and without the triangulation.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <vector>

#include "api/context.hpp"
#include "common/dimensions.hpp"
#include "common/session.hpp"
#include "exact/families.hpp"

namespace {

struct Told {
    std::vector<netmesh_pair> pairs;
    netmesh_report report;
};

Told told(const Session& s) { return {s.pairs(), s.report()}; }

// The two ways agree on every pair and on every figure of the diagram.
void expect_same(int dim, const inputs::Points& points, std::uint32_t max_degree, bool keep_zero,
                 const netmesh_filter* filter = &netmesh_filter_alpha) {
    INFO("D = " << dim << ", " << points.size() / static_cast<std::size_t>(dim) << " points, degree " << max_degree);
    Session s(dim);
    netmesh::Request persist = persist_by(&netmesh_filter_alpha);
    persist.max_degree = max_degree;
    persist.keep_zero_pairs = keep_zero ? 1 : 0;
    s.reserve(std::size_t{1} << 26);
    REQUIRE(s.delaunay(points) == NETMESH_OK);
    REQUIRE(s.persist(persist) == NETMESH_OK);
    const Told two = told(s);
    netmesh::Request request = s.alpha_request(points);
    request.max_degree = max_degree;
    request.keep_zero_pairs = persist.keep_zero_pairs;
    request.filter = filter;
    REQUIRE(netmesh_persist(s.context, &request) == NETMESH_OK);
    const Told one = told(s);
    REQUIRE(one.pairs.size() == two.pairs.size());
    for (std::size_t i = 0; i < one.pairs.size(); ++i) {
        CHECK(one.pairs[i].degree == two.pairs[i].degree);
        CHECK(one.pairs[i].birth == two.pairs[i].birth);
        CHECK(one.pairs[i].death == two.pairs[i].death);
    }
    CHECK(one.report.diagram.simplices == two.report.diagram.simplices);
    CHECK(one.report.diagram.certified_ratio == 1);
    CHECK(one.report.diagram.max_degree == two.report.diagram.max_degree);
    CHECK(one.report.input.fingerprint == two.report.input.fingerprint);
    CHECK(one.report.input.duplicates == two.report.input.duplicates);
    CHECK(one.report.input.distinct == two.report.input.distinct);
    CHECK(one.report.mesh.present == 0);
    CHECK(one.report.simplicial_complex.present == 1);
    CHECK(one.report.simplicial_complex.vertices == two.report.input.distinct);
}

}  // namespace

TEST_CASE("the diagram is that of a triangulation that is kept") {
    for (const int dim : dimensions()) {
        const std::size_t n = by_dimension<std::size_t>(dim, {300, 200, 60, 25, 14});
        for (std::uint32_t degree = 0; degree <= static_cast<std::uint32_t>(dim); ++degree)
            expect_same(dim, inputs::uniform(dim, n), degree, degree == 1);
        expect_same(dim, inputs::grid(dim, dim < 4 ? 4 : 2), NETMESH_DIM_MAX, false);
        expect_same(dim, inputs::grid(dim, dim < 4 ? 4 : 2), NETMESH_DIM_MAX, true);
        expect_same(dim, inputs::repeated(dim, inputs::uniform(dim, n / 2), 2), NETMESH_DIM_MAX, false);
        expect_same(dim, inputs::clusters(dim, n), NETMESH_DIM_MAX, false);
        expect_same(dim, inputs::uniform(dim, static_cast<std::size_t>(dim) + 1), NETMESH_DIM_MAX, true);
        const inputs::Points grid = inputs::grid(dim, dim < 4 ? 4 : 2), sphere = inputs::shell(dim, n / 2, 1, 1, 9);
        expect_same(dim, families::moved(grid, 3), NETMESH_DIM_MAX, false);
        expect_same(dim, families::moved(grid, 3), NETMESH_DIM_MAX, true);
        expect_same(dim, families::moved(sphere, 2), NETMESH_DIM_MAX, false);
    }
}

// Where edges are marked by the triangles on both sides, tie or are shorter than half the least double; words of 16 and
// of 32 bits.
TEST_CASE("in the plane it lists the edges that have radii of their own") {
    families::Random random(17);
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        CAPTURE(seed);
        const bool zero = seed % 3 == 0;
        for (const families::Family& family : families::all()) {
            INFO(family.name);
            families::Points x = family.make(random, 2, 4 + static_cast<int>(seed));
            Session any(2);
            const netmesh::Request request = any.alpha_request(x);
            if (netmesh_persist(any.context, &request) == NETMESH_FLAT) continue;
            for (const netmesh_filter* filter : {&netmesh_filter_alpha, &netmesh_filter_alpha_small})
                expect_same(2, x, static_cast<std::uint32_t>(seed % 2), zero, filter);
        }
    }
    const std::size_t few = 8192;
    for (const std::size_t n : {few - 1, few, few + 1}) expect_same(2, inputs::uniform(2, n), 1, false);
    expect_same(2, inputs::uniform(2, few), 1, true, &netmesh_filter_alpha_small);
    expect_same(2, inputs::grid(2, 91), 1, true);
    inputs::Points twice = inputs::uniform(2, few);
    twice.insert(twice.end(), {twice[0], twice[1]});
    expect_same(2, twice, 1, false);
}

TEST_CASE("the small filter refuses what it has no code for") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Session s(dim);
        s.reserve(std::size_t{1} << 24);
        const inputs::Points points = inputs::uniform(dim, 20);
        const auto refuses = [&](netmesh::Request r, netmesh_field field) {
            r.filter = &netmesh_filter_alpha_small;
            CHECK(netmesh_persist(s.context, &r) == NETMESH_INVALID_ARGUMENT);
            CHECK(s.detail().field == field);
            CHECK(s.detail().message[0] != 0);
        };
        netmesh::Request r = s.alpha_request(points);
        r.filter = &netmesh_filter_alpha_small;
        CHECK(netmesh_persist(s.context, &r) == NETMESH_OK);
        CHECK(s.report().diagram.filter == NETMESH_FILTER_ALPHA);
        r.keep_mesh = 1;
        refuses(r, NETMESH_FIELD_KEEP_MESH);
        r.keep_mesh = 0;
        r.cycles = &netmesh_cycles;
        refuses(r, NETMESH_FIELD_CYCLES);
        r.cycles = nullptr;
        r.points.weights = points.data();
        r.weighting = &netmesh_weights;
        refuses(r, NETMESH_FIELD_WEIGHTING);
        REQUIRE(s.delaunay(points) == NETMESH_OK);
        refuses(persist_by(&netmesh_filter_alpha_small), NETMESH_FIELD_POINTS);
        const inputs::Points many = inputs::uniform(dim, 8193);
        r = s.alpha_request(many);
        if (dim == 2) refuses(r, NETMESH_FIELD_POINTS);
    }
}

TEST_CASE("it takes less memory than a triangulation that is kept") {
    for (const int dim : dimensions()) {
        const inputs::Points points = inputs::uniform(dim, by_dimension<std::size_t>(dim, {500, 500, 120, 50, 25}));
        Session two(dim), one(dim);
        two.reserve(std::size_t{1} << 26);
        one.reserve(std::size_t{1} << 26);
        REQUIRE(two.alpha(points) == NETMESH_OK);
        const netmesh::Request request = one.alpha_request(points);
        REQUIRE(netmesh_persist(one.context, &request) == NETMESH_OK);
        INFO("D = " << dim << ", " << one.report().memory.peak_bytes << " bytes, " << two.report().memory.peak_bytes);
        CHECK(static_cast<double>(one.report().memory.peak_bytes) <
              0.85 * static_cast<double>(two.report().memory.peak_bytes));
        if (dim == 2) CHECK(one.report().memory.peak_bytes <= 43 * 1024);
        if (dim == 3) CHECK(one.report().memory.peak_bytes <= 360 * 1024);
    }
}

// The same points a few least doubles apart: radii are rounded to multiples of that, ties to even, and a bar is there
// where its ends are different multiples.
TEST_CASE("radii next to the least double are those of a larger size, rounded") {
    std::size_t bars = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        inputs::Random random(seed);
        inputs::Points whole, tiny;
        for (std::size_t i = 0; i < 2 * (6 + 5 * (seed % 8)); ++i)
            whole.push_back(static_cast<double>(random.below(4 + 2 * (seed % 11))));
        for (const double x : whole) tiny.push_back(std::ldexp(x, -1074));
        Session exact(2), rounded(2);
        const netmesh::Request in_units = exact.alpha_request(whole), in_doubles = rounded.alpha_request(tiny);
        if (netmesh_persist(exact.context, &in_units) == NETMESH_FLAT) continue;
        REQUIRE(netmesh_persist(rounded.context, &in_doubles) == NETMESH_OK);
        std::vector<std::array<double, 3>> due, made;
        for (const netmesh_pair& pair : told(exact).pairs) {
            const double birth = std::nearbyint(pair.birth), death = std::nearbyint(pair.death);
            if (birth < death) due.push_back({double(pair.degree), birth, death});
        }
        for (const netmesh_pair& pair : told(rounded).pairs)
            made.push_back({double(pair.degree), std::ldexp(pair.birth, 1074), std::ldexp(pair.death, 1074)});
        std::sort(due.begin(), due.end());
        CHECK(made == due);
        bars += made.size();
    }
    CHECK(bars > 500);
}

// A circle: half of the cells are ghosts while points come, and a search lists all of them.
TEST_CASE("a block of the peak is enough") {
    for (const std::uint64_t n : {60, 963}) {
        inputs::Points circle;
        for (std::uint64_t i = 0; i < n; ++i) {
            const auto [c, s] = inputs::turn(i, n);
            circle.insert(circle.end(), {c, s});
        }
        for (const inputs::Points& points : {circle, inputs::uniform(2, n), inputs::grid(2, n < 100 ? 8 : 31)}) {
            CAPTURE(points.size());
            Session large(2), exact(2);
            const netmesh::Request request = large.alpha_request(points);
            REQUIRE(netmesh_persist(large.context, &request) == NETMESH_OK);
            exact.reserve(large.report().memory.peak_bytes + 16);
            CHECK(netmesh_persist(exact.context, &request) == NETMESH_OK);
            CHECK(exact.report().fingerprint == large.report().fingerprint);
            REQUIRE(large.delaunay(points) == NETMESH_OK);
            exact.reserve(large.report().memory.peak_bytes + 16);
            CHECK(exact.delaunay_in_block(points) == NETMESH_OK);
        }
    }
}

TEST_CASE("what cannot be done is said, and leaves an empty context") {
    for (const int dim : dimensions()) {
        Session s(dim);
        inputs::Points points = inputs::uniform(dim, 20);
        const auto run = [&] {
            const netmesh::Request request = s.alpha_request(points);
            return netmesh_persist(s.context, &request);
        };
        REQUIRE(run() == NETMESH_OK);
        points[7] = std::numeric_limits<double>::quiet_NaN();
        CHECK(run() == NETMESH_NOT_FINITE);
        CHECK(s.detail().index_a == 7 / static_cast<std::uint64_t>(dim));
        CHECK(s.report().input.present == 0);
        for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(dim)) points[i] = 1;
        points[7] = 0.25;
        if (7 % dim == 0) points[7] = 1;
        CHECK(run() == NETMESH_FLAT);
        CHECK(s.report().input.present == 0);
        netmesh::Request request = s.alpha_request(points);
        request.points.coordinates = nullptr;
        CHECK(netmesh_persist(s.context, &request) == NETMESH_INVALID_ARGUMENT);
        CHECK(s.detail().field == NETMESH_FIELD_POINTS);
        request = s.alpha_request(points);
        request.points.dim = 7;
        CHECK(netmesh_persist(s.context, &request) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_plan(&request) == 0);
        request.points.dim = static_cast<std::uint32_t>(dim);
        request.points.count = 0;
        CHECK(netmesh_plan(&request) == 0);
    }
}

TEST_CASE("its diagram has bounds by its ratio, and no representatives") {
    const int dim = dimensions().front();
    Session s(dim);
    const inputs::Points points = inputs::uniform(dim, 30);
    const netmesh::Request request = s.alpha_request(points);
    REQUIRE(s.persist(request) == NETMESH_OK);
    CHECK(s.represent() == NETMESH_NO_RESULT);
    REQUIRE(s.bound_bars() == NETMESH_OK);
    const std::vector<netmesh_pair> pairs = s.pairs();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        auto bounds = netmesh::sized<netmesh_bar_bounds>();
        REQUIRE(netmesh_get_bar_bounds(s.context, i, &bounds) == NETMESH_OK);
        CHECK(bounds.death_low <= pairs[i].death);
        CHECK(pairs[i].death <= bounds.death_high);
        if (pairs[i].death > 1.001 * pairs[i].birth) CHECK(bounds.certain == 1);
    }
}

// netmesh_init fills the context with zeros and constructs nothing.
TEST_CASE("every member of an empty context is 0") {
    alignas(16) static unsigned char bytes[sizeof(netmesh_context)];
    std::memset(bytes, 0, sizeof bytes);
    new (bytes) netmesh_context{};
    for (const unsigned char byte : bytes) REQUIRE(byte == 0);
}
