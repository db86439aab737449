// The analysis through the C interface: reports, checks with planted violations, memory.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "common/session.hpp"

namespace {

netmesh_analysis analysed(Session& session, std::uint32_t what = NETMESH_ANALYSE_ALL, double tolerance = 0) {
    netmesh_analysis a = {};
    a.struct_bytes = sizeof a;
    REQUIRE(netmesh_analyse(session.context, what, tolerance, &session.options, &a) == NETMESH_OK);
    return a;
}

netmesh_status check_bounds(Session& session) {
    return netmesh_check(session.context, NETMESH_CHECK_BOUNDS, &session.options);
}

}  // namespace

TEST_CASE("a mesh's size stands between its bounds, and checks include them") {
    for (int dim = 2; dim <= 6; ++dim) {
        INFO("D = " << dim);
        const std::size_t n[] = {0, 0, 300, 80, 25, 10, 6};
        Session session(dim);
        session.reserve(std::size_t{1} << 25);  // for the check as well
        REQUIRE(session.mesh(inputs::clusters(dim, n[dim])) == NETMESH_OK);
        const netmesh_analysis a = analysed(session, NETMESH_ANALYSE_ALL, 40);
        const netmesh_report r = session.report();
        CHECK(a.what == NETMESH_ANALYSE_ALL);
        CHECK(a.size == r.inputs + r.steiner);
        CHECK(a.size_lower < static_cast<double>(a.size));
        CHECK(static_cast<double>(a.size) < a.size_upper);
        CHECK(a.radius[0] == r.domain[dim]);
        for (int k = 0; k < 3; ++k) CHECK(a.integral_lower[k] < a.integral_upper[k]);
        CHECK(a.bounded.cells <= a.size);
        CHECK(a.bounded.cells > 0);
        CHECK(a.star_max > a.degree_max - 1);
        CHECK(a.ply_max >= a.ply_mean);
        CHECK(a.intersections_max >= a.intersections_mean);
        CHECK(session.check() == NETMESH_OK);
        CHECK(check_bounds(session) == NETMESH_OK);
        // The analysis changes nothing.
        CHECK(session.report().fingerprint == r.fingerprint);
        CHECK(analysed(session, NETMESH_ANALYSE_ALL, 40).fingerprint == a.fingerprint);
        CHECK(analysed(session, NETMESH_ANALYSE_STRUCTURE).size == 0);
    }
}

TEST_CASE("a wanted tolerance is reached on small inputs") {
    Session session(2);
    REQUIRE(session.mesh(inputs::uniform(2, 30)) == NETMESH_OK);
    double width = HUGE_VAL;
    for (double tolerance : {1.0, 0.2, 0.05}) {
        const netmesh_analysis a = analysed(session, NETMESH_ANALYSE_SIZE, tolerance);
        CHECK(a.integral_upper[0] / a.integral_lower[0] < 1 + 1.5 * tolerance);
        CHECK(a.integral_upper[0] - a.integral_lower[0] < width);
        width = a.integral_upper[0] - a.integral_lower[0];
    }
}

TEST_CASE("planted: a mesh without Steiner points, far from quality") {
    // Pairs at 1e-9 need vertices at all scales between.
    inputs::Points points;
    for (int i = 0; i < 5; ++i) {
        const double x[2] = {0.3 * i + 0.01 * i * i, 0.7 * (i % 2)};
        points.insert(points.end(), {x[0], x[1], x[0] + 1e-9, x[1]});
    }
    Session made(2);
    REQUIRE(made.mesh(points) == NETMESH_OK);
    CHECK(check_bounds(made) == NETMESH_OK);
    Session session(2);
    REQUIRE(session.delaunay(points) == NETMESH_OK);
    std::vector<std::uint32_t> cells;
    netmesh_cell cell;
    for (std::uint64_t c = 0; netmesh_get_cell(session.context, c, &cell) == NETMESH_OK; ++c)
        cells.insert(cells.end(), cell.vertices, cell.vertices + 3);
    const std::vector<std::uint8_t> markers(10, 0);
    const netmesh_report r = made.report();
    const double domain[3] = {r.domain[0], r.domain[1], r.domain[2]};
    REQUIRE(netmesh_load(session.context, points.data(), markers.data(), 10, cells.data(), cells.size() / 3, domain,
                         &session.options) == NETMESH_OK);
    CHECK(check_bounds(session) == NETMESH_CHECK_FAILED);
    CHECK(std::strstr(netmesh_get_detail(session.context).message, "3.4.2") != nullptr);
}

TEST_CASE("planted: a mesh denser than the feature size allows") {
    Session session(2);
    session.options.over_refine_eps = 0.02;
    REQUIRE(session.mesh(inputs::uniform(2, 12)) == NETMESH_OK);
    CHECK(check_bounds(session) == NETMESH_OK);
    session.options.over_refine_eps = 0;
    CHECK(check_bounds(session) == NETMESH_CHECK_FAILED);
    CHECK(std::strstr(netmesh_get_detail(session.context).message, "3.3.2") != nullptr);
}

TEST_CASE("planted: a staircase of fat cells about one vertex") {
    // Three rings that wind 60 times about a centre before they close: each cell is fat, the centre has 360 neighbours.
    const int n = 360;
    std::vector<double> x = {0, 0};
    for (double radius : {1.0, 2.0, 3.0})
        for (int i = 0; i < n; ++i) {
            const auto [c, s] = inputs::turn(static_cast<std::uint64_t>(i), 6);
            x.push_back((radius + 1e-6 * i) * c);
            x.push_back((radius + 1e-6 * i) * s);
        }
    std::vector<std::uint32_t> cells;
    const auto ring = [&](int k, int i) { return static_cast<std::uint32_t>(1 + k * n + (i + n) % n); };
    for (int i = 0; i < n; ++i) {
        cells.insert(cells.end(), {0, ring(0, i), ring(0, i + 1)});
        for (int k = 0; k < 2; ++k) {
            cells.insert(cells.end(), {ring(k, i), ring(k + 1, i), ring(k + 1, i + 1)});
            cells.insert(cells.end(), {ring(k, i), ring(k + 1, i + 1), ring(k, i + 1)});
        }
    }
    const std::vector<std::uint8_t> markers(1 + 3 * n, 0);
    Session session(2);
    REQUIRE(netmesh_load(session.context, x.data(), markers.data(), 1 + 3 * n, cells.data(), cells.size() / 3, nullptr,
                         &session.options) == NETMESH_OK);
    CHECK(netmesh_check(session.context, NETMESH_CHECK_COMBINATORIAL, &session.options) == NETMESH_OK);
    CHECK(check_bounds(session) == NETMESH_CHECK_FAILED);
    CHECK(std::strstr(netmesh_get_detail(session.context).message, "5.") != nullptr);
    CHECK(analysed(session, NETMESH_ANALYSE_FATNESS).bounded.degree_max == 360);
}

TEST_CASE("well-paced orderings and paces of given ones") {
    Session session(3);
    const std::uint32_t n = 80;
    REQUIRE(session.mesh(inputs::clusters(3, n)) == NETMESH_OK);
    std::vector<std::uint32_t> order(n);
    std::vector<double> theta(n), again(n);
    REQUIRE(netmesh_well_paced_order(session.context, order.data(), theta.data()) == NETMESH_OK);
    REQUIRE(netmesh_pace(session.context, order.data(), again.data()) == NETMESH_OK);
    CHECK(theta == again);
    CHECK(*std::min_element(theta.begin(), theta.end()) == analysed(session, NETMESH_ANALYSE_SIZE, 10).theta);
    CHECK(netmesh_well_paced_order(session.context, order.data(), nullptr) == NETMESH_OK);
    order[5] = order[6];
    CHECK(netmesh_pace(session.context, order.data(), again.data()) == NETMESH_INVALID_ARGUMENT);
    order[5] = n;
    CHECK(netmesh_pace(session.context, order.data(), again.data()) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_pace(session.context, nullptr, again.data()) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_pace(session.context, order.data(), nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_well_paced_order(session.context, nullptr, theta.data()) == NETMESH_INVALID_ARGUMENT);
}

TEST_CASE("arguments") {
    Session session(2);
    netmesh_analysis a = {};
    a.struct_bytes = sizeof a;
    std::uint32_t order[40];
    CHECK(netmesh_analyse(session.context, 7, 0, &session.options, &a) == NETMESH_NO_RESULT);
    CHECK(netmesh_well_paced_order(session.context, order, nullptr) == NETMESH_NO_RESULT);
    REQUIRE(session.delaunay(inputs::uniform(2, 40)) == NETMESH_OK);
    CHECK(netmesh_analyse(session.context, NETMESH_ANALYSE_SIZE, 0, &session.options, &a) == NETMESH_NO_RESULT);
    CHECK(netmesh_analyse(session.context, 6, 0, &session.options, &a) == NETMESH_OK);
    CHECK(a.inside.cells == 0);
    CHECK(a.bounded.cells > 0);
    CHECK(netmesh_analyse(session.context, 0, 0, &session.options, &a) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_analyse(session.context, 8, 0, &session.options, &a) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_analyse(session.context, 6, -1, &session.options, &a) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_analyse(session.context, 6, std::nan(""), &session.options, &a) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_analyse(session.context, 6, 0, nullptr, &a) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_analyse(session.context, 6, 0, &session.options, nullptr) == NETMESH_INVALID_ARGUMENT);
    a.struct_bytes = 4;
    CHECK(netmesh_analyse(session.context, 6, 0, &session.options, &a) == NETMESH_INVALID_ARGUMENT);
}

TEST_CASE("any block that holds the mesh: the analysis fits or says so, and the mesh stays") {
    const inputs::Points points = inputs::uniform(2, 30);
    netmesh_analysis expected = {};
    int fits = 0, refused = 0;
    for (std::size_t bytes = std::size_t{1} << 20; bytes > 8192; bytes = bytes * 15 / 16) {
        Session session(2);
        session.reserve(bytes);
        if (netmesh_mesh(session.context, points.data(), 30, NETMESH_JOB_MESH, &session.options) != NETMESH_OK)
            continue;
        const std::uint64_t fingerprint = session.report().fingerprint;
        netmesh_analysis a = {};
        a.struct_bytes = sizeof a;
        const netmesh_status status = netmesh_analyse(session.context, 7, 0.5, &session.options, &a);
        REQUIRE((status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY));
        CHECK(session.report().fingerprint == fingerprint);
        if (status == NETMESH_OUT_OF_MEMORY) {
            CHECK(netmesh_get_detail(session.context).bytes_wanted > bytes);
            ++refused;
            continue;
        }
        if (fits++ == 0) expected = a;
        CHECK(a.fingerprint == expected.fingerprint);
    }
    CHECK(fits > 5);
    CHECK(refused > 5);
}

TEST_CASE("an analysis can be cancelled") {
    Session session(3);
    REQUIRE(session.mesh(inputs::uniform(3, 300)) == NETMESH_OK);
    session.options.poll = [](void*, const netmesh_progress* progress) {
        return static_cast<int>(progress->stage == NETMESH_STAGE_ANALYSE);
    };
    netmesh_analysis a = {};
    a.struct_bytes = sizeof a;
    CHECK(netmesh_analyse(session.context, 7, 0, &session.options, &a) == NETMESH_CANCELLED);
    session.options.poll = nullptr;
    CHECK(session.check() == NETMESH_OK);
}
