#include "mesh/sizing.hpp"

#include "mesh/clip/clipped_cell.hpp"

namespace netmesh {

Status worst_size_ratio(const AnyStore& store, const SizeRatioRequest& request, Arena& arena, SizeRatio* ratio) {
    *ratio = {0, none};
    if (!request.rule.asks()) return Status::ok;
    ArenaScope scope(arena);
    double* const out2 = arena.take_low<double>(store.state.vertex_count);
    AnyInputTree tree;
    if (out2 == nullptr || tree.build(store, arena, request.inputs) != Status::ok) return Status::out_of_memory;
    const Status status = measure_clipped_cells(store, request.domain, out2);
    if (status != Status::ok) return status;
    for (std::uint32_t v = 0; v < store.state.vertex_count;)
        for (const std::uint64_t piece = arena.piece(v, store.state.vertex_count, 500 * store.dim); v < piece; ++v) {
            if (store.vertex(v).cell == none || store.vertex(v).marker == Marker::exempt) continue;
            const double size = wanted_size(store, tree, request.rule, v);
            const double here = size > 0 ? square_root(out2[v]) / size : infinity;
            if (here > ratio->worst) *ratio = {here, v};
        }
    return Status::ok;
}

}  // namespace netmesh
