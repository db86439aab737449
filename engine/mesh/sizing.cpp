#include "mesh/sizing.hpp"

namespace netmesh {

template <int D>
Status worst_size_ratio(const Store<D>& store, const Domain<D>& domain, std::uint32_t inputs, const SizeRule& rule,
                        Corners corners, Arena& arena, double* worst, std::uint32_t* vertex) {
    *worst = 0;
    *vertex = none;
    if (!rule.asks()) return Status::ok;
    ArenaScope scope(arena);
    double* const out2 = arena.take_low<double>(store.state.vertex_count);
    InputTree<D> tree;
    if (out2 == nullptr || tree.build(store, arena, inputs) != Status::ok) return Status::out_of_memory;
    clipped_out_radii<D>(store, domain, corners, out2);
    for (std::uint32_t v = 0; v < store.state.vertex_count; ++v) {
        if (store.vertex(v).cell == none || store.vertex(v).marker == Marker::exempt) continue;
        const double size = wanted_size<D>(store, tree, rule, v);
        const double ratio = size > 0 ? square_root(out2[v]) / size : infinity;
        if (!(ratio > *worst)) continue;
        *worst = ratio;
        *vertex = v;
    }
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status worst_size_ratio<D>(const Store<D>&, const Domain<D>&, std::uint32_t, const SizeRule&, Corners,    \
                                        Arena&, double*, std::uint32_t*);
NETMESH_INSTANTIATE(2)
NETMESH_INSTANTIATE(3)
NETMESH_INSTANTIATE(4)
NETMESH_INSTANTIATE(5)
NETMESH_INSTANTIATE(6)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
