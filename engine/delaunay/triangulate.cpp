#include "delaunay/triangulate.hpp"

#include "delaunay/independent_points.hpp"
#include "delaunay/plane.hpp"
#include "delaunay/spatial_order.hpp"
#include "numerics/fingerprint.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Here balls only answer whether a point is inside, so their bounds may grow: one question in thousands turns exact.
constexpr double ball_error_max = 0x1p-7;

// Vertices asked for before their turn: the order jumps about in memory.
#ifdef __OPTIMIZE_SIZE__
constexpr std::uint32_t ahead = 0;
#else
constexpr std::uint32_t ahead = 6;
#endif

constexpr std::size_t points_max = std::size_t{1} << 28;

// Moves duplicates out: in `order` equal points are neighbours with the smallest index first.
std::uint32_t remove_duplicates(const AnyStore& store, std::uint32_t* order, std::uint32_t count) {
    std::uint32_t first = order[0];
    for (std::uint32_t k = 0; k < count;)
        for (const std::uint64_t piece = store.arena.piece(k, count, 20); k < piece; ++k) {
            const std::uint32_t v = order[k];
            if (ahead > 0 && k + ahead < count) __builtin_prefetch(store.point(order[k + ahead]), 1);
            const double *const a = store.point(first), *const b = store.point(v);
            int same = 0;
            while (same < store.dim && a[same] == b[same]) ++same;
            const bool duplicate = k > 0 && same == store.dim;
            if (!duplicate) first = v;
            store.vertex(v).next = duplicate ? none : VertexId(0);
        }
    std::uint32_t kept = 0;
    for (std::uint32_t v = 0; v < count;)
        for (const std::uint64_t piece = store.arena.piece(v, count, 6); v < piece; ++v) {
            if (store.vertex(v).next != none) store.vertex(v).next = VertexId(kept++);
        }
    if (kept == count) return count;
    std::uint32_t out = 0;
    for (std::uint32_t k = 0; k < count;)
        for (const std::uint64_t piece = store.arena.piece(k, count, 8); k < piece; ++k) {
            if (store.vertex(order[k]).next != none) order[out++] = store.vertex(order[k]).next;
        }
    out = 0;
    for (std::uint32_t v = 0; v < count;)
        for (const std::uint64_t piece = store.arena.piece(v, count, 20); v < piece; ++v) {
            if (store.vertex(v).next == none) continue;
            if (out != v) store.copy_vertex(v, out);
            ++out;
        }
    return kept;
}

bool are_finite(const InputRows& points, std::size_t n, int dim, const Arena& arena, InputReport* input) {
    for (std::size_t i = 0; i < n;)
        for (const std::uint64_t piece = arena.piece(i, n, 5 * dim); i < piece; ++i) {
            double x[dimension_max];
            if (points.read(i, dim, x)) continue;
            input->row_a = i;
            return false;
        }
    return true;
}

// The fingerprint of all coordinates, which become those of the vertices.
std::uint64_t copy_points(const InputRows& points, const AnyStore& store) {
    const std::uint32_t count = store.state.vertex_count;
    Fingerprint fingerprint;
    fingerprint.add(static_cast<std::uint64_t>(store.dim));
    for (std::uint32_t i = 0; i < count;)
        for (const std::uint64_t piece = store.arena.piece(i, count, 20 + 10 * store.dim); i < piece; ++i) {
            const AnyVertex v = store.vertex(i);
            points.read(i, store.dim, v.x);
            for (int k = 0; k < store.dim; ++k) fingerprint.add(v.x[k]);
            v.nearest2 = infinity;
            v.cell = none;
            v.next = none;
            v.origin = i;
            v.marker = Marker::input;
            v.queued = 0;
            v.size_hint = 0;
        }
    return fingerprint.value();
}

// The triangulation by the kernel of meshes. PlaneRun says what each function does.
template <int D> class KernelRun {
public:
    explicit KernelRun(Store<D>& store) : store_(store), kernel_(store, ball_error_max, VertexCells::ignored) {}
    Status open(const std::uint32_t* order, std::size_t low) {
        const std::uint32_t count = store_.state.vertex_count;
        vertices_begin_ = store_.arena.high_mark();
        std::uint32_t* const kept = store_.arena.template take_high<std::uint32_t>(count);
        if (kept == nullptr) return Status::out_of_memory;
        move_bytes(kept, order, count * sizeof *kept, store_.arena);
        order_ = kept;
        store_.arena.release_low(low);
        return store_.open_cells();
    }
    Status start(const VertexId* ids) {
        for (int i = 0; i <= D; ++i) first_[i] = ids[i];
        return kernel_.start(ids);
    }
    bool insert(std::uint32_t k, std::uint32_t* made) {
        const VertexId v(order_[k]);
        if (ahead > 0 && k + ahead < store_.state.vertex_count) {
            const double* const next = store_.point(order_[k + ahead]);
            __builtin_prefetch(next);
            __builtin_prefetch(next + D - 1);
        }
        *made = 0;
        for (const VertexId w : first_)
            if (v == w) return true;
        const double* const q = store_.point(v);
        const CellId hit = kernel_.locate(q, v, store_.state.last_cell);
        Cavity cavity;
        if (!kernel_.find_cavity(q, v, hit, &cavity) || !kernel_.can_fill(cavity, 0)) return false;
        kernel_.fill(cavity, v);
        *made = cavity.facets;
        return true;
    }
    void finish() {
        store_.compact(store_.state.cells_offset);
        store_.arena.release_high(vertices_begin_);
    }

private:
    Store<D>& store_;
    Kernel<D> kernel_;
    const std::uint32_t* order_;
    std::size_t vertices_begin_;  // offset of the last vertex
    VertexId first_[D + 1];       // the vertices of the first cell
};
template <int D> using TriangulationRun = std::conditional_t<D == 2, PlaneRun<D>, KernelRun<D>>;

// Before so many points nothing is given up: what they share is chance.
constexpr std::uint64_t sample_least = 16;

// Notes what `points` inserted points have cost. Is it more than is allowed?
bool is_spent(const StoreState& state, std::uint64_t points, Allowance* allowance) {
    const std::uint64_t* const calls = state.in_ball_counts.calls;
    const std::uint64_t hard =
        calls[NETMESH_PREDICATE_FLOAT] + calls[NETMESH_PREDICATE_INTEGER] + calls[NETMESH_PREDICATE_EXACT];
    const double work = static_cast<double>(state.cells_created) + allowance->by_hard * static_cast<double>(hard) +
                        allowance->by_tie * static_cast<double>(calls[NETMESH_PREDICATE_TIE]);
    allowance->is_dear = points >= sample_least && work > allowance->work_each * static_cast<double>(points);
    allowance->points_tried = points;
    allowance->cells_made = state.cells_created;
    allowance->is_spent = allowance->is_dear || state.cell_slots - state.cells_free > allowance->cells_max;
    return allowance->is_spent;
}

}  // namespace

Status take_input(AnyStore& store, const InputRows& points, std::size_t n, std::uint64_t seed, Monitor& monitor,
                  InputReport* input, std::uint32_t** order) {
    *input = InputReport{};
    if (n == 0 || n > points_max) return Status::invalid_argument;
    monitor.begin(NETMESH_STAGE_SORT, n);
    if (!are_finite(points, n, store.dim, store.arena, input)) return Status::not_finite;
    const std::uint32_t count = static_cast<std::uint32_t>(n);
    if (store.open_vertices(count) != Status::ok) return Status::out_of_memory;
    input->rows = n;
    input->fingerprint = copy_points(points, store);
    *order = store.arena.take_low<std::uint32_t>(count);
    if (*order == nullptr) return Status::out_of_memory;
    bool repeats;
    const Status status = with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        return spatial_order<decltype(dimension)::value>(store.first_point(), store.point_stride(), count, seed,
                                                         store.arena, *order, &repeats);
    });
    if (status != Status::ok) return status;
    const std::uint32_t kept = repeats ? remove_duplicates(store, *order, count) : count;
    input->duplicates = count - kept;
    store.truncate_vertices(kept);
    return store.arena.has_stopped() ? Status::cancelled : Status::ok;
}

template <int D>
Status triangulate(Store<D>& store, const InputRows& points, std::size_t n, std::uint64_t seed, Monitor& monitor,
                   InputReport* input, Allowance* allowance) {
    const std::size_t low = store.arena.low_mark();
    std::uint32_t* order;
    Status status = take_input<D>(store, points, n, seed, monitor, input, &order);
    if (status != Status::ok) return status;
    const std::uint32_t count = store.state.vertex_count;
    VertexId ids[D + 1];
    if (!independent_points(store, order, count, ids)) return Status::flat;
    TriangulationRun<D> run(store);
    status = run.open(order, low);
    if (status == Status::ok) status = run.start(ids);
    if (status != Status::ok) return status;

    monitor.begin(NETMESH_STAGE_DELAUNAY, count);
    for (std::uint32_t k = 0; k < count; ++k) {
        std::uint32_t made;
        if (!run.insert(k, &made)) {
            status = Status::out_of_memory;
            break;
        }
        if (made == 0) continue;
        if (allowance != nullptr && is_spent(store.state, std::uint64_t{k} + 1, allowance)) return Status::cancelled;
        monitor.mesh_size(k, store.live_cells());
        if (monitor.advance(k, 2 + made * (D - 1))) {
            status = Status::cancelled;
            break;
        }
    }
    run.finish();
    return status;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status triangulate<D>(Store<D>&, const InputRows&, std::size_t, std::uint64_t, Monitor&, InputReport*,    \
                                   Allowance*);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
