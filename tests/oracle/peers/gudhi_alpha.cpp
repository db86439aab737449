#include <doctest/doctest.h>
#include <gudhi/Alpha_complex.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <cmath>
#include <limits>
#include <tuple>

#include "oracle/peers/gudhi.hpp"
#include "oracle/peers/gudhi_tree.hpp"

void make_gudhi_tree(int dim, const inputs::Points& points, const inputs::Points& weights,
                     Gudhi::Simplex_tree<>* tree) {
    using Kernel = CGAL::Epeck_d<CGAL::Dynamic_dimension_tag>;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<Kernel::Point_d> rows;
    for (auto at = points.begin(); at != points.end(); at += dim) rows.emplace_back(at, at + dim);
    if (weights.empty()) {
        Gudhi::alpha_complex::Alpha_complex<Kernel> complex(rows);
        REQUIRE(complex.create_complex(*tree, infinity, true));
    } else {
        const std::vector<Kernel::FT> numbers(weights.begin(), weights.end());
        Gudhi::alpha_complex::Alpha_complex<Kernel, true> complex(rows, numbers);
        REQUIRE(complex.create_complex(*tree, infinity, true));
    }
}

GudhiAlpha::GudhiAlpha(int dim, const inputs::Points& points) {
    using Tree = Gudhi::Simplex_tree<>;
    Tree tree;
    make_gudhi_tree(dim, points, {}, &tree);
    for (auto handle : tree.complex_simplex_range()) {
        Simplex simplex = {{}, std::sqrt(tree.filtration(handle))};
        for (auto v : tree.simplex_vertex_range(handle)) simplex.vertices.push_back(static_cast<std::uint32_t>(v));
        simplices.push_back(simplex);
    }
    tree.initialize_filtration();
    Gudhi::persistent_cohomology::Persistent_cohomology<Tree, Gudhi::persistent_cohomology::Field_Zp> cohomology(tree);
    cohomology.init_coefficients(2);
    cohomology.compute_persistent_cohomology(-1);
    for (const auto& pair : cohomology.get_persistent_pairs()) {
        const auto birth = std::get<0>(pair), death = std::get<1>(pair);
        bars.push_back({tree.dimension(birth), std::sqrt(tree.filtration(birth)), std::sqrt(tree.filtration(death))});
    }
}
