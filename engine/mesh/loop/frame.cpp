#include "mesh/loop/frame.hpp"

#include "delaunay/independent_points.hpp"
#include "numerics/vector.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

Status open_frame(AnyStore store, const AnyInputTree& tree, const AnyDomain& domain, double reach,
                  std::uint64_t* steps) {
    const int size = 2 * store.dim;
    if (!store.has_room(0, static_cast<std::uint32_t>(size), 0)) return Status::out_of_memory;
    std::uint32_t frame[2 * dimension_max];
    for (int i = 0; i < size; ++i) {
        double x[dimension_max], d2;
        copy(store.dim, domain.centre, x);
        x[i / 2] += i % 2 == 0 ? reach : -reach;
        frame[i] = make_vertex(store, x, tree.nearest(x, 0, none, &d2), Marker::exempt);
    }
    for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j) {
            const double d2 = distance2(store.dim, store.point(frame[i]), store.point(frame[j]));
            if (i != j && d2 < store.vertex(frame[i]).nearest2) store.vertex(frame[i]).nearest2 = d2;
        }
    VertexId ids[dimension_max + 1];
    if (!independent_points(store, frame, static_cast<std::uint32_t>(size), ids)) return Status::internal;
    Kernel<any_dimension> kernel(store, corner_error_max, VertexCells::kept);
    const Status status = kernel.start(ids);
    if (status != Status::ok) return status;
    for (int i = 0; i < size; ++i) {
        if (store.vertex(frame[i]).cell != none) continue;
        const VertexId v(frame[i]);
        const double* const q = store.point(v);
        Cavity cavity;
        if (!kernel.find_cavity(q, v, kernel.locate(q, v, store.state.last_cell), &cavity) ||
            !kernel.can_fill(cavity, 0))
            return Status::out_of_memory;
        kernel.fill(cavity, v);
    }
    *steps += kernel.steps();
    return Status::ok;
}

}  // namespace netmesh
