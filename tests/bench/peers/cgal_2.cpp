#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_2.h>
#include <CGAL/Periodic_2_Delaunay_triangulation_traits_2.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/version.h>

#include "contestants.hpp"

namespace bench {

const char* cgal_version() { return CGAL_VERSION_STR; }

void cgal_delaunay_2(Trial& trial, const inputs::Points& points) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Point_2> rows;
    for (std::size_t i = 0; i < points.size(); i += 2) rows.emplace_back(points[i], points[i + 1]);
    CGAL::Delaunay_triangulation_2<Kernel> triangulation;
    trial.start();
    triangulation.insert(rows.begin(), rows.end());
    trial.stop();
    trial.figure(cells, static_cast<double>(triangulation.number_of_faces()));
}

void cgal_regular_2(Trial& trial, const inputs::Points& points, const inputs::Points& weights) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Weighted_point_2> rows;
    for (std::size_t i = 0; i < weights.size(); ++i)
        rows.emplace_back(Kernel::Point_2(points[2 * i], points[2 * i + 1]), weights[i]);
    CGAL::Regular_triangulation_2<Kernel> triangulation;
    trial.start();
    triangulation.insert(rows.begin(), rows.end());
    trial.stop();
    trial.figure(cells, static_cast<double>(triangulation.number_of_faces()));
    trial.figure(hidden, static_cast<double>(triangulation.number_of_hidden_vertices()));
}

void cgal_periodic_2(Trial& trial, const inputs::Points& points) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Traits = CGAL::Periodic_2_Delaunay_triangulation_traits_2<Kernel>;
    std::vector<Traits::Point_2> rows;
    for (std::size_t i = 0; i < points.size(); i += 2) rows.emplace_back(points[i], points[i + 1]);
    CGAL::Periodic_2_Delaunay_triangulation_2<Traits> triangulation(Traits::Iso_rectangle_2(0, 0, 1, 1));
    trial.start();
    triangulation.insert(rows.begin(), rows.end(), true);
    trial.stop();
    trial.figure(cells, static_cast<double>(triangulation.number_of_faces()));
}

}  // namespace bench
