#include "mesh/frame.hpp"

#include "delaunay/independent_points.hpp"
#include "numerics/vector.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

template <int D>
Status open_frame(Store<D>& store, Kernel<D>& kernel, const InputTree<D>& tree, const Domain<D>& domain, double reach) {
    if (!store.has_room(0, 2 * D, 0)) return Status::out_of_memory;
    std::uint32_t frame[2 * D];
    for (int i = 0; i < 2 * D; ++i) {
        double x[D], d2;
        for (int k = 0; k < D; ++k) x[k] = domain.centre[k];
        x[i / 2] += i % 2 == 0 ? reach : -reach;
        frame[i] = make_vertex<D>(store, x, tree.nearest(x, 0, none, &d2), Marker::exempt);
    }
    for (int i = 0; i < 2 * D; ++i)
        for (int j = 0; j < 2 * D; ++j) {
            const double d2 = distance2<D>(store.point(frame[i]), store.point(frame[j]));
            if (i != j && d2 < store.vertex(frame[i]).nearest2) store.vertex(frame[i]).nearest2 = d2;
        }
    VertexId ids[D + 1];
    if (!independent_points(store, frame, 2 * D, ids)) return Status::internal;
    const Status status = kernel.start(ids);
    if (status != Status::ok) return status;
    for (int i = 0; i < 2 * D; ++i) {
        if (store.vertex(frame[i]).cell != none) continue;
        const VertexId v(frame[i]);
        const double* const q = store.point(v);
        Cavity cavity;
        if (!kernel.find_cavity(q, v, kernel.locate(q, v, store.state.last_cell), &cavity) ||
            !kernel.can_fill(cavity, 0))
            return Status::out_of_memory;
        kernel.fill(cavity, v);
    }
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status open_frame<D>(Store<D>&, Kernel<D>&, const InputTree<D>&, const Domain<D>&, double);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
