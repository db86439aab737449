// Copies that are near are triangulated at once, as most of them are wanted. The others wait in cubes of a grid. A cell
// asks for those in conflict with it in the cubes that its ball meets. One that surely is in conflict, waiting or not
// yet, takes the cell away when it is inserted; those that doubles do not decide about are all inserted. So a cell need
// not be asked again.
#include "periods/wanted_copies.hpp"

#include "delaunay/independent_points.hpp"
#include "delaunay/kernel.hpp"
#include "delaunay/spatial_order.hpp"
#include "periods/ball_reach.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// As in triangulate.cpp: balls only answer whether a point is inside.
constexpr double ball_error_most = 0x1p-7;

template <int D> class WantedCopies {
public:
    WantedCopies(Store<D>& store, const PeriodicPoints& points, const Copies& copies, double near, double spacing,
                 const Weights& weights, bool has_weights, const Work& work)
        : store_(store), kernel_(store, ball_error_most, VertexCells::ignored, TieOrder::of_rows), points_(points),
          copies_(copies), spacing_(spacing), weights_(weights), work_(work), arena_(work.arena),
          reach_(points, fill_near(near), has_weights ? &weights_ : nullptr, work.arena) {
        kernel_.weigh(weights);
    }

    Status run(std::uint64_t seed) {
        const std::size_t low = arena_.low_mark();
        Status status = take_vertices();
        if (status == Status::ok) status = sort_others();
        if (status == Status::ok) status = triangulate_first(seed);
        if (status == Status::ok) status = ask_all();
        if (status != Status::ok) return status;
        // Those in no cell are left without one.
        arena_.each(store_.state.vertex_count, 2,
                    [this](std::uint64_t v) { store_.vertex(static_cast<std::uint32_t>(v)).cell = none; });
        store_.compact((low + Arena::alignment - 1) & ~(Arena::alignment - 1));
        return status;
    }

private:
    static constexpr int numbers = D + 1;
    enum State : std::uint8_t { outside, waiting, inserted };  // of a copy

    const double* fill_near(double near) {
        for (double& margin : near_) margin = near;
        return near_;
    }
    const double* number_of(std::uint32_t copy) const { return copies_.x + std::size_t{copy} * numbers; }
    bool is_near(std::uint32_t copy) const {
        for (int j = 0; j < D; ++j) {
            const double y = dot<D>(points_.lattice.e[j], number_of(copy));
            if (!(y >= points_.low[j] - near_[j] && y <= points_.high[j] + near_[j])) return false;
        }
        return true;
    }
    void fill_vertex(VertexId v, std::uint32_t copy) {
        Vertex<D>& vertex = store_.vertex(v);
        const double* const x = number_of(copy);
        for (int k = 0; k < D; ++k) vertex.x[k] = x[k];
        vertex.nearest2 = x[D];
        vertex.cell = none;
        vertex.next = none;
        vertex.origin = copy;
        vertex.marker = Marker::input;
        vertex.queued = 0;
        vertex.size_hint = 0;
    }
    // The points become the first vertices, then near copies.
    [[gnu::noinline]] Status take_vertices() {
        state_ = arena_.template take_low<std::uint8_t>(copies_.count);
        if (state_ == nullptr) return Status::out_of_memory;
        std::uint32_t chosen = 0;
        arena_.each(copies_.count, 6 * D, [&](std::uint64_t at) {
            const auto copy = static_cast<std::uint32_t>(at);
            state_[copy] = copy < points_.count || is_near(copy) ? inserted : outside;
            chosen += state_[copy] == inserted;
        });
        others_ = copies_.count - chosen;
        const Status status = store_.open_vertices(chosen);
        if (status != Status::ok) return status;
        VertexId next(0);
        arena_.each(copies_.count, 2 * D, [&](std::uint64_t at) {
            const auto copy = static_cast<std::uint32_t>(at);
            if (state_[copy] != inserted) return;
            fill_vertex(next, copy);
            next = VertexId(next + 1);
        });
        return Status::ok;
    }

    std::uint32_t place_along(int k, double x) const {
        const double place = (x - least_[k]) / side_;
        return !(place > 0) ? 0 : place < cubes_[k] ? static_cast<std::uint32_t>(place) : cubes_[k] - 1;
    }
    std::uint32_t cube_of(const double* x) const {
        std::uint32_t cube = 0;
        for (int k = D - 1; k >= 0; --k) cube = cube * cubes_[k] + place_along(k, x[k]);
        return cube;
    }
    // The copies that are not near, by cubes.
    [[gnu::noinline]] Status sort_others() {
        double most[D];
        for (int k = 0; k < D; ++k) {
            least_[k] = infinity;
            most[k] = -infinity;
        }
        arena_.each(copies_.count, 4 * D, [&](std::uint64_t copy) {
            const double* const x = number_of(static_cast<std::uint32_t>(copy));
            for (int k = 0; k < D; ++k) {
                least_[k] = x[k] < least_[k] ? x[k] : least_[k];
                most[k] = x[k] > most[k] ? x[k] : most[k];
            }
        });
        // Not many more cubes than copies.
        double cubes = infinity;
        for (side_ = spacing_; !(cubes < 4.0 * copies_.count + 64); side_ *= 1.25) {
            cubes = 1;
            for (int k = 0; k < D; ++k) cubes *= (most[k] - least_[k]) / side_ + 1;
        }
        std::uint32_t count = 1;
        for (int k = 0; k < D; ++k) count *= cubes_[k] = static_cast<std::uint32_t>((most[k] - least_[k]) / side_) + 1;
        begin_ = arena_.template take_low<std::uint32_t>(std::size_t{count} + 2);
        other_ = arena_.template take_low<std::uint32_t>(others_);
        stack_ = arena_.template take_low<std::uint32_t>(others_);
        if (begin_ == nullptr || other_ == nullptr || stack_ == nullptr) return Status::out_of_memory;
        arena_.each(std::uint64_t{count} + 2, 1, [this](std::uint64_t c) { begin_[c] = 0; });
        each_other([this](std::uint32_t, std::uint32_t cube) { ++begin_[cube + 2]; });
        arena_.each(count, 3, [this](std::uint64_t c) { begin_[c + 2] += begin_[c + 1]; });
        each_other([this](std::uint32_t copy, std::uint32_t cube) { other_[begin_[cube + 1]++] = copy; });
        return Status::ok;
    }
    template <class Act> void each_other(Act&& act) {
        arena_.each(copies_.count, 8 * D, [&](std::uint64_t at) {
            const auto copy = static_cast<std::uint32_t>(at);
            if (state_[copy] == outside) act(copy, cube_of(number_of(copy)));
        });
    }

    [[gnu::noinline]] Status triangulate_first(std::uint64_t seed) {
        const std::uint32_t count = store_.state.vertex_count;
        std::uint32_t* const order = arena_.template take_low<std::uint32_t>(count);
        if (order == nullptr) return Status::out_of_memory;
        bool repeats;
        Status status = spatial_order<D>(reinterpret_cast<const unsigned char*>(store_.point(0)),
                                         Store<D>::vertex_stride, count, seed, arena_, order, &repeats);
        if (status != Status::ok) return status;
        VertexId ids[D + 1];
        if (!independent_points(AnyStore(store_), order, count, ids)) return Status::flat;
        status = store_.open_cells();
        if (status == Status::ok) status = kernel_.start(ids);
        if (status != Status::ok) return status;
        work_.monitor.begin(NETMESH_STAGE_DELAUNAY, count);
        for (std::uint32_t k = 0; k < count; ++k) {
            if (k + ahead < count) {
                const double* const next = store_.point(order[k + ahead]);
                __builtin_prefetch(next);
                __builtin_prefetch(next + D - 1);
            }
            const VertexId v(order[k]);
            std::uint32_t made = 0;
            if (store_.vertex(v).cell == none && !insert(v, store_.state.last_cell, &made))
                return Status::out_of_memory;
            work_.monitor.mesh_size(k, store_.live_cells());
            if (work_.monitor.advance(k, 2 + made * (D - 1))) return Status::cancelled;
        }
        return Status::ok;
    }
    // made: new cells, 0 where the vertex is hidden.
    bool insert(VertexId v, CellId from, std::uint32_t* made) {
        const double* const q = store_.point(v);
        const CellId hit = kernel_.locate(q, v, from);
        *made = 0;
        if (hit == none) return true;
        Cavity cavity;
        if (!kernel_.find_cavity(q, v, hit, &cavity) || !kernel_.can_fill(cavity, 0)) return false;
        kernel_.fill(cavity, v);
        *made = cavity.facets;
        return true;
    }

    // Cells that are made while others are asked are asked at once.
    [[gnu::noinline]] Status ask_all() {
        for (std::uint32_t c = 0; c < store_.state.cell_slots; ++c) {
            arena_.step(c, 30 * D);
            if (!store_.is_live(c)) continue;
            ask(CellId(c));
            for (bool is_first = true; waiting_ > 0; is_first = false) {
                const std::uint32_t copy = stack_[--waiting_];
                if (!store_.has_room(0, 1, 0)) return Status::out_of_memory;
                const VertexId v = store_.new_vertex();
                fill_vertex(v, copy);
                state_[copy] = inserted;
                std::uint32_t made;
                if (!insert(v, is_first ? CellId(c) : store_.state.last_cell, &made)) return Status::out_of_memory;
                for (std::uint32_t k = 0; k < made; ++k) ask(kernel_.new_cell(k));
                arena_.pass(2 + made * (D - 1));
                if (arena_.has_stopped()) return Status::cancelled;
            }
        }
        return arena_.has_stopped() ? Status::cancelled : Status::ok;
    }
    // Lets copies wait that are in conflict with the cell.
    void ask(CellId c) {
        Cell<D>& cell = store_.cell(c);
        int at = D + 1;
        for (int i = 0; i <= D; ++i) {
            if (cell.vertex[i] == none) return;
            if (cell.vertex[i] < points_.count) at = i;
        }
        if (at > D) return;
        if (!(cell.error < 0.125f)) reach_.sharpen(store_, cell);
        if (!(BallReach<D>::reach2_of(cell) < infinity) || !(reach_.missing_of(cell) > 0)) return;
        const double* const x = store_.point(cell.vertex[at]);
        // Of a large ball mostly one near the vertex.
        const double width = square_root(BallReach<D>::reach2_of(cell)) * (1 + 0x1p-40);
        if (width < 2 * spacing_ || !look_around(cell, x, width, 2 * spacing_)) look_around(cell, x, width, infinity);
    }
    // Of copies in the ball, of that half width, no farther than `far` from x by coordinate. Is there one that surely
    // is in conflict?
    [[gnu::noinline]] bool look_around(const Cell<D>& cell, const double* x, double width, double far) {
        std::uint32_t first[D], last[D], place[D];
        for (int k = 0; k < D; ++k) {
            const double slack = 0x1p-40 * (absolute(cell.centre[k]) + width);
            const double low = cell.centre[k] - width - slack, high = cell.centre[k] + width + slack;
            first[k] = place[k] = place_along(k, low > x[k] - far ? low : x[k] - far);
            last[k] = place_along(k, high < x[k] + far ? high : x[k] + far);
        }
        std::uint32_t best = none;
        double best2 = infinity;
        for (;;) {
            std::uint32_t row = 0;
            for (int k = D - 1; k > 0; --k) row = (row + place[k]) * cubes_[k - 1];
            look_through(cell, x, begin_[row + first[0]], begin_[row + last[0] + 1], &best, &best2);
            int k = 1;
            while (k < D && place[k] == last[k]) {
                place[k] = first[k];
                ++k;
            }
            if (k == D) break;
            ++place[k];
        }
        if (best != none) let_wait(best);
        return best != none;
    }
    void look_through(const Cell<D>& cell, const double* x, std::uint32_t begin, std::uint32_t end, std::uint32_t* best,
                      double* best2) {
        arena_.pass((end - begin) / 8 + 1);
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::uint32_t copy = other_[i];
            if (state_[copy] == inserted) continue;
            const double* const q = number_of(copy);
            double bound;
            const double value = power<D>(cell, q, weights_.height(q[D]), &bound);
            if (value > bound) continue;
            if (!(value < -bound)) {
                let_wait(copy);
                continue;
            }
            double away2 = 0;
            for (int k = 0; k < D; ++k) away2 += (q[k] - x[k]) * (q[k] - x[k]);
            if (away2 < *best2) {
                *best2 = away2;
                *best = copy;
            }
        }
    }
    void let_wait(std::uint32_t copy) {
        if (state_[copy] != outside) return;
        state_[copy] = waiting;
        stack_[waiting_++] = copy;
    }

#ifdef __OPTIMIZE_SIZE__
    static constexpr std::uint32_t ahead = 0;
#else
    static constexpr std::uint32_t ahead = 6;
#endif

    Store<D>& store_;
    Kernel<D, Weights> kernel_;
    const PeriodicPoints& points_;
    const Copies& copies_;
    double near_[D];
    const double spacing_;
    const Weights weights_;
    const Work& work_;
    Arena& arena_;
    const BallReach<D> reach_;
    std::uint8_t* state_ = nullptr;   // [copies]
    std::uint32_t* begin_ = nullptr;  // [cubes + 1], in other_
    std::uint32_t* other_ = nullptr;  // copies that are not near
    std::uint32_t* stack_ = nullptr;  // copies that wait
    std::uint32_t others_ = 0, waiting_ = 0;
    double least_[D], side_ = 0;
    std::uint32_t cubes_[D];
};

}  // namespace

template <int D>
Status triangulate_wanted(Store<D>& store, const PeriodicPoints& points, const Copies& copies, double near,
                          double spacing, const Weights& weights, bool has_weights, std::uint64_t seed,
                          const Work& work) {
    if constexpr (D > 2)
        return WantedCopies<D>(store, points, copies, near, spacing, weights, has_weights, work).run(seed);
    else
        return Status::internal;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status triangulate_wanted<D>(Store<D>&, const PeriodicPoints&, const Copies&, double, double,             \
                                          const Weights&, bool, std::uint64_t, const Work&);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
