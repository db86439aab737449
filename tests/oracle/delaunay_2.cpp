#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include "delaunay.hpp"

namespace {

Cells<2> cgal_cells(const inputs::Points& points) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
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

}  // namespace

TEST_CASE("2D: the same triangles as CGAL") { compare_with_cgal<2>(2000, cgal_cells); }
