// Fits that choose scales of interest so that bars are decided: what the interface admits, what is said of the result,
// and that more memory never decides less.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "common/dimensions.hpp"
#include "common/polls.hpp"
#include "common/session.hpp"

namespace {

netmesh::Request deciding(const inputs::Points& points, int dim, double longer_than, double ratio = 0) {
    netmesh::Request asked(&netmesh_filter_complete);
    asked.points.dim = static_cast<std::uint32_t>(dim);
    asked.goal.longer_than = longer_than;
    asked.goal.ratio = ratio;
    asked.bounds = &netmesh_bounds;
    asked.fit = &netmesh_fit;
    return on(points, asked);
}

// What the report says, recomputed from bars, bounds and goal; the mesh and the diagram are those of the goal.
netmesh_decision_report checked(const Session& session, const inputs::Points& points, double longer_than) {
    const netmesh_report report = session.report();
    const netmesh_decision_report decision = report.decision;
    CHECK(decision.present == 1);
    CHECK(decision.longer_than == longer_than);
    CHECK(decision.max_degree == report.diagram.max_degree);
    const std::vector<netmesh_pair> pairs = session.pairs();
    const std::vector<netmesh_bar_bounds> bounds = read_all(session.context, netmesh_get_bar_bounds);
    REQUIRE(bounds.size() == pairs.size());
    std::uint64_t undecided[NETMESH_DEGREE_MAX + 1] = {};
    double reach = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (bounds[i].certain == 1 || bounds[i].death_high < longer_than * bounds[i].birth_low * (1 - 1e-11)) continue;
        ++undecided[pairs[i].degree];
        reach = std::fmax(reach, bounds[i].death_high);
    }
    for (std::uint32_t degree = 0; degree <= decision.max_degree; ++degree)
        CHECK(decision.undecided[degree] == undecided[degree]);
    CHECK(decision.undecided_to == reach);
    CHECK(decision.decided_from >= reach);

    Session direct(static_cast<int>(report.input.dim));
    direct.request.goal = report.mesh.goal;
    direct.bounds = true;
    REQUIRE(direct.mesh_and_persist(points) == NETMESH_OK);
    CHECK(direct.report().fingerprint == report.fingerprint);
    CHECK(direct.report().decision.present == 0);
    for (int degree = 0; degree <= NETMESH_DEGREE_MAX; ++degree)
        CHECK(direct.report().bounds.certain[degree] == report.bounds.certain[degree]);
    CHECK(direct.check(NETMESH_CHECK_QUALITY) == NETMESH_OK);
    return decision;
}

inputs::Points figure_eight(std::size_t n) {
    inputs::Points points;
    for (std::size_t i = 0; i < n; ++i) {
        const auto [c, s] = inputs::turn(i, n);
        points.insert(points.end(), {s, s * c});
    }
    return points;
}

inputs::Points linked_circles(std::size_t n) {
    inputs::Points points;
    for (std::size_t i = 0; i < n; ++i) {
        const auto [c, s] = inputs::turn(i, n);
        points.insert(points.end(), {c, s, 0, 1 + c, 0, s});
    }
    return points;
}

}  // namespace

TEST_CASE("fits that decide bars: what makes no sense") {
    const inputs::Points points = inputs::uniform(2, 20);
    Session session(2);
    const auto refused = [&](const netmesh::Request& asked, netmesh_field field) {
        CHECK(netmesh_persist(session.context, &asked) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == field);
    };
    for (const double longer_than : {-1.0, 0.5, 1.0, HUGE_VAL, std::nan("")})
        refused(deciding(points, 2, longer_than), NETMESH_FIELD_LONGER_THAN);
    netmesh::Request asked = deciding(points, 2, 1.5);
    asked.goal.focus_from = 1;
    asked.goal.focus_to = 2;
    refused(asked, NETMESH_FIELD_FOCUS_FROM);
    for (const netmesh_filter* const filter : {&netmesh_filter_basic, &netmesh_filter_knn, &netmesh_filter_tight}) {
        asked = deciding(points, 2, 1.5);
        asked.filter = filter;
        refused(asked, NETMESH_FIELD_LONGER_THAN);
    }
    asked = deciding(points, 2, 1.5);
    asked.values = NETMESH_VALUES_THESIS;
    refused(asked, NETMESH_FIELD_LONGER_THAN);
    asked = deciding(points, 2, 1.5);
    asked.bounds = nullptr;
    refused(asked, NETMESH_FIELD_BOUNDS);
    asked = deciding(points, 2, 1.5);
    asked.fit = nullptr;
    refused(asked, NETMESH_FIELD_LONGER_THAN);
    asked = deciding(points, 2, 1.5, 1.4);
    refused(asked, NETMESH_FIELD_RATIO);
    asked = deciding(points, 2, 1.5);
    REQUIRE(netmesh_persist(session.context, &asked) == NETMESH_OK);
    CHECK(session.report().decision.present == 1);
    REQUIRE(session.persist() == NETMESH_OK);  // another diagram, of which nothing was decided
    CHECK(session.report().decision.present == 0);
}

TEST_CASE("where the coarsest mesh decides every bar no other is made") {
    const inputs::Points points = inputs::circle(40);
    Session session(2);
    session.reserve(std::size_t{1} << 22);
    const netmesh::Request asked = deciding(points, 2, 1.5, 2);
    REQUIRE(netmesh_persist(session.context, &asked) == NETMESH_OK);
    CHECK(checked(session, points, 1.5).undecided_to == 0);
    CHECK(session.report().mesh.goal.focus_ratio == 0);
    CHECK(session.report().bounds.certain[1] == 1);
}

TEST_CASE("both loops of a figure eight, a void of a sphere, linked circles, both circles of a torus") {
    const auto certain = [](int dim, const inputs::Points& points, std::size_t bytes, std::uint32_t degree) {
        Session session(dim);
        session.reserve(bytes);
        const netmesh::Request asked = deciding(points, dim, 1.5, 2);
        REQUIRE(netmesh_persist(session.context, &asked) == NETMESH_OK);
        CHECK(session.report().memory.peak_bytes <= bytes);
        CHECK(session.report().mesh.goal.ratio == 2);
        checked(session, points, 1.5);
        return session.report().bounds.certain[degree];
    };
    const std::size_t megabyte = std::size_t{1} << 20;
    CHECK(certain(2, figure_eight(60), megabyte, 1) == 2);
    CHECK(certain(3, inputs::shell(3, 150, 1, 1, 5), 4 * megabyte, 2) == 1);
    CHECK(certain(3, linked_circles(40), 4 * megabyte, 1) == 2);
    CHECK(certain(3, inputs::torus(400, 2), 16 * megabyte, 1) >= 2);
}

TEST_CASE("the curve on the Clifford torus: the 3-sphere around it is real, which the coarsest mesh does not tell") {
    if (dimensions({4}).empty()) return;
    const inputs::Points points = inputs::clifford(500);
    Session session(4);
    session.reserve(std::size_t{16} << 20);
    const netmesh::Request asked = deciding(points, 4, 1.5, 2.25);
    REQUIRE(netmesh_persist(session.context, &asked) == NETMESH_OK);
    const netmesh_decision_report decision = checked(session, points, 1.5);
    CHECK(session.report().bounds.certain[1] >= 2);
    CHECK(session.report().bounds.certain[3] == 1);
    CHECK(decision.undecided[3] == 0);
    CHECK(decision.decided_from < 1.4);  // the sphere dies at the root of 2
    Session coarse(4);
    coarse.bounds = true;
    coarse.request.goal.ratio = 2.25;
    REQUIRE(coarse.mesh_and_persist(points) == NETMESH_OK);
    CHECK(coarse.report().bounds.certain[3] == 0);
    CHECK(session.report().mesh.vertices < 2 * coarse.report().mesh.vertices);
}

TEST_CASE("more memory never decides less, and the block is kept to") {
    int improved = 0;
    for (std::uint64_t set = 0; set < 12; ++set) {
        CAPTURE(set);
        const int dim = set % 4 == 3 ? 3 : 2;
        const inputs::Points points =
            set % 3 == 0 ? inputs::shell(dim, 20 + 3 * set, 1, 1.4, set) : inputs::uniform(dim, 20 + 2 * set, 70 + set);
        const double longer_than = 1.2 + 0.2 * static_cast<double>(set % 2);
        double last = -1;
        std::uint64_t certain = 0;
        for (std::size_t bytes = 30000; bytes < 400000; bytes += bytes / 8) {
            CAPTURE(bytes);
            Session session(dim);
            session.reserve(bytes);
            const netmesh::Request asked = deciding(points, dim, longer_than, 2.5);
            const netmesh_status status = netmesh_persist(session.context, &asked);
            if (status == NETMESH_OUT_OF_MEMORY) {
                CHECK(last < 0);
                CHECK(session.report().diagram.present == 0);
                continue;
            }
            REQUIRE(status == NETMESH_OK);
            CHECK(session.report().memory.peak_bytes <= (bytes + 15) / 16 * 16);  // it is a multiple of the alignment
            const netmesh_decision_report decision = checked(session, points, longer_than);
            std::uint64_t now = 0;
            for (const std::uint64_t of_degree : session.report().bounds.certain) now += of_degree;
            const double from = decision.undecided_to > 0 ? decision.decided_from : 0;
            CHECK((last < 0 || from < last || (from == last && now >= certain)));
            improved += last >= 0 && from < last;
            last = from;
            certain = now;
        }
    }
    CHECK(improved > 12);
}

TEST_CASE("a fit that decides bars and is stopped leaves no diagram") {
    Polls polls;
    const inputs::Points points = inputs::uniform(2, 300);
    Session session(2);
    session.reserve(std::size_t{1} << 22);
    netmesh::Request asked = deciding(points, 2, 1.5);
    asked.monitor = polls.monitor();
    REQUIRE(netmesh_persist(session.context, &asked) == NETMESH_OK);
    const long all = polls.made;
    const std::uint64_t print = session.report().fingerprint;
    for (const long stop_at : {0L, all / 2, all - 1}) {
        polls = {0, stop_at};
        CHECK(netmesh_persist(session.context, &asked) == NETMESH_CANCELLED);
        CHECK(session.report().diagram.present == 0);
        CHECK(session.report().decision.present == 0);
    }
    polls = {};
    REQUIRE(netmesh_persist(session.context, &asked) == NETMESH_OK);
    CHECK(session.report().fingerprint == print);
}
