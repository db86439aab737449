#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

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

}  // namespace bench
