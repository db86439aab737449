#include <CGAL/Delaunay_triangulation.h>
#include <CGAL/Epick_d.h>

#include "contestants.hpp"

namespace bench {
namespace {

template <int D> void triangulate(Trial& trial, const inputs::Points& points) {
    using Kernel = CGAL::Epick_d<CGAL::Dimension_tag<D>>;
    std::vector<typename Kernel::Point_d> rows;
    for (std::size_t i = 0; i < points.size(); i += D) rows.emplace_back(&points[i], &points[i] + D);
    CGAL::Delaunay_triangulation<Kernel> triangulation(D);
    trial.start();
    triangulation.insert(rows.begin(), rows.end());
    trial.stop();
    trial.figure(cells, static_cast<double>(triangulation.number_of_finite_full_cells()));
}

}  // namespace

void cgal_delaunay_d(Trial& trial, int dim, const inputs::Points& points) {
    if (dim == 4) triangulate<4>(trial, points);
    if (dim == 5) triangulate<5>(trial, points);
    if (dim == 6) triangulate<6>(trial, points);
}

}  // namespace bench
