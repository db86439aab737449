// The tight filter (7.5) against the exact diagram: the log-bottleneck distance is at most eps, and at most the
// logarithm of the ratio that the mesh certifies, which is at most 1 + eps.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

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
    session.options.eps = eps;
    const std::size_t n = points.size() / D;
    for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
        REQUIRE(session.until_it_fits(netmesh_plan_bytes(NETMESH_JOB_PERSIST_TIGHT, &session.options, n), [&] {
            const netmesh_status status =
                netmesh_mesh(session.context, points.data(), n, NETMESH_JOB_PERSIST_TIGHT, &session.options);
            if (status != NETMESH_OK) return status;
            const netmesh_status found =
                netmesh_persist(session.context, NETMESH_FILTER_TIGHT, values, D - 1, 0, &session.options);
            return found == NETMESH_OK ? netmesh_bound_bars(session.context, &session.options) : found;
        }) == NETMESH_OK);
        const netmesh_report r = report(session);
        const double distance = log_distance(diagram(session), truth, D);
        CHECK(r.certified_ratio <= (1 + eps) * (1 + 1e-9));
        CHECK(distance <= std::log(r.certified_ratio));
        CHECK(distance <= eps);
        std::size_t certain = 0;
        CHECK(bounds_hold(session, truth, &certain));
        CHECK(certain > 0);
        MESSAGE(name << " D=" << D << ", eps " << eps
                     << std::string(values == NETMESH_VALUES_THESIS ? ", thesis" : ", certified")
                     << " values: log distance " << distance << ", certified ratio " << r.certified_ratio << ", "
                     << r.vertices << " vertices, " << certain << " bars surely real");
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
