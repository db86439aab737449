// Bounds of single bars: what the interface says, and that the exact filter's are the bars themselves.
#include <doctest/doctest.h>

#include <cmath>

#include "common/session.hpp"

TEST_CASE("bounds of bars") {
    Session session(2);
    const inputs::Points points = inputs::uniform(2, 50);
    netmesh_bar_bounds b;
    CHECK(netmesh_bound_bars(session.context, &session.options) == NETMESH_NO_RESULT);
    CHECK(netmesh_get_bar_bounds(session.context, 0, &b) == NETMESH_INVALID_ARGUMENT);
    REQUIRE(session.mesh_and_persist(points, NETMESH_FILTER_BASIC) == NETMESH_OK);
    CHECK(netmesh_bound_bars(session.context, &session.options) == NETMESH_NO_RESULT);

    REQUIRE(session.alpha(points) == NETMESH_OK);
    REQUIRE(netmesh_bound_bars(session.context, &session.options) == NETMESH_OK);
    const std::vector<netmesh_pair> exact = session.pairs();
    for (std::size_t i = 0; i < exact.size(); ++i) {
        REQUIRE(netmesh_get_bar_bounds(session.context, i, &b) == NETMESH_OK);
        CHECK(b.birth_low == exact[i].birth);
        CHECK(b.birth_high == exact[i].birth);
        CHECK(b.death_low == exact[i].death);
        CHECK(b.death_high == exact[i].death);
        CHECK(b.certain == 1);
    }
    CHECK(netmesh_get_bar_bounds(session.context, exact.size(), &b) == NETMESH_INVALID_ARGUMENT);

    // No bar is bounded more widely than the ratio of the whole diagram says.
    for (const netmesh_filter filter : {NETMESH_FILTER_COMPLETE, NETMESH_FILTER_KNN, NETMESH_FILTER_KDISTANCE}) {
        session.options.k = 4;
        REQUIRE(session.mesh_and_persist(points, filter) == NETMESH_OK);
        const std::uint64_t print = session.report().fingerprint;
        const double c = session.report().certified_ratio * (1 + 1e-9);
        REQUIRE(netmesh_bound_bars(session.context, &session.options) == NETMESH_OK);
        CHECK(session.report().fingerprint == print);
        const std::vector<netmesh_pair> pairs = session.pairs();
        std::size_t certain = 0, by_ratio = 0;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            REQUIRE(netmesh_get_bar_bounds(session.context, i, &b) == NETMESH_OK);
            CHECK(b.birth_low * c >= pairs[i].birth);
            CHECK(b.birth_high <= c * pairs[i].birth);
            if (std::isfinite(pairs[i].death)) CHECK(b.death_low * c >= pairs[i].death);
            if (std::isfinite(pairs[i].death)) CHECK(b.death_high <= c * pairs[i].death);
            CHECK(b.certain_after <= c * c * pairs[i].birth);
            certain += b.certain;
            by_ratio += pairs[i].death > c * c * pairs[i].birth;
        }
        CHECK(certain >= by_ratio);
        CHECK(by_ratio > 0);
    }
}

TEST_CASE("bounds that do not fit leave the diagram") {
    const inputs::Points points = inputs::uniform(2, 30);
    Session roomy(2);
    REQUIRE(roomy.mesh_and_persist(points) == NETMESH_OK);
    const std::uint64_t used = roomy.report().used_bytes, peak = roomy.report().peak_bytes;
    bool refused = false;
    for (std::size_t bytes = used; bytes < peak + 100000 && !refused; bytes += 256) {
        Session session(2);
        session.reserve(bytes);
        netmesh_status status = netmesh_mesh(session.context, points.data(), 30, NETMESH_JOB_PERSIST, &session.options);
        if (status == NETMESH_OK)
            status = netmesh_persist(session.context, NETMESH_FILTER_COMPLETE, NETMESH_VALUES_CERTIFIED, 1, 0,
                                     &session.options);
        if (status != NETMESH_OK) continue;
        const netmesh_status bound = netmesh_bound_bars(session.context, &session.options);
        if (bound == NETMESH_OK) break;
        refused = true;
        CHECK(bound == NETMESH_OUT_OF_MEMORY);
        CHECK(session.report().fingerprint == roomy.report().fingerprint);
    }
    CHECK(refused);
}
