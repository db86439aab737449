#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
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

}  // namespace bench
