// The tight filter (7.5) against the exact diagram: the log-bottleneck distance is at most eps, and at most the
// logarithm of the ratio that the mesh certifies, which is at most 1 + eps.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "common/dimensions.hpp"
#include "common/session.hpp"
#include "oracle/log_distance.hpp"

namespace {

template <int D> void within_eps(const std::string& name, const inputs::Points& points, double eps) {
    CAPTURE(name);
    CAPTURE(eps);
    Session exact(D);
    REQUIRE(exact.alpha(points) == NETMESH_OK);
    const Diagram truth = diagram(exact);
    Session session(D);
    session.request.goal.eps = eps;
    session.bounds = true;
    for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
        REQUIRE(session.mesh_and_persist(points, persist_by(&netmesh_filter_tight, 0, values), &netmesh_filter_tight) ==
                NETMESH_OK);
        const netmesh_report r = session.report();
        const double distance = log_distance(diagram(session), truth, D);
        CHECK(r.diagram.certified_ratio <= (1 + eps) * (1 + 1e-9));
        CHECK(distance <= std::log(r.diagram.certified_ratio));
        CHECK(distance <= eps);
        std::size_t certain = 0;
        CHECK(bounds_hold(session, truth, &certain));
        CHECK(moves_within(curve(session), diagram(session), truth));
        CHECK(certain > 0);
        MESSAGE(name << " D=" << D << ", eps " << eps
                     << std::string(values == NETMESH_VALUES_THESIS ? ", thesis" : ", certified")
                     << " values: log distance " << distance << ", certified ratio " << r.diagram.certified_ratio
                     << ", " << r.mesh.vertices << " vertices, " << certain << " bars certified to exist");
    }
}

// On a mesh refined by the certificate, which is for the complete filter: what the tight filter certifies there is its
// own, at most a little more.
template <int D> void within_ratio(const inputs::Points& points, double ratio) {
    Session exact(D);
    REQUIRE(exact.alpha(points) == NETMESH_OK);
    const Diagram truth = diagram(exact);
    Session session(D);
    session.bounds = true;
    session.request.goal.ratio = ratio;
    session.request.mesh.whole_cells = 1;
    for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
        REQUIRE(session.mesh_and_persist(points, persist_by(&netmesh_filter_tight, 0, values),
                                         &netmesh_filter_complete) == NETMESH_OK);
        const netmesh_report r = session.report();
        const double distance = log_distance(diagram(session), truth, D);
        if (values == NETMESH_VALUES_CERTIFIED) CHECK(r.diagram.certified_ratio <= 1.1 * ratio);
        CHECK(distance <= std::log(r.diagram.certified_ratio));
        CHECK(moves_within(curve(session), diagram(session), truth));
        std::size_t certain = 0;
        CHECK(bounds_hold(session, truth, &certain));
        MESSAGE("D=" << D << ", ratio " << ratio << ": log distance " << distance << ", certified ratio "
                     << r.diagram.certified_ratio << ", " << r.mesh.vertices << " vertices, " << certain
                     << " bars certified to exist");
    }
}

}  // namespace

TEST_CASE("plane") {
    for (const double eps : {0.5, 0.25}) {
        within_eps<2>("uniform", inputs::uniform(2, 60), eps);
        within_eps<2>("circle", inputs::circle(40), eps);
        within_eps<2>("grid", inputs::grid(2, 6), eps);
        within_eps<2>("clusters", inputs::clusters(2, 40), eps);
        within_eps<2>("noisy circle", inputs::shell(2, 60, 1, 1.1, 11), eps);
    }
}

TEST_CASE("space") {
    within_eps<3>("uniform", inputs::uniform(3, 12), 0.5);
    within_eps<3>("sphere", inputs::shell(3, 14, 1, 1, 22), 0.5);
}

TEST_CASE("meshes refined by the certificate, in every dimension") {
    within_ratio<2>(inputs::uniform(2, 100), 1.8);
    within_ratio<3>(inputs::uniform(3, 60), 2);
    for_each_dimension<4, 4>([](auto dim) { within_ratio<dim>(inputs::uniform(4, 200), 2.3); });
    for_each_dimension<4, 4>([](auto dim) { within_ratio<dim>(inputs::shell(4, 40, 1, 1, 23), 1.9); });
    for_each_dimension<5, 5>([](auto dim) { within_ratio<dim>(inputs::uniform(5, 60), 2.4); });
    for_each_dimension<6, 6>([](auto dim) { within_ratio<dim>(inputs::uniform(6, 16), 2.4); });
}
