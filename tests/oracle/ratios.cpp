// Certified ratio, true ratio and theory's bound of every filter on point sets in 2D, 3D and 4D, as a table
// (ctest -R oracle.ratios -V). The truth: the alpha complex; for d_k nested sets of points, on sets small enough; for
// the k-distance sublevel sets on a fine grid. The true ratio is e to the exact log-bottleneck distance. Each is inside
// its certified ratio and its ratio by scale, that inside theory's bound, and each bar said to exist inside its
// bounds. The bound for d_k and the k-distance holds where every cell is as good as tau says
// (filtration/function_filter.hpp); refinement looks at the cells as the complete filter needs them.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "common/session.hpp"
#include "oracle/log_distance.hpp"
#include "oracle/sublevel_grid.hpp"

namespace {

struct Case {
    const char* name;
    int dim;
    inputs::Points points;
    double tau;
};

void print_row(const Case& c, const Session& session, const char* filter, double truth, double theory,
               std::size_t certain) {
    const netmesh_report r = session.report();
    std::uint64_t bars = 0;
    for (std::uint32_t degree = 0; degree <= r.diagram.max_degree; ++degree) bars += r.diagram.pairs[degree];
    std::printf("| %-18s | %-12s | %d | %6llu | %7llu | %9.3f | %6.3f | %6.3f | %5llu | %5zu |\n", filter, c.name,
                c.dim, static_cast<unsigned long long>(r.mesh.inputs),
                static_cast<unsigned long long>(r.scales.count > 0 ? r.scales.vertices : r.mesh.vertices),
                r.diagram.certified_ratio, truth, theory, static_cast<unsigned long long>(bars), certain);
    std::fflush(stdout);
}

void print_head() {
    std::printf("| filter | points | D | inputs | vertices | certified | true | theory | bars | exist |\n");
    std::printf("|---|---|---|---|---|---|---|---|---|---|\n");
}

// slack: what the truth is known to.
void judge(const Case& c, Session& session, const char* filter, const Diagram& truth, double distance, double theory,
           double slack = 1 + 1e-9) {
    CAPTURE(c.name);
    CAPTURE(filter);
    const double certified = session.report().diagram.certified_ratio, ratio = std::exp(distance);
    CHECK(ratio <= certified * slack);
    CHECK(certified <= theory * (1 + 1e-9));
    std::size_t certain = 0;
    CHECK(bounds_hold(session, truth, &certain, slack));
    CHECK(moves_within(curve(session), diagram(session), truth, slack));
    print_row(c, session, filter, ratio, theory, certain);
}

// Bars as they are from a scale on.
Diagram seen_from(const Diagram& bars, double from) {
    Diagram seen;
    for (const auto& [degree, list] : bars)
        for (const auto& [birth, death] : list)
            if (death > from) seen[degree].push_back({std::max(birth, from), death});
    return seen;
}

double distance_of_positive(const Diagram& a, const Diagram& b, int dim) {
    double distance = 0;
    for (std::uint32_t degree = 0; degree < static_cast<std::uint32_t>(dim); ++degree) {
        const Bars x = a.count(degree) ? a.at(degree) : Bars(), y = b.count(degree) ? b.at(degree) : Bars();
        distance = std::max(distance, gudhi_bottleneck(logarithms(x), logarithms(y)));
    }
    return distance;
}

double theory_of(const Case& c, netmesh_values values) {
    return values == NETMESH_VALUES_THESIS ? c.tau : std::sqrt(2 + c.tau);
}

void offsets(const Case& c) {
    Session exact(c.dim);
    REQUIRE(exact.alpha(c.points) == NETMESH_OK);
    const Diagram truth = diagram(exact);
    Session session(c.dim);
    session.bounds = true;
    session.request.mesh.tau = c.tau;
    const std::uint32_t dim = static_cast<std::uint32_t>(c.dim);
    for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
        const bool own = values == NETMESH_VALUES_THESIS;
        REQUIRE(session.mesh_and_persist(c.points, persist_by(&netmesh_filter_complete, 0, values)) == NETMESH_OK);
        judge(c, session, own ? "complete, thesis" : "complete", truth, log_distance(diagram(session), truth, dim),
              theory_of(c, values));
    }
    REQUIRE(session.mesh_and_persist(c.points, &netmesh_filter_basic) == NETMESH_OK);
    const double from = session.report().diagram.certified_from;
    judge(c, session, "basic", truth,
          distance_of_positive(seen_from(diagram(session), from), seen_from(truth, from), c.dim),
          theory_of(c, NETMESH_VALUES_CERTIFIED));
}

void tight_and_scales(const Case& c, double eps) {
    Session exact(c.dim);
    REQUIRE(exact.alpha(c.points) == NETMESH_OK);
    const Diagram truth = diagram(exact);
    const std::uint32_t dim = static_cast<std::uint32_t>(c.dim);
    Session session(c.dim);
    session.bounds = true;
    session.request.goal.eps = eps;
    REQUIRE(session.mesh_and_persist(c.points, persist_by(&netmesh_filter_tight), &netmesh_filter_tight) == NETMESH_OK);
    judge(c, session, eps == 0.5 ? "tight, eps 1/2" : "tight, eps 1/4", truth,
          log_distance(diagram(session), truth, dim), 1 + eps);
    netmesh::Request scales = session.scales_request(c.points);
    scales.goal.eps = eps;
    REQUIRE(session.persist_until_it_fits(scales) == NETMESH_OK);
    judge(c, session, eps == 0.5 ? "scales, eps 1/2" : "scales, eps 1/4", truth,
          log_distance(diagram(session), truth, dim), (1 + 3.0 / 9) * (1 + eps));
}

// d_k by brute force: the barycentric Cech complex of all nested sets.
void nearest_k(const Case& c, std::uint32_t k) {
    Session exact(c.dim);
    const std::uint32_t top = static_cast<std::uint32_t>(c.dim) - 1;
    REQUIRE(exact.persist_until_it_fits(exact.points_request(c.points, &netmesh_filter_barycentric_cech, k, top)) ==
            NETMESH_OK);
    const Diagram truth = diagram(exact);
    Session session(c.dim);
    session.bounds = true;
    session.request.mesh.tau = c.tau;
    REQUIRE(session.mesh_and_persist(c.points, persist_by(&netmesh_filter_knn, k)) == NETMESH_OK);
    judge(c, session, k == 2 ? "knn, k = 2" : "knn, k = 3", truth, distance_of_positive(diagram(session), truth, c.dim),
          std::sqrt(4 + c.tau));
}

void k_distance(const Case& c, std::uint32_t k, unsigned side) {
    Session session(c.dim);
    session.bounds = true;
    session.request.mesh.tau = c.tau;
    REQUIRE(session.mesh_and_persist(c.points, persist_by(&netmesh_filter_kdistance, k)) == NETMESH_OK);
    const netmesh_report r = session.report();
    double least, doubt;
    const Diagram truth =
        on_grid({&c.points, c.dim, k, true}, r.mesh.domain, r.mesh.domain[c.dim], side, &least, &doubt);
    const double slack = 1 + doubt / (least - doubt);
    REQUIRE(slack < 2);
    judge(c, session, "kdistance, k = 4", truth, distance_of_positive(diagram(session), truth, c.dim),
          std::sqrt(2 + std::sqrt(4.0 / 3) * (2 + c.tau)), slack);
}

}  // namespace

TEST_CASE("offsets: complete and basic") {
    print_head();
    offsets({"uniform", 2, inputs::uniform(2, 200), 2.5});
    offsets({"circle", 2, inputs::circle(80), 2.5});
    offsets({"noisy circle", 2, inputs::shell(2, 150, 1, 1.05, 11), 2.2});
    offsets({"eight", 2, inputs::eight(120, 0.05, 16), 3.08});
    offsets({"annulus", 2, inputs::shell(2, 200, 0.6, 1, 15), 4});
    offsets({"clusters", 2, inputs::clusters(2, 100), 2.5});
    offsets({"uniform", 3, inputs::uniform(3, 80), 2.5});
    offsets({"sphere", 3, inputs::shell(3, 100, 1, 1, 22), 3.08});
    offsets({"torus", 3, inputs::torus(150, 27), 3.08});
    offsets({"grid", 3, inputs::grid(3, 4), 2.5});
    offsets({"Clifford", 4, inputs::clifford(60), 4});
    offsets({"uniform", 4, inputs::uniform(4, 20), 4});
    offsets({"sphere", 4, inputs::shell(4, 30, 1, 1, 5), 4});
}

TEST_CASE("offsets: tight, and scale by scale") {
    print_head();
    tight_and_scales({"uniform", 2, inputs::uniform(2, 30), 2.5}, 0.5);
    tight_and_scales({"uniform", 2, inputs::uniform(2, 20), 2.5}, 0.25);
    tight_and_scales({"circle", 2, inputs::circle(24), 2.5}, 0.5);
    tight_and_scales({"clusters", 2, inputs::clusters(2, 25), 2.5}, 0.5);
    tight_and_scales({"grid", 2, inputs::grid(2, 5), 2.5}, 0.5);
    tight_and_scales({"sphere", 3, inputs::shell(3, 8, 1, 1, 22), 2.5}, 0.5);
}

TEST_CASE("k nearest neighbours") {
    print_head();
    nearest_k({"uniform", 2, inputs::uniform(2, 16), 2.5}, 2);
    nearest_k({"uniform", 2, inputs::uniform(2, 13), 2.5}, 3);
    nearest_k({"circle", 2, inputs::circle(15), 2.5}, 2);
    nearest_k({"eight", 2, inputs::eight(14, 0.1, 16), 2.2}, 3);
    nearest_k({"uniform", 3, inputs::uniform(3, 11), 2.5}, 2);
    nearest_k({"sphere", 3, inputs::shell(3, 11, 1, 1, 22), 2.5}, 2);
    nearest_k({"uniform", 3, inputs::uniform(3, 10), 3.08}, 3);
}

TEST_CASE("k-distance") {
    print_head();
    k_distance({"uniform", 2, inputs::uniform(2, 40), 2.5}, 4, 240);
    k_distance({"annulus", 2, inputs::shell(2, 80, 0.8, 1, 15), 2.5}, 4, 260);
    k_distance({"grid", 2, inputs::grid(2, 5), 2.5}, 4, 200);
    k_distance({"eight", 2, inputs::eight(60, 0.05, 16), 2.5}, 4, 260);
    k_distance({"sphere", 3, inputs::shell(3, 40, 1, 1, 22), 2.5}, 4, 50);
    k_distance({"uniform", 3, inputs::uniform(3, 25), 2.5}, 4, 50);
}
