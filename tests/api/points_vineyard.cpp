// Vineyards over k of nested sets of points, through the interface: what a context then holds and reports.
#include <doctest/doctest.h>

#include "common/dimensions.hpp"
#include "common/session.hpp"

namespace {

std::vector<netmesh_pair> diagram_at(const Session& session, std::uint32_t k) {
    std::vector<netmesh_pair> diagram;
    for (const netmesh_vine_point& p : read_all(session.context, netmesh_get_vine_point))
        if (p.k == k) diagram.push_back(bar(p.degree, p.birth, p.death));
    std::sort(diagram.begin(), diagram.end(), [](const netmesh_pair& a, const netmesh_pair& b) {
        if (a.degree != b.degree) return a.degree < b.degree;
        return a.birth != b.birth ? a.birth < b.birth : a.death < b.death;
    });
    return diagram;
}

}  // namespace

TEST_CASE("nested sets for a range of k: diagrams, ratios and report are those of single runs") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        const inputs::Points points = inputs::uniform(dim, 7);
        for (const netmesh_filter filter : {NETMESH_FILTER_BARYCENTRIC_CECH, NETMESH_FILTER_BARYCENTRIC_RIPS})
            for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
                Session session(dim), alone(dim);
                netmesh_points_vineyard_request request = session.nested_request(points, filter, 4);
                request.k_first = 2;
                request.values = values;
                REQUIRE(session.nested(request) == NETMESH_OK);
                const netmesh_report report = session.report();
                CHECK(report.complete == 1);
                CHECK(report.input.points == 7);
                CHECK(report.input.dim == static_cast<std::uint32_t>(dim));
                CHECK(report.vineyard.present == 1);
                CHECK(report.diagram.present + report.mesh.present == 0);
                CHECK(report.simplicial_complex.present == 1);
                CHECK(report.simplicial_complex.vertices == 7);
                CHECK(report.vineyard.filter == filter);
                CHECK(report.vineyard.values == values);
                CHECK(report.vineyard.k_first == 2);
                CHECK(report.vineyard.k_last == 4);
                CHECK(report.vineyard.max_degree == 1);
                CHECK(report.vineyard.transpositions == 0);
                CHECK(report.vineyard.points == read_all(session.context, netmesh_get_vine_point).size());
                for (std::uint32_t k = 2; k <= 4; ++k) {
                    CAPTURE(k);
                    netmesh_points_request one = alone.points_request(points, filter, k);
                    one.values = values;
                    REQUIRE(alone.points(one) == NETMESH_OK);
                    const netmesh_report single = alone.report();
                    CHECK(single.input.fingerprint == report.input.fingerprint);
                    double ratio = 0;
                    REQUIRE(netmesh_get_vine_ratio(session.context, k, &ratio) == NETMESH_OK);
                    CHECK(ratio == single.diagram.certified_ratio);
                    CHECK(report.vineyard.certified_ratio == ratio);
                    CHECK(report.vineyard.simplices > single.diagram.simplices);
                    const std::vector<netmesh_pair> have = diagram_at(session, k), due = alone.pairs();
                    REQUIRE(have.size() == due.size());
                    for (std::size_t i = 0; i < due.size(); ++i) {
                        CHECK(have[i].degree == due[i].degree);
                        CHECK(have[i].birth == due[i].birth);
                        CHECK(have[i].death == due[i].death);
                    }
                }
                // Once more in the same block, and in a larger one.
                REQUIRE(netmesh_points_vineyard(session.context, &request) == NETMESH_OK);
                CHECK(session.report().fingerprint == report.fingerprint);
                Session larger(dim);
                larger.reserve(std::size_t{1} << 23);
                REQUIRE(netmesh_points_vineyard(larger.context, &request) == NETMESH_OK);
                CHECK(larger.report().fingerprint == report.fingerprint);
                request.k_first = 3;
                REQUIRE(netmesh_points_vineyard(session.context, &request) == NETMESH_OK);
                CHECK(session.report().fingerprint != report.fingerprint);
            }
    }
}

TEST_CASE("nested sets for a range of k: equal points, too few, and none that are finite") {
    Session s(2);
    inputs::Points points = inputs::uniform(2, 5);
    points.insert(points.end(), {points[0], points[1]});
    netmesh_points_vineyard_request request = s.nested_request(points, NETMESH_FILTER_BARYCENTRIC_RIPS, 5);
    REQUIRE(s.nested(request) == NETMESH_OK);
    CHECK(s.report().input.duplicates == 1);
    CHECK(s.report().input.distinct == 5);
    request.k_last = 6;
    CHECK(netmesh_points_vineyard(s.context, &request) == NETMESH_INVALID_ARGUMENT);
    CHECK(s.detail().field == NETMESH_FIELD_K_LAST);
    CHECK(s.report().vineyard.present == 0);
    CHECK(s.report().input.present == 0);
    points[7] = std::numeric_limits<double>::quiet_NaN();
    request.k_last = 2;
    CHECK(netmesh_points_vineyard(s.context, &request) == NETMESH_NOT_FINITE);
    CHECK(s.detail().index_a == 3);
    double ratio;
    CHECK(netmesh_get_vine_ratio(s.context, 1, &ratio) == NETMESH_INVALID_ARGUMENT);
}
