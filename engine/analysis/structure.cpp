#include "analysis/structure.hpp"

#include "delaunay/cell_list.hpp"
#include "delaunay/load.hpp"
#include "numerics/vector.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Looks at a cell that a point's or a ball's flood takes, as measured on quality meshes in D = 2..6.
template <int D> constexpr std::uint32_t ply_expected = figures<D>.ply_expected;
template <int D> constexpr std::uint32_t intersections_expected = figures<D>.intersections_expected;
constexpr std::uint32_t looks_max = 1u << 24;

// The number of cells connected with `from` through cells that `take`. `none` when the gap has no room for their list.
template <int D, class Take> std::uint32_t flood(Store<D>& store, CellId from, Take&& take) {
    CellList<D> taken(store);
    if (!taken.add(from)) return none;
    for (std::uint32_t k = 0; k < taken.size(); ++k)
        for (const FacetId facet : store.cell(taken[k]).neighbour) {
            if (facet == none || taken.has(facet.cell()) || !take(store.cell(facet.cell()))) continue;
            if (!taken.add(facet.cell())) return none;
        }
    return taken.size();
}

template <int D> std::uint32_t stride_of(const Store<D>& store, std::uint32_t expected) {
    const std::uint64_t looks = std::uint64_t{store.state.cell_slots} * expected;
    return static_cast<std::uint32_t>(1 + looks / looks_max);
}

void note(std::uint64_t value, std::uint64_t* count, std::uint64_t* most, double* sum) {
    ++*count;
    *sum += static_cast<double>(value);
    if (value > *most) *most = value;
}

template <int D> Status measure_stars(Store<D>& store, Arena& arena, StructureAnalysis* analysis) {
    ArenaScope scope(arena);
    const std::uint32_t count = store.state.vertex_count;
    std::uint8_t* const open = arena.take_low<std::uint8_t>(count);
    if (open == nullptr) return Status::out_of_memory;
    for (std::uint32_t v = 0; v < count; ++v) {
        open[v] = store.vertex(v).cell == none;
        store.vertex(v).next = none;
    }
    for (std::uint32_t c = 0; c < store.state.cell_slots; ++c)
        for (int i = 0; i <= D; ++i)
            for (int j = 0; j <= D && store.cell(c).neighbour[i] == none; ++j)
                if (j != i) open[store.cell(c).vertex[j]] = 1;
    std::uint64_t stars = 0;
    for (VertexId v(0); v < count; ++v) {
        if (open[v]) continue;
        std::uint64_t degree = 0, star = 0;
        const bool room = visit_star(store, v, [&](CellId c) {
            ++star;
            for (const VertexId w : store.cell(c).vertex) {
                if (w == v || store.vertex(w).next == v) continue;
                store.vertex(w).next = v;
                ++degree;
            }
        });
        if (!room) return Status::out_of_memory;
        note(degree, &analysis->vertices, &analysis->degree_max, &analysis->degree_mean);
        note(star, &stars, &analysis->star_max, &analysis->star_mean);
    }
    return Status::ok;
}

template <int D> Status measure_ply(Store<D>& store, CellId c, const double* x, StructureAnalysis* analysis) {
    const std::uint32_t ply =
        flood<D>(store, c, [&](const Cell<D>& cell) { return distance2<D>(x, cell.centre) < cell.radius2; });
    if (ply == none) return Status::out_of_memory;
    note(ply, &analysis->ply_points, &analysis->ply_max, &analysis->ply_mean);
    return Status::ok;
}

template <int D> Status measure_intersections(Store<D>& store, CellId c, StructureAnalysis* analysis) {
    const Cell<D>& ball = store.cell(c);
    const double radius = square_root(ball.radius2);
    const std::uint32_t met = flood<D>(store, c, [&](const Cell<D>& cell) {
        const double sum = radius + square_root(cell.radius2);
        return distance2<D>(ball.centre, cell.centre) < sum * sum;
    });
    if (met == none) return Status::out_of_memory;
    note(met - 1, &analysis->balls, &analysis->intersections_max, &analysis->intersections_mean);
    return Status::ok;
}

template <int D> bool is_ordinary(const Store<D>& store, CellId c) {
    if (!(store.cell(c).radius2 < infinity)) return false;
    for (const VertexId v : store.cell(c).vertex)
        if (store.vertex(v).marker == Marker::exempt) return false;
    return true;
}

}  // namespace

template <int D>
Status analyse_structure(Store<D>& store, const double* centre, double reach, const Work& work,
                         StructureAnalysis* analysis) {
    *analysis = {};
    recompute_balls<D>(store);
    Status status = measure_stars<D>(store, work.arena, analysis);
    const std::uint32_t cells = store.state.cell_slots;
    const std::uint32_t ply_stride = stride_of<D>(store, ply_expected<D>);
    for (CellId c(0); c < cells && status == Status::ok; c = CellId(c + ply_stride)) {
        double x[D] = {};
        for (const VertexId v : store.cell(c).vertex)
            for (int k = 0; k < D; ++k) x[k] += store.point(v)[k] / (D + 1);
        status = measure_ply<D>(store, c, x, analysis);
        const Cell<D>& cell = store.cell(c);
        if (status == Status::ok && cell.radius2 < infinity && distance2<D>(cell.centre, centre) < reach * reach)
            status = measure_ply<D>(store, c, cell.centre, analysis);
        if (status == Status::ok && work.monitor.advance(c, ply_expected<D>)) status = Status::cancelled;
    }
    const std::uint32_t stride = stride_of<D>(store, intersections_expected<D>);
    for (CellId c(0); c < cells && status == Status::ok; c = CellId(c + stride)) {
        if (is_ordinary<D>(store, c)) status = measure_intersections<D>(store, c, analysis);
        if (status == Status::ok && work.monitor.advance(c, intersections_expected<D>)) status = Status::cancelled;
    }
    const auto mean = [](double* sum, std::uint64_t count) {
        *sum = count > 0 ? *sum / static_cast<double>(count) : 0;
    };
    mean(&analysis->degree_mean, analysis->vertices);
    mean(&analysis->star_mean, analysis->vertices);
    mean(&analysis->ply_mean, analysis->ply_points);
    mean(&analysis->intersections_mean, analysis->balls);
    return status;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status analyse_structure<D>(Store<D>&, const double*, double, const Work&, StructureAnalysis*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
