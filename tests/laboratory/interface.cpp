// The analysis through the C interface: reports, checks with planted violations, memory.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "common/arrays.hpp"
#include "common/dimensions.hpp"
#include "common/session.hpp"

namespace {

netmesh_analysis analysed(Session& session, std::uint32_t what = NETMESH_ANALYSE_ALL, double tolerance = 0) {
    netmesh_analysis a;
    REQUIRE(session.analyse(&a, what, tolerance) == NETMESH_OK);
    return a;
}

netmesh_status check_bounds(Session& session) { return session.check(NETMESH_CHECK_BOUNDS); }

}  // namespace

TEST_CASE("a mesh's size stands between its bounds, and checks include them") {
    for (const int dim : dimensions()) {
        INFO("D = " << dim);
        const std::size_t n = by_dimension<std::size_t>(dim, {200, 40, 12, 6, 4});
        Session session(dim);
        session.reserve(std::size_t{1} << 25);  // for the check as well
        REQUIRE(session.mesh(inputs::clusters(dim, n)) == NETMESH_OK);
        const netmesh_analysis a = analysed(session, NETMESH_ANALYSE_ALL, 40);
        const netmesh_report r = session.report();
        CHECK(a.what == NETMESH_ANALYSE_ALL);
        CHECK(a.size.vertices == r.mesh.inputs + r.mesh.steiner);
        CHECK(a.size.lower < static_cast<double>(a.size.vertices));
        CHECK(static_cast<double>(a.size.vertices) < a.size.upper);
        CHECK(a.size.radii[0] == r.mesh.domain[dim]);
        for (int k = 0; k < 3; ++k) CHECK(a.size.integral_lower[k] < a.size.integral_upper[k]);
        CHECK(a.fatness.bounded.cells <= a.size.vertices);
        CHECK(a.fatness.bounded.cells > 0);
        CHECK(a.structure.star_max > a.structure.degree_max - 1);
        CHECK(a.structure.ply_max >= a.structure.ply_mean);
        CHECK(a.structure.intersections_max >= a.structure.intersections_mean);
        CHECK(session.check() == NETMESH_OK);  // bounds included
        // The analysis changes nothing.
        CHECK(session.report().fingerprint == r.fingerprint);
        CHECK(analysed(session, NETMESH_ANALYSE_ALL, 40).fingerprint == a.fingerprint);
        const netmesh_analysis structure = analysed(session, NETMESH_ANALYSE_STRUCTURE);
        CHECK(structure.structure.present == 1);
        CHECK(structure.size.present == 0);
        CHECK(structure.size.vertices == 0);
    }
}

TEST_CASE("a wanted tolerance is reached on small inputs") {
    Session session(2);
    REQUIRE(session.mesh(inputs::uniform(2, 30)) == NETMESH_OK);
    double width = HUGE_VAL;
    for (double tolerance : {1.0, 0.2, 0.05}) {
        const netmesh_analysis a = analysed(session, NETMESH_ANALYSE_SIZE, tolerance);
        CHECK(a.size.integral_upper[0] / a.size.integral_lower[0] < 1 + 1.5 * tolerance);
        CHECK(a.size.integral_upper[0] - a.size.integral_lower[0] < width);
        width = a.size.integral_upper[0] - a.size.integral_lower[0];
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
    Arrays planted(session);
    planted.domain = Arrays(made).domain;
    REQUIRE(planted.load(session) == NETMESH_OK);
    CHECK(check_bounds(session) == NETMESH_CHECK_FAILED);
    CHECK(std::strstr(session.detail().message, "3.4.2") != nullptr);
}

TEST_CASE("planted: a mesh denser than the feature size allows") {
    Session session(2);
    session.request.mesh.sizes.eps = 0.02;
    REQUIRE(session.mesh(inputs::uniform(2, 12)) == NETMESH_OK);
    CHECK(check_bounds(session) == NETMESH_OK);
    session.request.mesh.sizes.eps = 0;
    CHECK(check_bounds(session) == NETMESH_CHECK_FAILED);
    CHECK(std::strstr(session.detail().message, "3.3.2") != nullptr);
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
    Session session(2);
    Arrays planted(2);
    planted.vertices = x;
    planted.markers.assign(1 + 3 * n, 0);
    planted.cells = cells;
    REQUIRE(planted.load(session) == NETMESH_OK);
    CHECK(session.check(NETMESH_CHECK_COMBINATORIAL) == NETMESH_OK);
    CHECK(check_bounds(session) == NETMESH_CHECK_FAILED);
    CHECK(std::strstr(session.detail().message, "5.") != nullptr);
    CHECK(analysed(session, NETMESH_ANALYSE_FATNESS).fatness.bounded.degree_max == 360);
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
    CHECK(*std::min_element(theta.begin(), theta.end()) == analysed(session, NETMESH_ANALYSE_SIZE, 10).size.theta);
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
    netmesh_analysis a;
    std::uint32_t order[40];
    CHECK(session.analyse(&a, 7, 0) == NETMESH_NO_RESULT);
    CHECK(netmesh_well_paced_order(session.context, order, nullptr) == NETMESH_NO_RESULT);
    REQUIRE(session.delaunay(inputs::uniform(2, 40)) == NETMESH_OK);
    CHECK(session.analyse(&a, NETMESH_ANALYSE_SIZE, 0) == NETMESH_NO_RESULT);
    CHECK(session.analyse(&a, 6, 0) == NETMESH_OK);
    CHECK(a.fatness.inside.cells == 0);
    CHECK(a.fatness.bounded.cells > 0);
    CHECK(session.analyse(&a, 0, 0) == NETMESH_NO_RESULT);  // all, of which the size is of a mesh
    CHECK(session.analyse(&a, 8, 0) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.analyse(&a, 6, -1) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.analyse(&a, 6, std::nan("")) == NETMESH_INVALID_ARGUMENT);
    auto request = netmesh::sized<netmesh_analyse_request>();
    request.what = 6;
    CHECK(netmesh_analyse(session.context, nullptr, &a) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_REQUEST);
    CHECK(netmesh_analyse(session.context, &request, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_RESULT);
    a.struct_bytes = 0;
    CHECK(netmesh_analyse(session.context, &request, &a) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_RESULT);
    request.struct_bytes = 0;
    CHECK(netmesh_analyse(session.context, &request, &a) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_STRUCT_BYTES);
}

TEST_CASE("any block that holds the mesh: the analysis fits or says so, and the mesh stays") {
    const inputs::Points points = inputs::uniform(2, 30);
    netmesh_analysis expected = {};
    int fits = 0, refused = 0;
    for (std::size_t bytes = std::size_t{1} << 20; bytes > 8192; bytes = bytes * 15 / 16) {
        Session session(2);
        session.reserve(bytes);
        if (session.mesh_in_block(points) != NETMESH_OK) continue;
        const std::uint64_t fingerprint = session.report().fingerprint;
        netmesh_analysis a;
        const netmesh_status status = session.analyse(&a, 7, 0.5);
        REQUIRE((status == NETMESH_OK || status == NETMESH_OUT_OF_MEMORY));
        CHECK(session.report().fingerprint == fingerprint);
        if (status == NETMESH_OUT_OF_MEMORY) {
            CHECK(session.detail().bytes_wanted > bytes);
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
    session.request.monitor.poll = [](void*, const netmesh_progress* progress) {
        return static_cast<int>(progress->stage == NETMESH_STAGE_ANALYSE);
    };
    netmesh_analysis a;
    CHECK(session.analyse(&a, 7, 0) == NETMESH_CANCELLED);
    session.request.monitor = {};
    CHECK(session.check() == NETMESH_OK);
}

TEST_CASE("every Voronoi cell and every D-ball through the interface") {
    for (const int dim : dimensions()) {
        INFO("D = " << dim);
        if (dim > 4) continue;
        for (const bool meshed : {true, false}) {
            Session session(dim);
            session.request.mesh.method = &netmesh_method_netmesh;
            const inputs::Points points = meshed ? inputs::geometric(dim, 100, 4) : inputs::uniform(dim, 25);
            REQUIRE((meshed ? session.mesh(points) : session.delaunay(points)) == NETMESH_OK);
            const netmesh_report r = session.report();
            const netmesh_analysis a = analysed(session, NETMESH_ANALYSE_STRUCTURE | NETMESH_ANALYSE_FATNESS);
            // Elements larger than this library's struct: the rest is 0.
            struct Wider {
                netmesh_voronoi known;
                std::uint64_t beyond;
            };
            std::vector<Wider> cells(r.mesh.vertices);
            std::memset(cells.data(), 0xAA, cells.size() * sizeof(Wider));
            cells[0].known.struct_bytes = sizeof(Wider);
            REQUIRE(netmesh_measure_voronoi(session.context, &cells[0].known) == NETMESH_OK);
            std::vector<netmesh_ball> balls(r.mesh.cells);
            balls[0].struct_bytes = sizeof(netmesh_ball);
            REQUIRE(netmesh_measure_balls(session.context, balls.data()) == NETMESH_OK);
            std::vector<double> ratios(r.mesh.vertices);
            std::vector<std::uint32_t> domains(r.mesh.vertices);
            REQUIRE(netmesh_measure_cells(session.context, ratios.data(), domains.data()) == NETMESH_OK);
            std::vector<std::vector<std::uint64_t>> star(r.mesh.vertices);
            std::vector<bool> hull(r.mesh.vertices, false);
            std::uint64_t meets_max = 0, hull_meets_max = 0;
            for (std::uint64_t c = 0; c < r.mesh.cells; ++c) {
                netmesh_cell cell = netmesh::sized<netmesh_cell>();
                REQUIRE(netmesh_get_cell(session.context, c, &cell) == NETMESH_OK);
                for (int i = 0; i <= dim; ++i) {
                    star[cell.vertices[i]].push_back(c);
                    for (int j = 0; j <= dim; ++j)
                        if (i != j && cell.neighbours[i] == NETMESH_NONE) hull[cell.vertices[j]] = true;
                }
            }
            const auto point = [&](std::uint64_t v) {
                netmesh_vertex vertex = netmesh::sized<netmesh_vertex>();
                REQUIRE(netmesh_get_vertex(session.context, v, &vertex) == NETMESH_OK);
                return std::vector<double>(vertex.coordinates, vertex.coordinates + dim);
            };
            const auto apart = [&](const double* x, const double* y) {
                double d2 = 0;
                for (int k = 0; k < dim; ++k) d2 += (x[k] - y[k]) * (x[k] - y[k]);
                return std::sqrt(d2);
            };
            for (std::uint64_t c = 0; c < r.mesh.cells; ++c) {
                netmesh_cell cell = netmesh::sized<netmesh_cell>();
                REQUIRE(netmesh_get_cell(session.context, c, &cell) == NETMESH_OK);
                std::vector<double> middle(static_cast<std::size_t>(dim), 0.0);
                bool boundary = false;
                for (int i = 0; i <= dim; ++i) {
                    const std::vector<double> p = point(cell.vertices[i]);
                    for (std::size_t k = 0; k < p.size(); ++k) middle[k] += p[k] / (dim + 1);
                    CHECK(apart(p.data(), balls[c].ball) == doctest::Approx(balls[c].ball[dim]).epsilon(1e-6));
                    boundary = boundary || (meshed && hull[cell.vertices[i]]);
                }
                std::uint32_t least[2] = {}, most[2] = {};  // what touches within rounding may count either way
                for (std::uint64_t b = 0; b < r.mesh.cells; ++b) {
                    const double r1 = balls[c].ball[dim], r2 = balls[b].ball[dim];
                    const double in = apart(middle.data(), balls[b].ball), d = apart(balls[c].ball, balls[b].ball);
                    least[0] += in < r2 * (1 - 1e-9);
                    most[0] += in < r2 * (1 + 1e-9);
                    least[1] += b != c && d < (r1 + r2) * (1 - 1e-9);
                    most[1] += b != c && d < (r1 + r2) * (1 + 1e-9);
                }
                CHECK(least[0] <= balls[c].ply);
                CHECK(balls[c].ply <= most[0]);
                CHECK(least[1] <= balls[c].meets);
                CHECK(balls[c].meets <= most[1]);
                (boundary ? hull_meets_max : meets_max) =
                    std::max<std::uint64_t>(boundary ? hull_meets_max : meets_max, balls[c].meets);
            }
            CHECK(a.structure.intersections_max == meets_max);
            CHECK(a.boundary.intersections_max == hull_meets_max);
            CHECK(a.structure.balls + a.boundary.balls == r.mesh.cells);
            CHECK(a.structure.balls_stride == 1);
            double beta_max = 0;
            for (std::uint64_t v = 0; v < r.mesh.vertices; ++v) {
                const netmesh_voronoi& cell = cells[v].known;
                CHECK(cell.struct_bytes == sizeof(Wider));
                CHECK(cells[v].beyond == 0);
                CHECK(cell.corners == star[v].size());
                CHECK(cell.bounded == !hull[v]);
                double reach = 0, nearest = HUGE_VAL;
                for (const std::uint64_t c : star[v]) reach = std::max(reach, apart(balls[c].ball, point(v).data()));
                for (std::uint64_t w = 0; w < r.mesh.vertices; ++w)
                    if (w != v) nearest = std::min(nearest, apart(point(w).data(), point(v).data()));
                CHECK(cell.nearest == doctest::Approx(nearest));
                if (cell.piece == 0) CHECK(cell.reach == doctest::Approx(reach).epsilon(1e-6));
                CHECK(cell.beta * cell.in_ball[dim] == doctest::Approx(cell.out_ball[dim]).epsilon(1e-9));
                beta_max = std::max(beta_max, cell.beta);
                if (meshed) continue;
                CHECK(domains[v] == NETMESH_NONE);
                if (hull[v])
                    CHECK(ratios[v] == HUGE_VAL);
                else
                    CHECK(ratios[v] == doctest::Approx(2 * reach / nearest).epsilon(1e-6));
            }
            CHECK(a.all_cells.cells.beta_max == doctest::Approx(beta_max).epsilon(1e-9));
            CHECK(a.all_cells.cells.cells == r.mesh.vertices);
            CHECK(a.all_cells.left_out == 0);
        }
    }
}

TEST_CASE("cells and balls: arguments") {
    Session session(2);
    netmesh_voronoi cell = netmesh::sized<netmesh_voronoi>();
    netmesh_ball ball = netmesh::sized<netmesh_ball>();
    CHECK(netmesh_measure_voronoi(session.context, &cell) == NETMESH_NO_RESULT);
    CHECK(netmesh_measure_balls(session.context, &ball) == NETMESH_NO_RESULT);
    CHECK(netmesh_measure_voronoi(nullptr, &cell) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_measure_balls(nullptr, &ball) == NETMESH_INVALID_ARGUMENT);
    for (const bool sized : {false, true}) {
        cell.struct_bytes = ball.struct_bytes = 0;
        CHECK(netmesh_measure_voronoi(session.context, sized ? &cell : nullptr) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == NETMESH_FIELD_RESULT);
        CHECK(netmesh_measure_balls(session.context, sized ? &ball : nullptr) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == NETMESH_FIELD_RESULT);
    }
}
