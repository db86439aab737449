#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_3.h>
#include <CGAL/Periodic_3_Delaunay_triangulation_traits_3.h>
#include <CGAL/Regular_triangulation_3.h>

#include "contestants.hpp"

namespace bench {

void cgal_delaunay_3(Trial& trial, const inputs::Points& points) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Point_3> rows;
    for (std::size_t i = 0; i < points.size(); i += 3) rows.emplace_back(points[i], points[i + 1], points[i + 2]);
    CGAL::Delaunay_triangulation_3<Kernel> triangulation;
    trial.start();
    triangulation.insert(rows.begin(), rows.end());
    trial.stop();
    trial.figure(cells, static_cast<double>(triangulation.number_of_finite_cells()));
}

void cgal_regular_3(Trial& trial, const inputs::Points& points, const inputs::Points& weights) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Weighted_point_3> rows;
    for (std::size_t i = 0; i < weights.size(); ++i)
        rows.emplace_back(Kernel::Point_3(points[3 * i], points[3 * i + 1], points[3 * i + 2]), weights[i]);
    CGAL::Regular_triangulation_3<Kernel> triangulation;
    trial.start();
    triangulation.insert(rows.begin(), rows.end());
    trial.stop();
    trial.figure(cells, static_cast<double>(triangulation.number_of_finite_cells()));
    trial.figure(hidden, static_cast<double>(weights.size() - triangulation.number_of_vertices()));
}

void cgal_periodic_3(Trial& trial, const inputs::Points& points) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Traits = CGAL::Periodic_3_Delaunay_triangulation_traits_3<Kernel>;
    std::vector<Traits::Point_3> rows;
    for (std::size_t i = 0; i < points.size(); i += 3) rows.emplace_back(points[i], points[i + 1], points[i + 2]);
    CGAL::Periodic_3_Delaunay_triangulation_3<Traits> triangulation(Traits::Iso_cuboid_3(0, 0, 0, 1, 1, 1));
    trial.start();
    triangulation.insert(rows.begin(), rows.end(), true);
    trial.stop();
    trial.figure(cells, static_cast<double>(triangulation.number_of_cells()));
}

}  // namespace bench
