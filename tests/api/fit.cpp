// Ratios and budgets: what the interface admits, and that more memory never gives a worse certificate.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "common/session.hpp"

TEST_CASE("ratios that make no sense") {
    Session session(2);
    const inputs::Points points = inputs::uniform(2, 20);
    const auto mesh = [&](netmesh_purpose purpose) { return session.mesh_in_block(points, purpose); };
    const auto fit_refused = [&](netmesh_field field) {
        CHECK(session.fit(points) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == field);
    };
    session.request.certificate.focus_ratio = 1.5;
    CHECK(mesh(NETMESH_PURPOSE_PERSIST) == NETMESH_INVALID_ARGUMENT);
    session.request.certificate.focus_ratio = 0;
    for (const double ratio : {-2.0, 1.0, 1.414, 1e300, 1e300 * 1e300, std::nan("")}) {
        session.request.certificate.ratio = ratio;
        CHECK(mesh(NETMESH_PURPOSE_PERSIST) == NETMESH_INVALID_ARGUMENT);
        CHECK(session.detail().field == NETMESH_FIELD_RATIO);
        fit_refused(NETMESH_FIELD_RATIO);
    }
    session.request.certificate.ratio = 2.25;
    CHECK(mesh(NETMESH_PURPOSE_MESH) == NETMESH_INVALID_ARGUMENT);
    CHECK(mesh(NETMESH_PURPOSE_TIGHT) == NETMESH_INVALID_ARGUMENT);
    session.request.sizes.eps = 0.5;
    CHECK(mesh(NETMESH_PURPOSE_PERSIST) == NETMESH_INVALID_ARGUMENT);
    session.request.sizes.eps = 0;
    session.request.method = NETMESH_METHOD_REFINE;
    CHECK(mesh(NETMESH_PURPOSE_PERSIST) == NETMESH_INVALID_ARGUMENT);
    session.request.method = NETMESH_METHOD_SVR;
    const double bad[][3] = {{1.5, 0, 1}, {1.5, 1, 0.5}, {2.5, 0.1, 1}, {1, 0.1, 1}, {0, 0.1, 1}};
    for (const auto& [focus, from, to] : bad) {
        session.request.certificate.focus_ratio = focus;
        session.request.certificate.focus_from = from;
        session.request.certificate.focus_to = to;
        CHECK(mesh(NETMESH_PURPOSE_PERSIST) == NETMESH_INVALID_ARGUMENT);
    }
    session.request.certificate = {2.25, 0, 0.1, 0};
    fit_refused(NETMESH_FIELD_FOCUS_TO);
    session.request.certificate = {2.25, 0, 0, 1};
    fit_refused(NETMESH_FIELD_FOCUS_FROM);
    CHECK(mesh(NETMESH_PURPOSE_PERSIST) == NETMESH_INVALID_ARGUMENT);
    const netmesh_fit_request request = session.fit_request(points);
    CHECK(netmesh_fit(session.context, nullptr) == NETMESH_INVALID_ARGUMENT);
    CHECK(netmesh_fit(nullptr, &request) == NETMESH_INVALID_ARGUMENT);
    session.request.certificate.focus_to = 0;
    CHECK(netmesh_tau(&session.request) == 2.5);
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
                session.request.certificate.focus_from = 0.05;
                session.request.certificate.focus_to = 0.2;
            }
            const netmesh_status status = session.fit(points, focused);
            if (status == NETMESH_OUT_OF_MEMORY) {
                CHECK(ratios.empty());
                continue;
            }
            REQUIRE(status == NETMESH_OK);
            const netmesh_report report = session.report();
            CHECK(report.memory.peak_bytes <= bytes);
            CHECK(report.diagram.certified_ratio <= report.mesh.certificate.ratio);
            const netmesh_certificate_goal goal = report.mesh.certificate;
            const double found = focused && goal.focus_ratio > 0 ? goal.focus_ratio : goal.ratio;
            CHECK(found <= last);
            last = found;
            ratios.push_back(found);
            auto bounds = netmesh::sized<netmesh_bar_bounds>();
            CHECK((netmesh_get_bar_bounds(session.context, 0, &bounds) == NETMESH_OK) == focused);

            // The same mesh and diagram as when the ratio is asked for by itself.
            Session direct(2);
            direct.request.certificate = goal;
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
    session.request.monitor.user = &polls;
    session.request.monitor.poll = [](void* user, const netmesh_progress*) {
        Polls& p = *static_cast<Polls*>(user);
        return static_cast<int>(p.made++ == p.stop_at);
    };
    REQUIRE(session.fit(points) == NETMESH_OK);
    const long all = polls.made;
    const std::uint64_t print = session.report().fingerprint;
    REQUIRE(all > 2);
    for (const long stop_at : {0L, all / 2, all - 1}) {
        polls = {0, stop_at};
        CHECK(session.fit(points) == NETMESH_CANCELLED);
        CHECK(session.report().diagram.present == 0);
    }
    polls = {};
    REQUIRE(session.fit(points) == NETMESH_OK);
    CHECK(session.report().fingerprint == print);
}
