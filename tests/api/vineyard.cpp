// Vineyards of d_k and the k-distance: every diagram is the one that netmesh_persist gives for its k.
#include <doctest/doctest.h>

#include <map>

#include "common/dimensions.hpp"
#include "common/session.hpp"

namespace {

void diagrams_equal_fresh_ones(int dim, const inputs::Points& points, std::uint32_t k_last,
                               std::uint32_t top = NETMESH_DIM_MAX) {
    if (dimensions({dim}).empty()) return;
    Session session(dim);
    top = std::min(top, static_cast<std::uint32_t>(dim) - 1);
    session.reserve(std::size_t{1} << 26);
    for (const netmesh_filter* const filter : {&netmesh_filter_knn, &netmesh_filter_kdistance})
        for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
            REQUIRE(session.mesh(points, &netmesh_filter_complete) == NETMESH_OK);
            netmesh::Request request(filter);
            request.k_last = k_last;
            request.values = values;
            request.max_degree = top;
            REQUIRE(session.vineyard(request) == NETMESH_OK);
            const netmesh_report report = session.report();
            CHECK(report.vineyard.present == 1);
            CHECK(report.diagram.present == 0);
            CHECK(report.vineyard.transpositions > 0);
            std::map<std::uint32_t, std::vector<netmesh_pair>> diagram;
            std::map<std::uint32_t, double> ratio;
            netmesh_vine_point last = {};
            for (const netmesh_vine_point& p : read_all(session.context, netmesh_get_vine_point)) {
                diagram[p.k].push_back(bar(p.degree, p.birth, p.death));
                if (last.k > 0)
                    CHECK((p.vine > last.vine || (p.vine == last.vine && p.k > last.k && p.degree == last.degree)));
                last = p;
            }
            CHECK(last.vine + 1 == report.vineyard.vines);
            for (std::uint32_t k = 1; k <= k_last; ++k)
                REQUIRE(netmesh_get_vine_ratio(session.context, k, &ratio[k]) == NETMESH_OK);
            CHECK(netmesh_get_vine_ratio(session.context, k_last + 1, &ratio[0]) == NETMESH_INVALID_ARGUMENT);
            for (std::uint32_t k = 1; k <= k_last; ++k) {
                netmesh::Request fresh_one = persist_by(filter, k, values);
                fresh_one.max_degree = top;
                REQUIRE(session.persist(fresh_one) == NETMESH_OK);
                CHECK(session.report().diagram.certified_ratio == ratio[k]);
                const auto before = [](const netmesh_pair& a, const netmesh_pair& b) {
                    if (a.degree != b.degree) return a.degree < b.degree;
                    return a.birth != b.birth ? a.birth < b.birth : a.death < b.death;
                };
                std::vector<netmesh_pair>& ours = diagram[k];
                std::sort(ours.begin(), ours.end(), before);
                const std::vector<netmesh_pair> fresh = session.pairs();
                REQUIRE(ours.size() == fresh.size());
                for (std::size_t i = 0; i < ours.size(); ++i) {
                    CHECK(ours[i].degree == fresh[i].degree);
                    CHECK(ours[i].birth == fresh[i].birth);
                    CHECK(ours[i].death == fresh[i].death);
                }
            }
        }
}

}  // namespace

TEST_CASE("each diagram equals a fresh one") {
    diagrams_equal_fresh_ones(2, inputs::uniform(2, 30), 8);
    diagrams_equal_fresh_ones(2, inputs::grid(2, 5), 4);
    diagrams_equal_fresh_ones(3, inputs::uniform(3, 8), 3);
    diagrams_equal_fresh_ones(4, inputs::uniform(4, 7), 4);
    diagrams_equal_fresh_ones(5, inputs::uniform(5, 7), 5, 1);
    diagrams_equal_fresh_ones(6, inputs::uniform(6, 8), 5, 1);
}

TEST_CASE("what a vineyard refuses") {
    Session session(2);
    const auto vineyard = [&](const netmesh_filter* filter, std::uint32_t first, std::uint32_t last) {
        return session.vineyard(filter, first, last);
    };
    CHECK(vineyard(&netmesh_filter_knn, 1, 2) == NETMESH_NO_RESULT);
    REQUIRE(session.mesh(inputs::uniform(2, 20), &netmesh_filter_complete) == NETMESH_OK);
    CHECK(vineyard(&netmesh_filter_complete, 1, 2) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_K);
    CHECK(vineyard(&netmesh_filter_complete, 0, 0) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_VINES);
    CHECK(vineyard(&netmesh_filter_knn, 3, 2) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_K_LAST);
    CHECK(vineyard(&netmesh_filter_knn, 1, 21) == NETMESH_INVALID_ARGUMENT);
    CHECK(session.detail().field == NETMESH_FIELD_K_LAST);
    auto point = netmesh::sized<netmesh_vine_point>();
    CHECK(netmesh_get_vine_point(session.context, 0, &point) == NETMESH_INVALID_ARGUMENT);
    REQUIRE(vineyard(&netmesh_filter_knn, 0, 2) == NETMESH_OK);  // from 1 on
    CHECK(session.report().vineyard.k_first == 1);
}

TEST_CASE("every size of memory: a status and a whole mesh, or the same vineyard") {
    Session session(2);
    const inputs::Points points = inputs::uniform(2, 12);
    REQUIRE(session.mesh(points, &netmesh_filter_complete) == NETMESH_OK);
    REQUIRE(session.vineyard(&netmesh_filter_knn, 1, 3) == NETMESH_OK);
    const std::uint64_t print = session.report().fingerprint, peak = session.report().memory.peak_bytes;
    int refused = 0;
    for (std::size_t bytes = peak / 8; bytes < peak + peak / 4; bytes += peak / 40) {
        Session small(2);
        small.reserve(bytes);
        netmesh_status status = small.mesh_in_block(points, &netmesh_filter_complete);
        if (status == NETMESH_OK) status = small.vineyard(&netmesh_filter_knn, 1, 3);
        if (status == NETMESH_OK) {
            CHECK(small.report().fingerprint == print);
            CHECK(bytes >= peak / 2);
        } else {
            ++refused;
            CHECK(status == NETMESH_OUT_OF_MEMORY);
            CHECK(small.report().vineyard.present == 0);
        }
    }
    CHECK(refused > 0);
}
