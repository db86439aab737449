#include "mesh/separation.hpp"

#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// The largest coordinate in absolute value.
template <int D> double magnitude_of(const double* x) {
    double most = 0;
    for (int k = 0; k < D; ++k)
        if (absolute(x[k]) > most) most = absolute(x[k]);
    return most;
}

}  // namespace

template <int D>
Status check_separation(const Store<D>& store, const InputTree<D>& tree, double finest, InputReport* input) {
    const std::uint32_t inputs = store.state.vertex_count;
    for (std::uint32_t v = 0; v < inputs;)
        for (const std::uint64_t piece = store.arena.piece(v, inputs, 10 * D); v < piece; ++v) {
            for (int k = 0; k < D; ++k)
                if (!(absolute(store.point(v)[k]) <= coordinate_max)) {
                    input->row_a = store.vertex(v).origin;
                    return Status::out_of_range;
                }
        }
    if (inputs == 1) return Status::ok;
    for (std::uint32_t v = 0; v < inputs;)
        for (const std::uint64_t piece = store.arena.piece(v, inputs, 500 * D); v < piece; ++v) {
            double d2;
            const std::uint32_t near = tree.nearest(store.point(v), v > 0 ? v - 1 : 1, v, &d2);
            const bool tiny = d2 < separation_min * separation_min;
            const double least = finest * magnitude_of<D>(store.point(v));
            if (!tiny && d2 >= least * least) continue;
            const std::uint64_t a = store.vertex(v).origin, b = store.vertex(near).origin;
            input->row_a = a < b ? a : b;
            input->row_b = a < b ? b : a;
            return tiny && d2 > least * least ? Status::out_of_range : Status::too_close;
        }
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status check_separation<D>(const Store<D>&, const InputTree<D>&, double, InputReport*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
