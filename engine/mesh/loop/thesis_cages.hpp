// NetMesh with the cages of thesis 4.5 and the operations of 4.7.3; D = 2, 3 and 4.
//
// Afterwards the mesh is hierarchical and of quality tau as definition 4.5 says, without clipping: the whole cell of
// each vertex that is of no shell and of each cage but the outermost has aspect ratio at most tau, and no cage is
// encroached, whatever kind of vertex is in its annuli. The ratio of a cage is taken over half of the distance from its
// centre to the nearest vertex outside, which is at most its in-radius. engine/decisions/cages-of-the-thesis.md has the
// constants.
//
// InsertInput. NewCage about the nearest neighbour u in M_Omega, an input, when no vertex is within its clearance: that
// is the trigger mediality <= e^2 / (2 slack), with the thesis's e a cage would be born encroached. An input that a
// Steiner point yields to is medial by its distance from other vertices and only makes cages grow. NewCage inserts the
// template, each point of which yields to an input within gamma. GrowCage makes a cage larger in its place, or where
// there is no room releases it. What an insertion encroaches on from outside is released after it.
//
// FinishMesh grows cages one after another, each followed by Clean, until only the outermost is left.
//
// Corners of cells in a cage could lie outside of it: inserted there they encroach on it and release it. Of the
// outermost cage they can not be inserted. They come from a corner between its shell and its sphere: a Steiner vertex
// near the shell, below the middle of a facet of the shell's hull, has a cell that reaches out through that facet;
// split there, the new vertex stands outside of the shell, where nothing but the frame bounds its cell. That takes a
// Steiner vertex not much farther from the shell than the shell's vertices are from one another, which 3.5.1 excludes
// for shells of covering 1 / K'_S alone; the outermost shell covers 15 degrees in space. Seen in space at tau 3.4 to 4,
// in 8 of 100 runs at 3.4. Such a cell is left as it is, and a mesh that ends with one is made again with a larger
// outermost cage, where Steiner vertices come to stand elsewhere. When that does not help either the run ends with
// check_failed.
#pragma once
#include "mesh/cages/any_cage.hpp"
#include "mesh/cages/cage_template.hpp"
#include "mesh/cages/hierarchy.hpp"
#include "mesh/loop/aspect_rule.hpp"
#include "numerics/random.hpp"

namespace netmesh {

template <int D, class Rule> class ThesisCages : public AspectRule<D, Rule> {
    using Base = AspectRule<D, Rule>;

protected:
    using Base::domain_;
    using Base::inputs_;
    using Base::inserted_;
    using Base::is_bad;
    using Base::kernel_;
    using Base::observers_;
    using Base::passed_;
    using Base::queue_;
    using Base::store_;
    using Base::tree_;

public:
    static constexpr bool notes_nearest_inputs = false, makes_shells = true;

    ThesisCages(Store<D>& store, const MeshRequest& request, const Work& work, MeshResult<D>& result)
        : Base(store, request, work, result) {}

    Status reserve(std::size_t n);
    double choose_domain();
    Status begin();
    Status insert_input(VertexId p, CellId from, bool cleaning);
    VertexId yields_to(const Split<D>& split, NearestInput* nearest) const;
    void update_distances(const Cavity& cavity, VertexId v);
    void queue_bad(CellId c);
    void queue_new(const Cavity&, VertexId) {}
    bool may_be_bad(double corner2, const Vertex<D>& vertex) const { return is_bad(corner2, vertex.nearest2); }
    // A cage waits in the place of a vertex of its shell.
    Verdict judge(VertexId v, Split<D>* split);
    void requeue(VertexId v);
    Status after_step();
    // check_failed: a cell is left whose ratio is above tau.
    Status finish_mesh();
    Hierarchy<D>* hierarchy() { return &hierarchy_; }
    std::size_t keep_results(std::size_t low);
#ifdef NETMESH_VALIDATE
    const char* clean_violation() const { return nullptr; }
#endif

protected:
    Status new_cage(const NearestInDomain& near, double radius, std::uint32_t parent, std::uint32_t* made);
    Status grow_cage(std::uint32_t d);
    Status release_cage(std::uint32_t d);
    Status grow_encroached(VertexId p, bool is_member);
    Status insert_shell(std::uint32_t d);
    Status demote(const Cage& cage);
    void place(const Cage& cage, const double* unit, std::uint32_t k, double* x) const;
    // Calls visit(vertex) for each vertex of the shell.
    template <class Visit> void visit_shell(const Cage& cage, Visit&& visit) const;
    // Is v of a shell: a vertex of its own, or an input that such a vertex has yielded to?
    bool is_of_shell(VertexId v);
    // Annuli are kept free with a margin of 2^-20, and radii of cages and ratios of cells end that much before their
    // bounds. A squared distance as computed is within (D + 2) 2^-52 of the true one, as the difference of two
    // coordinates is within 2^-53 and all terms are positive; a product of three such numbers and constants is off by
    // less than 2^-48. The corner of a cell is within corner_error_max times its distance R from the cell's vertices
    // (delaunay/sphere.hpp), and R is at most its distance from any other vertex, the centre of a cage among them: so
    // seen from there, too, it is known as well as tau_margin needs it.
    static constexpr double inner = ThesisCage::epsilon * (1 - tau_margin);
    static double clear2(double radius) {
        const double clear = ThesisCage::clearance * radius * (1 + tau_margin);
        return clear * clear;
    }
    bool is_beyond(std::uint32_t d, double factor, const double* x) {
        const double far = factor * hierarchy_.cage(d).radius;
        return distance2<D>(store_.dim, x, store_.point(hierarchy_.cage(d).centre)) > far * far;
    }
    void update_cages(VertexId w, const Vertex<D>& fresh);
    void queue_cage(std::uint32_t d) {
        const Cage& cage = hierarchy_.cage(d);
        queue_.push(VertexId(cage.shell), cage.nearest2);
    }
    // Squared distance of the corner from a vertex x of the cell. Where coordinates do not resolve the corner the
    // radius is still known (delaunay/sphere.hpp).
    double corner_distance2(const Cell<D>& cell, const double* x) const {
        return cell.error > blurred_error ? cell.radius2 : distance2<D>(store_.dim, cell.centre, x);
    }
    // From the centre x of a cage, at most: by as much more as the corner may be off.
    double cage_corner_distance2(const Cell<D>& cell, const double* x) const {
        const double d2 = distance2<D>(store_.dim, cell.centre, x);
        if (!(cell.error > blurred_error)) return d2;
        const double most = square_root(d2) + static_cast<double>(cell.error) * square_root(cell.radius2);
        return most * most;
    }
    Verdict judge_vertex(VertexId v, Split<D>* split);
    Verdict judge_cage(std::uint32_t d, Split<D>* split);
    // Of a cell that is bad: it is left as it is where it cannot be split.
    Verdict judge_split(const Split<D>& split) {
        if (hierarchy_.contains(root, split.x)) return Verdict::bad;
        has_left_ = true;
        return Verdict::good;
    }
    Status finish_cages();
    Status find_left();

    static constexpr std::uint32_t root = 0;
    Hierarchy<D> hierarchy_;
    NearestInDomain near_;             // of the input whose turn it is
    std::uint32_t making_ = none;      // the cage whose shell is being inserted
    std::uint32_t encroached_ = none;  // list of cages through Cage::next
    bool has_yielded_ = false;         // a shell vertex has, in the step at hand
    bool has_left_ = false;            // a cell that was bad has been left as it was
};

template <int D, class Rule> Status ThesisCages<D, Rule>::reserve(std::size_t n) {
    if (n > (std::size_t{1} << 28)) return Status::invalid_argument;
    return hierarchy_.open(store_, store_.arena, static_cast<std::uint32_t>(n));
}

// The root's ball has at most 2 / epsilon enclosing radii, and nothing may be in its clearance.
template <int D, class Rule> double ThesisCages<D, Rule>::choose_domain() {
    Base::choose_domain();
    return (2 * ThesisCage::clearance / ThesisCage::epsilon + 2) * this->request_.outermost_scale *
           domain_.enclosing_radius;
}

// OuterCage: about an input, so that M begins with a centre.
template <int D, class Rule> Status ThesisCages<D, Rule>::begin() {
    double d2;
    const VertexId centre(tree_.nearest(domain_.centre, 0, none, &d2));
    Status status = this->insert(centre, store_.state.last_cell);
    if (status != Status::ok) return status;
    double far2 = inputs_ > 1 ? 0 : domain_.enclosing_radius * domain_.enclosing_radius;
    for (std::uint32_t p = 0; p < inputs_;)
        for (const std::uint64_t piece = store_.arena.piece(p, inputs_, 8 * store_.dim); p < piece; ++p) {
            const double p2 = distance2<D>(store_.dim, store_.point(p), store_.point(centre));
            if (p2 > far2) far2 = p2;
        }
    std::uint32_t made;
    const double radius = square_root(far2) / inner * (1 + tau_margin) * this->request_.outermost_scale;
    status = new_cage({centre, infinity, none}, radius, none, &made);
    return status == Status::ok ? this->finish_step(centre, false) : status;
}

template <int D, class Rule> Status ThesisCages<D, Rule>::insert_input(VertexId p, CellId from, bool cleaning) {
    if (store_.vertex(p).cell != none) return Status::ok;
    Cavity cavity;
    if (!this->find_cavity(p, from, &cavity)) return Status::out_of_memory;
    const std::uint32_t before = store_.state.vertex_count;
    near_ = hierarchy_.locate(p, this->nearest_in_conflict(p, cavity), &passed_);
    Status status = Status::ok;
    if (!cleaning && store_.vertex(near_.vertex).marker == Marker::input) {
        const double radius = square_root(distance2<D>(store_.dim, store_.point(p), store_.point(near_.vertex))) /
                              ThesisCage::epsilon * ThesisCage::slack;
        std::uint32_t made;
        if (near_.nearest2 >= clear2(radius)) {
            status = new_cage(near_, radius, hierarchy_.of_input(p), &made);
            if (status == Status::ok) hierarchy_.set(p, made);
        }
    }
    if (status == Status::ok) status = grow_encroached(p, false);
    if (status != Status::ok) return status;
    const bool has_shell = before != store_.state.vertex_count || has_yielded_;
    status = has_shell ? this->insert(p, store_.vertex(near_.vertex).cell) : this->fill(p, cavity);
    return status == Status::ok ? this->finish_step(p, cleaning) : status;
}

// GrowCage for all that p encroaches on from inside. An input of a shell does not encroach on that cage.
template <int D, class Rule> Status ThesisCages<D, Rule>::grow_encroached(VertexId p, bool is_member) {
    const double* const x = store_.point(p);
    std::uint32_t d = hierarchy_.of_input(p);
    if (is_member) d = hierarchy_.parent(d);
    for (; d != none; d = hierarchy_.parent(d)) {
        if (d == root || !hierarchy_.is_live(d) || !is_beyond(d, inner, x)) continue;
        const Status status = grow_cage(d);
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

template <int D, class Rule>
Status ThesisCages<D, Rule>::new_cage(const NearestInDomain& near, double radius, std::uint32_t parent,
                                      std::uint32_t* made) {
    const std::uint32_t size = template_size(store_.dim, parent == none);
    if (!store_.has_room(0, size, 0)) return Status::out_of_memory;
    const std::uint32_t d = *made = hierarchy_.make(near, radius, parent, store_.state.vertex_count);
    const Status status = insert_shell(d);
    if (status != Status::ok) hierarchy_.release(d);
    return status;
}

// Once a larger cage is there, or not, the smaller one is released.
template <int D, class Rule> Status ThesisCages<D, Rule>::grow_cage(std::uint32_t d) {
    Cage& cage = hierarchy_.cage(d);
    const double radius = cage.radius / inner;
    if (!(cage.nearest2 >= clear2(radius))) return release_cage(d);
    if (!store_.has_room(0, template_size(store_.dim, false), 0)) return Status::out_of_memory;
    const Cage old = cage;
    cage.radius = radius;
    const Status status = insert_shell(d);
    if (status == Status::ok) {
        observers_.note_grown(VertexId(old.shell), d);
        return demote(old);
    }
    cage = old;
    return status;
}

template <int D, class Rule> Status ThesisCages<D, Rule>::release_cage(std::uint32_t d) {
    const Cage old = hierarchy_.cage(d);
    hierarchy_.release(d);
    observers_.note({none, d});
    return demote(old);
}

// The shell becomes vertices like others; their cells, and those of their neighbours, are looked at.
template <int D, class Rule> Status ThesisCages<D, Rule>::demote(const Cage& cage) {
    visit_shell(cage, [&](VertexId v) {
        if (v != none && store_.vertex(v).marker == Marker::exempt) store_.vertex(v).marker = Marker::steiner;
    });
    visit_shell(cage, [&](VertexId v) {
        if (v != none) queue_.push(v);
    });
    return Status::ok;
}

template <int D, class Rule> Status ThesisCages<D, Rule>::after_step() {
    for (;;) {
        while (encroached_ != none) {
            const std::uint32_t d = encroached_;
            Cage& cage = hierarchy_.cage(d);
            encroached_ = cage.next == d ? none : cage.next;
            cage.next = none;
            if (!hierarchy_.is_live(d)) continue;
            const Status status = release_cage(d);
            if (status != Status::ok) return status;
        }
        if (!has_yielded_) return Status::ok;
        has_yielded_ = false;
        for (VertexId p(0); p < inputs_;)
            for (const std::uint64_t piece = store_.arena.piece(p, inputs_, 300); p < piece; ++p) {
                if (store_.vertex(p).cell == none) continue;
                hierarchy_.of(p);
                const Status status = grow_encroached(p, is_of_shell(p));
                if (status != Status::ok) return status;
            }
    }
}

template <int D, class Rule>
VertexId ThesisCages<D, Rule>::yields_to(const Split<D>& split, NearestInput* nearest) const {
    nearest->input = split.input;
    if (inserted_ == inputs_) return none;
    double input2;
    const std::uint32_t input = tree_.nearest_within(split.x, yield_radius * yield_radius * split.empty2, &input2);
    return input != none && store_.vertex(input).cell == none ? VertexId(input) : VertexId(none);
}

template <int D, class Rule> void ThesisCages<D, Rule>::update_distances(const Cavity& cavity, VertexId v) {
    this->update_nearest(cavity, v);
    if (hierarchy_.live() == 0) return;
    const Vertex<D>& fresh = store_.vertex(v);
    kernel_.visit_neighbours(cavity, v, [&](VertexId w) { update_cages(w, fresh); });
}

// A new vertex has become a neighbour of w: it is outside of the cages that contain w but not the vertex.
template <int D, class Rule> void ThesisCages<D, Rule>::update_cages(VertexId w, const Vertex<D>& fresh) {
    for (std::uint32_t d = hierarchy_.of(w); d != none && !hierarchy_.contains(d, fresh.x); d = hierarchy_.parent(d)) {
        Cage& cage = hierarchy_.cage(d);
        const double d2 = distance2<D>(store_.dim, fresh.x, store_.point(cage.centre));
        if (d2 < cage.nearest2) {
            cage.nearest2 = d2;
            if (d != making_) queue_cage(d);
        }
        if (!(d2 < clear2(cage.radius)) || cage.next != none) continue;
        cage.next = encroached_ == none ? d : encroached_;  // the last one points at itself
        encroached_ = d;
    }
}

template <int D, class Rule> void ThesisCages<D, Rule>::queue_bad(CellId c) {
    const Cell<D>& cell = store_.cell(c);
    if (!(cell.radius2 < infinity)) return;
    this->queue_positions(cell, this->positions_of_bad(cell));
    if (hierarchy_.live() == 0) return;
    for (int i = 0; i <= store_.dim; ++i)
        for (std::uint32_t d = hierarchy_.of(cell.vertex[i]);
             d != none && d != root && is_on_boundary(store_, hierarchy_.cage(d), c); d = hierarchy_.parent(d)) {
            const Cage& cage = hierarchy_.cage(d);
            if (d != making_ && is_bad(cage_corner_distance2(cell, store_.point(cage.centre)), cage.nearest2))
                queue_cage(d);
        }
}

template <int D, class Rule> void ThesisCages<D, Rule>::requeue(VertexId v) {
    if (is_of_shell(v))
        queue_cage(hierarchy_.of(v));
    else
        queue_.push(v);
}

template <int D, class Rule> Verdict ThesisCages<D, Rule>::judge(VertexId v, Split<D>* split) {
    if (!is_of_shell(v)) return judge_vertex(v, split);
    const std::uint32_t d = hierarchy_.of(v);
    return d == none || d == root ? Verdict::good : judge_cage(d, split);
}

// By the farthest corner of v's whole cell.
template <int D, class Rule> Verdict ThesisCages<D, Rule>::judge_vertex(VertexId v, Split<D>* split) {
    const double* const p = store_.point(v);
    Corner<D> corner(store_.dim);
    const bool fits = kernel_.visit_star(v, [&](CellId c) {
        const Cell<D>& cell = store_.cell(c);
        if (cell.radius2 < infinity) corner.offer(cell.centre, corner_distance2(cell, p), c);
    });
    if (!fits) return Verdict::out_of_memory;
    const double nearest2 = store_.vertex(v).nearest2;
    if (!is_bad(corner.distance2, nearest2)) return Verdict::good;
    this->split_towards(v, corner, this->wanted_distance(square_root(nearest2), this->pull_back()), split);
    return judge_split(*split);
}

// By the farthest corner of the cage's whole cell, as seen from its centre. Its in-radius is at least half of the way
// to the nearest vertex outside, as the centre is a vertex.
template <int D, class Rule> Verdict ThesisCages<D, Rule>::judge_cage(std::uint32_t d, Split<D>* split) {
    const Cage& cage = hierarchy_.cage(d);
    const double* const p = store_.point(cage.centre);
    Corner<D> corner(store_.dim);
    std::uint32_t cells;
    if (!list_cage_boundary(AnyStore(store_), cage, &cells)) return Verdict::out_of_memory;
    const CellId* const boundary = store_.list_top();
    for (std::uint32_t k = 0; k < cells; ++k) {
        const CellId c = boundary[-1 - static_cast<std::ptrdiff_t>(k)];
        const Cell<D>& cell = store_.cell(c);
        if (cell.radius2 < infinity) corner.offer(cell.centre, cage_corner_distance2(cell, p), c);
    }
    if (!is_bad(corner.distance2, cage.nearest2)) return Verdict::good;
    const double wanted = this->wanted_distance(square_root(cage.nearest2), this->pull_back());
    this->split_towards(VertexId(cage.centre), corner, wanted, split);
    const double empty = square_root(split->empty2) - cage.radius;
    split->empty2 = empty * empty;
    return judge_split(*split);
}

template <int D, class Rule> Status ThesisCages<D, Rule>::finish_mesh() {
    const Status status = finish_cages();
    return status == Status::ok && has_left_ ? find_left() : status;
}

// Are cells left that have not become good since?
template <int D, class Rule> [[gnu::cold]] Status ThesisCages<D, Rule>::find_left() {
    const std::uint32_t count = store_.state.vertex_count;
    has_left_ = false;
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = store_.arena.piece(v, count, 500 * store_.dim); v < piece; ++v) {
            const Vertex<D>& vertex = store_.vertex(v);
            if (vertex.cell == none) continue;
            const bool of_shell = is_of_shell(v);
            const std::uint32_t d = of_shell ? hierarchy_.of(v) : none;
            if (of_shell && (d == none || hierarchy_.cage(d).shell != v)) continue;
            Split<D> split;
            const Verdict verdict = judge(v, &split);
            if (verdict == Verdict::out_of_memory) return Status::out_of_memory;
            if (verdict == Verdict::bad || has_left_) return Status::check_failed;
        }
    return Status::ok;
}

template <int D, class Rule> Status ThesisCages<D, Rule>::finish_cages() {
    if (!this->request_.finish) return Status::ok;
    while (hierarchy_.live() > 1)
        for (std::uint32_t d = 1; d < hierarchy_.made(); ++d) {
            if (!hierarchy_.is_live(d)) continue;
            Status status = grow_cage(d);
            if (status == Status::ok) status = this->finish_step(none, true);
            if (status == Status::ok) status = this->clean();
            if (status != Status::ok) return status;
        }
    return Status::ok;
}

template <int D, class Rule> std::size_t ThesisCages<D, Rule>::keep_results(std::size_t) {
    const std::uint32_t made = hierarchy_.made(), kept = hierarchy_.keep_live(store_.arena);
    this->result_.cages = hierarchy_.cages();
    this->result_.hierarchy = {kept, made, made - kept};
    return store_.arena.offset_of(hierarchy_.cages() + kept);
}

// store.dim <= thesis_dim_max, or invalid_argument. check_failed: whatever the radius of the outermost cage, a cell is
// left whose aspect ratio is above tau.
Status mesh_by_thesis_cages(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                            const Work& work, AnyMeshResult* result);

}  // namespace netmesh
