#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include "delaunay.hpp"

namespace {

Cells<3> cgal_cells(const inputs::Points& points) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
    using Structure = CGAL::Triangulation_data_structure_3<Vertex, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
    CGAL::Delaunay_triangulation_3<Kernel, Structure> triangulation;
    std::vector<std::pair<Kernel::Point_3, std::uint32_t>> rows;
    for (std::size_t i = 0; i < points.size() / 3; ++i)
        rows.emplace_back(Kernel::Point_3(points[3 * i], points[3 * i + 1], points[3 * i + 2]),
                          static_cast<std::uint32_t>(i));
    triangulation.insert(rows.begin(), rows.end());
    Cells<3> cells;
    for (auto c = triangulation.finite_cells_begin(); c != triangulation.finite_cells_end(); ++c) {
        cells.push_back({c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()});
        std::sort(cells.back().begin(), cells.back().end());
    }
    std::sort(cells.begin(), cells.end());
    return cells;
}

}  // namespace

TEST_CASE("3D: the same tetrahedra as CGAL") { compare_with_cgal<3>(1000, cgal_cells); }
