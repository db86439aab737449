#include "mesh/netmesh.hpp"

#include "mesh/bucket_queue.hpp"
#include "mesh/corner.hpp"
#include "mesh/hierarchy.hpp"
#include "mesh/nearest.hpp"
#include "mesh/opening.hpp"
#include "numerics/random.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// How the thesis's operations are carried out here, and why they differ where they do.
//
// InsertInput. The thesis makes a cage about the nearest neighbour u of an input p that is not medial, with a radius out of
// |u - p|, and lets it grow when more inputs turn out to encroach on it from inside. Here the radius looks ahead: ring searches
// among all inputs, inserted or not, climb from |u - p| outwards until the annulus that a cage needs is empty. That is
// the radius that the cage keeps: no input ever encroaches on it, from inside or outside, and none has to grow; and as its
// whole clearance must be free of vertices, it is not born encroached (meshing by the trigger mediality <= e alone would). The
// inputs met on the way are inserted before p, the farthest first, with or without a cage at the end: so each input is medial
// up to a constant when its turn comes, and a set without gaps keeps its quality at every step.
// The nearest neighbour in M_Omega: the nearest mesh vertex, or the centre of the largest cage that contains it but not p.
//
// ReleaseCage happens when a Steiner point comes nearer than a cage's clearance, which only gaps not much wider than a cage
// needs let happen. Cages are never made again about the same inputs, as their shells stay as vertices, so refinement ends
// where it would end without cages. The shell of a neighbouring cage and Steiner points inside it are as near as its centre, up to
// a quarter, and do not count as encroaching. Whoever lost a clipping sphere by a release is found by a look at all cells after the last
// insertion; those next to the shell at once.
//
// YieldingInsert of a shell vertex never yields: the thesis's gamma is .25, and no input is nearer to it than .4 of the way to the
// centre. An input that a Steiner point yields to is inserted without going back to others: it is medial as it stands.
//
// FinishMesh releases all cages and cleans. Steiner points are pulled back towards their vertices, so the layers that grow
// out of a shell are those that growing the cage step by step would give.

// Inputs waiting for one another. Two ring searches multiply the radius by more than the clearance, 8, and distances span
// 2^1002: at most 2 * 1002 / 3 = 668 for one input.
class Path {
public:
    bool push(std::uint32_t v) {
        if (count_ == capacity) return false;
        items_[count_++] = v;
        return true;
    }
    bool empty() const { return count_ == 0; }
    std::uint32_t top() const { return items_[count_ - 1]; }
    void pop() { --count_; }

private:
    static constexpr int capacity = 700;
    std::uint32_t items_[capacity];
    int count_ = 0;
};

template <int D> class NetMesh {
public:
    NetMesh(Store<D>& store, const HierarchyOptions& options, Monitor& monitor, Domain<D>& domain)
        : store_(store), kernel_(store, corner_error_max, true), monitor_(monitor), domain_(domain), options_(options),
          measures_(options.audit_quality), tau_(options.tau * (1 - tau_margin)) {}

    Status open(InputReport* input);
    Status run(const std::uint32_t* order);
    Status run_rounds(std::uint32_t* order);
    Status finish();
    void find_nearest_inputs();
    std::uint32_t keep_cages(HierarchyReport* report);
    // First thing at the low end.
    Status reserve(std::size_t n) { return hierarchy_.open(store_, store_.arena, static_cast<std::uint32_t>(n)); }
    Cage* cages() { return hierarchy_.cages(); }
    bool lists_are_full() const { return lists_full_; }

private:
    Status insert(std::uint32_t v, std::uint32_t from);
    Status fill(std::uint32_t v, const Cavity& cavity);
    Status insert_input(std::uint32_t p, std::uint32_t from, Path* path);
    Status insert_with_path(std::uint32_t p, Path* path);
    Status audit(std::uint32_t v, bool cleaning);
    Status approach(std::uint32_t p, const Cavity& cavity, Path* path);
    Status insert_steiner(const double* x, double empty2, std::uint32_t near, std::uint32_t cell);
    Status new_cage(std::uint32_t p, double reach);
    Status release_encroached();
    Status release_cage(std::uint32_t d);

    Status clean();
    Status clean_vertex(std::uint32_t v);
    Status clean_cage(std::uint32_t d);
    bool find_cage_corner(std::uint32_t d, Corner<D>* corner);
    Status sweep();

    void update_star(const Cavity& cavity, std::uint32_t v);
    void settle(std::uint32_t p, const Cavity& cavity);
    void meet(std::uint32_t w, const double* x, bool encroaches, std::uint32_t within);
    void queue_bad_vertices(std::uint32_t c);
    void queue_bad_cages(std::uint32_t c);
    void queue_bad_crossings(const Domain<D>& ball, std::uint32_t c, unsigned positions);
    void push_cage(std::uint32_t d) {
        const Cage& cage = hierarchy_.cage(d);
        queue_.push(cage.shell, cage.nearest2);
    }

    bool is_bad(double corner2, double nearest2) const { return 4 * corner2 > tau_ * tau_ * nearest2; }
    // Where the search for input p starts.
    std::uint32_t start_for(std::uint32_t p) const {
        return lists_.is_open() ? lists_.ball_of(p) : store_.state.last_cell;
    }
    Domain<D> ball_of(std::uint32_t d) { return domain_ball<D>(store_, hierarchy_.cages(), d, domain_); }

    Store<D>& store_;
    Kernel<D> kernel_;
    Monitor& monitor_;
    Domain<D>& domain_;
    const HierarchyOptions& options_;
    InputTree<D> tree_;
    BucketQueue<D> queue_;
    Hierarchy<D> hierarchy_;
    BallLists<D> lists_;
    LocationAudit location_ = {};
    QualityAudit quality_ = {};
    std::uint32_t audited_ = none;  // vertices made before the step at hand
    bool lists_full_ = false, measures_;
    double tau_;
    std::uint32_t inputs_ = 0, inserted_ = 0;
    // Of the input p whose turn it is: its nearest neighbour u in M_Omega, Omega the domain of p, the nearest distance of u in
    // M_Omega, and the cage in Omega that has u for its centre, if one does.
    std::uint32_t near_ = none, near_cage_ = none;
    double near_nearest2_ = 0;
    std::uint32_t encroached_ = none;  // list of cages through Cage::next
    std::uint64_t passed_ = 0;         // domains passed in finding the domain of an input
};

template <int D> Status NetMesh<D>::open(InputReport* input) {
    inputs_ = store_.state.vertex_count;
    Status status = tree_.build(store_, store_.arena, inputs_, true);
    if (status == Status::ok) status = check_separation<D>(store_, tree_, resolution, input);
    if (status != Status::ok) return status;
    smallest_enclosing_ball<D>(store_, inputs_, domain_);
    domain_.radius = domain_.enclosing_radius * options_.domain_factor * (1 + tau_margin);
    const double reach = frame_factor<D> * domain_.radius;
    if (queue_.open(store_, store_.arena, 16 * reach * reach) != Status::ok) return Status::out_of_memory;
    if (options_.audit_location && lists_.open(store_, store_.arena, inputs_) != Status::ok)
        return Status::out_of_memory;
    if (store_.open_cells() != Status::ok) return Status::out_of_memory;
    status = open_frame<D>(store_, kernel_, tree_, domain_, reach);
    audited_ = store_.state.vertex_count;
    if (status == Status::ok && lists_.is_open() && !lists_.start(kernel_)) status = Status::out_of_memory;
    return status;
}

// Inserts vertex v, whose record is complete, near cell `from`. Nothing has changed when memory runs out.
template <int D> Status NetMesh<D>::insert(std::uint32_t v, std::uint32_t from) {
    const double* const q = store_.point(v);
    Cavity cavity;
    const VertexId id(v);
    return kernel_.find_cavity(q, id, kernel_.locate(q, id, CellId(from)), &cavity) ? fill(v, cavity) : Status::out_of_memory;
}

template <int D> Status NetMesh<D>::fill(std::uint32_t v, const Cavity& cavity) {
    if (!kernel_.can_fill(cavity, 0)) return Status::out_of_memory;
    const bool is_input = store_.vertex(v).marker == Marker::input;
    if (lists_.is_open()) {
        if (is_input && !lists_.agrees(kernel_, cavity, v)) return Status::internal;
        lists_.detach(kernel_, cavity, v);
    }
    kernel_.fill(cavity, VertexId(v));
    if (is_input) ++inserted_;
    update_star(cavity, v);
    // The mesh is whole, only the lists are not: the job stops as if it had been asked to.
    if (lists_.is_open() && !lists_.attach(kernel_, cavity, v)) {
        lists_full_ = true;
        return Status::cancelled;
    }
    monitor_.mesh_size(store_.state.vertex_count - inputs_ + inserted_, store_.live_cells());
    return monitor_.advance(inserted_, 4 + 2 * cavity.facets) ? Status::cancelled : Status::ok;
}

// Nearest-neighbour distances around the new vertex v, of vertices and cages, and the queue.
template <int D> void NetMesh<D>::update_star(const Cavity& cavity, std::uint32_t v) {
    update_nearest<D>(store_, kernel_, cavity, v, queue_);
    const Vertex<D>& centre = store_.vertex(v);
    if (hierarchy_.live() > 0) {
        const std::uint32_t within = centre.marker == Marker::steiner ? hierarchy_.of(v) : none;
        kernel_.visit_neighbours(cavity, VertexId(v),
                                 [&](std::uint32_t w) { meet(w, centre.x, centre.marker != Marker::exempt, within); });
    }
    for (std::uint32_t k = 0; k < cavity.facets; ++k) {
        const std::uint32_t c = kernel_.new_cell(k);
        queue_bad_vertices(c);
        if (hierarchy_.live() > 0) queue_bad_cages(c);
    }
}

// Finds the domain of p and its nearest neighbour in it from the nearest vertex, which is one of the cells in conflict. Those
// are finite, as the frame's hull contains the domain.
template <int D> void NetMesh<D>::settle(std::uint32_t p, const Cavity& cavity) {
    const double* const x = store_.point(p);
    double best2 = infinity;
    for (std::uint32_t k = 0; k < cavity.cells; ++k)
        for (const std::uint32_t w : store_.cell(kernel_.cavity_cell(k)).vertex) {
            const double d2 = distance2<D>(x, store_.point(w));
            if (!(d2 < best2)) continue;
            best2 = d2;
            near_ = w;
        }
    near_nearest2_ = store_.vertex(near_).nearest2;
    near_cage_ = none;
    std::uint32_t d = hierarchy_.of(near_);
    for (; !hierarchy_.contains(d, x); d = hierarchy_.parent(d), ++passed_) near_cage_ = d;
    hierarchy_.set(p, d);
    if (near_cage_ == none) return;
    near_ = hierarchy_.cage(near_cage_).centre;
    near_nearest2_ = hierarchy_.cage(near_cage_).nearest2;
}

// A new vertex at x has become a neighbour of w: it is outside of the cages that contain w but not x. `within`: the domain
// of a Steiner point, whose cage is the one that a cage beside it has to do with.
template <int D> void NetMesh<D>::meet(std::uint32_t w, const double* x, bool encroaches, std::uint32_t within) {
    for (std::uint32_t d = hierarchy_.of(w); d != none && !hierarchy_.contains(d, x); d = hierarchy_.parent(d)) {
        Cage& cage = hierarchy_.cage(d);
        const double d2 = distance2<D>(x, store_.point(cage.centre)), clear = cage_clearance * cage.radius;
        if (d2 < cage.nearest2) {
            cage.nearest2 = d2;
            push_cage(d);
        }
        if (!encroaches || !(d2 < clear * clear) || cage.next != none) continue;
        if (!hierarchy_.contains(within, store_.point(cage.centre))) continue;
        cage.next = encroached_ == none ? d : encroached_;  // the last one points at itself
        encroached_ = d;
    }
}

// Queues the vertices that the new cell c makes bad, domain by domain. A crossing on an edge from an old outer cell need
// not be looked at: the edge has only become shorter.
template <int D> void NetMesh<D>::queue_bad_vertices(std::uint32_t c) {
    const Cell<D>& cell = store_.cell(c);
    if (!(cell.radius2 < infinity)) return;
    unsigned far = 0;  // positions of the vertices for which this corner is far
    for (int i = 0; i <= D; ++i) {
        const Vertex<D>& vertex = store_.vertex(cell.vertex[i]);
        if (!vertex.queued && vertex.marker != Marker::exempt && is_bad(cell.radius2, vertex.nearest2)) far |= 1u << i;
    }
    while (far != 0) {
        std::uint32_t d = none;
        unsigned equal = far;  // those in the domain of the first
        if (hierarchy_.live() > 0) {
            int first = 0;
            while ((far >> first & 1u) == 0) ++first;
            d = hierarchy_.of(cell.vertex[first]);
            for (int i = first + 1; i <= D; ++i)
                if ((far >> i & 1u) && hierarchy_.of(cell.vertex[i]) != d) equal &= ~(1u << i);
        }
        far &= ~equal;
        const Domain<D> ball = ball_of(d);
        if (!ball.contains(cell.centre)) {
            queue_bad_crossings(ball, c, equal);
            continue;
        }
        for (int i = 0; i <= D; ++i)
            if (equal >> i & 1u) queue_.push(cell.vertex[i]);
    }
}

template <int D> void NetMesh<D>::queue_bad_crossings(const Domain<D>& ball, std::uint32_t c, unsigned positions) {
    const Cell<D>& cell = store_.cell(c);
    for (int i = 0; i <= D; ++i) {
        const unsigned others = positions & ~(1u << i);
        if (others == 0) continue;
        const CellId n = cell.neighbour[i].cell();
        if (!(store_.cell(n).radius2 < infinity)) continue;
        double z[2][D];
        const int crossings = sphere_crossings<D>(ball, cell.centre, store_.cell(n).centre, z);
        for (int j = 0; j < crossings; ++j)
            for (int k = 0; k <= D; ++k) {
                const std::uint32_t w = cell.vertex[k];
                if ((others >> k & 1u) && is_bad(distance2<D>(z[j], store_.point(w)), store_.vertex(w).nearest2))
                    queue_.push(w);
            }
    }
}

// Queues the cages whose boundary cell c is on, where it makes them bad. Corners outside of the ball of the
// domain around are looked at when it is the cage's turn.
template <int D> void NetMesh<D>::queue_bad_cages(std::uint32_t c) {
    const Cell<D>& cell = store_.cell(c);
    if (!(cell.radius2 < infinity)) return;
    std::uint32_t domains[D + 1];
    bool equal = true;
    for (int i = 0; i <= D; ++i) {
        domains[i] = hierarchy_.of(cell.vertex[i]);
        equal &= domains[i] == domains[0];
    }
    if (equal) return;
    for (int i = 0; i <= D; ++i)
        for (std::uint32_t d = domains[i]; d != none && is_on_boundary<D>(store_, hierarchy_.cage(d), c);
             d = hierarchy_.parent(d)) {
            const Cage& cage = hierarchy_.cage(d);
            const double bound = tau_ * in_radius<D>(cage);
            if (distance2<D>(cell.centre, store_.point(cage.centre)) > bound * bound) push_cage(d);
        }
}

// Climbs from p, which is not medial, through inputs farther and farther from its nearest neighbour, which are to be inserted
// first, to the cage that contains them all, if there is room for one.
template <int D> Status NetMesh<D>::approach(std::uint32_t p, const Cavity& cavity, Path* path) {
    if (!options_.cages) return Status::ok;
    settle(p, cavity);
    if (store_.vertex(near_).marker != Marker::input) return Status::ok;
    constexpr double clearance = cage_clearance / cage_epsilon * (1 + 2 * tau_margin);
    const double* const u = store_.point(near_);
    const double room = square_root(near_nearest2_);
    double reach = square_root(distance2<D>(store_.point(p), u));
    while (clearance * reach <= room) {
        double d2;
        const std::uint32_t q = tree_.farthest_in_ring(u, reach * (1 + 0x1p-40), clearance * reach, &d2);
        if (q == none) return new_cage(p, reach);
        reach = square_root(d2);
        if (path != nullptr && store_.vertex(q).cell == none && !path->push(q)) return Status::ok;
    }
    return Status::ok;
}

// Inserts p near cell `from`, unless others have to come first: then they are on top of the path.
template <int D> Status NetMesh<D>::insert_input(std::uint32_t p, std::uint32_t from, Path* path) {
    const double* const q = store_.point(p);
    Cavity cavity;
    if (!kernel_.find_cavity(q, VertexId(p), kernel_.locate(q, VertexId(p), CellId(from)), &cavity)) return Status::out_of_memory;
    const std::uint32_t before = store_.state.vertex_count;
    Status status = approach(p, cavity, path);
    if (status != Status::ok || (path != nullptr && path->top() != p)) return status;
    status = before == store_.state.vertex_count ? fill(p, cavity) : insert(p, store_.vertex(near_).cell);
    if (status == Status::ok) status = release_encroached();
    return status == Status::ok ? audit(p, path == nullptr) : status;
}

// Inserts p and what has to come before it, and restores the quality of all cells each time.
template <int D> Status NetMesh<D>::insert_with_path(std::uint32_t p, Path* path) {
    for (path->push(p); !path->empty();) {
        const std::uint32_t top = path->top();
        if (store_.vertex(top).cell != none) {
            path->pop();
            continue;
        }
        Status status = insert_input(top, start_for(top), path);
        if (status == Status::ok && path->top() == top) status = clean();
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

// One intermediate mesh is whole: vertex v has been inserted, and the shell of a cage before, if one was made.
template <int D> Status NetMesh<D>::audit(std::uint32_t v, bool cleaning) {
    if (!measures_) return Status::ok;
    const Status status = audit_quality<D>(store_, hierarchy_.cages(), hierarchy_.made(), domain_, store_.arena,
                                           {audited_, v, cleaning}, &quality_);
    audited_ = store_.state.vertex_count;
    if (status != Status::ok) return status;
    return quality_.encroached > 0 || quality_.cage > cage_insertion_bound<D>() ? Status::internal : status;
}

// The cage of the inputs within `reach` of the nearest neighbour of p. There are no vertices in it yet, but for those of a
// cage about the same centre that p is outside of.
template <int D> Status NetMesh<D>::new_cage(std::uint32_t p, double reach) {
    if (!store_.has_room(0, shell_size<D>, 0)) return Status::out_of_memory;
    const double radius = reach / cage_epsilon * (1 + tau_margin);
    const std::uint32_t u = near_, shell = store_.state.vertex_count;
    const std::uint32_t d = hierarchy_.make(u, radius, near_nearest2_, hierarchy_.of_input(p), shell);
    if (near_cage_ != none)
        hierarchy_.cage(near_cage_).parent = d;
    else
        hierarchy_.set(u, d);
    hierarchy_.set(p, d);
    const double* const c = store_.point(u);
    std::uint64_t random = mix64(std::uint64_t{u} << 32 | d);
    for (std::uint32_t i = 0; i < shell_size<D>; ++i) {
        double x[D];
        for (int k = 0; k < D; ++k) {
            random = mix64(random);
            const double jitter = shell_jitter * (static_cast<double>(random >> 11) * 0x1p-52 - 1);
            const double axis = k != static_cast<int>(i / 2) ? 0 : i % 2 == 0 ? 1 : -1;
            x[k] = c[k] + shell_factor * radius * (axis + jitter);
        }
        make_vertex<D>(store_, x, u, Marker::exempt);
    }
    for (std::uint32_t v = shell; v < shell + shell_size<D>; ++v) {
        const Status status = insert(v, store_.vertex(u).cell);
        if (status == Status::ok) continue;
        // Half a shell is none: its vertices stay as a frame of sorts.
        hierarchy_.release(d);
        store_.truncate_vertices(status == Status::cancelled ? v + 1 : v);
        return status;
    }
    return Status::ok;
}

template <int D> Status NetMesh<D>::release_encroached() {
    while (encroached_ != none) {
        const std::uint32_t d = encroached_;
        Cage& cage = hierarchy_.cage(d);
        encroached_ = cage.next == d ? none : cage.next;
        cage.next = none;
        const Status status = release_cage(d);
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

template <int D> Status NetMesh<D>::release_cage(std::uint32_t d) {
    const std::uint32_t shell = hierarchy_.cage(d).shell;
    hierarchy_.release(d);
    for (std::uint32_t v = shell; v < shell + shell_size<D>; ++v) {
        store_.vertex(v).marker = Marker::steiner;
        queue_.push(v);
    }
    // Two stars cannot be walked at once, and what is pushed here is looked at again anyway: all neighbours are pushed. None
    // is infinity, as the frame is around them.
    for (std::uint32_t v = shell; v < shell + shell_size<D>; ++v) {
        const bool fits = kernel_.visit_star(VertexId(v), [&](CellId c) {
            for (const std::uint32_t w : store_.cell(c).vertex)
                if (store_.vertex(w).marker != Marker::exempt) queue_.push(w);
        });
        if (!fits) return Status::out_of_memory;
    }
    return Status::ok;
}

// Inserts a Steiner point at x, where a ball of this squared radius is empty, or yields to an input. `near`: an input, inserted,
// in the domain of x or in one inside it.
template <int D>
Status NetMesh<D>::insert_steiner(const double* x, double empty2, std::uint32_t near, std::uint32_t cell) {
    double input2;
    const bool may_yield = inserted_ < inputs_;
    const std::uint32_t input =
        may_yield ? tree_.nearest_within(x, yield_radius * yield_radius * empty2, &input2) : none;
    if (input != none && store_.vertex(input).cell == none) return insert_input(input, cell, nullptr);
    if (!store_.has_room(0, 1, 0)) return Status::out_of_memory;
    const std::uint32_t s = make_vertex<D>(store_, x, near, Marker::steiner);
    Status status = insert(s, cell);
    if (status == Status::out_of_memory) store_.truncate_vertices(s);
    if (status == Status::ok) status = release_encroached();
    return status == Status::ok ? audit(s, true) : status;
}

// Farthest corner of the clipped cell of v, and a Steiner point towards it when that makes the cell bad.
template <int D> Status NetMesh<D>::clean_vertex(std::uint32_t v) {
    const double* const p = store_.point(v);
    const double nearest2 = store_.vertex(v).nearest2, least2 = 0.25 * tau_ * tau_ * nearest2;
    const std::uint32_t d = hierarchy_.of(v);
    const Domain<D> ball = ball_of(d);
    Corner<D> corner;
    const bool fits = kernel_.visit_star(VertexId(v), [&](CellId c) {
        const Cell<D>& cell = store_.cell(c);
        if (!(cell.radius2 < infinity)) return;
        if (ball.contains(cell.centre))
            corner.offer(cell.centre, distance2<D>(cell.centre, p), c);
        else
            offer_crossings<D>(store_, ball, v, c, least2, &corner);
    });
    if (!fits) return Status::out_of_memory;
    if (!is_bad(corner.distance2, nearest2)) return Status::ok;
    const double wanted = pull_back<D> * 0.5 * tau_ * square_root(nearest2), whole = square_root(corner.distance2);
    const double fraction = wanted < whole ? wanted / whole : 1;
    double x[D];
    for (int k = 0; k < D; ++k) x[k] = p[k] + fraction * (corner.x[k] - p[k]);
    const std::uint32_t near = store_.vertex(v).marker == Marker::input ? v : store_.vertex(v).origin;
    const Status status = insert_steiner(x, distance2<D>(x, p), near, corner.cell);
    if (status == Status::ok) queue_.push(v);
    return status;
}

// Farthest corner of the cage's cell, clipped to the ball of the domain around it: cells on the boundary are connected, and
// one of them is at any shell vertex.
template <int D> bool NetMesh<D>::find_cage_corner(std::uint32_t d, Corner<D>* corner) {
    const Cage& cage = hierarchy_.cage(d);
    const double* const centre = store_.point(cage.centre);
    std::uint32_t first = none;
    if (!kernel_.visit_star(VertexId(cage.shell), [&](CellId c) {
            if (first == none && is_on_boundary<D>(store_, cage, c)) first = c;
        }))
        return false;
    if (first == none) return true;
    const Domain<D> ball = ball_of(hierarchy_.parent(d));
    const std::uint32_t stamp = store_.new_stamp();
    const std::size_t capacity = store_.list_capacity();
    CellId* const list = store_.list_top();
    std::uint32_t count = 1;
    list[-1] = CellId(first);
    store_.cell(first).mark = stamp;
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t c = list[-1 - static_cast<std::ptrdiff_t>(k)];
        const Cell<D>& cell = store_.cell(c);
        const bool known = cell.radius2 < infinity, contained = known && ball.contains(cell.centre);
        if (contained) corner->offer(cell.centre, distance2<D>(cell.centre, centre), c);
        for (int i = 0; i <= D; ++i) {
            const CellId n = cell.neighbour[i].cell();
            if (!is_on_boundary<D>(store_, cage, n)) continue;
            const Cell<D>& other = store_.cell(n);
            if (known && !contained && other.radius2 < infinity) {
                double z[2][D];
                const int crossings = sphere_crossings<D>(ball, cell.centre, other.centre, z);
                for (int j = 0; j < crossings; ++j) corner->offer(z[j], distance2<D>(z[j], centre), c);
            }
            if (other.mark == stamp) continue;
            if (count >= capacity) {
                store_.arena.refuse(4);
                return false;
            }
            store_.cell(n).mark = stamp;
            list[-1 - static_cast<std::ptrdiff_t>(count++)] = n;
        }
    }
    return true;
}

template <int D> Status NetMesh<D>::clean_cage(std::uint32_t d) {
    Corner<D> corner;
    if (!find_cage_corner(d, &corner)) return Status::out_of_memory;
    const Cage& cage = hierarchy_.cage(d);
    const double inner = in_radius<D>(cage), whole = square_root(corner.distance2 > 0 ? corner.distance2 : 0);
    if (!(whole > tau_ * inner)) return Status::ok;
    const double wanted = pull_back<D> * tau_ * inner;
    const double distance = wanted < whole ? wanted : whole, empty = distance - cage.radius;
    const double* const c = store_.point(cage.centre);
    double x[D];
    for (int k = 0; k < D; ++k) x[k] = c[k] + distance / whole * (corner.x[k] - c[k]);
    const Status status = insert_steiner(x, empty * empty, cage.centre, corner.cell);
    if (status == Status::ok && hierarchy_.is_live(d)) push_cage(d);
    return status;
}

// Restores the quality of all cells. A cage waits in the place of its first shell vertex.
template <int D> Status NetMesh<D>::clean() {
    for (;;) {
        const std::uint32_t v = queue_.pop();
        if (v == none) return Status::ok;
        const Status status =
            store_.vertex(v).marker == Marker::exempt ? clean_cage(hierarchy_.of(v)) : clean_vertex(v);
        if (status != Status::ok) return status;
    }
}

template <int D> Status NetMesh<D>::run(const std::uint32_t* order) {
    Path path;
    for (std::uint32_t k = 0; k < inputs_; ++k) {
        if (store_.vertex(order[k]).cell != none) continue;
        const Status status = insert_with_path(order[k], &path);
        if (status != Status::ok) return status;
    }
    return sweep();
}

// SelectRound (4.7.5), where a net is a sample whose effect is verified. order: scratch.
template <int D> Status NetMesh<D>::run_rounds(std::uint32_t* order) {
    Path path;
    for (std::uint32_t load = lists_.load(); load > 0; load = lists_.load()) {
        location_.load[location_.rounds++] = load;
        std::uint32_t nets = 0;
        do {
            const std::uint32_t count = lists_.draw_nets(load / 2, options_.seed + location_.nets++, order);
            if (++nets > location_.nets_max) location_.nets_max = nets;
            for (std::uint32_t k = 0; k < count; ++k) {
                const Status status =
                    store_.vertex(order[k]).cell != none ? Status::ok : insert_with_path(order[k], &path);
                if (status != Status::ok) return status;
            }
        } while (lists_.load() > load / 2);
    }
    return sweep();
}

// Looks at all cells until there is nothing to do.
template <int D> Status NetMesh<D>::sweep() {
    std::uint32_t before;
    do {
        before = store_.state.vertex_count;
        for (std::uint32_t c = 0; c < store_.state.cell_slots; ++c)
            if (store_.is_live(c)) queue_bad_vertices(c);
        for (std::uint32_t d = 0; d < hierarchy_.made(); ++d)
            if (hierarchy_.is_live(d)) push_cage(d);
        const Status status = clean();
        if (status != Status::ok) return status;
    } while (store_.state.vertex_count > before);
    return Status::ok;
}

template <int D> Status NetMesh<D>::finish() {
    measures_ = false;
    for (std::uint32_t d = 0; d < hierarchy_.made(); ++d) {
        if (!hierarchy_.is_live(d)) continue;
        const Status status = release_cage(d);
        if (status != Status::ok) return status;
    }
    return sweep();
}

// What filters ask of a mesh without cages: the nearest input of each vertex.
template <int D> void NetMesh<D>::find_nearest_inputs() {
    for (std::uint32_t v = inputs_; v < store_.state.vertex_count; ++v) {
        double d2;
        store_.vertex(v).origin = tree_.nearest(store_.point(v), store_.vertex(v).origin, none, &d2);
    }
}

// Moves the cages that are left to the front; parents are named by their new places.
template <int D> std::uint32_t NetMesh<D>::keep_cages(HierarchyReport* report) {
    Cage* const cages = hierarchy_.cages();
    std::uint32_t kept = 0;
    for (std::uint32_t d = 0; d < hierarchy_.made(); ++d) {
        if (!hierarchy_.is_live(d)) continue;
        hierarchy_.parent(d);
        cages[d].next = kept++;
    }
    for (std::uint32_t d = 0; d < hierarchy_.made(); ++d)
        if (hierarchy_.is_live(d) && cages[d].parent != none) cages[d].parent = cages[cages[d].parent].next;
    if (lists_.is_open()) lists_.report(&location_);
    *report = {kept,      hierarchy_.made(), hierarchy_.made() - kept, tree_.touches() + kernel_.steps() + passed_,
               location_, quality_};
    std::uint32_t out = 0;
    for (std::uint32_t d = 0; out < kept; ++d) {
        if (!hierarchy_.is_live(d)) continue;
        cages[out] = cages[d];
        cages[out++].next = none;
    }
    return kept;
}

}  // namespace

template <int D>
Status netmesh(Store<D>& store, const double* points, std::size_t n, const HierarchyOptions& options, Monitor& monitor,
               InputReport* input, Domain<D>* domain, Cage** cages, HierarchyReport* report) {
    *report = {};
    *cages = nullptr;
    if (n > (std::size_t{1} << 28)) return Status::invalid_argument;
    NetMesh<D> mesher(store, options, monitor, *domain);
    Status status = mesher.reserve(n);
    if (status != Status::ok) return status;
    std::uint32_t* order;
    status = take_input<D>(store, points, n, options.seed, monitor, input, &order);
    if (status != Status::ok) return status;
    status = mesher.open(input);
    if (status == Status::ok) {
        monitor.begin(NETMESH_STAGE_REFINE, input->rows - input->duplicates);
        status = options.audit_location ? mesher.run_rounds(order) : mesher.run(order);
    }
    if (status == Status::ok && options.finish) status = mesher.finish();
    if (status == Status::cancelled && mesher.lists_are_full()) status = Status::out_of_memory;
    const std::uint32_t kept = mesher.keep_cages(report);
    if (kept == 0 && store.state.cell_slots > 0) mesher.find_nearest_inputs();
    *cages = mesher.cages();
    const std::size_t low = store.arena.offset_of(*cages + kept);
    store.compact((low + Arena::alignment - 1) & ~(Arena::alignment - 1));
    settle_spheres<D>(store);
    domain->radius = domain->enclosing_radius * options.domain_factor;
    return status;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status netmesh<D>(Store<D>&, const double*, std::size_t, const HierarchyOptions&, Monitor&, InputReport*, \
                               Domain<D>*, Cage**, HierarchyReport*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
