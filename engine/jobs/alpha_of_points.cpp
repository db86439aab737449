#include "jobs/alpha_of_points.hpp"

#include "delaunay/spatial_order.hpp"
#include "jobs/alpha_of_triangulation.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Leaves the coordinates, one point after the other, where the cells were, and behind them the vertices of cells,
// without neighbours and spheres. The store is empty then. False: out of memory, as there are more points than cells.
// In D <= 4 the coordinates are along a curve, whose order stands behind the cells.
template <int D> bool strip(Store<D>& store, AlphaFiltration<D>* out) {
    constexpr std::size_t row_bytes = sizeof(VertexId) * (D + 1);
    Arena& arena = store.arena;
    const std::uint32_t cells = store.state.cell_slots, vertices = store.state.vertex_count;
    const std::size_t begin = static_cast<std::size_t>(store.state.cells_offset);
    const std::uint64_t hull_facets = count_hull_facets(store.view(), arena);
    unsigned char* rows = arena.at(begin);
    for (std::uint32_t c = 0; c < cells;)
        for (const std::uint64_t piece = arena.piece(c, cells, 12); c < piece; ++c) {
            __builtin_memmove(rows + c * row_bytes, store.cell(c).vertex, row_bytes);
        }
    arena.release_low(begin);
    double* const coordinates = arena.template take_low<double>(std::size_t{vertices} * D);
    unsigned char* const moved = arena.template take_low<unsigned char>(cells * row_bytes);
    if (coordinates == nullptr || moved == nullptr) return false;
    move_bytes(moved, rows, cells * row_bytes, arena);
    rows = moved;
    std::uint32_t* order = nullptr;
    if constexpr (lists_follow_order<D>) {
        order = arena.template take_low<std::uint32_t>(vertices);
        bool repeats;
        if (order == nullptr ||
            spatial_order<D>(reinterpret_cast<const unsigned char*>(store.point(0)), Store<D>::vertex_stride, vertices,
                             0, arena, order, &repeats, false) != Status::ok)
            return false;
    }
    for (std::uint32_t i = 0; i < vertices;)
        for (const std::uint64_t piece = arena.piece(i, vertices, 12); i < piece; ++i) {
            const double* const from = store.point(order != nullptr ? order[i] : i);
            __builtin_memcpy(coordinates + std::size_t{i} * D, from, sizeof(double) * D);
        }
    store.truncate_vertices(0);
    *out = {{rows, row_bytes, cells, vertices},
            coordinates,
            static_cast<std::ptrdiff_t>(sizeof(double) * D),
            hull_facets,
            true,
            order};
    return true;
}

template <int D> Status run(const AlphaOfPoints& request, const Work& work, AlphaDiagram* out) {
    StoreState state = {};
    Store<D> store(work.arena, state);
    const Status status = triangulate<D>(store, request.points, request.count, request.seed, work.monitor, &out->input);
    if (status != Status::ok) return status;
    out->distinct = state.vertex_count;
    AlphaFiltration<D> filtration;
    if (!strip<D>(store, &filtration)) return Status::out_of_memory;
    return alpha_of_triangulation<D>(filtration, request.diagram, work, &out->found);
}

}  // namespace

template <int D> Status alpha_of_points(const AlphaOfPoints& request, const Work& work, AlphaDiagram* out) {
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    *out = AlphaDiagram{};
    const Status status = run<D>(request, work, out);
    work.arena.release_low(low);
    work.arena.release_high(high);
    return status == Status::ok ? move_pairs_down(low, work.arena, &out->found.pairs) : status;
}

#define NETMESH_INSTANTIATE(D) template Status alpha_of_points<D>(const AlphaOfPoints&, const Work&, AlphaDiagram*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
