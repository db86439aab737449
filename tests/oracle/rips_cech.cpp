// Rips and Cech filtrations against GUDHI: diagrams of degrees up to 2, in D = 2..6, degenerate points among them.
#include <gudhi/Cech_complex.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Rips_complex.h>
#include <gudhi/Simplex_tree.h>
#include <gudhi/distance_functions.h>

#include <CGAL/Epeck_d.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "common/bottleneck.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "common/session.hpp"

namespace {

using Tree = Gudhi::Simplex_tree<>;
using Field = Gudhi::persistent_cohomology::Field_Zp;
using Diagram = std::vector<netmesh_pair>;

Diagram diagram_of(Tree& tree, double factor, int max_degree) {
    tree.initialize_filtration();
    Gudhi::persistent_cohomology::Persistent_cohomology<Tree, Field> cohomology(tree);
    cohomology.init_coefficients(2);
    cohomology.compute_persistent_cohomology(-1);
    Diagram bars;
    for (const auto& pair : cohomology.get_persistent_pairs()) {
        const auto birth = std::get<0>(pair), death = std::get<1>(pair);
        const int degree = tree.dimension(birth);
        if (degree > max_degree) continue;
        bars.push_back(bar(static_cast<std::uint32_t>(degree), factor * tree.filtration(birth),
                           death == tree.null_simplex() ? HUGE_VAL : factor * tree.filtration(death)));
    }
    return bars;
}

Diagram rips(int dim, const inputs::Points& points, int max_degree) {
    std::vector<std::vector<double>> rows;
    for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(dim))
        rows.emplace_back(points.begin() + static_cast<std::ptrdiff_t>(i),
                          points.begin() + static_cast<std::ptrdiff_t>(i) + dim);
    Gudhi::rips_complex::Rips_complex<double> complex(rows, std::numeric_limits<double>::infinity(),
                                                      Gudhi::Euclidean_distance());
    Tree tree;
    complex.create_complex(tree, max_degree + 1);
    return diagram_of(tree, 0.5, max_degree);
}

Diagram cech(int dim, const inputs::Points& points, int max_degree) {
    using Kernel = CGAL::Epeck_d<CGAL::Dynamic_dimension_tag>;
    std::vector<Kernel::Point_d> rows;
    for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(dim))
        rows.emplace_back(points.begin() + static_cast<std::ptrdiff_t>(i),
                          points.begin() + static_cast<std::ptrdiff_t>(i) + dim);
    Gudhi::cech_complex::Cech_complex<Kernel, Tree> complex(rows, 1e9, true);
    Tree tree;
    complex.create_complex(tree, max_degree + 1);
    return diagram_of(tree, 1, max_degree);
}

// GUDHI keeps bars whose ends differ by a rounding error; the bottleneck distance is not bothered by them.
void compare(int dim, const std::string& name, const inputs::Points& points, const netmesh_filter* filter,
             int max_degree) {
    if (dimensions({dim}).empty()) return;
    CAPTURE(dim);
    CAPTURE(name);
    Session session(dim);
    const std::uint32_t degree = static_cast<std::uint32_t>(max_degree);
    REQUIRE(session.persist_until_it_fits(session.points_request(points, filter, 1, degree)) == NETMESH_OK);
    const Diagram ours = session.pairs();
    const Diagram theirs =
        filter == &netmesh_filter_rips ? rips(dim, points, max_degree) : cech(dim, points, max_degree);
    const Distance d = bottleneck(ours, theirs);
    REQUIRE(d.status == NETMESH_OK);
    CHECK(d.value <= 1e-9);
}

}  // namespace

TEST_CASE("Rips") {
    compare(2, "uniform", inputs::uniform(2, 60), &netmesh_filter_rips, 1);
    compare(2, "circle", inputs::circle(40), &netmesh_filter_rips, 2);
    compare(2, "grid", inputs::grid(2, 6), &netmesh_filter_rips, 2);
    compare(3, "torus", inputs::torus(60, 1), &netmesh_filter_rips, 1);
    compare(3, "sphere", inputs::shell(3, 30, 1, 1, 2), &netmesh_filter_rips, 2);
    compare(4, "Clifford helix", inputs::clifford(40), &netmesh_filter_rips, 1);
    compare(6, "uniform", inputs::uniform(6, 18), &netmesh_filter_rips, 3);
}

TEST_CASE("Cech") {
    compare(2, "uniform", inputs::uniform(2, 30), &netmesh_filter_cech, 1);
    compare(2, "circle", inputs::circle(20), &netmesh_filter_cech, 1);
    compare(2, "grid", inputs::grid(2, 4), &netmesh_filter_cech, 2);
    compare(3, "torus", inputs::torus(24, 1), &netmesh_filter_cech, 1);
    compare(3, "sphere", inputs::shell(3, 14, 1, 1, 2), &netmesh_filter_cech, 2);
    compare(3, "grid", inputs::grid(3, 2), &netmesh_filter_cech, 2);
    compare(4, "Clifford helix", inputs::clifford(16), &netmesh_filter_cech, 1);
    compare(5, "uniform", inputs::uniform(5, 12), &netmesh_filter_cech, 2);
}
