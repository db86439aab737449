// d_k and the k-distance against sublevel sets on a fine grid (GUDHI's cubical complexes and bottleneck distance): the
// log-bottleneck distance is at most the logarithm of the certified ratio, but for what the grid is too coarse to tell.
#include <doctest/doctest.h>
#include <gudhi/Bitmap_cubical_complex.h>
#include <gudhi/Bottleneck.h>
#include <gudhi/Persistent_cohomology.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "common/session.hpp"

namespace {

using Bars = std::vector<std::pair<double, double>>;
using Diagram = std::map<int, Bars>;

struct Set {
    const inputs::Points* points;
    int dim;
    std::size_t k;
    bool mean;
};

double value(const Set& set, const double* x) {
    std::vector<double> d2;
    const std::size_t dim = static_cast<std::size_t>(set.dim);
    for (std::size_t i = 0; i < set.points->size(); i += dim) {
        double sum = 0;
        for (std::size_t a = 0; a < dim; ++a) sum += (x[a] - (*set.points)[i + a]) * (x[a] - (*set.points)[i + a]);
        d2.push_back(sum);
    }
    std::nth_element(d2.begin(), d2.begin() + static_cast<std::ptrdiff_t>(set.k - 1), d2.end());
    if (!set.mean) return std::sqrt(d2[set.k - 1]);
    double sum = 0;
    for (std::size_t i = 0; i < set.k; ++i) sum += d2[i];
    return std::sqrt(sum / static_cast<double>(set.k));
}

// The diagram of min(f, cut) on cubes with `side` of them along each edge of the box centre +- 2.1 cut, outside of which f >= cut;
// *doubt: how far f may be from its value in the middle of a cube.
Diagram on_grid(const Set& set, const double* centre, double cut, unsigned side, double* least, double* doubt) {
    using Complex =
        Gudhi::cubical_complex::Bitmap_cubical_complex<Gudhi::cubical_complex::Bitmap_cubical_complex_base<double>>;
    using Persistence =
        Gudhi::persistent_cohomology::Persistent_cohomology<Complex, Gudhi::persistent_cohomology::Field_Zp>;
    const double width = 4.2 * cut / side;
    *doubt = width * std::sqrt(static_cast<double>(set.dim)) / 2;
    std::vector<double> cubes;
    std::vector<unsigned> at(static_cast<std::size_t>(set.dim), 0);
    *least = cut;
    for (bool more = true; more;) {
        double x[6];
        for (std::size_t a = 0; a < at.size(); ++a) x[a] = centre[a] + width * (at[a] + 0.5 - side / 2.0);
        cubes.push_back(std::min(value(set, x), cut));
        *least = std::min(*least, cubes.back());
        std::size_t a = 0;
        while (a < at.size() && ++at[a] == side) at[a++] = 0;
        more = a < at.size();
    }
    Complex complex(std::vector<unsigned>(static_cast<std::size_t>(set.dim), side), cubes);
    Persistence persistence(complex);
    persistence.init_coefficients(2);
    persistence.compute_persistent_cohomology(0);
    Diagram diagram;
    for (const auto& pair : persistence.get_persistent_pairs()) {
        const double birth = complex.filtration(std::get<0>(pair)), death = complex.filtration(std::get<1>(pair));
        diagram[complex.get_dimension_of_a_cell(std::get<0>(pair))].push_back({birth, death});
    }
    return diagram;
}

Bars logarithms(const Bars& bars) {
    Bars logs;
    for (const auto& [birth, death] : bars) logs.push_back({std::log(birth), std::log(death)});
    return logs;
}

void within_certificate(const std::string& name, int dim, const inputs::Points& points, std::size_t k, bool mean,
                        unsigned side) {
    CAPTURE(name);
    CAPTURE(k);
    Session session(dim);
    session.options.k = static_cast<std::uint32_t>(k);
    for (const netmesh_values values : {NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS}) {
        REQUIRE(session.mesh_and_persist(points, mean ? NETMESH_FILTER_KDISTANCE : NETMESH_FILTER_KNN, values) ==
                NETMESH_OK);
        const netmesh_report report = session.report();
        REQUIRE(report.k == k);
        const Set set = {&points, dim, k, mean};
        double least, doubt;
        // The domain's radius is that of the smallest enclosing ball, or a hair more.
        Diagram truth = on_grid(set, report.domain, report.domain[dim], side, &least, &doubt);
        Diagram ours;
        std::size_t essential = 0;
        for (const netmesh_pair& pair : session.pairs()) {
            if (std::isinf(pair.death)) ++essential;
            ours[static_cast<int>(pair.degree)].push_back({pair.birth, pair.death});
        }
        CHECK(essential == 1);
        double distance = 0;
        for (int degree = 0; degree < dim; ++degree)
            distance = std::max(distance, Gudhi::persistence_diagram::bottleneck_distance(logarithms(truth[degree]),
                                                                                          logarithms(ours[degree]), 0));
        const double slack = std::log(1 + doubt / (least - doubt));
        REQUIRE(slack < 0.7);
        CHECK(distance <= std::log(report.certified_ratio) + slack);
        MESSAGE(name << std::string(mean ? " k-distance" : " d_k") << ", k = " << k
                     << std::string(values == NETMESH_VALUES_THESIS ? " thesis" : " certified")
                     << " values: true ratio " << std::exp(distance) << " (grid " << std::exp(slack) << "), certified "
                     << report.certified_ratio);
    }
}

}  // namespace

TEST_CASE("plane") {
    for (const bool mean : {false, true}) {
        within_certificate("uniform", 2, inputs::uniform(2, 40), 4, mean, 260);
        within_certificate("annulus", 2, inputs::shell(2, 80, 0.8, 1, 15), 5, mean, 260);
        within_certificate("grid", 2, inputs::grid(2, 5), 3, mean, 200);
        within_certificate("figure eight", 2, inputs::eight(60, 0.05, 16), 3, mean, 260);
    }
}

TEST_CASE("space") {
    for (const bool mean : {false, true}) {
        within_certificate("sphere", 3, inputs::shell(3, 50, 1, 1, 22), mean ? 10 : 4, mean, 60);
        within_certificate("uniform", 3, inputs::uniform(3, 30), mean ? 8 : 5, mean, 50);
    }
}

TEST_CASE("k = 1 is the complete filter") {
    const inputs::Points points = inputs::uniform(3, 80);
    Session complete(3), nearest(3), mean(3);
    REQUIRE(complete.mesh_and_persist(points) == NETMESH_OK);
    REQUIRE(nearest.mesh_and_persist(points, NETMESH_FILTER_KNN) == NETMESH_OK);
    REQUIRE(mean.mesh_and_persist(points, NETMESH_FILTER_KDISTANCE) == NETMESH_OK);
    CHECK(nearest.report().fingerprint == complete.report().fingerprint);
    CHECK(mean.report().fingerprint == complete.report().fingerprint);
}
