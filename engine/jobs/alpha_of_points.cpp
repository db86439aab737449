#include "jobs/alpha_of_points.hpp"

#include "delaunay/spatial_order.hpp"
#include "jobs/alpha_of_plane.hpp"
#include "jobs/alpha_of_triangulation.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Leaves the coordinates, one point after the other, where the cells were, and behind them the vertices of cells,
// without neighbours and spheres. The store is empty then. False: out of memory, as there are more points than cells.
// In D <= 4 the coordinates are along a curve, whose order stands behind the cells. numbers: of a point, D or D + 1.
template <int D, int numbers> bool strip(Store<D>& store, AlphaFiltration<D>* out) {
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
    double* const coordinates = arena.template take_low<double>(std::size_t{vertices} * numbers);
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
            __builtin_memcpy(coordinates + std::size_t{i} * numbers, from, sizeof(double) * numbers);
        }
    store.truncate_vertices(0);
    *out = {{rows, row_bytes, cells, vertices},
            coordinates,
            static_cast<std::ptrdiff_t>(sizeof(double) * numbers),
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
    if (!strip<D, D>(store, &filtration)) return Status::out_of_memory;
    return alpha_of_triangulation<D>(filtration, request.diagram, work, &out->found);
}

// The list of hidden points moves up to where the vertices were.
template <int D> void keep_hidden(const Store<D>& store, HiddenPoints* hidden) {
    if (hidden->count == 0) return;
    Arena& arena = store.arena;
    const std::size_t bytes = sizeof(std::uint32_t) * hidden->count;
    const std::size_t at = (static_cast<std::size_t>(store.state.vertices_end) - bytes) & ~(Arena::alignment - 1);
    std::uint32_t* const rows = reinterpret_cast<std::uint32_t*>(arena.at(at));
    move_bytes(rows, hidden->rows, bytes, arena);
    hidden->rows = rows;
    arena.release_high(at);
}

template <int D>
Status run_weighted(const WeightedAlphaOfPoints& request, const Work& work, WeightedAlphaDiagram* out) {
    StoreState state = {};
    Store<D> store(work.arena, state);
    const Status status = triangulate_weighted<D>(store, request.points, request.count, request.weights, request.seed,
                                                  work.monitor, &out->input, &out->hidden);
    if (status != Status::ok) return status;
    out->distinct = state.vertex_count;
    AlphaFiltration<D> filtration;
    if (!strip<D, D + 1>(store, &filtration)) return Status::out_of_memory;
    keep_hidden(store, &out->hidden);
    PowerValues powers = {};
    powers.are_radii = request.weights.are_radii;
    powers.squares = request.squares;
    return alpha_of_triangulation<D>(filtration, powers, request.diagram, work, &out->found);
}

}  // namespace

template <int D>
Status alpha_of_weighted_points(const WeightedAlphaOfPoints& request, const Work& work, WeightedAlphaDiagram* out) {
    Arena& arena = work.arena;
    const std::size_t low = arena.low_mark(), high = arena.high_mark();
    *out = WeightedAlphaDiagram{};
    const Status status = run_weighted<D>(request, work, out);
    arena.release_low(low);
    const bool keeps = status == Status::ok && out->hidden.count > 0;
    arena.release_high(keeps ? arena.offset_of(out->hidden.rows) : high);
    return status == Status::ok ? move_pairs_down(low, arena, &out->found.pairs) : status;
}

using MakeAlphaDiagram = Status(const AlphaOfPoints&, const Work&, AlphaDiagram*);
template <MakeAlphaDiagram make_diagram>
static Status make_alpha(const AlphaOfPoints& request, const Work& work, AlphaDiagram* out) {
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    *out = AlphaDiagram{};
    const Status status = make_diagram(request, work, out);
    work.arena.release_low(low);
    work.arena.release_high(high);
    return status == Status::ok ? move_pairs_down(low, work.arena, &out->found.pairs) : status;
}

template <int D> Status alpha_of_points(const AlphaOfPoints& request, const Work& work, AlphaDiagram* out) {
    if constexpr (D == 2)
        return make_alpha<alpha_of_plane>(request, work, out);
    else
        return make_alpha<run<D>>(request, work, out);
}

template <int D> Status alpha_of_few_points(const AlphaOfPoints& request, const Work& work, AlphaDiagram* out) {
    if constexpr (D == 2)
        return make_alpha<alpha_of_few_in_plane>(request, work, out);
    else
        return alpha_of_points<D>(request, work, out);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status alpha_of_points<D>(const AlphaOfPoints&, const Work&, AlphaDiagram*);                              \
    template Status alpha_of_few_points<D>(const AlphaOfPoints&, const Work&, AlphaDiagram*);                          \
    template Status alpha_of_weighted_points<D>(const WeightedAlphaOfPoints&, const Work&, WeightedAlphaDiagram*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
