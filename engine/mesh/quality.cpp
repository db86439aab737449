#include "mesh/quality.hpp"

namespace netmesh {
namespace {

template <int D> void raise(const Store<D>& store, const double* corner, std::uint32_t v, double* out2) {
    double d2 = 0;
    for (int k = 0; k < D; ++k) {
        const double d = corner[k] - store.point(v)[k];
        d2 += d * d;
    }
    if (d2 > out2[v]) out2[v] = d2;
}

}  // namespace

template <int D>
Status worst_aspect_ratio(const Store<D>& store, const Domain<D>& domain, Arena& arena, double* worst,
                          std::uint32_t* vertex) {
    ArenaScope scope(arena);
    const std::uint32_t count = store.state.vertex_count;
    double* const out2 = arena.take_low<double>(count);
    if (out2 == nullptr) return Status::out_of_memory;
    for (std::uint32_t v = 0; v < count; ++v) out2[v] = 0;
    for (std::uint32_t c = 0; c < store.state.cell_slots; ++c) {
        const Cell<D>& cell = store.cell(c);
        if (domain.contains(cell.centre)) {
            for (const std::uint32_t v : cell.vertex) raise<D>(store, cell.centre, v, out2);
            continue;
        }
        for (int i = 0; i <= D; ++i) {
            if (cell.neighbour[i] == none) continue;
            const std::uint32_t n = cell.neighbour[i] >> 3;
            if (n < c && !domain.contains(store.cell(n).centre)) continue;
            double z[2][D];
            const int crossings = sphere_crossings<D>(domain, cell.centre, store.cell(n).centre, z);
            for (int j = 0; j < crossings; ++j)
                for (int k = 0; k <= D; ++k)
                    if (k != i) raise<D>(store, z[j], cell.vertex[k], out2);
        }
    }
    double worst2 = 0;
    *vertex = none;
    for (std::uint32_t v = 0; v < count; ++v) {
        if (store.vertex(v).cell == none || store.vertex(v).marker == Marker::exempt) continue;
        const double ratio2 = 4 * out2[v] / store.vertex(v).nearest2;
        if (!(ratio2 > worst2)) continue;
        worst2 = ratio2;
        *vertex = v;
    }
    *worst = square_root(worst2);
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D) \
    template Status worst_aspect_ratio<D>(const Store<D>&, const Domain<D>&, Arena&, double*, std::uint32_t*);
NETMESH_INSTANTIATE(2)
NETMESH_INSTANTIATE(3)
NETMESH_INSTANTIATE(4)
NETMESH_INSTANTIATE(5)
NETMESH_INSTANTIATE(6)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
