#include "mesh/loop/quality_rule.hpp"

#include "certificate/interval.hpp"
#include "mesh/loop/aspect_rule.hpp"
#include "mesh/loop/reference_rule.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

template <int D> class QualityRule : public AspectRule<D, QualityRule<D>> {
    using Base = AspectRule<D, QualityRule<D>>;
    using Base::domain_;
    using Base::is_bad;
    using Base::kernel_;
    using Base::nearest_input;
    using Base::observers_;
    using Base::queue_;
    using Base::sizes_;
    using Base::store_;
    using Base::tau_;
    using Base::tree_;

public:
    static constexpr bool heeds_sizes = true;

    QualityRule(Store<D>& store, const MeshRequest& request, const Work& work, MeshResult<D>& result)
        : Base(store, request, work, result), reference_(request.method == MeshMethod::reference),
          certify_(request.certify_filter && !is_reference()), pull_(is_reference() ? infinity : Base::pull_back()) {
        if (!is_reference()) this->wait_for_inputs();
    }

    double choose_domain();
    double promised_radius() const { return is_reference() ? domain_.radius : Base::promised_radius(); }
    Status check_goal();
    Status begin() { return is_reference() ? insert_boundary_net() : Status::ok; }
    Status take_turn(VertexId p);
    Status finish_mesh();
    void queue_bad(CellId c);
    void queue_new(const Cavity& cavity, VertexId v) { Base::queue_new(cavity, domain_, v); }
    Verdict judge(VertexId v, Split<D>* split);
    bool must_yield(const Split<D>& split, const NearestInput& nearest) const;
    bool may_be_bad(double corner2, const Vertex<D>& vertex) const {
        return is_bad(corner2, vertex.nearest2) || corner2 > sizes_.bound2(vertex);
    }

private:
    struct CellView {
        explicit CellView(int dim) : clipped(dim), whole(dim) {}

        std::uint32_t cells = 0;
        bool leaves_domain = false;  // some corner is outside, far enough to matter, or not known
        Corner<D> clipped;           // farthest corner of the clipped cell
        Corner<D> whole;             // farthest corner of the whole cell
        double reach2 = 0;           // squared distance from the nearest input to the farthest corner from it, or more
    };

    bool is_reference() const { return reference_; }
    Status insert_boundary_net();
    bool may_spoil_certificate(VertexId v, const double* x) const;
    bool view_cell(VertexId v, double least2, CellView* view);
    bool spoils_certificate(VertexId v, const CellView& view) const;

    bool is_surely_medial(VertexId p, VertexId u) const;
    Verdict judge_medial(VertexId p, VertexId u, Split<D>* split);

    const bool reference_, certify_;
    const double pull_;
};

template <int D> double QualityRule<D>::choose_domain() {
    if (!is_reference()) return Base::choose_domain();
    return domain_.radius = reference_radius(this->request_.tau, this->request_.net_spacing, domain_.enclosing_radius);
}

// With a net that coordinates on its sphere do not resolve the same place would be missing again and again.
template <int D> [[gnu::cold]] Status QualityRule<D>::check_goal() {
    if (!is_reference() || has_resolved_net<D>(domain_, this->request_.net_spacing)) return Status::ok;
    this->result_.input.row_a = none;
    return Status::invalid_argument;
}

template <int D> Status QualityRule<D>::finish_mesh() {
    if (is_reference()) return this->clean();
    this->stop_waiting();
    return this->clean_by_scales();
}

// Splits the cell of the nearest vertex until p is medial, unless p goes in as another cell is split.
template <int D> Status QualityRule<D>::take_turn(VertexId p) {
    if (is_reference()) return this->insert_input(p, store_.state.last_cell, false);
    Status status = Status::ok;
    CellId from = observers_.start_for(store_.state, p);
    while (status == Status::ok && store_.vertex(p).cell == none) {
        Cavity cavity;
        if (!this->find_cavity(p, from, &cavity)) return Status::out_of_memory;
        const VertexId u = this->nearest_in_conflict(p, cavity);
        Split<D> split;
        Verdict medial = Verdict::good;
        if (!is_surely_medial(p, u)) {
            medial = judge_medial(p, u, &split);  // where it walks around u the cavity is lost
            if (medial == Verdict::good && !this->find_cavity(p, store_.vertex(u).cell, &cavity))
                return Status::out_of_memory;
        }
        if (medial == Verdict::out_of_memory) return Status::out_of_memory;
        status = medial == Verdict::bad ? this->yielding_insert(split) : this->fill(p, cavity);
        if (status == Status::ok && medial == Verdict::good) status = this->finish_step(p, false);
        if (status == Status::ok) status = this->clean();
        from = store_.vertex(u).cell;
    }
    return status;
}

// u's cell reaches no farther than tau_/2 times the way to its nearest neighbour, as the mesh is clean.
template <int D> bool QualityRule<D>::is_surely_medial(VertexId p, VertexId u) const {
    const Vertex<D>& vertex = store_.vertex(u);
    const double d2 = distance2<D>(store_.dim, store_.point(p), vertex.x);
    return vertex.marker == Marker::exempt || !(this->least_bad2(vertex) > mediality * mediality * d2);
}

// Does the cell of u, the nearest vertex of p, reach farther than p is medial for? Then it is split there.
template <int D> [[gnu::cold]] Verdict QualityRule<D>::judge_medial(VertexId p, VertexId u, Split<D>* split) {
    const double bound2 = mediality * mediality * distance2<D>(store_.dim, store_.point(p), store_.point(u));
    CellView view(store_.dim);
    if (!view_cell(u, bound2, &view)) return Verdict::out_of_memory;
    if (!(view.clipped.distance2 > bound2) && view.leaves_domain)
        offer_poles(store_, domain_, store_.point(u), u, store_.list_top(), view.cells, &view.clipped);
    if (!(view.clipped.distance2 > bound2)) return Verdict::good;
    this->split_towards(u, view.clipped, square_root(view.clipped.distance2), split);
    return Verdict::bad;
}

template <int D> Status QualityRule<D>::insert_boundary_net() {
    const VertexId inside(0);
    const double delta = this->request_.net_spacing * 2 * domain_.enclosing_radius;
    Status status = this->insert(inside, store_.state.last_cell);
    for (bool covered = false; !covered && status == Status::ok;) {
        covered = true;
        for (CellId c(0); c < store_.state.cell_slots && status == Status::ok;)
            for (const std::uint64_t piece = store_.arena.piece(c, store_.state.cell_slots, 200 * store_.dim);
                 c < piece && status == Status::ok; ++c) {
                double z[DimensionOf<D>::most], d2;
                if (!lacks_net_vertex<D>(store_, domain_, delta, c, inside, z)) continue;
                if (!store_.has_room(0, 1, 0)) return Status::out_of_memory;
                const VertexId v = make_vertex<D>(store_, z, tree_.nearest(z, 0, none, &d2), Marker::exempt);
                status = this->insert(v, c);
                if (status == Status::out_of_memory) store_.truncate_vertices(v);
                covered = false;
            }
    }
    return status;
}

template <int D> void QualityRule<D>::queue_bad(CellId c) {
    const Cell<D>& cell = store_.cell(c);
    if (!(cell.radius2 < infinity)) return;
    unsigned far = this->positions_of_bad(cell);
    if (far == 0) return;
    if (domain_.contains(cell.centre)) return this->queue_positions(cell, far);
    if (certify_)
        for (int i = 0; i <= store_.dim; ++i)
            if ((far >> i & 1u) && may_spoil_certificate(cell.vertex[i], cell.centre)) {
                queue_.push(cell.vertex[i]);
                far &= ~(1u << i);
            }
    this->queue_bad_crossings(domain_, cell, far);
}

// Could a corner at x of v's cell spoil the certificate? As lo is at least half of d_P(v), a necessary condition that
// needs no walk around v.
template <int D> bool QualityRule<D>::may_spoil_certificate(VertexId v, const double* x) const {
    const double* const input = store_.point(nearest_input(v));
    const double reach2 = distance2<D>(store_.dim, x, input), rho = domain_.enclosing_radius;
    const double hi2 = reach2 < rho * rho ? reach2 : rho * rho;
    if (store_.vertex(v).marker == Marker::input) return 4 * hi2 > tau_ * tau_ * store_.vertex(v).nearest2;
    return 4 * hi2 > (2 + tau_) * (2 + tau_) * distance2<D>(store_.dim, store_.point(v), input);
}

// Walks around v's cell; corners within the root of least2 do not matter. False when the gap is too small for that.
template <int D> bool QualityRule<D>::view_cell(VertexId v, double least2, CellView* view) {
    *view = CellView(store_.dim);
    const double* const p = store_.point(v);
    const double* const input = store_.point(nearest_input(v));
    return kernel_.visit_star(v, [&](CellId c) {
        const Cell<D>& cell = store_.cell(c);
        ++view->cells;
        if (!certify_ && is_within(cell, least2)) return;
        if (!(cell.radius2 < infinity)) {  // so flat that its corner is not known
            view->leaves_domain = true;
            return;
        }
        const double d2 = distance2<D>(store_.dim, cell.centre, p);
        if (domain_.contains(cell.centre))
            view->clipped.offer(cell.centre, d2, c);
        else {
            offer_crossings<D>(store_, domain_, v, c, least2, &view->clipped);
            view->leaves_domain |= cell.radius2 > least2;
        }
        if (!certify_) return;
        double whole2 = d2, reach2 = distance2<D>(store_.dim, cell.centre, input);
        if (cell.error > blurred_error) {
            const double reach = square_root(reach2) + static_cast<double>(cell.error) * square_root(cell.radius2);
            whole2 = cell.radius2;
            reach2 = reach * reach;
        }
        view->whole.offer(cell.centre, whole2, c);
        if (reach2 > view->reach2) view->reach2 = reach2;
    });
}

// Do lo and hi on the whole cell say that the filter does not have the ratio that tau promises?
template <int D> bool QualityRule<D>::spoils_certificate(VertexId v, const CellView& view) const {
    const double nearest2 = store_.vertex(v).nearest2;
    if (!is_bad(view.whole.distance2, nearest2)) return false;
    const bool is_input = store_.vertex(v).marker == Marker::input;
    const double rho = domain_.enclosing_radius, out_radius = square_root(view.whole.distance2),
                 reach = is_input ? out_radius : square_root(view.reach2);
    const double hi = reach < rho ? reach : rho;
    if (is_input) return 2 * hi > tau_ * square_root(nearest2);
    const double d = distance<D>(store_.dim, store_.point(v), store_.point(nearest_input(v)));
    const double lo = least_distance(d, out_radius, as_computed);
    return hi > (2 + tau_) * lo || hi > tau_ * d;
}

template <int D> Verdict QualityRule<D>::judge(VertexId v, Split<D>* split) {
    CellView view(store_.dim);
    if (!view_cell(v, this->least_beyond2(store_.vertex(v)), &view)) return Verdict::out_of_memory;
    const double nearest2 = store_.vertex(v).nearest2, clipped2 = view.clipped.distance2;
    const Corner<D>* corner = &view.clipped;
    Corner<D> beyond(store_.dim);
    if (!is_bad(clipped2, nearest2) && !sizes_.are_exceeded(v, clipped2)) {
        if (view.leaves_domain) this->find_sized_beyond(domain_, v, view.cells, &beyond);
        corner = &beyond;
        if (beyond.distance2 < 0 && this->may_be_blurred(store_.vertex(v)) && !this->find_blurred(domain_, v, &beyond))
            return Verdict::out_of_memory;
        if (beyond.distance2 < 0) {
            if (!certify_ || !spoils_certificate(v, view)) return Verdict::good;
            corner = &view.whole;
        }
    }
    this->split_towards(v, *corner, this->wanted_distance(square_root(nearest2), pull_), split);
    return Verdict::bad;
}

// What the proof in the header asks of inputs that are not inserted yet.
template <int D> bool QualityRule<D>::must_yield(const Split<D>& split, const NearestInput& nearest) const {
    const double input2 = nearest.distance2;
    if (input2 < yield_radius * yield_radius * split.empty2 || !(input2 < split.empty2)) return input2 < split.empty2;
    double second2;  // f_P(x) squared
    tree_.nearest(split.x, none, nearest.input, &second2);
    const double tau = this->tight_;
    return (tau - 2) * (tau - 2) * second2 > (tau + 2) * (tau + 2) * input2;
}

}  // namespace

template <int D>
Status mesh_by_quality(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                       const Work& work, AnyMeshResult* result) {
    return mesh_by<D, QualityRule>(store, points, n, request, work, result);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status mesh_by_quality<D>(AnyStore&, const InputRows&, std::size_t, const MeshRequest&, const Work&,      \
                                       AnyMeshResult*);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
