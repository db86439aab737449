#include <cmath>

#include <CGAL/Epick_d.h>
#include <gudhi/Alpha_complex.h>
#include <gudhi/Alpha_complex_3d.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include "contestants.hpp"

namespace bench {
namespace {

// The fast options with double values. Hidden points leave gaps between vertices.
struct Options : Gudhi::Simplex_tree_options_full_featured {
    static const bool contiguous_vertices = true;
};
using Tree = Gudhi::Simplex_tree<Options>;
using TreeWithGaps = Gudhi::Simplex_tree<>;

// make(tree) builds the alpha complex; its values are squared radii, or powers: of these no roots are taken.
template <class Tree = bench::Tree, class Make> void persist(Trial& trial, Make make, bool are_powers = false) {
    using Cohomology =
        Gudhi::persistent_cohomology::Persistent_cohomology<Tree, Gudhi::persistent_cohomology::Field_Zp>;
    trial.start();
    Tree tree;
    make(tree);
    tree.initialize_filtration();
    Cohomology cohomology(tree, true);
    cohomology.init_coefficients(2);
    cohomology.compute_persistent_cohomology(0);
    trial.stop();
    trial.figure(simplices, static_cast<double>(tree.num_simplices()));
    const auto value_of = [=](double power) { return are_powers ? power : std::sqrt(power); };
    for (const auto& pair : cohomology.get_persistent_pairs()) {
        const auto birth = std::get<0>(pair), death = std::get<1>(pair);
        trial.outcome.diagram.push_back(
            bar(static_cast<std::uint32_t>(tree.dimension(birth)), value_of(tree.filtration(birth)),
                death == tree.null_simplex() ? INFINITY : value_of(tree.filtration(death))));
    }
}

template <int D> void persist_d(Trial& trial, const inputs::Points& points) {
    using Kernel = CGAL::Epick_d<CGAL::Dimension_tag<D>>;
    std::vector<typename Kernel::Point_d> rows;
    for (std::size_t i = 0; i < points.size(); i += D) rows.emplace_back(&points[i], &points[i] + D);
    persist(trial, [&](Tree& tree) { Gudhi::alpha_complex::Alpha_complex<Kernel>(rows).create_complex(tree); });
}

}  // namespace

void gudhi_alpha(Trial& trial, int dim, const inputs::Points& points) {
    if (dim == 2) persist_d<2>(trial, points);
    if (dim == 4) persist_d<4>(trial, points);
    if (dim == 3) {
        using Alpha = Gudhi::alpha_complex::Alpha_complex_3d<Gudhi::alpha_complex::complexity::FAST>;
        std::vector<Alpha::Bare_point_3> rows;
        for (std::size_t i = 0; i < points.size(); i += 3) rows.emplace_back(points[i], points[i + 1], points[i + 2]);
        persist(trial, [&](Tree& tree) { Alpha(rows).create_complex(tree); });
    }
}

void gudhi_weighted_alpha(Trial& trial, int dim, const inputs::Points& points, const inputs::Points& weights) {
    if (dim == 2) {
        using Kernel = CGAL::Epick_d<CGAL::Dimension_tag<2>>;
        std::vector<typename Kernel::Point_d> rows;
        for (std::size_t i = 0; i < points.size(); i += 2) rows.emplace_back(&points[i], &points[i] + 2);
        const auto make = [&](TreeWithGaps& tree) {
            Gudhi::alpha_complex::Alpha_complex<Kernel, true>(rows, weights).create_complex(tree);
        };
        persist<TreeWithGaps>(trial, make, true);
    } else {
        using Alpha = Gudhi::alpha_complex::Alpha_complex_3d<Gudhi::alpha_complex::complexity::FAST, true>;
        std::vector<Alpha::Bare_point_3> rows;
        for (std::size_t i = 0; i < points.size(); i += 3) rows.emplace_back(points[i], points[i + 1], points[i + 2]);
        persist(
            trial, [&](Tree& tree) { Alpha(rows, weights).create_complex(tree); }, true);
    }
}

void gudhi_periodic_alpha_3(Trial& trial, const inputs::Points& points) {
    using Alpha = Gudhi::alpha_complex::Alpha_complex_3d<Gudhi::alpha_complex::complexity::FAST, false, true>;
    std::vector<Alpha::Bare_point_3> rows;
    for (std::size_t i = 0; i < points.size(); i += 3) rows.emplace_back(points[i], points[i + 1], points[i + 2]);
    persist(trial, [&](Tree& tree) { Alpha(rows, 0, 0, 0, 1, 1, 1).create_complex(tree); });
}

}  // namespace bench
