#include "mesh/opening.hpp"

#include "numerics/vector.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
template <int D>
Status check_separation(const Store<D>& store, const InputTree<D>& tree, double finest, InputReport* input) {
    const std::uint32_t inputs = store.state.vertex_count;
    for (std::uint32_t v = 0; v < inputs; ++v)
        for (int k = 0; k < D; ++k)
            if (!(absolute(store.point(v)[k]) <= coordinate_max)) {
                input->row_a = store.vertex(v).origin;
                return Status::out_of_range;
            }
    if (inputs == 1) return Status::ok;
    for (std::uint32_t v = 0; v < inputs; ++v) {
        double d2;
        const std::uint32_t near = tree.nearest(store.point(v), v > 0 ? v - 1 : 1, v, &d2);
        double size = 0;
        for (int k = 0; k < D; ++k)
            if (absolute(store.point(v)[k]) > size) size = absolute(store.point(v)[k]);
        const bool tiny = d2 < separation_min * separation_min;
        const double least = finest * size;
        if (!tiny && d2 >= least * least) continue;
        const std::uint64_t a = store.vertex(v).origin, b = store.vertex(near).origin;
        input->row_a = a < b ? a : b;
        input->row_b = a < b ? b : a;
        return tiny && d2 > least * least ? Status::out_of_range : Status::too_close;
    }
    return Status::ok;
}

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
    if (!independent_points<D>(store, frame, 2 * D, ids)) return Status::internal;
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

template <int D> void settle_spheres(Store<D>& store) {
    for (std::uint32_t c = 0; c < store.state.cell_slots; ++c) {
        const double* p[D + 1];
        for (int i = 0; i <= D; ++i) p[i] = store.point(store.cell(c).vertex[i]);
        solve_sphere<D>(p, corner_error_max, store.cell(c));
    }
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status check_separation<D>(const Store<D>&, const InputTree<D>&, double, InputReport*);                   \
    template Status open_frame<D>(Store<D>&, Kernel<D>&, const InputTree<D>&, const Domain<D>&, double);               \
    template void settle_spheres<D>(Store<D>&);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
