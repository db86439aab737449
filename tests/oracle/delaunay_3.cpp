#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include "delaunay.hpp"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Cells<3> cgal_cells(const inputs::Points& points) {
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

bool on_sphere(const inputs::Points& points, const std::array<std::uint32_t, 4>& cell, std::uint32_t q) {
    const auto point = [&](std::uint32_t i) {
        return Kernel::Point_3(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
    };
    return CGAL::side_of_bounded_sphere(point(cell[0]), point(cell[1]), point(cell[2]), point(cell[3]), point(q)) ==
           CGAL::ON_BOUNDARY;
}

}  // namespace

TEST_CASE("3D: the same tetrahedra as CGAL") { compare_with_cgal<3>(1000, cgal_cells); }
TEST_CASE("3D: the same polyhedra as CGAL where points are cospherical") {
    compare_degenerate_with_cgal<3>(9, 3 * 3 * 29, 0x1p24, cgal_cells, on_sphere);
}
