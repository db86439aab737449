// From what radius on a Rips complex of points has nothing of degree 1 any more: by alpha complexes.
//
// At each radius r the Cech and the Rips complex have the same edges, and the Cech complex is in the Rips complex. So
// every cycle of edges in the Rips complex is one in the Cech complex, and from where that has no homology of degree 1
// any more the Rips complex has none either. The Cech complex has that of the alpha complex: nothing from its last
// death of degree 1 on. What enters later changes nothing but components, whose bars are those of the alpha complex, as
// a shortest spanning tree is in the Delaunay triangulation.
#pragma once
#include <cstdint>

#include "jobs/point_set.hpp"
#include "memory/work.hpp"

namespace netmesh {

struct RipsBound {
    double limit;       // edges up to this one and components tell all of degrees 0 and 1
    double* joined_at;  // when the components that are left at the limit are joined, ascending, as far as the threshold
    std::uint32_t joins;
};

// Of points in 2 or 3 dimensions. Without a bound, as of points in a plane of space or of more cells than are worth it:
// the threshold, and no components. joined_at lies at the arena's low end; besides it takes bound_bytes. out_of_memory,
// cancelled.
Status bound_rips(const PointSet& points, double threshold, const Work& work, RipsBound* out);

// What it takes besides, whatever the points are; 0: there is no bound, as for few points, whose edges are as fast.
std::size_t bound_bytes(std::uint64_t n, std::uint32_t dim);

}  // namespace netmesh
