#include "certificate/cells.hpp"

#include "vocabulary/dimension.hpp"

namespace netmesh {

void measure_cells(const AnyStore& store, double* out_radius, double* reach, std::uint32_t first) {
    with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        measure_cells<D>(store.of_dimension<D>(), out_radius, reach, first);
    });
}

}  // namespace netmesh
