// The triangulation of points in the plane when nothing else is made of them. Meshes have cells with circles
// (planar.hpp); here no cell has one, as in-circle tests are determinants of coordinates, which cost no division and no
// square root. A part of triangulate.cpp; templates, so that nothing of it is made where the plane is not served.
//
//   low end: cells 0, 1, 2, ...  -->     gap     <-- list of a cavity | points | order | vertices, high end
//
// While it grows, vertices of cells are numbered in the order of insertion, and their coordinates stand in that order:
// what is near in the plane is near in memory. It ends in one of two ways:
//   finish()  The points go and every cell becomes one of the store, which takes more than twice the room; it is asked
//             for before a cell is made, so the end cannot fail.
//   close()   Points and cells stay as they are, for a diagram of them. The store's vertices have gone at the start.
//
// With weights cells have a mark, as a cavity with a vertex inside is no tree of cells, and points three numbers.
#pragma once
#include "delaunay/plane_cells.hpp"
#include "delaunay/plane_question.hpp"
#include "delaunay/sphere.hpp"
#include "delaunay/store.hpp"
#include "predicates/weighted.hpp"

namespace netmesh {

// Cells of points with weights.
struct MarkedPlaneCell {
    VertexId vertex[3];
    FacetId neighbour[3];
    std::uint32_t mark = 0;  // number of the last cavity that has it, from 1 on
};

// Line k of a cavity's list, line 0 highest in memory: columns of different lengths.
struct PlaneLine {
    CellId made;      // a cell in conflict, then the cell that takes its place
    FacetId beyond;   // a bounding facet, of the cell outside; they come counterclockwise
    VertexId start;   // the vertex at which the facet starts
    FacetId waiting;  // stack of facets still to be crossed
};

// Which of the two ends it comes to.
enum class PlaneEnd { finish, close };

// Short words are closed.
template <int D, class W = NoWeights, class Words = WideWords> class PlaneRun {
public:
    static constexpr int dim = D;

    explicit PlaneRun(Store<D>& store, PlaneEnd end = PlaneEnd::finish)
        : store_(store), arena_(store.arena), state_(store.state), end_(end) {}
    // Of points with weights; before open.
    void weigh(const Weights& weights) { question_.weights = weights; }

    // Before the first cell. order[0..count) stands at the low end from `low` on, and is moved. out_of_memory.
    Status open(const std::uint32_t* order, std::size_t low);
    // Makes the first cell, of these vertices, and its ghosts. out_of_memory.
    Status start(const VertexId* ids);
    // Inserts vertex order[k] and tells how many cells that made; 0 when the first cell has it or, with weights, when
    // it is hidden. False: out of memory, and nothing has changed.
    bool insert(std::uint32_t k, std::uint32_t* made);
    // Makes a compact store of it.
    void finish();
    // The cells are the last piece at the low end, the points and below them the order at the high end.
    PlaneTriangulation<Words> close();

    VertexId vertex_at(std::uint32_t k) const { return VertexId(order_[k]); }
    bool is_in_first_cell(std::uint32_t k) const { return k == first_[0] || k == first_[1] || k == first_[2]; }

private:
    static constexpr std::uint32_t next[4] = {1, 2, 0, 0};
    using Question = PlaneQuestion<W>;
    using Index = typename Words::Index;
    using CellT = std::conditional_t<W::has, MarkedPlaneCell, PlaneCell<Words>>;
    bool is_finished() const { return !Words::are_short && end_ == PlaneEnd::finish; }
    using PlaneArm = typename Question::Arm;

    // Whether q lies inside of a cell, by the sides of its edges, as far as doubles tell.
    static bool is_surely_in(const PlaneArm* arm, const double* side) {
        bool is_in = true;
        for (std::uint32_t i = 0; i < 3; ++i)
            is_in =
                is_in && side[i] > 4 * unit_roundoff * (arm[next[i]].square() + arm[next[next[i]]].square()) + 0x1p-960;
        return is_in;
    }
    const double* point(std::uint32_t k) const { return question_.points + Question::numbers * std::size_t{k}; }
    bool has_room(std::size_t cells, std::size_t lines);
    bool refuse_list(std::size_t lines) {
        arena_.refuse(lines * sizeof(PlaneLine));
        return false;
    }
    int collect(CellId c, const double** p, VertexId* ids) const;
    bool undecided_conflict(CellId c);
    CellId locate();
    CellId walk(CellId from);
    bool find_cavity(CellId first);
    void fill();

    Store<D>& store_;
    Arena& arena_;
    StoreState& state_;
    const PlaneEnd end_;
    CellT* cells_;
    PlaneLine* lines_;  // line 0
    const Index* order_;
    std::size_t vertices_begin_;  // offset of the last vertex
    std::size_t cells_end_;       // offset up to which cells may reach in the end
    Question question_ = {};
    const double* q_;
    std::uint32_t q_number_;
    std::uint32_t first_[3];  // the vertices of the first cell
    std::ptrdiff_t facets_;   // of the cavity
    std::ptrdiff_t count_;    // its cells; with weights alone
    std::uint32_t cavities_ = 0;
};

template <int D, class W, class Words> Status PlaneRun<D, W, Words>::open(const std::uint32_t* order, std::size_t low) {
    const std::uint32_t count = state_.vertex_count;
    vertices_begin_ = arena_.high_mark();
    Index* kept = arena_.template take_high<Index>(count);
    cells_end_ = arena_.high_mark();
    double* points = arena_.template take_high<double>(Question::numbers * count);
    if (kept == nullptr || points == nullptr) return Status::out_of_memory;
    constexpr int numbers = static_cast<int>(Question::numbers);
    double least[numbers], most[numbers];
    for (int i = 0; i < numbers; ++i) {
        least[i] = infinity;
        most[i] = -infinity;
    }
    for (std::uint32_t k = 0; k < count;)
        for (const std::uint64_t piece = arena_.piece(k, count, 30); k < piece; ++k) {
            kept[k] = static_cast<Index>(order[k]);
            if (k + 16 < count) __builtin_prefetch(store_.point(order[k + 16]));
            const double* const x = store_.point(order[k]);
            for (int i = 0; i < numbers; ++i) {
                points[Question::numbers * std::size_t{k} + static_cast<std::size_t>(i)] = x[i];
                least[i] = x[i] < least[i] ? x[i] : least[i];
                most[i] = x[i] > most[i] ? x[i] : most[i];
            }
        }
    // Both go to where the vertices are, which take more room than they do.
    if (!W::has && !is_finished()) {
        const double* const points_below = points;
        const Index* const kept_below = kept;
        arena_.release_high(static_cast<std::size_t>(state_.vertices_end) & ~(Arena::alignment - 1));
        points = arena_.template take_high<double>(Question::numbers * count);
        kept = arena_.template take_high<Index>(count);
        if (kept == nullptr || points == nullptr) return Status::out_of_memory;
        move_bytes(points, points_below, sizeof(double) * Question::numbers * count, arena_);
        move_bytes(kept, kept_below, sizeof(Index) * count, arena_);
    }
    const double width = most[0] - least[0], height = most[1] - least[1];
    question_.points = points;
    question_.extent2 = width * width + height * height;
    if constexpr (W::has) question_.extent2 += question_.weights.difference(most[2], least[2]);
    // With lifts up to 2^240 what underflows adds less than 2^-800, as in planar_stage.hpp.
    question_.underflow = question_.extent2 < 0x1p240 ? 0x1p-790 : infinity;
    order_ = kept;
    arena_.release_low(low);
    if (store_.open_cells() != Status::ok) return Status::out_of_memory;
    cells_ = reinterpret_cast<CellT*>(arena_.at(state_.cells_offset));
    lines_ = reinterpret_cast<PlaneLine*>(arena_.at(arena_.high_mark())) - 1;
    return Status::ok;
}

// Room for that many more cells, now and at the end, and for a list of so many lines?
template <int D, class W, class Words> bool PlaneRun<D, W, Words>::has_room(std::size_t cells, std::size_t lines) {
    const std::size_t now = cells * sizeof(CellT) + lines * sizeof(PlaneLine) + Arena::alignment;
    const std::size_t last = state_.cells_offset + (state_.cell_slots + cells) * sizeof(Cell<D>) + Arena::alignment;
    const std::size_t in_the_end =
        arena_.bytes_free() + last > cells_end_ ? arena_.bytes_free() + last - cells_end_ : 0;
    const std::size_t needed = now > in_the_end || !is_finished() ? now : in_the_end;
    if (needed > arena_.bytes_free()) {
        arena_.refuse(needed);
        return false;
    }
    // Of points on a circle half of the cells are ghosts, which the end does not have, and a list may be as long.
    arena_.use_gap(needed);
    return true;
}

template <int D, class W, class Words> [[gnu::cold]] Status PlaneRun<D, W, Words>::start(const VertexId* ids) {
    if (!has_room(4, 0)) return Status::out_of_memory;
    for (int i = 0; i < 3; ++i) {
        std::uint32_t k = 0;
        while (order_[k] != ids[i]) arena_.step(++k, 4);
        first_[i] = k;
    }
    const double* const p[3] = {point(first_[0]), point(first_[1]), point(first_[2])};
    const bool turn = orient<D>(p, state_.orient_counts) == Sign::negative;
    const VertexId v[3] = {VertexId(first_[turn]), VertexId(first_[!turn]), VertexId(first_[2])};
    // Cell 0 is finite; ghost 1 + i lies behind its facet i, and has the facet's vertices exchanged.
    const auto facet = [](std::uint32_t c, std::uint32_t i) { return FacetId(CellId(c), i); };
    cells_[0] = CellT{{v[0], v[1], v[2]}, {facet(1, 0), facet(2, 1), facet(3, 2)}};
    cells_[1] = CellT{{none, v[2], v[1]}, {facet(0, 0), facet(3, 1), facet(2, 2)}};
    cells_[2] = CellT{{v[2], none, v[0]}, {facet(3, 0), facet(0, 1), facet(1, 2)}};
    cells_[3] = CellT{{v[1], v[0], none}, {facet(2, 0), facet(1, 1), facet(0, 2)}};
    arena_.extend_low(4 * sizeof(CellT));
    state_.cell_slots = 4;
    state_.cells_created += 4;
    state_.last_cell = CellId(0);
    return Status::ok;
}

// The cell's points and their indices, the point in question for infinity; where that is, -1 for a finite cell.
template <int D, class W, class Words>
int PlaneRun<D, W, Words>::collect(CellId c, const double** p, VertexId* ids) const {
    int infinite = -1;
    for (int i = 0; i < 3; ++i) {
        const VertexId v = cells_[c].vertex[i];
        if (v == none) infinite = i;
        p[i] = v == none ? q_ : point(v);
        ids[i] = v == none ? VertexId(none) : VertexId(order_[v]);
    }
    return infinite;
}

// As Kernel::in_conflict.
template <int D, class W, class Words> [[gnu::noinline]] bool PlaneRun<D, W, Words>::undecided_conflict(CellId c) {
    arena_.pass(undecided_units);
    const double* p[3];
    VertexId ids[3];
    const int infinite = collect(c, p, ids);
    if (infinite >= 0) {
        const Sign side = orient<D>(p, state_.orient_counts);
        if (side != Sign::zero) return side == Sign::positive;
        collect(cells_[c].neighbour[infinite].cell(), p, ids);
    }
    VertexId id(order_[q_number_]);
    if constexpr (W::has) {
        for (VertexId& v : ids) v = question_.weights.index_of(v);
        id = question_.weights.index_of(id);
        return in_power_perturbed<D>(p, ids, q_, id, question_.weights.are_radii, state_.in_ball_counts) ==
               Sign::positive;
    } else {
        return in_ball_perturbed<D>(p, ids, q_, id, state_.in_ball_counts) == Sign::positive;
    }
}

// A cell in conflict: from the last cell on through the first edge beyond which q surely lies, until a circle surely
// contains q. No other edge than the hull's is left then, or the exact walk goes on.
template <int D, class W, class Words> CellId PlaneRun<D, W, Words>::locate() {
    const Question question = question_;
    const CellT* const cells = cells_;
    CellId c = state_.last_cell;
    for (std::uint32_t i = 0; i < 3; ++i)
        if (cells[c].vertex[i] == none) {
            if (undecided_conflict(c)) return c;
            c = cells[c].neighbour[i].cell();
            break;
        }
    for (std::uint32_t steps = 1;; ++steps) {
        if (steps % 32 == 0) arena_.pass(5 * dim);  // points on a curve take as many as there are
        const CellT& cell = cells[c];
        const PlaneArm arm[3] = {question.arm_to(cell.vertex[0]), question.arm_to(cell.vertex[1]),
                                 question.arm_to(cell.vertex[2])};
        const double side[3] = {cross(arm[1], arm[2]), cross(arm[2], arm[0]), cross(arm[0], arm[1])};
        const double value = arm[0].lift * side[0] + arm[1].lift * side[1] + arm[2].lift * side[2];
        const double error = question.error_of(arm[0].size(), arm[1].size(), arm[2].size());
        if (value > error) return c;
        CellId to = none, outside = none;
        for (std::uint32_t i = 0; i < 3 && to == none; ++i) {
            if (!(side[i] < -4 * unit_roundoff * (arm[next[i]].square() + arm[next[next[i]]].square()) - 0x1p-960))
                continue;
            const FacetId beyond = cell.neighbour[i];
            if (cells[beyond.cell()].vertex[beyond.position()] != none)
                to = beyond.cell();
            else if (outside == none)
                outside = beyond.cell();
        }
        if (to == none) {
            const bool is_outside = W::has && value < -error;  // surely; else it has only not been decided
            if (!is_outside && undecided_conflict(c)) return c;
            if (outside != none) return outside;
            if constexpr (W::has)
                if (is_outside && is_surely_in(arm, side)) return CellId(none);
            c = walk(c);
            // The cell that q lies in; what is beyond the hull is in conflict.
            if constexpr (W::has)
                if (!undecided_conflict(c)) return CellId(none);
            return c;
        }
        c = to;
    }
}

// As Kernel::walk.
template <int D, class W, class Words> [[gnu::noinline]] CellId PlaneRun<D, W, Words>::walk(CellId from) {
    CellId c = from;
    for (;;) {
        arena_.pass(exact_step_units);
        const double* p[3];
        VertexId ids[3];
        if (collect(c, p, ids) >= 0) return c;
        CellId to = none;
        for (int i = 0; i < 3 && to == none; ++i) {
            const double* const kept = p[i];
            p[i] = q_;
            if (orient<D>(p, state_.orient_counts) == Sign::negative) to = cells_[c].neighbour[i].cell();
            p[i] = kept;
        }
        if (to == none) return c;
        c = to;
    }
}

// The search of PlanarCavity::find. Each facet starts where the last bounding one ended: `from` and `to` are the ends
// of the facet that is crossed next, `edge` their cross product, and only the apex beyond is new.
template <int D, class W, class Words> bool PlaneRun<D, W, Words>::find_cavity(CellId first) {
    const std::size_t capacity = arena_.bytes_free() / sizeof(PlaneLine);
    const Question question = question_;
    CellT* const cells = cells_;
    PlaneLine* const lines = lines_;
    std::uint64_t sure = 0;
    std::ptrdiff_t count = 1, facets = 0, waiting = 2;
    if (capacity < 4) return refuse_list(4);
    lines[0].made = first;
    lines[0].waiting = FacetId(first, 2);
    lines[-1].waiting = FacetId(first, 1);
    FacetId facet(first, 0);
    VertexId a = cells[first].vertex[1], b = cells[first].vertex[2];
    PlaneArm from = question.arm_to(a), to = question.arm_to(b);
    double edge = cross(from, to);
    if constexpr (W::has) cells[first].mark = ++cavities_;
    for (;;) {
        const FacetId beyond = cells[facet.cell()].neighbour[facet.position()];
        const CellId n = beyond.cell();
        // Around a vertex inside of the cavity the search comes back to cells that it has been to. Such a facet is
        // none of its boundary, and the next one starts where it ends, as behind all that was found beyond a facet.
        bool again = false;
        if constexpr (W::has) again = cells[n].mark == cavities_;
        const PlaneArm apex = question.arm_to(cells[n].vertex[beyond.position()]);
        // The cell beyond is (to, from, apex).
        const double up = cross(from, apex), down = cross(apex, to);
        const double value = from.lift * down + to.lift * up - apex.lift * edge;
        const double error = question.error_of(from.size(), to.size(), apex.size());
        bool inside = value > 0;
        ++sure;
        if (W::has && again) {
            inside = false;
        } else if (__builtin_expect(!(__builtin_fabs(value) > error), 0)) {
            inside = undecided_conflict(n);
            --sure;
        }
        if (inside) {
            if (static_cast<std::size_t>(count) + 4 > capacity) return refuse_list(static_cast<std::size_t>(count) + 4);
            const std::uint32_t i = next[beyond.position()];
            if constexpr (W::has) cells[n].mark = cavities_;
            lines[-count++].made = n;
            lines[-waiting++].waiting = FacetId(n, next[i]);
            facet = FacetId(n, i);
            b = cells[n].vertex[beyond.position()];
            to = apex;
            edge = up;
            continue;
        }
        if (!(W::has && again)) {
            lines[-facets].beyond = beyond;
            lines[-facets++].start = a;
        }
        if (waiting == 0) break;
        facet = lines[-(--waiting)].waiting;
        a = b;
        from = to;
        b = cells[facet.cell()].vertex[next[next[facet.position()]]];
        to = question.arm_to(b);
        edge = cross(from, to);
    }
    state_.in_ball_counts.calls[0] += sure;
    arena_.use_gap(static_cast<std::size_t>(count + 3) * sizeof(PlaneLine));
    facets_ = facets;
    if constexpr (W::has) count_ = count;
    return true;
}

// As PlanarCavity::fill: each new cell (q, a, b) has its neighbours before and after it.
template <int D, class W, class Words> void PlaneRun<D, W, Words>::fill() {
    PlaneLine* const lines = lines_;
    const std::ptrdiff_t facets = facets_;
    // As many cells as before and two more, but two less for each vertex inside: what is left over stays unused.
    for (std::ptrdiff_t k = facets; W::has && k < count_; ++k) cells_[lines[-k].made].vertex[0] = Store<D>::freed;
    if (!W::has || facets > count_) {
        lines[2 - facets].made = CellId(state_.cell_slots);
        lines[1 - facets].made = CellId(state_.cell_slots + 1);
        arena_.extend_low(2 * sizeof(CellT));
        state_.cell_slots += 2;
    } else {
        state_.cells_free += static_cast<std::uint32_t>(count_ - facets);
    }
    state_.cells_created += static_cast<std::uint64_t>(facets);
    CellId before = lines[1 - facets].made, n = lines[0].made;
    VertexId a = lines[0].start;
    for (std::ptrdiff_t k = 0; k < facets; ++k) {
        const std::ptrdiff_t after = k + 1 < facets ? k + 1 : 0;
        const FacetId beyond = lines[-k].beyond;
        const VertexId b = lines[-after].start;
        const CellId then = lines[-after].made;
        cells_[n] = CellT{{VertexId(q_number_), a, b}, {beyond, FacetId(then, 2), FacetId(before, 1)}};
        cells_[beyond.cell()].neighbour[beyond.position()] = FacetId(n, 0);
        before = n;
        n = then;
        a = b;
    }
    state_.last_cell = before;
}

template <int D, class W, class Words> bool PlaneRun<D, W, Words>::insert(std::uint32_t k, std::uint32_t* made) {
    *made = 0;
    if (is_in_first_cell(k)) return true;
    q_number_ = k;
    q_ = point(k);
    question_.ask(q_);
    const CellId hit = locate();
    if (W::has && hit == none) return true;
    if (!find_cavity(hit) || !has_room(2, static_cast<std::size_t>(facets_) + 1)) return false;
    fill();
    *made = static_cast<std::uint32_t>(facets_);
    return true;
}

template <int D, class W, class Words> void PlaneRun<D, W, Words>::finish() {
    const std::uint32_t count = close_gaps<D>(cells_, state_.cell_slots, arena_);
    // A cell at each vertex, in place of the points: the last one that has it.
    CellId* const cell_at = reinterpret_cast<CellId*>(arena_.at(arena_.high_mark()));
    arena_.each(state_.vertex_count, 1, [=](std::uint64_t k) { cell_at[k] = none; });
    arena_.each(count, 6, [=](std::uint64_t c) {
        for (const VertexId v : cells_[c].vertex) cell_at[v] = CellId(static_cast<std::uint32_t>(c));
    });
    arena_.each(state_.vertex_count, 20, [=](std::uint64_t k) {
        if (k + 16 < state_.vertex_count) __builtin_prefetch(&store_.vertex(order_[k + 16]), 1);
        store_.vertex(order_[k]).cell = cell_at[k];
    });
    arena_.release_high(cells_end_);
    arena_.release_low(state_.cells_offset);
    arena_.extend_low(count * sizeof(Cell<D>));
    state_.cell_slots = count;
    if constexpr (W::has) state_.cells_free = 0;
    state_.last_cell = CellId(0);
    // From the last one on, as a cell of the store ends behind all that are still to be read.
    Cell<D>* const cells = &store_.cell(0);
    arena_.each(count, 30, [=](std::uint64_t i) {
        const std::uint64_t c = count - 1 - i;
        const CellT from = cells_[c];
        Cell<D>& to = cells[c];
        for (int j = 0; j < 3; ++j) {
            to.vertex[j] = VertexId(order_[from.vertex[j]]);
            to.neighbour[j] = from.neighbour[j];
        }
        make_ghost<D>(to);
        to.mark = 0;
    });
    arena_.release_high(vertices_begin_);
}

template <int D, class W, class Words> PlaneTriangulation<Words> PlaneRun<D, W, Words>::close() {
    const std::uint32_t count = close_gaps<D>(cells_, state_.cell_slots, arena_);
    arena_.release_low(static_cast<std::size_t>(state_.cells_offset) + count * sizeof(CellT));
    return {cells_, count, question_.points, state_.vertex_count, order_};
}

}  // namespace netmesh
