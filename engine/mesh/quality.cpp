#include "mesh/quality.hpp"

#include "delaunay/sphere.hpp"
#include "numerics/vector.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

template <int D> void raise(const Store<D>& store, const double* corner, std::uint32_t v, double* out2) {
    const double d2 = distance2<D>(corner, store.point(v));
    if (d2 > out2[v]) out2[v] = d2;
}

// Corner of a cell as the mesh has it, or computed anew; null when the cell is too flat for doubles to know it.
template <int D> const double* kept_corner(const Store<D>& store, std::uint32_t c, Cell<D>&) {
    return store.cell(c).radius2 < infinity ? store.cell(c).centre : nullptr;
}
template <int D> const double* fresh_corner(const Store<D>& store, std::uint32_t c, Cell<D>& scratch) {
    const double* p[D + 1];
    for (int i = 0; i <= D; ++i) p[i] = store.point(store.cell(c).vertex[i]);
    solve_sphere<D>(p, corner_error_max, scratch);
    return scratch.radius2 < infinity ? scratch.centre : nullptr;
}

// out2[v] := squared out-radius of v's clipped cell, corners from corner_of.
template <int D, class CornerOf>
void measure_out_radii(const Store<D>& store, const Domain<D>& domain, CornerOf&& corner_of, double* out2) {
    for (std::uint32_t v = 0; v < store.state.vertex_count; ++v) out2[v] = 0;
    for (std::uint32_t c = 0; c < store.state.cell_slots; ++c) {
        const Cell<D>& cell = store.cell(c);
        Cell<D> here, there;
        const double* const corner = corner_of(c, here);
        if (corner == nullptr) continue;
        if (domain.contains(corner)) {
            for (const std::uint32_t v : cell.vertex) raise<D>(store, corner, v, out2);
            continue;
        }
        for (int i = 0; i <= D; ++i) {
            if (cell.neighbour[i] == none) continue;
            const CellId n = cell.neighbour[i].cell();
            const double* const other = corner_of(n, there);
            if (other == nullptr) continue;
            if (n < c && !domain.contains(other)) continue;
            double z[2][D];
            const int crossings = sphere_crossings<D>(domain, corner, other, z);
            for (int j = 0; j < crossings; ++j)
                for (int k = 0; k <= D; ++k)
                    if (k != i) raise<D>(store, z[j], cell.vertex[k], out2);
        }
    }
}

template <int D>
void worst_ratio(const Store<D>& store, const double* out2, const double* nearest2, double* worst,
                 std::uint32_t* vertex) {
    double worst2 = 0;
    *vertex = none;
    for (std::uint32_t v = 0; v < store.state.vertex_count; ++v) {
        if (store.vertex(v).cell == none || store.vertex(v).marker == Marker::exempt) continue;
        const double ratio2 = 4 * out2[v] / (nearest2 != nullptr ? nearest2[v] : store.vertex(v).nearest2);
        if (!(ratio2 > worst2)) continue;
        worst2 = ratio2;
        *vertex = v;
    }
    *worst = square_root(worst2);
}

}  // namespace

template <int D> void clipped_out_radii(const Store<D>& store, const Domain<D>& domain, Corners corners, double* out2) {
    measure_out_radii<D>(
        store, domain,
        [&](std::uint32_t c, Cell<D>& s) {
            return corners == Corners::kept ? kept_corner<D>(store, c, s) : fresh_corner<D>(store, c, s);
        },
        out2);
}

template <int D>
Status worst_aspect_ratio(const Store<D>& store, const Domain<D>& domain, Arena& arena, double* worst,
                          std::uint32_t* vertex) {
    ArenaScope scope(arena);
    double* const out2 = arena.take_low<double>(store.state.vertex_count);
    if (out2 == nullptr) return Status::out_of_memory;
    clipped_out_radii<D>(store, domain, Corners::kept, out2);
    worst_ratio<D>(store, out2, nullptr, worst, vertex);
    return Status::ok;
}

template <int D> void recomputed_nearest2(const Store<D>& store, double* nearest2) {
    for (std::uint32_t v = 0; v < store.state.vertex_count; ++v) nearest2[v] = infinity;
    for (std::uint32_t c = 0; c < store.state.cell_slots; ++c) {
        const Cell<D>& cell = store.cell(c);
        for (int i = 0; i <= D; ++i)
            for (int j = 0; j <= D; ++j) {
                if (i == j) continue;
                const double d2 = distance2<D>(store.point(cell.vertex[i]), store.point(cell.vertex[j]));
                if (d2 < nearest2[cell.vertex[i]]) nearest2[cell.vertex[i]] = d2;
            }
    }
}

template <int D>
Status recomputed_aspect_ratio(const Store<D>& store, const Domain<D>& domain, Arena& arena, double* worst,
                               std::uint32_t* vertex) {
    ArenaScope scope(arena);
    double* const out2 = arena.take_low<double>(store.state.vertex_count);
    double* const nearest2 = arena.take_low<double>(store.state.vertex_count);
    if (out2 == nullptr || nearest2 == nullptr) return Status::out_of_memory;
    clipped_out_radii<D>(store, domain, Corners::recomputed, out2);
    recomputed_nearest2<D>(store, nearest2);
    worst_ratio<D>(store, out2, nearest2, worst, vertex);
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status worst_aspect_ratio<D>(const Store<D>&, const Domain<D>&, Arena&, double*, std::uint32_t*);         \
    template Status recomputed_aspect_ratio<D>(const Store<D>&, const Domain<D>&, Arena&, double*, std::uint32_t*);    \
    template void clipped_out_radii<D>(const Store<D>&, const Domain<D>&, Corners, double*);                           \
    template void recomputed_nearest2<D>(const Store<D>&, double*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
