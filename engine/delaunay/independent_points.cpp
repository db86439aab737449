#include "delaunay/independent_points.hpp"

namespace netmesh {

// K+1 points span a K-flat exactly when K of the coordinates have a non-zero minor; a set of coordinates that works for
// the first K points can be extended by one of the others, so no more than dim - K of them are tried for each point.
void IndependentPoints::offer(VertexId v) {
    if (are_enough()) return;
    p_[count_] = store_.point(v);
    ids_[count_] = v;
    if (count_ == 0) {
        count_ = 1;
        return;
    }
    for (int axis = 0; axis < store_.dim; ++axis) {
        bool used = false;
        for (int j = 0; j + 1 < count_; ++j) used |= axes_[j] == axis;
        if (used) continue;
        axes_[count_ - 1] = axis;
        if (orient_projected(count_, p_, axes_, store_.state.orient_counts) == Sign::zero) continue;
        ++count_;
        return;
    }
}

bool independent_points(const AnyStore& store, const std::uint32_t* order, std::uint32_t count, VertexId* ids) {
    IndependentPoints found(store);
    for (std::uint32_t k = 0; k < count && !found.are_enough(); ++k) {
        store.arena.step(k, 300);
        found.offer(VertexId(order[k]));
    }
    for (int i = 0; i <= store.dim; ++i) ids[i] = found.ids()[i];
    return found.are_enough();
}

}  // namespace netmesh
