// Lower-star persistence where the dimension is a number.
#include "homology/cycles/cycles.hpp"
#include "homology/lower_star/lower_star.hpp"

namespace netmesh {

Status persist_lower_star(const LowerStarFiltration<any_dimension>& filtration, DiagramRequest request,
                          const Work& work, CountedPairs* out) {
    return with_dimension(filtration.complex.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        return persist_lower_star<D>(filtration.of_dimension<D>({}).get(), request, work, out);
    });
}

Status lower_star_cycles(const LowerStarFiltration<any_dimension>& filtration, std::uint32_t max_degree,
                         std::uint64_t pair_count, const Work& work, Representatives* out) {
    return with_dimension(filtration.complex.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        return lower_star_cycles<D>(filtration.of_dimension<D>({}).get(), max_degree, pair_count, work, out);
    });
}

}  // namespace netmesh
