#include "mesh/loop/hierarchy_rule.hpp"

#include "mesh/cages/cage_corner.hpp"
#include "mesh/loop/compact_cages.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

template <int D> Status HierarchyRule<D>::reserve(std::size_t n) {
    if (n > (std::size_t{1} << 28)) return Status::invalid_argument;
    const std::uint32_t inputs = static_cast<std::uint32_t>(n);
    // Cages come first, as they stay in front of the mesh.
    const Status status = hierarchy_.open(store_, store_.arena, inputs);
    return status == Status::ok ? path_.open(store_.arena, inputs) : status;
}

// Inserts p and what has to come before it, and restores the quality of all cells each time.
template <int D> Status HierarchyRule<D>::take_turn(VertexId p) {
    for (path_.push(p); !path_.empty();) {
        const VertexId top = path_.top();
        if (store_.vertex(top).cell != none) {
            path_.pop();
            continue;
        }
        Status status = insert_input(top, observers_.start_for(store_.state, top), false);
        if (status == Status::ok && path_.top() == top) status = this->clean();
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

// Inserts p near cell `from`, unless others have to come first: then they are on top of the path.
template <int D> Status HierarchyRule<D>::insert_input(VertexId p, CellId from, bool cleaning) {
    Cavity cavity;
    if (!this->find_cavity(p, from, &cavity)) return Status::out_of_memory;
    const std::uint32_t before = store_.state.vertex_count;
    Status status = climb_to_cage(p, cavity, cleaning);
    if (status != Status::ok || (!cleaning && path_.top() != p)) return status;
    const bool has_shell = before != store_.state.vertex_count;  // then the cavity is no more what it was
    status = has_shell ? this->insert(p, store_.vertex(near_.vertex).cell) : this->fill(p, cavity);
    return status == Status::ok ? this->finish_step(p, cleaning) : status;
}

// A Steiner point's nearest input is looked for where sizes are asked for, which depend on it; otherwise the one that
// the split comes from serves as well.
template <int D> VertexId HierarchyRule<D>::yields_to(const Split<D>& split, NearestInput* nearest) const {
    double input2;
    nearest->input = split.input;
    if (sizes_.have_started()) nearest->input = VertexId(tree_.nearest(split.x, split.input, none, &input2));
    if (inserted_ == inputs_) return none;
    const std::uint32_t input = tree_.nearest_within(split.x, yield_radius * yield_radius * split.empty2, &input2);
    return input != none && store_.vertex(input).cell == none ? VertexId(input) : VertexId(none);
}

// Nearest distances of vertices and of cages.
template <int D> void HierarchyRule<D>::update_distances(const Cavity& cavity, VertexId v) {
    this->update_nearest(cavity, v);
    if (hierarchy_.live() == 0) return;
    const Vertex<D>& fresh = store_.vertex(v);
    const std::uint32_t within = fresh.marker == Marker::steiner ? hierarchy_.of(v) : none;
    kernel_.visit_neighbours(cavity, v, [&](VertexId w) { update_cages(w, fresh, within); });
}

template <int D> void HierarchyRule<D>::queue_bad(CellId c) {
    queue_bad_vertices(c);
    if (hierarchy_.live() > 0) queue_bad_cages(c);
}

// A shell vertex waits only with its cage.
template <int D> void HierarchyRule<D>::queue_new(const Cavity& cavity, VertexId v) {
    if (store_.vertex(v).marker != Marker::exempt) Base::queue_new(cavity, ball_of(hierarchy_.of(v)), v);
}

// Domain by domain.
template <int D> void HierarchyRule<D>::queue_bad_vertices(CellId c) {
    const Cell<D>& cell = store_.cell(c);
    if (!(cell.radius2 < infinity)) return;
    unsigned far = this->positions_of_bad(cell);
    while (far != 0) {
        std::uint32_t d = none;
        unsigned equal = far;  // those in the domain of the first
        if (hierarchy_.live() > 0) {
            int first = 0;
            while ((far >> first & 1u) == 0) ++first;
            d = hierarchy_.of(cell.vertex[first]);
            for (int i = first + 1; i <= store_.dim; ++i)
                if ((far >> i & 1u) && hierarchy_.of(cell.vertex[i]) != d) equal &= ~(1u << i);
        }
        far &= ~equal;
        const Domain<D> ball = ball_of(d);
        if (ball.contains(cell.centre))
            this->queue_positions(cell, equal);
        else
            this->queue_bad_crossings(ball, cell, equal);
    }
}

// Queues all vertices whose cells this corner, or a point of the sphere on a face that it belongs to, could make bad.
template <int D> [[gnu::cold]] void HierarchyRule<D>::queue_all_far(CellId c) {
    const Cell<D>& cell = store_.cell(c);
    if (!store_.is_ghost(c)) this->queue_positions(cell, this->positions_of_bad(cell));
}

// Queues the cages whose boundary cell c is on, where it makes them bad. Corners outside of the ball of the
// domain around are looked at when it is the cage's turn.
template <int D> void HierarchyRule<D>::queue_bad_cages(CellId c) {
    const Cell<D>& cell = store_.cell(c);
    if (!(cell.radius2 < infinity)) return;
    std::uint32_t domains[DimensionOf<D>::most + 1];
    bool equal = true;
    for (int i = 0; i <= store_.dim; ++i) {
        domains[i] = hierarchy_.of(cell.vertex[i]);
        equal &= domains[i] == domains[0];
    }
    if (equal) return;
    for (int i = 0; i <= store_.dim; ++i)
        for (std::uint32_t d = domains[i]; d != none && is_on_boundary(store_, hierarchy_.cage(d), c);
             d = hierarchy_.parent(d)) {
            const Cage& cage = hierarchy_.cage(d);
            const double bound = tau_ * in_radius(cage);
            if (distance2<D>(store_.dim, cell.centre, store_.point(cage.centre)) > bound * bound) queue_cage(d);
        }
}

template <int D> void HierarchyRule<D>::requeue(VertexId v) {
    if (store_.vertex(v).marker != Marker::exempt) return queue_.push(v);
    const std::uint32_t d = hierarchy_.of(v);
    hierarchy_.cage(d).shell == v ? queue_cage(d) : queue_growth(hierarchy_.cage(d));
}

// By the farthest corner of v's cell clipped to the ball of its domain.
template <int D> Verdict HierarchyRule<D>::judge_vertex(VertexId v, Split<D>* split) {
    const double* const p = store_.point(v);
    const double nearest2 = store_.vertex(v).nearest2, least2 = this->least_beyond2(store_.vertex(v));
    const Domain<D> ball = ball_of(hierarchy_.of(v));
    Corner<D> corner(store_.dim);
    std::uint32_t cells = 0;
    bool leaves_ball = false;
    const bool fits = kernel_.visit_star(v, [&](CellId c) {
        const Cell<D>& cell = store_.cell(c);
        ++cells;
        if (is_within(cell, least2)) return;
        if (!(cell.radius2 < infinity)) {
            leaves_ball = true;
        } else if (ball.contains(cell.centre)) {
            corner.offer(cell.centre, distance2<D>(store_.dim, cell.centre, p), c);
        } else {
            offer_crossings<D>(store_, ball, v, c, least2, &corner);
            leaves_ball |= cell.radius2 > least2;
        }
    });
    if (!fits) return Verdict::out_of_memory;
    store_.arena.pass(cells / 4);
    if (!is_bad(corner.distance2, nearest2) && !sizes_.are_exceeded(v, corner.distance2)) {
        corner.distance2 = -1;
        if (leaves_ball) this->find_sized_beyond(ball, v, cells, &corner);
        if (corner.distance2 < 0 && this->may_be_blurred(store_.vertex(v)) && !this->find_blurred(ball, v, &corner))
            return Verdict::out_of_memory;
        if (corner.distance2 < 0) return Verdict::good;
    }
    this->split_towards(v, corner, this->wanted_distance(square_root(nearest2), this->pull_back()), split);
    return Verdict::bad;
}

// By the farthest corner of the cage's cell, clipped to the ball of the domain around it.
template <int D> Verdict HierarchyRule<D>::judge_cage(std::uint32_t d, double tau, Split<D>* split) {
    const Cage& cage = hierarchy_.cage(d);
    const AnyStore store(store_);
    const AnyDomain ball(ball_of(hierarchy_.parent(d)));
    AnyCorner corner(store_.dim);
    bool leaves_ball;
    CageBoundary boundary;
    if (!find_cage_corner(store, cage, ball, &corner, &leaves_ball, &boundary)) return Verdict::out_of_memory;
    const double inner = in_radius(cage), most = tau * inner;
    if (!(corner.distance2 > most * most)) {
        corner.distance2 = -1;
        if (leaves_ball) find_cage_pole(store, cage, ball, boundary, most * most, &corner);
        if (corner.distance2 < 0) return Verdict::good;
    }
    const double whole = square_root(corner.distance2);
    const double wanted = this->pull_back() * tau * inner;
    this->split_towards(VertexId(cage.centre), corner.template of_dimension<D>(), wanted, split);
    const double empty = (wanted < whole ? wanted : whole) - cage.radius;
    split->empty2 = empty * empty;
    return Verdict::bad;
}

// Looks at all cells until there is nothing to do.
template <int D> [[gnu::cold]] Status HierarchyRule<D>::sweep() {
    std::uint32_t before;
    do {
        before = store_.state.vertex_count;
        for (CellId c(0); c < store_.state.cell_slots;)
            for (const std::uint64_t piece = store_.arena.piece(c, store_.state.cell_slots, 60 * store_.dim); c < piece;
                 ++c) {
                if (store_.is_live(c)) queue_all_far(c);
            }
        for (std::uint32_t d = 0; d < hierarchy_.made();)
            for (const std::uint64_t piece = store_.arena.piece(d, hierarchy_.made(), 20); d < piece; ++d) {
                if (hierarchy_.is_live(d)) queue_cage(d);
            }
        const Status status = this->clean();
        if (status != Status::ok) return status;
    } while (store_.state.vertex_count > before);
    return Status::ok;
}

template <int D> Status HierarchyRule<D>::finish_mesh() {
    this->stop_waiting();
    const Status cleaned = this->clean_by_scales(), swept = cleaned == Status::ok ? sweep() : cleaned;
    if (swept != Status::ok || !this->request_.finish) return swept;
    observers_.stop_measuring();
    for (std::uint32_t d = 0; d < hierarchy_.made();)
        for (const std::uint64_t piece = store_.arena.piece(d, hierarchy_.made(), 20); d < piece; ++d) {
            if (hierarchy_.is_live(d)) give_up_shell(d);
        }
    const Status finished = sweep();
    if (finished == Status::ok && sizes_.are_asked()) find_nearest_inputs();
    return finished;
}

// What filters and sizes ask of a mesh without cages: the nearest input of each vertex.
template <int D> [[gnu::cold]] void HierarchyRule<D>::find_nearest_inputs() {
    const std::uint64_t before = tree_.touches();
    for (std::uint32_t v = inputs_; v < store_.state.vertex_count;)
        for (const std::uint64_t piece = store_.arena.piece(v, store_.state.vertex_count, 500 * store_.dim); v < piece;
             ++v) {
            double d2;
            store_.vertex(v).origin = tree_.nearest(store_.point(v), store_.vertex(v).origin, none, &d2);
        }
    last_ = tree_.touches() - before;
}

// A run that is cut off while cages grow leaves them as released ones.
template <int D> std::size_t HierarchyRule<D>::keep_results(std::size_t) {
    for (std::uint32_t d = 0; d < hierarchy_.made();)
        for (const std::uint64_t piece = store_.arena.piece(d, hierarchy_.made(), 5); d < piece; ++d) {
            if (hierarchy_.is_live(d) && is_growing(hierarchy_.cage(d))) give_up_shell(d);
        }
    const std::uint32_t made = hierarchy_.made(), kept = hierarchy_.keep_live(store_.arena);
    this->result_.cages = hierarchy_.cages();
    this->result_.hierarchy = {kept, made, made - kept};
    if (kept == 0 && store_.state.cell_slots > 0 && !sizes_.have_started()) find_nearest_inputs();
    return store_.arena.offset_of(hierarchy_.cages() + kept);
}

template <int D>
Status mesh_by_hierarchy(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                         const Work& work, AnyMeshResult* result) {
    return mesh_by<D, HierarchyRule>(store, points, n, request, work, result);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status mesh_by_hierarchy<D>(AnyStore&, const InputRows&, std::size_t, const MeshRequest&, const Work&,    \
                                         AnyMeshResult*);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
