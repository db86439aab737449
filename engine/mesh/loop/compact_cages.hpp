// The rule of NetMesh with compact cages (hierarchy_rule.hpp), and how cages are made, grow and are released. What it
// judges, and when, is in hierarchy_rule.cpp.
#pragma once
#include "mesh/cages/any_cage.hpp"
#include "mesh/cages/hierarchy.hpp"
#include "mesh/check/check_cages.hpp"
#include "mesh/loop/aspect_rule.hpp"
#include "mesh/loop/hierarchy_rule.hpp"
#include "numerics/random.hpp"

namespace netmesh {

// How far the ball of a cage grows, in radii: halfway from where it begins to the shell.
constexpr double grown_most = 3.0 / 4;
// A cage is released when its own cell has no larger ratio than this, or tau. Cells of shells have about 20 to 60 times
// that then. Smaller values place more vertices beside cages, and more cages are encroached: held to tau = 2.5, close
// pairs in space at gaps next to what a cage needs have up to 1.6 times the vertices.
constexpr double released_tau = 8;
// The cells in a growing cage that would be bad if they were not clipped.
struct Reaching {
    double least = infinity;  // of their in-radii
    bool some_put_off = false;
};
inline double growth_of(const Cage& cage) { return cage.clip - cage_epsilon * cage.radius; }
// It goes on when all vertices of in-radii up to what the ball has grown by are good, but for the factor of root 2 that
// the queue does not tell apart: their nearest neighbours are at most twice as far away.
inline double growth_distance2(const Cage& cage) { return 4 * growth_of(cage) * growth_of(cage); }

// Inputs waiting for one another, the next one on top. Two ring searches multiply the radius by more than the
// clearance, 8, and distances span 2^1002: at most 2 * 1002 / 3 = 668 for one input. No input waits twice, so there are
// no more places than inputs. They are in the block: stacks are small where memory is.
class Path {
public:
    // At the low end. out_of_memory.
    Status open(Arena& arena, std::uint32_t inputs) {
        capacity_ = inputs < most ? inputs : most;
        items_ = arena.take_low<VertexId>(capacity_);
        return items_ != nullptr ? Status::ok : Status::out_of_memory;
    }
    bool push(VertexId v) {
        if (count_ == capacity_) return false;
        items_[count_++] = v;
        return true;
    }
    bool has(VertexId v) const {
        for (std::uint32_t i = 0; i < count_; ++i)
            if (items_[i] == v) return true;
        return false;
    }
    bool empty() const { return count_ == 0; }
    VertexId top() const { return items_[count_ - 1]; }
    void pop() { --count_; }

private:
    static constexpr std::uint32_t most = 672;
    VertexId* items_ = nullptr;
    std::uint32_t capacity_ = 0, count_ = 0;
};

template <int D> class HierarchyRule : public AspectRule<D, HierarchyRule<D>> {
    using Base = AspectRule<D, HierarchyRule<D>>;
    using Base::domain_;
    using Base::inputs_;
    using Base::inserted_;
    using Base::is_bad;
    using Base::kernel_;
    using Base::last_;
    using Base::nearest_input;
    using Base::observers_;
    using Base::passed_;
    using Base::queue_;
    using Base::sizes_;
    using Base::store_;
    using Base::tau_;
    using Base::tree_;

public:
    static constexpr bool searches_rings = true, notes_nearest_inputs = false, makes_shells = true, heeds_sizes = true;

    HierarchyRule(Store<D>& store, const MeshRequest& request, const Work& work, MeshResult<D>& result)
        : Base(store, request, work, result) {
        this->wait_for_inputs();
    }

    Status reserve(std::size_t n);
    Status take_turn(VertexId p);
    Status insert_input(VertexId p, CellId from, bool cleaning);
    VertexId yields_to(const Split<D>& split, NearestInput* nearest) const;
    void update_distances(const Cavity& cavity, VertexId v);
    void queue_bad(CellId c);
    void queue_new(const Cavity& cavity, VertexId v);
    bool may_be_bad(double corner2, const Vertex<D>& vertex) const {
        return is_bad(corner2, vertex.nearest2) || corner2 > sizes_.bound2(vertex);
    }
    // A cage waits in the place of its first shell vertex, its growth in that of the second one.
    Verdict judge(VertexId v, Split<D>* split) {
        if (store_.vertex(v).marker != Marker::exempt) return judge_vertex(v, split);
        const std::uint32_t d = hierarchy_.of(v);
        return hierarchy_.cage(d).shell == v ? judge_cage(d, tau_, split) : grow_cage(d, split);
    }
    void requeue(VertexId v);
    bool is_judged(VertexId v) { return Base::is_judged(v) || is_cage(v); }
    double queued_distance2(VertexId v) {
        return is_cage(v) ? hierarchy_.cage(hierarchy_.of(v)).nearest2 : Base::queued_distance2(v);
    }
    Status finish_mesh();
    Hierarchy<D>* hierarchy() { return &hierarchy_; }
    std::size_t keep_results(std::size_t low);
#ifdef NETMESH_VALIDATE
    const char* step_violation() const { return cages_violation<D>(store_, hierarchy_, inputs_); }
    // Cells that a released cage has kept apart are found by the sweep at the end.
    const char* clean_violation() const {
        if (hierarchy_.live() != hierarchy_.made() || !this->is_held_to_tau()) return nullptr;
        return aspect_violation<D>(store_, this->request_.tau, [this](VertexId v) {
            const std::uint32_t d = innermost_cage<D>(store_, hierarchy_, store_.point(v), 0);
            return domain_ball(store_, hierarchy_.cages(), d, domain_);
        });
    }
#endif

private:
    Status climb_to_cage(VertexId p, const Cavity& cavity, bool cleaning);
    Status new_cage(VertexId p, VertexId farthest, double reach);
    void make_shell(VertexId centre, VertexId farthest, std::uint32_t cage, double radius);
    void begin_growth(std::uint32_t d);
    void queue_growth(const Cage& cage) { queue_.push_now(VertexId(cage.shell + 1), growth_distance2(cage)); }
    Verdict grow_cage(std::uint32_t d, Split<D>* split);
    void queue_reaching(std::uint32_t d, CellId c, Reaching* reaching);
    bool release_cage(std::uint32_t d);
    void give_up_shell(std::uint32_t d);

    void update_cages(VertexId w, const Vertex<D>& fresh, std::uint32_t within);
    void queue_bad_vertices(CellId c);
    void queue_all_far(CellId c);
    void queue_bad_cages(CellId c);
    // Does a cage wait in the place of v?
    bool is_cage(VertexId v) {
        if (store_.vertex(v).marker != Marker::exempt) return false;
        const std::uint32_t d = hierarchy_.of(v);
        return d != none && hierarchy_.cage(d).shell == v;
    }
    void queue_cage(std::uint32_t d) {
        const Cage& cage = hierarchy_.cage(d);
        queue_.push(VertexId(cage.shell), cage.nearest2);
    }
    Verdict judge_vertex(VertexId v, Split<D>* split);
    Verdict judge_cage(std::uint32_t d, double tau, Split<D>* split);
    Status sweep();
    void find_nearest_inputs();
    Domain<D> ball_of(std::uint32_t d) { return domain_ball(store_, hierarchy_.cages(), d, domain_); }

    Hierarchy<D> hierarchy_;
    Path path_;
    NearestInDomain near_;  // of the input whose turn it is
};

// Climbs from p, which is not medial, through inputs farther and farther from its nearest neighbour, which are to be
// inserted first, to the cage that contains them all, if there is room for one. Who waits for p already is passed: two
// inputs with different nearest neighbours can each be what the other would wait for.
template <int D> Status HierarchyRule<D>::climb_to_cage(VertexId p, const Cavity& cavity, bool cleaning) {
    near_ = hierarchy_.locate(p, this->nearest_in_conflict(p, cavity), &passed_);
    if (store_.vertex(near_.vertex).marker != Marker::input) return Status::ok;
    constexpr double clearance = cage_clearance / cage_epsilon * (1 + 2 * tau_margin);
    const double* const u = store_.point(near_.vertex);
    const double room = square_root(near_.nearest2);
    double reach = square_root(distance2<D>(store_.dim, store_.point(p), u));
    VertexId farthest = p;
    while (clearance * reach <= room) {
        double d2;
        const std::uint32_t q = tree_.farthest_in_ring(u, reach * (1 + 0x1p-40), clearance * reach, &d2);
        if (q == none) return new_cage(p, farthest, reach);
        reach = square_root(d2);
        farthest = VertexId(q);
        const bool waits = !cleaning && store_.vertex(q).cell == none && !path_.has(farthest);
        if (waits && !path_.push(farthest)) return Status::ok;
    }
    return Status::ok;
}

// The cage of the inputs within `reach` of the nearest neighbour of p, of which one is so far away. There are no
// vertices in it yet, but for those of a cage about the same centre that p is outside of.
template <int D> [[gnu::cold]] Status HierarchyRule<D>::new_cage(VertexId p, VertexId farthest, double reach) {
    if (!store_.has_room(0, shell_size_of(store_.dim), 0)) return Status::out_of_memory;
    const double radius = reach / cage_epsilon * (1 + tau_margin);
    const VertexId u = near_.vertex, shell(store_.state.vertex_count);
    const std::uint32_t d = hierarchy_.make(near_, radius, hierarchy_.of_input(p), shell);
    hierarchy_.set(p, d);
    make_shell(u, farthest, d, radius);
    for (VertexId v = shell; v < shell + shell_size_of(store_.dim); ++v) {
        const Status status = this->insert(v, store_.vertex(u).cell);
        if (status == Status::ok) continue;
        // A cage without its whole shell is given up; the shell vertices that are in the mesh stay there, exempt.
        hierarchy_.release(d);
        store_.truncate_vertices(status == Status::cancelled ? v + 1 : v);
        return status;
    }
    return Status::ok;
}

// The first axis of the cross-polytope points at an input farthest from the centre: it is reflected at the plane that
// brings it there.
template <int D>
[[gnu::cold]] void HierarchyRule<D>::make_shell(VertexId centre, VertexId farthest, std::uint32_t cage, double radius) {
    const double* const c = store_.point(centre);
    const double* const q = store_.point(farthest);
    double normal[DimensionOf<D>::most], norm2 = 0;
    const double away = square_root(distance2<D>(store_.dim, q, c));
    for (int k = 0; k < store_.dim; ++k) {
        normal[k] = (q[k] - c[k]) / away;
        if (k == 0) normal[k] += normal[k] < 0 ? -1 : 1;
        norm2 += normal[k] * normal[k];
    }
    std::uint64_t random = mix64(std::uint64_t{centre.index} << 32 | cage);
    for (std::uint32_t i = 0; i < shell_size_of(store_.dim); ++i) {
        double x[DimensionOf<D>::most], along = 0;
        for (int k = 0; k < store_.dim; ++k) {
            random = mix64(random);
            const double jitter = shell_jitter * (static_cast<double>(random >> 11) * 0x1p-52 - 1);
            const double axis = k != static_cast<int>(i / 2) ? 0 : i % 2 == 0 ? 1 : -1;
            x[k] = axis + jitter;
            along += x[k] * normal[k];
        }
        for (int k = 0; k < store_.dim; ++k)
            x[k] = c[k] + shell_factor * radius * (x[k] - 2 * along / norm2 * normal[k]);
        make_vertex<D>(store_, x, centre, Marker::exempt);
    }
}

// Something in the domain around has come nearer to cage d than its clearance: its ball begins to grow at once. Neither
// that nor the cells in the cage are put off.
template <int D> [[gnu::cold, gnu::noinline]] void HierarchyRule<D>::begin_growth(std::uint32_t d) {
    Cage& cage = hierarchy_.cage(d);
    cage.clip *= 1 + 0x1p-50;
    queue_growth(cage);
}

// Lets the ball of cage d grow, or releases the cage, when the ball is large enough, or when no cell would be bad
// without it. See the top of the header. When cells had been put off they have their turn first; when the cage's own
// cell is bad it is split first.
template <int D> [[gnu::cold, gnu::noinline]] Verdict HierarchyRule<D>::grow_cage(std::uint32_t d, Split<D>* split) {
    Cage& cage = hierarchy_.cage(d);
    Reaching found;
    std::uint32_t cells;
    if (!list_cage_cells(AnyStore(store_), cage, &cells)) return Verdict::out_of_memory;
    const CellId* const list = store_.list_top();
    for (std::uint32_t k = 0; k < cells; ++k) {
        store_.arena.pass(20 * store_.dim);
        queue_reaching(d, list[-1 - static_cast<std::ptrdiff_t>(k)], &found);
    }
    const double most = grown_most * cage.radius, grown = growth_of(cage);
    if (found.some_put_off) {
        queue_growth(cage);
        return Verdict::good;
    }
    if (!(found.least < infinity) || !(cage.clip < most)) {
        const double tight = this->tight_;
        const Verdict verdict = judge_cage(d, tight > released_tau ? tight : released_tau, split);
        if (verdict != Verdict::good) return verdict;
        if (!release_cage(d)) return Verdict::out_of_memory;
    } else {
        cage.clip += found.least > grown ? found.least : grown;
        if (cage.clip > most) cage.clip = most;
        queue_growth(cage);
    }
    observers_.note({none, d});
    return this->finish_step(none, true) == Status::ok ? Verdict::good : Verdict::out_of_memory;
}

// Queues the vertices in domain d, and the cages in it, that the corner of cell c would make bad if their cells were
// not clipped.
template <int D>
[[gnu::cold, gnu::noinline]] void HierarchyRule<D>::queue_reaching(std::uint32_t d, CellId c, Reaching* reaching) {
    const Cell<D>& cell = store_.cell(c);
    if (!(cell.radius2 < infinity)) return;
    for (int i = 0; i <= store_.dim; ++i) {
        VertexId place = cell.vertex[i];
        std::uint32_t within = hierarchy_.of(place);
        if (within == none) continue;
        double nearest2 = store_.vertex(place).nearest2, inner = 0.5 * square_root(nearest2);
        bool is_far = store_.vertex(place).marker != Marker::exempt && is_bad(cell.radius2, nearest2);
        if (within != d) {
            for (std::uint32_t around; (around = hierarchy_.parent(within)) != d && around != none;) within = around;
            const Cage& cage = hierarchy_.cage(within);
            place = VertexId(cage.shell);
            nearest2 = cage.nearest2;
            inner = in_radius(cage);
            const double bound = tau_ * inner;
            is_far = hierarchy_.parent(within) == d &&
                     distance2<D>(store_.dim, cell.centre, store_.point(cage.centre)) > bound * bound &&
                     is_on_boundary(store_, cage, c);
        }
        if (!is_far) continue;
        if (queue_.is_put_off(store_.vertex(place))) reaching->some_put_off = true;
        if (inner < reaching->least) reaching->least = inner;
        queue_.push_now(place, nearest2);
    }
}

// The cage is none any more: what is around it is looked at, and what was in it may encroach on other cages of the
// domain around. False: no room for that.
template <int D> [[gnu::cold, gnu::noinline]] bool HierarchyRule<D>::release_cage(std::uint32_t d) {
    const Cage& cage = hierarchy_.cage(d);
    std::uint32_t cells;
    if (!list_cage_cells(AnyStore(store_), cage, &cells)) return false;
    give_up_shell(d);
    const CellId* const list = store_.list_top();
    for (std::uint32_t k = 0; k < cells; ++k) {
        store_.arena.pass(20 * store_.dim);
        const Cell<D>& cell = store_.cell(list[-1 - static_cast<std::ptrdiff_t>(k)]);
        for (const VertexId v : cell.vertex) {
            const Vertex<D>& vertex = store_.vertex(v);
            if (vertex.marker != Marker::steiner || !is_inside(store_, cage, vertex.x)) continue;
            for (const VertexId w : cell.vertex) {
                if (is_inside(store_, cage, store_.point(w))) continue;
                update_cages(w, vertex, hierarchy_.of(v));
                if (store_.vertex(w).marker != Marker::exempt) queue_.push(w);
            }
        }
    }
    return true;
}

// The cage is none from now on, the vertices of its shell are as others and looked at.
template <int D> [[gnu::cold, gnu::noinline]] void HierarchyRule<D>::give_up_shell(std::uint32_t d) {
    const VertexId shell(hierarchy_.cage(d).shell);
    hierarchy_.release(d);
    for (VertexId v = shell; v < shell + shell_size_of(store_.dim); ++v) {
        store_.vertex(v).marker = Marker::steiner;
        queue_.push(v);
    }
}

// A new vertex has become a neighbour of w: it is outside of the cages that contain w but not the vertex. `within`: the
// domain of a Steiner point, whose cage is the one that a cage beside it has to do with.
template <int D> void HierarchyRule<D>::update_cages(VertexId w, const Vertex<D>& fresh, std::uint32_t within) {
    for (std::uint32_t d = hierarchy_.of(w); d != none && !hierarchy_.contains(d, fresh.x); d = hierarchy_.parent(d)) {
        Cage& cage = hierarchy_.cage(d);
        const double d2 = distance2<D>(store_.dim, fresh.x, store_.point(cage.centre)),
                     clear = cage_clearance * cage.radius;
        if (d2 < cage.nearest2) {
            cage.nearest2 = d2;
            queue_cage(d);
        }
        if (fresh.marker == Marker::exempt || !(d2 < clear * clear) || is_growing(cage)) continue;
        if (hierarchy_.contains(within, store_.point(cage.centre))) begin_growth(d);
    }
}

}  // namespace netmesh
