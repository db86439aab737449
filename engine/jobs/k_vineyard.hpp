// A vineyard in k (thesis 6.3, 8.1, 8.6): one mesh for all k, the filtrations of a filter by neighbours for
// k = k_first..k_last, and the path of each bar from k to k.
#pragma once
#include <cstdint>

#include "filtration/filters.hpp"
#include "jobs/follow_vines.hpp"

namespace netmesh {

struct VineRequest {
    netmesh_filter_id filter;       // with has_vineyard
    const MeshFilter* on_mesh;      // that filter's
    std::uint32_t k_first, k_last;  // 1 <= k_first <= k_last <= number of inputs; k = 1 is the complete filter (7.4.2)
    FilterValues values;
    std::uint32_t max_degree;  // 0..D-1
};

// The diagram at each k is that of netmesh_persist with the same k. `out` is put at the arena's low end, everything
// else is given back; without ok nothing stays. Memory: about 100 bytes a simplex of dimension up to max_degree + 1,
// and the columns. out_of_memory, cancelled.
Status k_vineyard(const AnyMesh& mesh, const VineRequest& request, const Work& work, VineList* out);

}  // namespace netmesh
