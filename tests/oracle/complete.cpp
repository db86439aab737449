// The complete filter against the exact diagram: on every set the log-bottleneck distance, by GUDHI's exact algorithm,
// is at most the logarithm of the ratio that the mesh certifies, for both kinds of values and in every degree.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "common/dimensions.hpp"
#include "common/session.hpp"
#include "oracle/log_distance.hpp"

namespace {

template <int D> void within_certificate(const std::string& name, const inputs::Points& points, double tau = 0) {
    CAPTURE(name);
    Session exact(D);
    REQUIRE(exact.alpha(points) == NETMESH_OK);
    const Diagram truth = diagram(exact);
    for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
        Session session(D);
        session.request.mesh.tau = tau;
        session.bounds = true;
        REQUIRE(session.mesh_and_persist(points, persist_by(&netmesh_filter_complete, 0, values)) == NETMESH_OK);
        const netmesh_report r = session.report();
        CHECK(r.diagram.certified_ratio <= r.mesh.tau);
        if (values == NETMESH_VALUES_CERTIFIED) CHECK(r.diagram.certified_ratio <= std::sqrt(2 + r.mesh.tau));
        const double distance = log_distance(diagram(session), truth, D);
        const double ratio = std::exp(distance);
        CHECK(ratio <= r.diagram.certified_ratio);
        CHECK(ratio >= 1);
        std::size_t certain = 0;
        CHECK(bounds_hold(session, truth, &certain));
        CHECK(moves_within(curve(session), diagram(session), truth));
        CHECK(certain > 0);
        MESSAGE(name << " D=" << D << std::string(values == NETMESH_VALUES_THESIS ? " thesis" : " certified")
                     << " values: true ratio " << ratio << ", certified " << r.diagram.certified_ratio << ", tau "
                     << r.mesh.tau << ", " << certain << " bars certified to exist");
    }
}

// A mesh that is refined by the certificate and promises nothing else.
template <int D> void reaches_ratio(const std::string& name, const inputs::Points& points, double ratio) {
    CAPTURE(name);
    Session exact(D), session(D);
    REQUIRE(exact.alpha(points) == NETMESH_OK);
    const Diagram truth = diagram(exact);
    session.request.goal.ratio = ratio;
    session.bounds = true;
    REQUIRE(session.mesh_and_persist(points) == NETMESH_OK);
    const netmesh_report r = session.report();
    CHECK(r.diagram.certified_ratio <= ratio);
    const double true_ratio = std::exp(log_distance(diagram(session), truth, D));
    CHECK(true_ratio <= r.diagram.certified_ratio);
    std::size_t certain = 0;
    CHECK(bounds_hold(session, truth, &certain));
    CHECK(moves_within(curve(session), diagram(session), truth));
    MESSAGE(name << " D=" << D << " by the certificate: true ratio " << true_ratio << ", certified "
                 << r.diagram.certified_ratio << ", " << r.mesh.vertices << " vertices, " << certain
                 << " bars certified to exist");
}

}  // namespace

TEST_CASE("refinement by the certificate") {
    for (const double ratio : {3.5, 2.25, 2.0}) {
        reaches_ratio<2>("uniform", inputs::uniform(2, 300), ratio);
        reaches_ratio<2>("circle", inputs::circle(101), ratio);
        reaches_ratio<2>("clusters", inputs::clusters(2, 200), ratio);
        reaches_ratio<2>("grid", inputs::grid(2, 12), ratio);
        reaches_ratio<2>("figure eight", inputs::eight(200, 0.05, 16), ratio);
        reaches_ratio<2>("zoom", inputs::zoom(2, 40, 1), ratio);
        reaches_ratio<3>("uniform", inputs::uniform(3, 150), ratio);
        reaches_ratio<3>("sphere", inputs::shell(3, 120, 1, 1, 22), ratio);
        reaches_ratio<3>("clusters", inputs::clusters(3, 100), ratio);
        reaches_ratio<3>("grid", inputs::grid(3, 4), ratio);
        reaches_ratio<3>("torus", inputs::torus(250, 27), ratio);
    }
    for_each_dimension<4, 4>([&](auto dim) { reaches_ratio<dim>("uniform", inputs::uniform(4, 60), 2.25); });
    for_each_dimension<4, 4>([&](auto dim) { reaches_ratio<dim>("sphere", inputs::shell(4, 60, 1, 1, 31), 2.25); });
}

TEST_CASE("plane") {
    within_certificate<2>("uniform", inputs::uniform(2, 300));
    within_certificate<2>("uniform, tau 4", inputs::uniform(2, 300), 4);
    within_certificate<2>("uniform, tau 2.2", inputs::uniform(2, 200), 2.2);
    within_certificate<2>("noisy circle", inputs::shell(2, 200, 1, 1.05, 11));
    within_certificate<2>("circle", inputs::circle(101));
    within_certificate<2>("clusters", inputs::clusters(2, 200));
    within_certificate<2>("grid", inputs::grid(2, 12));
    within_certificate<2>("grid, jitter 0.1", inputs::jittered(2, 12, 0.1, 12));
    within_certificate<2>("annulus", inputs::shell(2, 300, 0.6, 1, 15));
    within_certificate<2>("figure eight", inputs::eight(200, 0.05, 16));
    within_certificate<2>("zoom", inputs::zoom(2, 40, 1));
}

TEST_CASE("space") {
    within_certificate<3>("uniform", inputs::uniform(3, 150));
    within_certificate<3>("uniform, tau 4", inputs::uniform(3, 150), 4);
    within_certificate<3>("uniform, tau 3.08", inputs::uniform(3, 150), 3.08);
    within_certificate<3>("noisy sphere", inputs::shell(3, 120, 1, 1.02, 21), 3.08);
    within_certificate<3>("sphere", inputs::shell(3, 120, 1, 1, 22), 3.08);
    within_certificate<3>("clusters", inputs::clusters(3, 100), 3.08);
    within_certificate<3>("grid", inputs::grid(3, 4));
    within_certificate<3>("grid, jitter 0.1", inputs::jittered(3, 4, 0.1, 23));
    within_certificate<3>("shell", inputs::shell(3, 150, 0.6, 1, 26), 3.08);
    within_certificate<3>("torus", inputs::torus(250, 27), 3.08);
}
