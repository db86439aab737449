// Ratios and budgets: what the interface admits, and that more memory never gives a worse certificate.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "common/session.hpp"

TEST_CASE("ratios that make no sense") {
    Session session(2);
    const inputs::Points points = inputs::uniform(2, 20);
    const auto mesh = [&](netmesh_job job) {
        return netmesh_mesh(session.context, points.data(), 20, job, &session.options);
    };
    session.options.focus_ratio = 1.5;
    CHECK(mesh(NETMESH_JOB_PERSIST) == NETMESH_INVALID_ARGUMENT);
    session.options.focus_ratio = 0;
    for (const double ratio : {-2.0, 1.0, 1.414, 1e300, 1e300 * 1e300, std::nan("")}) {
        session.options.ratio = ratio;
        CHECK(mesh(NETMESH_JOB_PERSIST) == NETMESH_INVALID_ARGUMENT);
        CHECK(netmesh_get_detail(session.context).index_a == 5);
    }
    session.options.ratio = 2.25;
    CHECK(mesh(NETMESH_JOB_MESH) == NETMESH_INVALID_ARGUMENT);
    CHECK(mesh(NETMESH_JOB_PERSIST_TIGHT) == NETMESH_INVALID_ARGUMENT);
    session.options.over_refine_eps = 0.5;
    CHECK(mesh(NETMESH_JOB_PERSIST) == NETMESH_INVALID_ARGUMENT);
    session.options.over_refine_eps = 0;
    session.options.method = NETMESH_METHOD_REFINE;
    CHECK(mesh(NETMESH_JOB_PERSIST) == NETMESH_INVALID_ARGUMENT);
    session.options.method = NETMESH_METHOD_SVR;
    const double bad[][3] = {{1.5, 0, 1}, {1.5, 1, 0.5}, {2.5, 0.1, 1}, {1, 0.1, 1}, {0, 0.1, 1}};
    for (const auto& [focus, from, to] : bad) {
        session.options.focus_ratio = focus;
        session.options.focus_from = from;
        session.options.focus_to = to;
        CHECK(mesh(NETMESH_JOB_PERSIST) == NETMESH_INVALID_ARGUMENT);
    }
    session.options.focus_ratio = 1.5;
    CHECK(netmesh_fit(session.context, points.data(), 20, 1, 0, 0, &session.options) == NETMESH_INVALID_ARGUMENT);
    session.options.focus_ratio = 0;
    session.options.focus_to = 0;
    CHECK(netmesh_fit(session.context, points.data(), 20, 1, 0, 0, &session.options) == NETMESH_INVALID_ARGUMENT);
    session.options.focus_from = 0;
    session.options.focus_to = 1;
    CHECK(netmesh_fit(session.context, points.data(), 20, 1, 0, 0, &session.options) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_get_detail(session.context).index_a == 7);
    CHECK(mesh(NETMESH_JOB_PERSIST) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_fit(session.context, points.data(), 20, 1, 0, 0, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_fit(nullptr, points.data(), 20, 1, 0, 0, &session.options) == NETMESH_INVALID_ARGUMENT);
    session.options.focus_to = 0;
    CHECK(netmesh_tau(&session.options) == 2.5);
    CHECK(netmesh_tau(nullptr) == 0);
}

TEST_CASE("more memory never gives a worse ratio, and the block is kept to") {
    for (const bool focused : {false, true}) {
        const inputs::Points points = inputs::uniform(2, 60);
        double last = 5;
        std::vector<double> ratios;
        for (std::size_t bytes = 14000; bytes < 1500000; bytes += bytes / 8) {
            Session session(2);
            session.reserve(bytes);
            if (focused) {
                session.options.focus_from = 0.05;
                session.options.focus_to = 0.2;
            }
            const netmesh_status status =
                netmesh_fit(session.context, points.data(), 60, 1, 0, focused ? 1 : 0, &session.options);
            if (status == NETMESH_OUT_OF_MEMORY) {
                CHECK(ratios.empty());
                continue;
            }
            REQUIRE(status == NETMESH_OK);
            const netmesh_report report = session.report();
            CHECK(report.peak_bytes <= bytes);
            CHECK(report.certified_ratio <= report.ratio);
            const double found = focused && report.focus_ratio > 0 ? report.focus_ratio : report.ratio;
            CHECK(found <= last);
            last = found;
            ratios.push_back(found);
            netmesh_bar_bounds bounds;
            CHECK((netmesh_get_bar_bounds(session.context, 0, &bounds) == NETMESH_OK) == focused);

            // The same mesh and diagram as when the ratio is asked for by itself.
            Session direct(2);
            direct.options.ratio = report.ratio;
            direct.options.focus_ratio = report.focus_ratio;
            direct.options.focus_from = report.focus_from;
            direct.options.focus_to = report.focus_to;
            REQUIRE(direct.mesh_and_persist(points) == NETMESH_OK);
            CHECK(direct.report().fingerprint == report.fingerprint);
        }
        REQUIRE(ratios.size() > 5);
        CHECK(ratios.front() > 1.3 * ratios.back());
    }
}

TEST_CASE("a fit that is stopped on its way leaves no diagram") {
    struct Polls {
        long made = 0, stop_at = -1;
    } polls;
    const inputs::Points points = inputs::uniform(2, 300);
    Session session(2);
    session.reserve(std::size_t{1} << 22);
    session.options.user = &polls;
    session.options.poll = [](void* user, const netmesh_progress*) {
        Polls& p = *static_cast<Polls*>(user);
        return static_cast<int>(p.made++ == p.stop_at);
    };
    REQUIRE(netmesh_fit(session.context, points.data(), 300, 1, 0, 0, &session.options) == NETMESH_OK);
    const long all = polls.made;
    const std::uint64_t print = session.report().fingerprint;
    REQUIRE(all > 2);
    for (const long stop_at : {0L, all / 2, all - 1}) {
        polls = {0, stop_at};
        CHECK(netmesh_fit(session.context, points.data(), 300, 1, 0, 0, &session.options) == NETMESH_CANCELLED);
        CHECK(session.report().has_diagram == 0);
    }
    polls = {};
    REQUIRE(netmesh_fit(session.context, points.data(), 300, 1, 0, 0, &session.options) == NETMESH_OK);
    CHECK(session.report().fingerprint == print);
}
