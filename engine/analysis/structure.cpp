#include "analysis/structure.hpp"

#include "delaunay/any_star.hpp"
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
// *hull: whether a facet of the hull is among theirs.
template <int D, class Take> std::uint32_t flood(Store<D>& store, CellId from, bool* hull, Take&& take) {
    CellList<D> taken(store);
    *hull = false;
    if (!taken.add(from)) return none;
    for (std::uint32_t k = 0; k < taken.size();)
        for (const std::uint64_t piece = store.arena.piece(k, taken.size(), 20 * D); k < piece; ++k) {
            for (const FacetId facet : store.cell(taken[k]).neighbour) {
                *hull |= facet == none;
                if (facet == none || taken.has(facet.cell()) || !take(store.cell(facet.cell()))) continue;
                if (!taken.add(facet.cell())) return none;
            }
        }
    return taken.size();
}

template <int D> std::uint32_t stride_of(const Store<D>& store, std::uint32_t expected) {
    const std::uint64_t looks = std::uint64_t{store.state.cell_slots} * expected;
    return static_cast<std::uint32_t>(1 + looks / looks_max);
}

void note_count(std::uint64_t value, std::uint64_t* count, std::uint64_t* most, double* sum) {
    ++*count;
    *sum += static_cast<double>(value);
    if (value > *most) *most = value;
}

// Whether each vertex is on the hull.
template <int D> bool* find_hull(const Store<D>& store, Arena& arena) {
    bool* const hull = arena.take_low<bool>(store.state.vertex_count);
    if (hull == nullptr) return nullptr;
    for (std::uint32_t v = 0; v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 4); v < piece; ++v) {
            hull[v] = false;
        }
    for (std::uint32_t c = 0; c < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 10 * D); c < piece; ++c) {
            for (int i = 0; i <= D; ++i)
                for (int j = 0; j <= D && store.cell(c).neighbour[i] == none; ++j)
                    if (j != i) hull[store.cell(c).vertex[j]] = true;
        }
    return hull;
}

template <int D> Status measure_stars(Store<D>& store, const bool* hull, StructureAnalysis* analysis) {
    const std::uint32_t count = store.state.vertex_count;
    for (std::uint32_t v = 0; v < count;)
        for (const std::uint64_t piece = store.arena.piece(v, count, 4); v < piece; ++v) {
            store.vertex(v).next = none;
        }
    std::uint64_t stars = 0;
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = store.arena.piece(v, count, 300 * D * D); v < piece; ++v) {
            if (store.vertex(v).cell == none) continue;
            std::uint64_t degree = 0, star = 0;
            const bool room = visit_any_star(store, v, [&](CellId c) {
                ++star;
                for (const VertexId w : store.cell(c).vertex) {
                    if (w == v || store.vertex(w).next == v) continue;
                    store.vertex(w).next = v;
                    ++degree;
                }
            });
            if (!room) return Status::out_of_memory;
            double sum = 0;
            if (hull[v]) {
                note_count(degree, &analysis->hull_vertices, &analysis->hull_degree_max, &sum);
                continue;
            }
            note_count(degree, &analysis->vertices, &analysis->degree_max, &analysis->degree_mean);
            note_count(star, &stars, &analysis->star_max, &analysis->star_mean);
        }
    return Status::ok;
}

// Has the cell a vertex of a mesh's boundary: exempt, and on the hull?
template <int D> bool is_at_boundary(const Store<D>& store, const bool* hull, CellId c) {
    for (const VertexId v : store.cell(c).vertex)
        if (hull[v] && store.vertex(v).marker == Marker::exempt) return true;
    return false;
}

// D-balls that contain x, a point within the hull that c's contains; none when memory runs out.
template <int D> std::uint32_t ply_of(Store<D>& store, CellId c, const double* x) {
    bool hull;
    return flood<D>(store, c, &hull, [&](const Cell<D>& cell) { return distance2<D>(x, cell.centre) < cell.radius2; });
}

// D-balls that meet that of c, itself among them. Beyond the hull balls may meet that do not hang together within it.
template <int D> std::uint32_t balls_at(Store<D>& store, CellId c) {
    const Cell<D>& ball = store.cell(c);
    const double radius = square_root(ball.radius2);
    const auto meets = [&](const Cell<D>& cell) {
        const double sum = radius + square_root(cell.radius2);
        return distance2<D>(ball.centre, cell.centre) < sum * sum;
    };
    bool hull;
    const std::uint32_t met = flood<D>(store, c, &hull, meets);
    if (met == none || !hull) return met;
    std::uint32_t count = 0;
    for (std::uint32_t b = 0; b < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(b, store.state.cell_slots, 8 * D); b < piece; ++b) {
            count += b == c || meets(store.cell(b));
        }
    return count;
}

template <int D> void barycentre(const Store<D>& store, CellId c, double* x) {
    for (int k = 0; k < D; ++k) x[k] = 0;
    for (const VertexId v : store.cell(c).vertex)
        for (int k = 0; k < D; ++k) x[k] += store.point(v)[k] / (D + 1);
}

template <int D> Status measure_ply(Store<D>& store, CellId c, const double* x, StructureAnalysis* analysis) {
    const std::uint32_t ply = ply_of<D>(store, c, x);
    if (ply == none) return Status::out_of_memory;
    note_count(ply, &analysis->ply_points, &analysis->ply_max, &analysis->ply_mean);
    return Status::ok;
}

// `boundary`: the ball counts apart.
template <int D> Status measure_intersections(Store<D>& store, CellId c, bool boundary, StructureAnalysis* analysis) {
    const std::uint32_t met = balls_at<D>(store, c);
    if (met == none) return Status::out_of_memory;
    double sum = 0;
    if (boundary)
        note_count(met - 1, &analysis->hull_balls, &analysis->hull_intersections_max, &sum);
    else
        note_count(met - 1, &analysis->balls, &analysis->intersections_max, &analysis->intersections_mean);
    return Status::ok;
}

}  // namespace

template <int D> [[gnu::cold]] Status measure_ball(Store<D>& store, CellId c, BallFigures* figures) {
    double x[D];
    barycentre<D>(store, c, x);
    figures->ply = ply_of<D>(store, c, x);
    figures->meets = balls_at<D>(store, c) - 1;
    return figures->ply == none || figures->meets + 1 == none ? Status::out_of_memory : Status::ok;
}

template <int D>
Status analyse_structure(Store<D>& store, const double* centre, double reach, const Work& work,
                         StructureAnalysis* analysis) {
    *analysis = {};
    ArenaScope scope(work.arena);
    recompute_balls<D>(store);
    const bool* const hull = find_hull<D>(store, work.arena);
    if (hull == nullptr) return Status::out_of_memory;
    Status status = measure_stars<D>(store, hull, analysis);
    const std::uint32_t cells = store.state.cell_slots;
    const std::uint32_t ply_stride = analysis->ply_stride = stride_of<D>(store, ply_expected<D>);
    for (CellId c(0); c < cells && status == Status::ok; c = CellId(c + ply_stride)) {
        double x[D];
        barycentre<D>(store, c, x);
        status = measure_ply<D>(store, c, x, analysis);
        const Cell<D>& cell = store.cell(c);
        if (status == Status::ok && cell.radius2 < infinity && distance2<D>(cell.centre, centre) < reach * reach)
            status = measure_ply<D>(store, c, cell.centre, analysis);
        if (status == Status::ok && work.monitor.advance(c, 1)) status = Status::cancelled;
    }
    const std::uint32_t stride = analysis->balls_stride = stride_of<D>(store, intersections_expected<D>);
    for (CellId c(0); c < cells && status == Status::ok; c = CellId(c + stride)) {
        if (store.cell(c).radius2 < infinity)
            status = measure_intersections<D>(store, c, is_at_boundary<D>(store, hull, c), analysis);
        if (status == Status::ok && work.monitor.advance(c, 1)) status = Status::cancelled;
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
    template Status analyse_structure<D>(Store<D>&, const double*, double, const Work&, StructureAnalysis*);           \
    template Status measure_ball<D>(Store<D>&, CellId, BallFigures*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
