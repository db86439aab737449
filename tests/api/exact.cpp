// What is certified of the diagrams of few points, in every dimension, against the exact diagram.
#include <doctest/doctest.h>

#include <cmath>

#include "common/bottleneck.hpp"
#include "common/dimensions.hpp"
#include "common/session.hpp"

namespace {

// e^distance in log scale.
double distance(const std::vector<netmesh_pair>& a, const std::vector<netmesh_pair>& b) {
    const Distance d = bottleneck(a, b, NETMESH_SCALE_LOG);
    REQUIRE(d.status == NETMESH_OK);
    return std::ldexp(d.value, d.exponent);
}

// Surely real bars belong to different true ones; here to any.
void check_bounds(Session& s, const std::vector<netmesh_pair>& exact) {
    REQUIRE(s.bound_bars() == NETMESH_OK);
    const std::vector<netmesh_pair> pairs = s.pairs();
    auto b = netmesh::sized<netmesh_bar_bounds>();
    for (std::uint64_t i = 0; i < pairs.size(); ++i) {
        REQUIRE(netmesh_get_bar_bounds(s.context, i, &b) == NETMESH_OK);
        if (b.certain == 0) continue;
        bool found = false;
        for (const netmesh_pair& p : exact)
            found = found || (p.degree == pairs[i].degree && b.birth_low <= p.birth * (1 + 1e-9) &&
                              p.birth <= b.birth_high * (1 + 1e-9) && b.death_low <= p.death * (1 + 1e-9) &&
                              p.death <= b.death_high * (1 + 1e-9));
        CHECK(found);
    }
}

}  // namespace

TEST_CASE("diagrams are within their certified ratio of the exact one") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        const std::size_t few = by_dimension<std::size_t>(dim, {24, 12, 9, 9, 8});
        const inputs::Points points = inputs::clusters(dim, few);
        Session truth(dim), s(dim);
        REQUIRE(truth.alpha(points) == NETMESH_OK);
        const std::vector<netmesh_pair> exact = truth.pairs();
        if (dim > 4) s.request.tau = 3;
        s.bounds = true;
        REQUIRE(s.mesh_and_persist(points) == NETMESH_OK);  // makes room for bounds
        REQUIRE(s.report().mesh.steiner > 0);
        for (const netmesh_filter filter : {NETMESH_FILTER_COMPLETE, NETMESH_FILTER_TIGHT, NETMESH_FILTER_BASIC})
            for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
                if (dim == 6 && (filter == NETMESH_FILTER_BASIC || values == NETMESH_VALUES_THESIS)) continue;
                REQUIRE(s.persist(persist_by(filter, 0, values)) == NETMESH_OK);
                CHECK(std::isfinite(s.report().diagram.certified_ratio));
                if (filter != NETMESH_FILTER_BASIC)
                    CHECK(distance(s.pairs(), exact) <= s.report().diagram.certified_ratio * (1 + 1e-9));
                if (values == NETMESH_VALUES_CERTIFIED && (dim < 6 || filter == NETMESH_FILTER_COMPLETE))
                    check_bounds(s, exact);
            }
    }
}

// Sublevel sets of the distance to the second nearest point have minima between neighbours: of three points on a line
// two, and the one farther apart dies where the middle point has its nearest.
TEST_CASE("a bar between three points on a line is bounded by covers") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        const std::size_t d = static_cast<std::size_t>(dim);
        inputs::Points points(3 * d, 0.0);
        points[d] = 1;
        points[2 * d] = -1.3;
        const double birth = 0.65, death = 1;
        Session s(dim);
        if (dim > 4) s.request.tau = 2.2;
        s.bounds = true;
        REQUIRE(s.mesh_and_persist(points, persist_by(NETMESH_FILTER_KNN, 2)) == NETMESH_OK);
        const std::vector<netmesh_pair> exact = {bar(0, 0.5, HUGE_VAL), bar(0, birth, death)};
        check_bounds(s, exact);
        const double c = s.report().diagram.certified_ratio;
        for (const netmesh_pair& p : s.pairs()) {
            if (p.degree == 0 && p.death > c * c * p.birth && std::isfinite(p.death)) {
                CHECK(p.birth <= c * birth * (1 + 1e-9));
                CHECK(p.death >= death / c * (1 - 1e-9));
            }
        }
    }
}
