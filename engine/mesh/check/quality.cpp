#include "mesh/check/quality.hpp"

#include "mesh/clip/clipped_cell.hpp"

namespace netmesh {

Status worst_aspect_ratio(const AnyStore& store, const AnyDomain& domain, Arena& arena, double* worst,
                          std::uint32_t* vertex) {
    ArenaScope scope(arena);
    *worst = 0;
    *vertex = none;
    double* const out2 = arena.take_low<double>(store.state.vertex_count);
    if (out2 == nullptr) return Status::out_of_memory;
    const Status status = measure_worst_cells(store, domain, out2);
    double worst2 = 0;
    for (std::uint32_t v = 0; v < store.state.vertex_count && status == Status::ok;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 12);
             v < piece && status == Status::ok; ++v) {
            const double ratio2 = 4 * out2[v] / store.vertex(v).nearest2;
            if (!(ratio2 > worst2)) continue;
            worst2 = ratio2;
            *vertex = v;
        }
    *worst = square_root(worst2);
    return status;
}

void recomputed_nearest2(const AnyStore& store, double* nearest2) {
    const int dim = store.dim;
    for (std::uint32_t v = 0; v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 4); v < piece; ++v) {
            nearest2[v] = infinity;
        }
    for (std::uint32_t c = 0; c < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 50 * dim * dim); c < piece; ++c) {
            const AnyCell cell = store.cell(c);
            for (int i = 0; i <= dim; ++i)
                for (int j = 0; j <= dim; ++j) {
                    if (i == j) continue;
                    const double d2 = distance2(dim, store.point(cell.vertex[i]), store.point(cell.vertex[j]));
                    if (d2 < nearest2[cell.vertex[i]]) nearest2[cell.vertex[i]] = d2;
                }
        }
}

}  // namespace netmesh
