#include "delaunay/independent_points.hpp"

namespace netmesh {

// K+1 points span a K-flat exactly when K of the coordinates have a non-zero minor; a set of coordinates that works for
// the first K points can be extended by one of the others, so no more than dim - K of them are tried for each point.
bool independent_points(const AnyStore& store, const std::uint32_t* order, std::uint32_t count, VertexId* ids) {
    const double* p[dimension_max + 1];
    int axes[dimension_max] = {};
    PredicateCounts& counts = store.state.orient_counts;
    if (count == 0) return false;
    ids[0] = VertexId(order[0]);
    p[0] = store.point(ids[0]);
    int rank = 0;
    for (std::uint32_t k = 1; k < count && rank < store.dim; ++k) {
        store.arena.step(k, 300);
        p[rank + 1] = store.point(order[k]);
        for (int axis = 0; axis < store.dim; ++axis) {
            bool used = false;
            for (int j = 0; j < rank; ++j) used |= axes[j] == axis;
            if (used) continue;
            axes[rank] = axis;
            if (orient_projected(rank + 1, p, axes, counts) == Sign::zero) continue;
            ids[++rank] = VertexId(order[k]);
            break;
        }
    }
    return rank == store.dim;
}

}  // namespace netmesh
