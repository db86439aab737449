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
        for (const netmesh_filter* const filter : {&netmesh_filter_barycentric_cech, &netmesh_filter_barycentric_rips})
            for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
                Session session(dim), alone(dim);
                netmesh::Request request = session.nested_request(points, filter, 4);
                request.k = 2;
                request.values = values;
                if (filter == &netmesh_filter_barycentric_cech && values == NETMESH_VALUES_THESIS) {  // it has one kind
                    CHECK(session.persist(request) == NETMESH_INVALID_ARGUMENT);
                    CHECK(session.detail().field == NETMESH_FIELD_VALUES);
                    continue;
                }
                REQUIRE(session.persist_until_it_fits(request) == NETMESH_OK);
                const netmesh_report report = session.report();
                CHECK(report.complete == 1);
                CHECK(report.input.points == 7);
                CHECK(report.input.dim == static_cast<std::uint32_t>(dim));
                CHECK(report.vineyard.present == 1);
                CHECK(report.diagram.present + report.mesh.present == 0);
                CHECK(report.simplicial_complex.present == 1);
                CHECK(report.simplicial_complex.vertices == 7);
                CHECK(filter_of(report.vineyard.filter) == filter);
                CHECK(report.vineyard.values == values);
                CHECK(report.vineyard.k_first == 2);
                CHECK(report.vineyard.k_last == 4);
                CHECK(report.vineyard.max_degree == 1);
                CHECK(report.vineyard.transpositions == 0);
                CHECK(report.vineyard.points == read_all(session.context, netmesh_get_vine_point).size());
                for (std::uint32_t k = 2; k <= 4; ++k) {
                    CAPTURE(k);
                    netmesh::Request one = alone.points_request(points, filter, k);
                    one.values = values;
                    REQUIRE(alone.persist_until_it_fits(one) == NETMESH_OK);
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
                REQUIRE(netmesh_persist(session.context, &request) == NETMESH_OK);
                CHECK(session.report().fingerprint == report.fingerprint);
                Session larger(dim);
                larger.reserve(std::size_t{1} << 23);
                REQUIRE(netmesh_persist(larger.context, &request) == NETMESH_OK);
                CHECK(larger.report().fingerprint == report.fingerprint);
                request.k = 3;
                REQUIRE(netmesh_persist(session.context, &request) == NETMESH_OK);
                CHECK(session.report().fingerprint != report.fingerprint);
            }
    }
}

TEST_CASE("nested sets for a range of k: equal points, too few, and none that are finite") {
    Session s(2);
    inputs::Points points = inputs::uniform(2, 5);
    points.insert(points.end(), {points[0], points[1]});
    netmesh::Request request = s.nested_request(points, &netmesh_filter_barycentric_rips, 5);
    REQUIRE(s.persist_until_it_fits(request) == NETMESH_OK);
    CHECK(s.report().input.duplicates == 1);
    CHECK(s.report().input.distinct == 5);
    request.k_last = 6;
    CHECK(netmesh_persist(s.context, &request) == NETMESH_INVALID_ARGUMENT);
    CHECK(s.detail().field == NETMESH_FIELD_K_LAST);
    CHECK(s.report().vineyard.present == 0);
    CHECK(s.report().input.present == 0);
    points[7] = std::numeric_limits<double>::quiet_NaN();
    request.k_last = 2;
    CHECK(netmesh_persist(s.context, &request) == NETMESH_NOT_FINITE);
    CHECK(s.detail().index_a == 3);
    double ratio;
    CHECK(netmesh_get_vine_ratio(s.context, 1, &ratio) == NETMESH_INVALID_ARGUMENT);
}
