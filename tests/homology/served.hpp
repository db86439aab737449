// The engine's calls on lower stars for dimensions that a build may leave out. What asks serves_dimension() first never
// sees their no_result.
#pragma once
#include "homology/cycles/cycles.hpp"
#include "homology/lower_star/lower_star.hpp"
#include "vocabulary/dimension.hpp"

namespace served {

using namespace netmesh;

template <int D>
Status persist_lower_star(const LowerStarFiltration<D>& filtration, DiagramRequest request, const Work& work,
                          CountedPairs* out) {
    if constexpr (serves_dimension(D))
        return netmesh::persist_lower_star<D>(filtration, request, work, out);
    else
        return Status::no_result;
}
template <int D>
Status lower_star_cycles(const LowerStarFiltration<D>& filtration, std::uint32_t max_degree, std::uint64_t pairs,
                         const Work& work, Representatives* out) {
    if constexpr (serves_dimension(D))
        return netmesh::lower_star_cycles<D>(filtration, max_degree, pairs, work, out);
    else
        return Status::no_result;
}

}  // namespace served
