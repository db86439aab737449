#include "laboratory/structure.hpp"

#include "numerics/vector.hpp"

namespace netmesh {
namespace {

constexpr std::uint32_t looks_max = 1u << 24;

// The number of cells connected with `from` through cells that `take`. `none` when the gap has no room for their list.
// *hull: whether a facet of the hull is among theirs.
template <class Take> std::uint32_t flood(const AnyStore& store, CellId from, bool* hull, Take&& take) {
    AnyCellList taken(store);
    *hull = false;
    if (!taken.add(from)) return none;
    for (std::uint32_t k = 0; k < taken.size();)
        for (const std::uint64_t piece = store.arena.piece(k, taken.size(), 150 * store.dim); k < piece; ++k) {
            for (const FacetId facet : store.cell(taken[k]).neighbour) {
                *hull |= facet == none;
                if (facet == none || taken.has(facet.cell()) || !take(store.cell(facet.cell()))) continue;
                if (!taken.add(facet.cell())) return none;
            }
        }
    return taken.size();
}

std::uint32_t stride_of(const AnyStore& store, std::uint32_t expected) {
    const std::uint64_t looks = std::uint64_t{store.state.cell_slots} * expected;
    return static_cast<std::uint32_t>(1 + looks / looks_max);
}

void note_count(std::uint64_t value, std::uint64_t* count, std::uint64_t* most, double* sum) {
    ++*count;
    *sum += static_cast<double>(value);
    if (value > *most) *most = value;
}

// Whether each vertex is on the hull.
bool* find_hull(const AnyStore& store, Arena& arena) {
    bool* const hull = arena.take_low<bool>(store.state.vertex_count);
    if (hull == nullptr) return nullptr;
    for (std::uint32_t v = 0; v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 4); v < piece; ++v) {
            hull[v] = false;
        }
    for (std::uint32_t c = 0; c < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 10 * store.dim); c < piece; ++c) {
            for (int i = 0; i <= store.dim; ++i)
                for (int j = 0; j <= store.dim && store.cell(c).neighbour[i] == none; ++j)
                    if (j != i) hull[store.cell(c).vertex[j]] = true;
        }
    return hull;
}

Status measure_stars(const AnyStore& store, const bool* hull, StructureAnalysis* analysis) {
    const std::uint32_t count = store.state.vertex_count;
    for (std::uint32_t v = 0; v < count;)
        for (const std::uint64_t piece = store.arena.piece(v, count, 4); v < piece; ++v) {
            store.vertex(v).next = none;
        }
    std::uint64_t stars = 0;
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = store.arena.piece(v, count, 800 * store.dim * store.dim); v < piece; ++v) {
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
bool is_at_boundary(const AnyStore& store, const bool* hull, CellId c) {
    for (const VertexId v : store.cell(c).vertex)
        if (hull[v] && store.vertex(v).marker == Marker::exempt) return true;
    return false;
}

// D-balls that contain x, a point within the hull that c's contains; none when memory runs out.
std::uint32_t ply_of(const AnyStore& store, CellId c, const double* x) {
    bool hull;
    return flood(store, c, &hull,
                 [&](const AnyCell& cell) { return distance2(store.dim, x, cell.centre) < cell.radius2; });
}

// D-balls that meet that of c, itself among them. Beyond the hull balls may meet that do not hang together within it.
std::uint32_t balls_at(const AnyStore& store, CellId c) {
    const AnyCell ball = store.cell(c);
    const double radius = square_root(ball.radius2);
    const auto meets = [&](const AnyCell& cell) {
        const double sum = radius + square_root(cell.radius2);
        return distance2(store.dim, ball.centre, cell.centre) < sum * sum;
    };
    bool hull;
    const std::uint32_t met = flood(store, c, &hull, meets);
    if (met == none || !hull) return met;
    std::uint32_t count = 0;
    for (std::uint32_t b = 0; b < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(b, store.state.cell_slots, 8 * store.dim); b < piece; ++b) {
            count += b == c || meets(store.cell(b));
        }
    return count;
}

void barycentre(const AnyStore& store, CellId c, double* x) {
    for (int k = 0; k < store.dim; ++k) x[k] = 0;
    for (const VertexId v : store.cell(c).vertex)
        for (int k = 0; k < store.dim; ++k) x[k] += store.point(v)[k] / (store.dim + 1);
}

Status measure_ply(const AnyStore& store, CellId c, const double* x, StructureAnalysis* analysis) {
    const std::uint32_t ply = ply_of(store, c, x);
    if (ply == none) return Status::out_of_memory;
    note_count(ply, &analysis->ply_points, &analysis->ply_max, &analysis->ply_mean);
    return Status::ok;
}

// `boundary`: the ball counts apart.
Status measure_intersections(const AnyStore& store, CellId c, bool boundary, StructureAnalysis* analysis) {
    const std::uint32_t met = balls_at(store, c);
    if (met == none) return Status::out_of_memory;
    double sum = 0;
    if (boundary)
        note_count(met - 1, &analysis->hull_balls, &analysis->hull_intersections_max, &sum);
    else
        note_count(met - 1, &analysis->balls, &analysis->intersections_max, &analysis->intersections_mean);
    return Status::ok;
}

}  // namespace

[[gnu::cold]] Status measure_ball(const AnyStore& store, CellId c, BallFigures* figures) {
    double x[dimension_max];
    barycentre(store, c, x);
    figures->ply = ply_of(store, c, x);
    figures->meets = balls_at(store, c) - 1;
    return figures->ply == none || figures->meets + 1 == none ? Status::out_of_memory : Status::ok;
}

Status analyse_structure(const AnyStore& store, const Figures& figures, const double* centre, double reach,
                         const Work& work, StructureAnalysis* analysis) {
    *analysis = {};
    ArenaScope scope(work.arena);
    const bool* const hull = find_hull(store, work.arena);
    if (hull == nullptr) return Status::out_of_memory;
    Status status = measure_stars(store, hull, analysis);
    const std::uint32_t cells = store.state.cell_slots;
    const std::uint32_t ply_stride = analysis->ply_stride = stride_of(store, figures.ply_expected);
    for (CellId c(0); c < cells && status == Status::ok; c = CellId(c + ply_stride)) {
        double x[dimension_max];
        barycentre(store, c, x);
        status = measure_ply(store, c, x, analysis);
        const AnyCell cell = store.cell(c);
        if (status == Status::ok && cell.radius2 < infinity &&
            distance2(store.dim, cell.centre, centre) < reach * reach)
            status = measure_ply(store, c, cell.centre, analysis);
        if (status == Status::ok && work.monitor.advance(c, 1)) status = Status::cancelled;
    }
    const std::uint32_t stride = analysis->balls_stride = stride_of(store, figures.intersections_expected);
    for (CellId c(0); c < cells && status == Status::ok; c = CellId(c + stride)) {
        if (store.cell(c).radius2 < infinity)
            status = measure_intersections(store, c, is_at_boundary(store, hull, c), analysis);
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

}  // namespace netmesh
