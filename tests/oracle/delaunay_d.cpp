#include <CGAL/Delaunay_triangulation.h>
#include <CGAL/Epick_d.h>

#include "common/dimensions.hpp"
#include "delaunay.hpp"

namespace {

template <int D> Cells<D> cgal_cells(const inputs::Points& points) {
    using Kernel = CGAL::Epick_d<CGAL::Dimension_tag<D>>;
    using Structure =
        CGAL::Triangulation_data_structure<CGAL::Dimension_tag<D>, CGAL::Triangulation_vertex<Kernel, std::uint32_t>,
                                           CGAL::Triangulation_full_cell<Kernel>>;
    CGAL::Delaunay_triangulation<Kernel, Structure> triangulation(D);
    for (std::size_t i = 0; i < points.size() / D; ++i)
        triangulation.insert(typename Kernel::Point_d(&points[i * D], &points[i * D] + D))->data() =
            static_cast<std::uint32_t>(i);
    Cells<D> cells;
    for (auto c = triangulation.finite_full_cells_begin(); c != triangulation.finite_full_cells_end(); ++c) {
        cells.emplace_back();
        for (int v = 0; v <= D; ++v) cells.back()[static_cast<std::size_t>(v)] = c->vertex(v)->data();
        std::sort(cells.back().begin(), cells.back().end());
    }
    std::sort(cells.begin(), cells.end());
    return cells;
}

template <int D>
bool on_sphere(const inputs::Points& points, const std::array<std::uint32_t, D + 1>& cell, std::uint32_t q) {
    using Kernel = CGAL::Epick_d<CGAL::Dimension_tag<D>>;
    std::vector<typename Kernel::Point_d> sphere;
    for (const std::uint32_t v : cell) sphere.emplace_back(&points[v * D], &points[v * D] + D);
    const typename Kernel::Point_d point(&points[q * D], &points[q * D] + D);
    return Kernel().side_of_oriented_sphere_d_object()(sphere.begin(), sphere.end(), point) ==
           CGAL::ON_ORIENTED_BOUNDARY;
}

}  // namespace

TEST_CASE("4D: the same polytopes as CGAL where points are cospherical") {
    for_each_dimension<4, 4>(
        [](auto dim) { compare_degenerate_with_cgal<dim>(4, 10, 0x1p12, cgal_cells<4>, on_sphere<4>); });
}
TEST_CASE("5D: the same polytopes as CGAL where points are cospherical") {
    for_each_dimension<5, 5>(
        [](auto dim) { compare_degenerate_with_cgal<dim>(3, 3, 0x1p8, cgal_cells<5>, on_sphere<5>); });
}
TEST_CASE("4D: the same cells as CGAL") {
    for_each_dimension<4, 4>([](auto dim) { compare_with_cgal<dim>(300, cgal_cells<4>); });
}
TEST_CASE("5D: the same cells as CGAL") {
    for_each_dimension<5, 5>([](auto dim) { compare_with_cgal<dim>(150, cgal_cells<5>); });
}
TEST_CASE("6D: the same cells as CGAL") {
    for_each_dimension<6, 6>([](auto dim) { compare_with_cgal<dim>(60, cgal_cells<6>); });
}
