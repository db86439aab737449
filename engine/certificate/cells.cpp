#include "certificate/cells.hpp"

#include "vocabulary/dimension.hpp"

namespace netmesh {

double blurred_reach(const AnyStore& store, VertexId v, CellId c) {
    const AnyCell cell = store.cell(c);
    const double radius = square_root(cell.radius2), wrong = static_cast<double>(cell.error) * radius,
                 far = distance(store.dim, cell.centre, store.point(nearest_input(store, v))) + wrong,
                 most = distance_to_inputs(store, v) + (1 + corner_error_max) * radius;
    return (far < most ? far : most) * up;
}

void measure_cells(const AnyStore& store, double* out_radius, double* reach, std::uint32_t first) {
    with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        measure_cells<D>(store.of_dimension<D>(), out_radius, reach, first);
    });
}

}  // namespace netmesh
