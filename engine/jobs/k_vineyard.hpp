// A vineyard in k (thesis 6.3, 8.1, 8.6): one mesh for all k, the filtrations of a filter by neighbours for
// k = k_first..k_last, and the path of each bar from k to k.
#pragma once
#include <cstdint>

#include "filtration/filters.hpp"

namespace netmesh {

// A pair of the diagram of one k: where a vine is there. Vines are numbered from 0 by degree, the first k at which they
// have a length, and birth and death there; a vine is listed for the k at which it has a length only.
struct VinePoint {
    double birth, death;
    std::uint32_t vine, k, degree, unused;
};

struct VineList {
    const double* ratio;      // [k_last - k_first + 1], certified ratios, at the arena's low end, then the points
    const VinePoint* points;  // [count], by vine, then k
    std::uint64_t count;
    std::uint32_t vine_count;
    std::uint64_t simplices, transpositions;
};

struct VineRequest {
    netmesh_filter filter;          // with has_vineyard
    std::uint32_t k_first, k_last;  // 1 <= k_first <= k_last <= number of inputs; k = 1 is the complete filter (7.4.2)
    FilterValues values;
    std::uint32_t max_degree;  // 0..D-1
};

// The diagram at each k is that of netmesh_persist with the same k. `out` is put at the arena's low end, everything
// else is given back; without ok nothing stays. Memory: about 100 bytes a simplex of dimension up to max_degree + 1,
// and the columns. out_of_memory, cancelled.
template <int D>
Status k_vineyard(const FilteredMesh<D>& mesh, const VineRequest& request, const Work& work, VineList* out);

}  // namespace netmesh
