#include "delaunay/triangulate.hpp"

#include "delaunay/independent_points.hpp"
#include "delaunay/insert_all.hpp"
#include "delaunay/plane.hpp"
#include "delaunay/spatial_order.hpp"
#include "numerics/fingerprint.hpp"
#include "numerics/sort.hpp"
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

// Takes the vertices whose `next` is none out of the store's and of `order`.
std::uint32_t drop_marked(const AnyStore& store, std::uint32_t* order, std::uint32_t count) {
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
    return drop_marked(store, order, count);
}

bool are_finite(const InputRows& points, std::size_t n, int dim, const Arena& arena, InputReport* input) {
    for (std::size_t i = 0; i < n;)
        for (const std::uint64_t piece = arena.piece(i, n, 20 * dim); i < piece; ++i) {
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
        for (const std::uint64_t piece = store.arena.piece(i, count, 20 + 40 * store.dim); i < piece; ++i) {
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
template <int D, class W = NoWeights> class KernelRun {
public:
    static constexpr int dim = D;

    explicit KernelRun(Store<D>& store) : store_(store), kernel_(store, ball_error_max, VertexCells::ignored) {}
    void weigh(const Weights& weights) { kernel_.weigh(weights); }
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
        if (is_in_first_cell(k)) return true;
        const double* const q = store_.point(v);
        const CellId hit = kernel_.locate(q, v, store_.state.last_cell);
        if (W::has && hit == none) return true;
        Cavity cavity;
        if (!kernel_.find_cavity(q, v, hit, &cavity) || !kernel_.can_fill(cavity, 0)) return false;
        kernel_.fill(cavity, v);
        *made = cavity.facets;
        return true;
    }
    void finish() {
        // Vertices of the first cell have it still.
        if constexpr (W::has)
            for (int i = 0; i <= D; ++i) store_.vertex(first_[i]).cell = none;
        store_.compact(store_.state.cells_offset);
        store_.arena.release_high(vertices_begin_);
    }
    VertexId vertex_at(std::uint32_t k) const { return VertexId(order_[k]); }
    bool is_in_first_cell(std::uint32_t k) const {
        for (const VertexId w : first_)
            if (vertex_at(k) == w) return true;
        return false;
    }

private:
    Store<D>& store_;
    Kernel<D, W> kernel_;
    const std::uint32_t* order_;
    std::size_t vertices_begin_;  // offset of the last vertex
    VertexId first_[D + 1];       // the vertices of the first cell
};
template <int D, class W = NoWeights>
using TriangulationRun = std::conditional_t<D == 2, PlaneRun<D, W>, KernelRun<D, W>>;

// ---- with weights ----

// Are they finite, and radii not negative? Else the row in question.
bool are_weights(const WeightRows& weights, std::size_t n, const Arena& arena, InputReport* input,
                 HiddenPoints* hidden) {
    for (std::size_t i = 0; i < n;)
        for (const std::uint64_t piece = arena.piece(i, n, 8); i < piece; ++i) {
            double number;
            const bool finite = weights.rows.read(i, 1, &number);
            if (finite && !(weights.are_radii && number < 0)) continue;
            input->row_a = i;
            hidden->has_weight = !finite;
            hidden->has_negative = finite;
            return false;
        }
    return true;
}

// Puts them behind the coordinates; a fingerprint of both.
std::uint64_t copy_weights(const WeightRows& weights, const AnyStore& store, std::uint64_t of_points) {
    const std::uint32_t count = store.state.vertex_count;
    Fingerprint fingerprint;
    fingerprint.add(of_points);
    fingerprint.add(std::uint64_t{weights.are_radii});
    for (std::uint32_t i = 0; i < count;)
        for (const std::uint64_t piece = store.arena.piece(i, count, 20); i < piece; ++i) {
            double number;
            weights.rows.read(i, 1, &number);
            store.vertex(i).nearest2 = number;
            fingerprint.add(number);
        }
    return fingerprint.value();
}

// remove_duplicates, but of equal points the first of those with the largest weight stays.
std::uint32_t remove_lighter(const AnyStore& store, std::uint32_t* order, std::uint32_t count) {
    std::uint32_t heaviest = order[0];
    for (std::uint32_t k = 0; k < count;)
        for (const std::uint64_t piece = store.arena.piece(k, count, 20); k < piece; ++k) {
            const std::uint32_t v = order[k];
            const double *const a = store.point(heaviest), *const b = store.point(v);
            int same = 0;
            while (same < store.dim && a[same] == b[same]) ++same;
            const bool duplicate = k > 0 && same == store.dim;
            const bool stays = !duplicate || b[store.dim] > a[store.dim];
            if (duplicate && stays) store.vertex(heaviest).next = none;
            store.vertex(v).next = stays ? VertexId(0) : VertexId(none);
            if (stays) heaviest = v;
        }
    return drop_marked(store, order, count);
}

double largest_number(const AnyStore& store) {
    double top = -infinity;
    store.arena.each(store.state.vertex_count, 6, [&](std::uint64_t v) {
        const double number = store.point(static_cast<std::uint32_t>(v))[store.dim];
        top = number > top ? number : top;
    });
    return top;
}

Status take_weighted_input(AnyStore& store, const InputRows& points, std::size_t n, const WeightRows& weights,
                           std::uint64_t seed, Monitor& monitor, InputReport* input, HiddenPoints* hidden,
                           std::uint32_t** order) {
    *input = InputReport{};
    *hidden = HiddenPoints{};
    if (n == 0 || n > points_max) return Status::invalid_argument;
    monitor.begin(NETMESH_STAGE_SORT, n);
    if (!are_finite(points, n, store.dim, store.arena, input)) return Status::not_finite;
    if (!are_weights(weights, n, store.arena, input, hidden))
        return hidden->has_negative ? Status::invalid_argument : Status::not_finite;
    const std::uint32_t count = static_cast<std::uint32_t>(n);
    if (store.open_vertices(count) != Status::ok) return Status::out_of_memory;
    input->rows = n;
    input->fingerprint = copy_points(points, store);
    input->fingerprint = copy_weights(weights, store, input->fingerprint);
    *order = store.arena.take_low<std::uint32_t>(count);
    if (*order == nullptr) return Status::out_of_memory;
    bool repeats;
    const Status status = with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        return spatial_order<decltype(dimension)::value>(store.first_point(), store.point_stride(), count, seed,
                                                         store.arena, *order, &repeats);
    });
    if (status != Status::ok) return status;
    const std::uint32_t kept = repeats ? remove_lighter(store, *order, count) : count;
    input->duplicates = count - kept;
    store.truncate_vertices(kept);
    return store.arena.has_stopped() ? Status::cancelled : Status::ok;
}

// Takes vertices in no cell, but for those that are queued, out of a compact store, and lists their rows. In place: the
// records of those that stay move up, each by an exchange with a hidden one, and rows of the hidden ones are written
// over their own records.
void leave_hidden_out(const AnyStore& store, HiddenPoints* hidden) {
    const std::uint32_t count = store.state.vertex_count;
    std::uint32_t kept = 0;
    store.arena.each(count, 20, [&](std::uint64_t at) {
        const std::uint32_t v = static_cast<std::uint32_t>(at);
        const bool stays = store.vertex(v).cell != none || store.vertex(v).queued != 0;
        store.vertex(v).queued = 0;
        store.vertex(v).next = stays ? VertexId(kept) : VertexId(none);
        kept += stays;
    });
    hidden->count = count - kept;
    if (kept == count) return;
    store.arena.each(store.state.cell_slots, 10, [&](std::uint64_t c) {
        for (VertexId& v : store.cell(static_cast<std::uint32_t>(c)).vertex) v = store.vertex(v).next;
    });
    std::uint32_t out = 0;
    store.arena.each(count, 30, [&](std::uint64_t at) {
        const std::uint32_t v = static_cast<std::uint32_t>(at);
        if (store.vertex(v).next == none) return;
        if (out != v) store.exchange_vertices(v, out);
        ++out;
    });
    unsigned char* const end = store.arena.at(static_cast<std::size_t>(store.state.vertices_end)) -
                               kept * static_cast<std::size_t>(-store.point_stride());
    hidden->rows = reinterpret_cast<std::uint32_t*>(end) - hidden->count;
    for (std::uint32_t i = hidden->count; i > 0; --i) {
        store.arena.step(i, 6);
        hidden->rows[i - 1] = store.vertex(count - i).origin;
    }
    sort(hidden->rows, hidden->count, Ascending{}, store.arena);
    store.state.vertex_count = kept;
    store.arena.release_high(store.arena.offset_of(hidden->rows) & ~(Arena::alignment - 1));
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

    status = insert_all(run, store.state, monitor, allowance);
    if (allowance != nullptr && allowance->is_spent) return status;
    run.finish();
    return status;
}

template <int D>
Status triangulate_weighted(Store<D>& store, const InputRows& points, std::size_t n, const WeightRows& weights,
                            std::uint64_t seed, Monitor& monitor, InputReport* input, HiddenPoints* hidden) {
    const std::size_t low = store.arena.low_mark();
    std::uint32_t* order;
    AnyStore any(store);
    Status status = take_weighted_input(any, points, n, weights, seed, monitor, input, hidden, &order);
    store.locate_arrays();
    if (status != Status::ok) return status;
    const std::uint32_t count = store.state.vertex_count;
    VertexId ids[D + 1];
    if (!independent_points(store, order, count, ids)) return Status::flat;
    TriangulationRun<D, Weights> run(store);
    run.weigh({largest_number(store), weights.are_radii, weights.index});
    status = run.open(order, low);
    if (status == Status::ok) status = run.start(ids);
    if (status != Status::ok) return status;

    monitor.begin(NETMESH_STAGE_DELAUNAY, count);
    std::uint32_t k = 0;
    for (; k < count; ++k) {
        std::uint32_t made;
        if (!run.insert(k, &made)) {
            status = Status::out_of_memory;
            break;
        }
        monitor.mesh_size(k, store.live_cells());
        if (monitor.advance(k, 2 + made * (D - 1))) {
            ++k;
            status = Status::cancelled;
            break;
        }
    }
    for (; k < count; ++k) {
        store.arena.step(k, 6);
        store.vertex(run.vertex_at(k)).queued = run.is_in_first_cell(k) ? 0 : 1;
    }
    run.finish();
    leave_hidden_out(AnyStore(store), hidden);
    return status;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status triangulate_weighted<D>(Store<D>&, const InputRows&, std::size_t, const WeightRows&,               \
                                            std::uint64_t, Monitor&, InputReport*, HiddenPoints*);                     \
    template Status triangulate<D>(Store<D>&, const InputRows&, std::size_t, std::uint64_t, Monitor&, InputReport*,    \
                                   Allowance*);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
