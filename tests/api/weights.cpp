// Points with weights through the C interface: refusals that depend on numbers, formats, what zero and equal weights
// give, hidden points, memory, stops. Values against rationals: tests/weights.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "common/inputs.hpp"
#include "common/kept.hpp"
#include "netmesh.hpp"

namespace {

using inputs::Points;
using kept::Bar;
using kept::bars_of;
using kept::Context;
using kept::hidden_of;
using kept::report_of;

netmesh::Request request_of(int dim, const Points& points, const Points& numbers,
                            const netmesh_weighting* what = &netmesh_radii) {
    netmesh::Request request(&netmesh_filter_alpha);
    request.set_points(static_cast<std::uint32_t>(dim), points).set_weights(what, numbers);
    return request;
}
Points radii_of(std::size_t n, double most, std::uint64_t seed = 9) {
    Points radii = inputs::uniform(1, n, seed);
    for (double& r : radii) r *= most;
    return radii;
}

constexpr std::size_t block = std::size_t(1) << 25;

}  // namespace

TEST_CASE("weights of 0 give the diagram without weights, to the last bit") {
    for (int dim = 2; dim <= 4; ++dim) {
        const Points points = inputs::uniform(dim, 300), zero(300, 0.0);
        Context plain(block), weighted(block);
        netmesh::Request without(&netmesh_filter_alpha);
        without.set_points(static_cast<std::uint32_t>(dim), points);
        REQUIRE(plain.engine.persist(without) == NETMESH_OK);
        for (const netmesh_weighting* what : {&netmesh_radii, &netmesh_weights}) {
            REQUIRE(weighted.engine.persist(request_of(dim, points, zero, what)) == NETMESH_OK);
            CHECK(report_of(weighted.engine).input.squares == 0);
            CHECK(bars_of(weighted.engine) == bars_of(plain.engine));
            CHECK(hidden_of(weighted.engine).empty());
        }
    }
}

TEST_CASE("equal radii r move a to a - r^2") {
    struct Case {
        int dim;
        std::size_t n;
    };
    // In the last one so many values are negative that they are sorted by buckets.
    for (const auto& [dim, n] : {Case{2, 200}, Case{3, 200}, Case{4, 200}, Case{3, 15000}}) {
        const Points points = inputs::uniform(dim, n), equal(n, 0.25);  // whose square is exact
        Context plain(block), weighted(block);
        netmesh::Request without(&netmesh_filter_alpha);
        without.set_points(static_cast<std::uint32_t>(dim), points);
        REQUIRE(plain.engine.persist(without) == NETMESH_OK);
        netmesh::Request with = request_of(dim, points, equal);
        with.squares = 1;
        REQUIRE(weighted.engine.persist(with) == NETMESH_OK);
        CHECK(report_of(weighted.engine).input.squares == 1);
        std::vector<Bar> was = bars_of(plain.engine), is = bars_of(weighted.engine);
        for (Bar& bar : was) {
            bar.birth = bar.birth * bar.birth - 0.0625;
            bar.death = bar.death * bar.death - 0.0625;
        }
        REQUIRE(is.size() == was.size());
        const auto before = [](const Bar& a, const Bar& b) {
            return a.degree != b.degree ? a.degree < b.degree
                   : a.birth != b.birth ? a.birth < b.birth
                                        : a.death < b.death;
        };
        std::sort(was.begin(), was.end(), before);
        std::sort(is.begin(), is.end(), before);
        // Radii are rounded once, to u r, and so their squares to 2 u r^2 and a little.
        const auto near = [](double a, double b) { return a == b || std::fabs(a - b) <= 1e-14; };
        std::size_t wrong = 0;
        for (std::size_t i = 0; i < is.size(); ++i)
            wrong +=
                is[i].degree != was[i].degree || !near(is[i].birth, was[i].birth) || !near(is[i].death, was[i].death);
        CHECK(wrong == 0);
    }
}

TEST_CASE("floats, rows apart, and another order of rows") {
    const Points points = inputs::uniform(3, 120), radii = radii_of(120, 0.2);
    std::vector<float> floats, rows;  // x y z r . of each point
    Points exact, numbers;
    for (std::size_t i = 0; i < 120; ++i) {
        for (std::size_t c = 0; c < 3; ++c) floats.push_back(static_cast<float>(points[3 * i + c]));
        floats.push_back(static_cast<float>(radii[i]));
        floats.push_back(std::numeric_limits<float>::quiet_NaN());
        for (std::size_t c = 0; c < 3; ++c) exact.push_back(static_cast<double>(floats[5 * i + c]));
        numbers.push_back(static_cast<double>(floats[5 * i + 3]));
    }
    Context a(block), b(block);
    REQUIRE(a.engine.persist(request_of(3, exact, numbers)) == NETMESH_OK);
    netmesh::Request apart(&netmesh_filter_alpha);
    apart.points.coordinates = floats.data();
    apart.points.count = 120;
    apart.points.dim = 3;
    apart.points.format = NETMESH_POINTS_FLOAT32;
    apart.points.stride_bytes = apart.points.weight_stride_bytes = 20;
    apart.points.weights = floats.data() + 3;
    apart.weighting = &netmesh_radii;
    REQUIRE(b.engine.persist(apart) == NETMESH_OK);
    CHECK(report_of(a.engine).fingerprint == report_of(b.engine).fingerprint);
    Points turned, turned_numbers(numbers.rbegin(), numbers.rend());
    for (std::size_t i = 120; i-- > 0;)
        turned.insert(turned.end(), exact.begin() + 3 * std::ptrdiff_t(i), exact.begin() + 3 * std::ptrdiff_t(i) + 3);
    REQUIRE(b.engine.persist(request_of(3, turned, turned_numbers)) == NETMESH_OK);
    CHECK(bars_of(a.engine) == bars_of(b.engine));
    std::vector<std::uint64_t> hidden = hidden_of(b.engine);
    CHECK(!hidden.empty());
    for (std::uint64_t& row : hidden) row = 119 - row;
    std::reverse(hidden.begin(), hidden.end());
    CHECK(hidden == hidden_of(a.engine));
}

TEST_CASE("one ball that hides all but the hull") {
    Points points = inputs::uniform(2, 500), radii(500, 0.0);
    points[0] = points[1] = 0.5;
    radii[0] = 100;
    Context c(block);
    netmesh::Request request = request_of(2, points, radii);
    request.keep_mesh = 1;
    REQUIRE(c.engine.persist(request) == NETMESH_OK);
    const netmesh_report report = report_of(c.engine);
    CHECK(report.input.hidden > 450);
    CHECK(report.input.hidden + report.input.distinct == 500);
    CHECK(report.mesh.vertices == report.input.distinct);
    CHECK(report.input.weighting == NETMESH_WEIGHTING_RADII);
    REQUIRE(!bars_of(c.engine).empty());
    CHECK(bars_of(c.engine)[0].birth == -100);
    // Everybody is a vertex of the hull's corners or hidden: cells are checked.
    auto check = netmesh::sized<netmesh_check_request>();
    CHECK(netmesh_check(c.engine.context(), &check) == NETMESH_INVALID_ARGUMENT);
    check.what = NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_GEOMETRIC;
    CHECK(netmesh_check(c.engine.context(), &check) == NETMESH_OK);
    // What there is not of it.
    netmesh::Request more(&netmesh_filter_alpha);
    CHECK(c.engine.persist(more) == NETMESH_NO_RESULT);
    more.filter = &netmesh_filter_complete;
    CHECK(c.engine.persist(more) == NETMESH_NO_RESULT);
}

TEST_CASE("auto takes alpha, and netmesh_mesh the triangulation alone") {
    const Points points = inputs::uniform(3, 200), radii = radii_of(200, 0.3);
    Context a(block), b(block);
    netmesh::Request request = request_of(3, points, radii);
    request.keep_mesh = 1;
    REQUIRE(a.engine.persist(request) == NETMESH_OK);
    request.keep_mesh = 0;
    request.filter = &netmesh_filter_auto;
    REQUIRE(b.engine.persist(request) == NETMESH_OK);
    CHECK(report_of(a.engine).fingerprint == report_of(b.engine).fingerprint);
    CHECK(report_of(a.engine).diagram.why == NETMESH_WHY_ASKED);
    CHECK(report_of(b.engine).diagram.why == NETMESH_WHY_ALONE);
    const netmesh_report whole = report_of(a.engine);
    request.filter = nullptr;
    request.mesh.method = &netmesh_method_delaunay;
    REQUIRE(b.engine.mesh(request) == NETMESH_OK);
    CHECK(report_of(b.engine).mesh.cells == whole.mesh.cells);
    CHECK(hidden_of(a.engine) == hidden_of(b.engine));
    request.mesh.method = &netmesh_method_svr;
    CHECK(b.engine.mesh(request) == NETMESH_INVALID_ARGUMENT);
    CHECK(b.engine.detail().field == NETMESH_FIELD_WEIGHTING);
}

TEST_CASE("numbers that are no weights") {
    const Points points = inputs::uniform(2, 50);
    for (const bool keep : {false, true}) {
        Context c(block);
        Points numbers(50, 1.0);
        netmesh::Request request = request_of(2, points, numbers);
        request.keep_mesh = keep;
        numbers[7] = -1;
        CHECK(c.engine.persist(request) == NETMESH_INVALID_ARGUMENT);
        CHECK(c.engine.detail().field == NETMESH_FIELD_WEIGHTS);
        CHECK(c.engine.detail().index_a == 7);
        request.weighting = &netmesh_weights;
        CHECK(c.engine.persist(request) == NETMESH_OK);
        for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
            numbers[7] = bad;
            CHECK(c.engine.persist(request) == NETMESH_NOT_FINITE);
            CHECK(c.engine.detail().index_a == 7);
        }
        request.points.weights = nullptr;
        CHECK(c.engine.persist(request) == NETMESH_INVALID_ARGUMENT);
        CHECK(c.engine.detail().field == NETMESH_FIELD_WEIGHTS);
        request.weighting = nullptr;
        request.squares = 1;
        CHECK(c.engine.persist(request) == NETMESH_INVALID_ARGUMENT);
        CHECK(c.engine.detail().field == NETMESH_FIELD_SQUARES);
        request.squares = 0;
        request.weighting = &netmesh_weights;
        request.points.weights = reinterpret_cast<const unsigned char*>(numbers.data()) + 1;
        CHECK(c.engine.persist(request) == NETMESH_INVALID_ARGUMENT);
        CHECK(c.engine.detail().field == NETMESH_FIELD_WEIGHTS);
    }
}

TEST_CASE("no bar is born at minus infinity") {
    const Points points = {0, 0, 1e200, 0, 0, 1e200, 3e200, 3e200};
    for (const bool keep : {false, true}) {
        Context c(block);
        Points radii = {0, 1e200, 0, 0};
        netmesh::Request request = request_of(2, points, radii);
        request.keep_mesh = keep;
        CHECK(c.engine.persist(request) == NETMESH_OK);
        request.squares = 1;
        CHECK(c.engine.persist(request) == NETMESH_INVALID_ARGUMENT);
        CHECK(c.engine.detail().field == NETMESH_FIELD_WEIGHTS);
        CHECK(c.engine.detail().index_a == 1);
        CHECK(bars_of(c.engine).empty());
        CHECK(report_of(c.engine).mesh.present == (keep ? 1 : 0));  // the triangulation is whole, and stays
        radii[1] = 0x1.fffffffffffffp511;                           // its square is a double
        CHECK(c.engine.persist(request) == NETMESH_OK);
        CHECK(bars_of(c.engine)[0].birth == -0x1.ffffffffffffep1023);
        radii[1] = 0x1p512;
        CHECK(c.engine.persist(request) == NETMESH_INVALID_ARGUMENT);
    }
}

TEST_CASE("every block: a diagram, or out of memory and a triangulation of what was inserted") {
    for (int dim = 2; dim <= 3; ++dim) {
        const Points points = inputs::uniform(dim, 60), radii = radii_of(60, 0.3);
        netmesh::Request request = request_of(dim, points, radii);
        Context whole(block);
        REQUIRE(whole.engine.persist(request) == NETMESH_OK);
        const std::vector<Bar> bars = bars_of(whole.engine);
        const std::vector<std::uint64_t> hidden = hidden_of(whole.engine);
        for (const bool keep : {false, true}) {
            request.keep_mesh = keep;
            REQUIRE(whole.engine.persist(request) == NETMESH_OK);
            const std::size_t enough = report_of(whole.engine).memory.peak_bytes;
            CHECK(netmesh_plan(&request) >= enough);
            int fitted = 0, parts = 0;
            for (std::size_t bytes = 4096; bytes < enough + 20000; bytes += 16 * (97 + 40 * keep)) {
                Context c(bytes);
                const netmesh_status status = c.engine.persist(request);
                if (status == NETMESH_OK) {
                    ++fitted;
                    CHECK(bars_of(c.engine) == bars);
                    CHECK(hidden_of(c.engine) == hidden);
                    continue;
                }
                REQUIRE(status == NETMESH_OUT_OF_MEMORY);
                if (report_of(c.engine).mesh.present == 0) continue;
                ++parts;
                // What is hidden stays so; points that were not come to are no hidden ones.
                const std::vector<std::uint64_t> by_then = hidden_of(c.engine);
                CHECK(std::includes(hidden.begin(), hidden.end(), by_then.begin(), by_then.end()));
                auto check = netmesh::sized<netmesh_check_request>();
                check.what = NETMESH_CHECK_COMBINATORIAL;
                const netmesh_status checked = netmesh_check(c.engine.context(), &check);
                CHECK((checked == NETMESH_OK || checked == NETMESH_OUT_OF_MEMORY));
            }
            CHECK(fitted > 0);
            CHECK((parts > 0) == keep);
        }
    }
}

TEST_CASE("every poll can stop it") {
    const Points points = inputs::uniform(3, 400), radii = radii_of(400, 0.1);
    netmesh::Request request = request_of(3, points, radii);
    request.keep_mesh = 1;
    Context c(block);
    kept::stop_at_every_poll(&c, request);
}
