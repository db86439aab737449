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

// Bars that are certified to exist belong to different true ones; here to any.
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
        if (dim > 4) s.request.mesh.tau = 3;
        s.bounds = true;
        REQUIRE(s.mesh_and_persist(points) == NETMESH_OK);  // makes room for bounds
        REQUIRE(s.report().mesh.steiner > 0);
        for (const netmesh_filter* const filter :
             {&netmesh_filter_complete, &netmesh_filter_tight, &netmesh_filter_basic})
            for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
                if (dim == 6 && (filter == &netmesh_filter_basic || values == NETMESH_VALUES_THESIS)) continue;
                REQUIRE(s.persist(persist_by(filter, 0, values)) == NETMESH_OK);
                CHECK(std::isfinite(s.report().diagram.certified_ratio));
                if (filter != &netmesh_filter_basic)
                    CHECK(distance(s.pairs(), exact) <= s.report().diagram.certified_ratio * (1 + 1e-9));
                if (values == NETMESH_VALUES_CERTIFIED && (dim < 6 || filter == &netmesh_filter_complete))
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
        if (dim > 4) s.request.mesh.tau = 2.2;
        s.bounds = true;
        REQUIRE(s.mesh_and_persist(points, persist_by(&netmesh_filter_knn, 2)) == NETMESH_OK);
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

// The circle through the three is larger than any double: a triangle and its longest edge that never enter.
TEST_CASE("what enters beyond the largest double is no pair, where zero lengths are kept, too") {
    const inputs::Points points = {-1e308, 0, 1e308, 0, 0, 1e-5};
    for (const netmesh_filter* filter : {&netmesh_filter_alpha, &netmesh_filter_cech})
        for (const std::uint32_t keep_mesh : {0u, 1u}) {
            if (keep_mesh != 0 && filter != &netmesh_filter_alpha) continue;
            Session s(2);
            netmesh::Request request(filter);
            request.set_points(2, points);
            request.keep_zero_pairs = 1;
            request.keep_mesh = keep_mesh;
            REQUIRE(s.persist_until_it_fits(request) == NETMESH_OK);
            const std::vector<netmesh_pair> pairs = s.pairs();
            CHECK(pairs.size() >= 3);
            for (const netmesh_pair& pair : pairs) CHECK(std::isfinite(pair.birth));
            request.cycles = &netmesh_cycles;
            REQUIRE(s.persist_until_it_fits(request) == NETMESH_OK);
            CHECK(s.pairs().size() == pairs.size());
        }
}
