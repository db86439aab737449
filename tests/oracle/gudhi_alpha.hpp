// GUDHI's alpha complex in exact arithmetic. Its values are exact squares of radii, rounded to double.
#pragma once
#include <gudhi/Alpha_complex.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <vector>

#include "common/inputs.hpp"

struct GudhiAlpha {
    Gudhi::Simplex_tree<> tree;

    GudhiAlpha(int dim, const inputs::Points& points) {
        using Kernel = CGAL::Epeck_d<CGAL::Dynamic_dimension_tag>;
        std::vector<Kernel::Point_d> rows;
        for (auto at = points.begin(); at != points.end(); at += dim) rows.emplace_back(at, at + dim);
        Gudhi::alpha_complex::Alpha_complex<Kernel> complex(rows);
        REQUIRE(complex.create_complex(tree, std::numeric_limits<double>::infinity(), true));
    }
    // visit(degree, birth, death): radii; bars of no length as well.
    template <class Visit> void for_each_bar(Visit visit) {
        using Field = Gudhi::persistent_cohomology::Field_Zp;
        tree.initialize_filtration();
        Gudhi::persistent_cohomology::Persistent_cohomology<Gudhi::Simplex_tree<>, Field> cohomology(tree);
        cohomology.init_coefficients(2);
        cohomology.compute_persistent_cohomology(-1);
        for (const auto& pair : cohomology.get_persistent_pairs()) {
            const auto birth = std::get<0>(pair), death = std::get<1>(pair);
            visit(tree.dimension(birth), std::sqrt(tree.filtration(birth)), std::sqrt(tree.filtration(death)));
        }
    }
};
