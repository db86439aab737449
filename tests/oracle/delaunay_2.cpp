#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "delaunay.hpp"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Cells<2> cgal_cells(const inputs::Points& points) {
    using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>> triangulation;
    std::vector<std::pair<Kernel::Point_2, std::uint32_t>> rows;
    for (std::size_t i = 0; i < points.size() / 2; ++i)
        rows.emplace_back(Kernel::Point_2(points[2 * i], points[2 * i + 1]), static_cast<std::uint32_t>(i));
    triangulation.insert(rows.begin(), rows.end());
    Cells<2> cells;
    for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f) {
        cells.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
        std::sort(cells.back().begin(), cells.back().end());
    }
    std::sort(cells.begin(), cells.end());
    return cells;
}

bool on_circle(const inputs::Points& points, const std::array<std::uint32_t, 3>& cell, std::uint32_t q) {
    const auto point = [&](std::uint32_t i) { return Kernel::Point_2(points[2 * i], points[2 * i + 1]); };
    return CGAL::side_of_bounded_circle(point(cell[0]), point(cell[1]), point(cell[2]), point(q)) == CGAL::ON_BOUNDARY;
}

}  // namespace

TEST_CASE("2D: the same triangles as CGAL") { compare_with_cgal<2>(2000, cgal_cells); }
TEST_CASE("2D: the same polygons as CGAL where points are cocircular") {
    compare_degenerate_with_cgal<2>(24, 5 * 5 * 13 * 17, 0x1p30, cgal_cells, on_circle);
}
