// Filters by a function: what the interface takes and refuses.
#include <doctest/doctest.h>

#include <cmath>

#include "common/session.hpp"

namespace {

// The distance to the middle of the points, and one more: one component, no cycle.
double from_middle(void* calls, const double* x) {
    ++*static_cast<int*>(calls);
    return std::sqrt((x[0] - 0.5) * (x[0] - 0.5) + (x[1] - 0.5) * (x[1] - 0.5)) + 1;
}
double negative(void*, const double* x) { return x[0] - 1e6; }
double undefined(void*, const double*) { return std::nan(""); }

}  // namespace

TEST_CASE("a function of the caller's") {
    Session session(2);
    const inputs::Points points = inputs::uniform(2, 60);
    int calls = 0;
    netmesh_function function = {from_middle, &calls, 1, 1, 1.7};
    const auto persist = [&] {
        return netmesh_persist_function(session.context, &function, NETMESH_VALUES_CERTIFIED, 1, 0, &session.options);
    };
    CHECK(persist() == NETMESH_NO_RESULT);
    REQUIRE(session.mesh(points, NETMESH_JOB_PERSIST) == NETMESH_OK);
    REQUIRE(persist() == NETMESH_OK);
    const netmesh_report report = session.report();
    CHECK(calls == static_cast<int>(report.vertices));
    CHECK(report.filter == NETMESH_FILTER_FUNCTION);
    CHECK(report.certified_ratio > 1);
    // Bars that the certificate lets count: the essential one.
    int real = 0;
    for (const netmesh_pair& pair : session.pairs())
        real += pair.death > pair.birth * report.certified_ratio * report.certified_ratio;
    CHECK(real == 1);

    const auto refused = [&](const netmesh_function& f) {
        return netmesh_persist_function(session.context, &f, NETMESH_VALUES_CERTIFIED, 1, 0, &session.options) ==
                   NETMESH_INVALID_ARGUMENT &&
               netmesh_get_detail(session.context).index_a == 2;
    };
    CHECK(refused({nullptr, nullptr, 1, 0, 2}));
    CHECK(refused({from_middle, &calls, -1, 0, 2}));
    CHECK(refused({from_middle, &calls, 1, INFINITY, 2}));
    CHECK(refused({from_middle, &calls, 1, 0, std::nan("")}));
    CHECK(session.report().has_diagram == 1);  // refused before anything was given up
    for (const auto evaluate : {negative, undefined}) {
        function.evaluate = evaluate;
        CHECK(persist() == NETMESH_NOT_FINITE);
        CHECK(session.report().has_diagram == 0);
    }
    CHECK(session.report().complete == 1);
    CHECK(netmesh_persist(session.context, NETMESH_FILTER_FUNCTION, NETMESH_VALUES_CERTIFIED, 1, 0, &session.options) ==
          NETMESH_INVALID_ARGUMENT);
}

TEST_CASE("k: one mesh for all, as many neighbours as there are points") {
    Session session(3);
    inputs::Points points = inputs::uniform(3, 40);
    points.insert(points.end(), points.begin(), points.begin() + 3);  // a duplicate is no neighbour
    REQUIRE(session.mesh(points, NETMESH_JOB_PERSIST) == NETMESH_OK);
    double last = -1;
    for (std::uint32_t k = 1; k <= 40; k += 13) {
        session.options.k = k;
        REQUIRE(netmesh_persist(session.context, NETMESH_FILTER_KNN, NETMESH_VALUES_THESIS, 2, 0, &session.options) ==
                NETMESH_OK);
        const std::vector<netmesh_pair> pairs = session.pairs();
        double least = 1e9;
        for (const netmesh_pair& pair : pairs)
            if (std::isinf(pair.death)) least = pair.birth;
        CHECK(least > last);
        last = least;
    }
    session.options.k = 41;
    CHECK(netmesh_persist(session.context, NETMESH_FILTER_KDISTANCE, NETMESH_VALUES_THESIS, 2, 0, &session.options) ==
          NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_detail(session.context).index_a == 7);
    CHECK(netmesh_persist(session.context, NETMESH_FILTER_COMPLETE, NETMESH_VALUES_THESIS, 2, 0, &session.options) ==
          NETMESH_OK);
}
