// d_k and the k-distance against sublevel sets on a fine grid (GUDHI's cubical complexes and bottleneck distance): the
// log-bottleneck distance is at most the logarithm of the certified ratio, but for what the grid is too coarse to tell.
#include <doctest/doctest.h>
#include <gudhi/Bottleneck.h>

#include <cmath>
#include <string>

#include "common/session.hpp"
#include "oracle/log_distance.hpp"
#include "oracle/sublevel_grid.hpp"

namespace {

void within_certificate(const std::string& name, int dim, const inputs::Points& points, std::size_t k, bool mean,
                        unsigned side) {
    CAPTURE(name);
    CAPTURE(k);
    Session session(dim);
    for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
        const netmesh_filter* const filter = mean ? &netmesh_filter_kdistance : &netmesh_filter_knn;
        REQUIRE(session.mesh_and_persist(points, persist_by(filter, static_cast<std::uint32_t>(k), values)) ==
                NETMESH_OK);
        const netmesh_report report = session.report();
        REQUIRE(report.diagram.k == k);
        const KDistance set = {&points, dim, k, mean};
        double least, doubt;
        // The domain's radius is that of the smallest enclosing ball, or a hair more.
        Diagram truth = on_grid(set, report.mesh.domain, report.mesh.domain[dim], side, &least, &doubt);
        Diagram ours;
        std::size_t essential = 0;
        for (const netmesh_pair& pair : session.pairs()) {
            if (std::isinf(pair.death)) ++essential;
            ours[pair.degree].push_back({pair.birth, pair.death});
        }
        CHECK(essential == 1);
        double distance = 0;
        for (std::uint32_t degree = 0; degree < static_cast<std::uint32_t>(dim); ++degree)
            distance = std::max(distance, gudhi_bottleneck(logarithms(truth[degree]), logarithms(ours[degree])));
        const double slack = std::log(1 + doubt / (least - doubt));
        REQUIRE(slack < 0.7);
        CHECK(distance <= std::log(report.diagram.certified_ratio) + slack);
        MESSAGE(name << std::string(mean ? " k-distance" : " d_k") << ", k = " << k
                     << std::string(values == NETMESH_VALUES_THESIS ? " thesis" : " certified")
                     << " values: true ratio " << std::exp(distance) << " (grid " << std::exp(slack) << "), certified "
                     << report.diagram.certified_ratio);
    }
}

}  // namespace

TEST_CASE("plane") {
    for (const bool mean : {false, true}) {
        within_certificate("uniform", 2, inputs::uniform(2, 40), 4, mean, 260);
        within_certificate("annulus", 2, inputs::shell(2, 80, 0.8, 1, 15), 5, mean, 260);
        within_certificate("grid", 2, inputs::grid(2, 5), 3, mean, 200);
        within_certificate("figure eight", 2, inputs::eight(60, 0.05, 16), 3, mean, 260);
    }
}

TEST_CASE("space") {
    for (const bool mean : {false, true}) {
        within_certificate("sphere", 3, inputs::shell(3, 50, 1, 1, 22), mean ? 10 : 4, mean, 60);
        within_certificate("uniform", 3, inputs::uniform(3, 30), mean ? 8 : 5, mean, 50);
    }
}

TEST_CASE("k = 1 is the complete filter") {
    const inputs::Points points = inputs::uniform(3, 80);
    Session complete(3), nearest(3), mean(3);
    REQUIRE(complete.mesh_and_persist(points) == NETMESH_OK);
    REQUIRE(nearest.mesh_and_persist(points, &netmesh_filter_knn) == NETMESH_OK);
    REQUIRE(mean.mesh_and_persist(points, &netmesh_filter_kdistance) == NETMESH_OK);
    CHECK(nearest.report().fingerprint == complete.report().fingerprint);
    CHECK(mean.report().fingerprint == complete.report().fingerprint);
}
