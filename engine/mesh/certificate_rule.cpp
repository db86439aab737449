#include "mesh/certificate_rule.hpp"

#include "certificate/interval.hpp"
#include "delaunay/load.hpp"
#include "mesh/refinement.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// A Steiner point is put this much farther from its vertex than the nearest corner that can be bad.
constexpr double overshoot = 1.1;

// What R / r of an input's cell is held to, over what the certificate needs; but no less than a tau that is cheap to
// reach. In between a filter value of its own, r, stays nearer to the one that it is given: most of the true error is
// there.
constexpr double input_share = 0.8, input_least = 2.2;

// A ratio asked for, and the K of certificate_rule.hpp that goes with it.
struct Bound {
    double ratio2, reach2, step, input;  // c^2, K^2, k, largest R / r of an input's cell

    explicit Bound(double ratio) : ratio2(ratio * ratio * (1 - tau_margin)) {
        const double near = (ratio2 - 1) / (ratio2 + 1), far = 0.5 * ratio2 - 1;
        reach2 = near > far ? near * near : far * far;
        step = far > 0 ? far : near;
        input = input_share * ratio2 > input_least ? input_share * ratio2 : ratio2 < input_least ? ratio2 : input_least;
    }
    // Nothing is refined farther from the domain's centre, in enclosing radii.
    double extent() const {
        const double steiner = 1 + 2 * (1 + overshoot * square_root(reach2)) / ratio2;
        return steiner > 2.1 ? steiner : 2.1;
    }
};

template <int D> class CertificateRule : public Refinement<D, CertificateRule<D>> {
    using Base = Refinement<D, CertificateRule<D>>;
    using Base::domain_;
    using Base::inputs_;
    using Base::kernel_;
    using Base::nearest_input;
    using Base::queue_;
    using Base::store_;

public:
    static constexpr bool keeps_input_distances = true;

    CertificateRule(Store<D>& store, const MeshRequest& request, const Work& work, MeshResult<D>& result)
        : Base(store, request, work, result), goal_(request.goal), bound_(goal_.ratio),
          focus_(goal_.focus > 0 && goal_.focus < goal_.ratio ? goal_.focus : goal_.ratio) {}

    // A Steiner point comes as near to others as `step` times its distance to the inputs.
    double finest() const { return bound_.step < 1 ? resolution / bound_.step : resolution; }
    Status check_goal();
    double choose_domain();
    void update_distances(const Cavity& cavity, VertexId v);
    void queue_bad(CellId c);
    Verdict judge(VertexId v, Split<D>* split);
    bool must_yield(const Split<D>& split, const NearestInput& nearest) const {
        return nearest.distance2 < yield_radius * yield_radius * split.empty2;
    }
    void note_steiner(VertexId v, const NearestInput& nearest) {
        input_distance2(store_.vertex(v)) = nearest.distance2;
    }
    void restore_distances() { measure_edges<D>(store_); }
#ifdef NETMESH_VALIDATE
    const char* clean_violation() const {
        return ratio_violation<D>(store_, goal_.ratio * goal_.ratio, domain_.enclosing_radius);
    }
#endif

private:
    struct CellView {
        Corner<D> farthest;    // from the vertex
        Corner<D> from_input;  // from the nearest input; `distance2` is to that
    };

    // While a mesh is refined the record of a Steiner vertex holds the squared distance to its nearest input where
    // that to its nearest neighbour, of which this rule makes no use, belongs: also what the queue goes by.
    static double& input_distance2(Vertex<D>& steiner) { return steiner.nearest2; }
    // Of an input to its nearest neighbour, of a Steiner vertex to its nearest input.
    static double local_distance2(const Vertex<D>& vertex) { return vertex.nearest2; }

    const Bound& bound_at(const Vertex<D>& vertex) const;
    double least_bad2(const Vertex<D>& vertex) const;
    bool view_cell(VertexId v, CellView* view);
    bool is_bad(VertexId v, const CellView& view) const;

    const RatioGoal goal_;
    const Bound bound_, focus_;
    double cut2_ = 0;  // squared enclosing radius
};

template <int D> Status CertificateRule<D>::check_goal() {
    if (!(goal_.focus > 0)) return Status::ok;
    double size = 0;
    for (std::uint32_t v = 0; v < inputs_; ++v)
        for (int k = 0; k < D; ++k)
            if (absolute(store_.point(v)[k]) > size) size = absolute(store_.point(v)[k]);
    return goal_.from * focus_.step < resolution * size ? Status::invalid_argument : Status::ok;
}

template <int D> double CertificateRule<D>::choose_domain() {
    domain_.radius = domain_.enclosing_radius;
    cut2_ = domain_.enclosing_radius * domain_.enclosing_radius;
    const double factor = 1.05 * square_root(D) * focus_.extent();  // the smaller a ratio, the larger its extent
    return domain_.radius * (factor > frame_factor<D> ? factor : frame_factor<D>);
}

// The bound that may hold for a cell, as far as d_P of its vertex tells: a focused one has d/2 <= lo < to, and
// from < hi <= c^2 d or else it is bad anyhow.
template <int D> const Bound& CertificateRule<D>::bound_at(const Vertex<D>& vertex) const {
    if (!(goal_.focus > 0) || vertex.marker == Marker::input) return bound_;
    const double above = goal_.from / bound_.ratio2, below = 2 * goal_.to, d2 = local_distance2(vertex);
    return d2 > above * above && d2 < below * below ? focus_ : bound_;
}

// A cell without a corner farther from the vertex than this (squared) is good.
template <int D> double CertificateRule<D>::least_bad2(const Vertex<D>& vertex) const {
    const Bound& bound = bound_at(vertex);
    const bool is_input = vertex.marker == Marker::input;
    const double d2 = local_distance2(vertex);
    const double most = is_input ? bound.input : bound.ratio2;  // 2 hi over the root of d2, at most, if good for sure
    if (4 * cut2_ <= most * most * d2) return infinity;
    return is_input ? 0.25 * most * most * d2 : bound.reach2 * d2;
}

// An input's cell may have become bad because its nearest neighbour came nearer.
template <int D> void CertificateRule<D>::update_distances(const Cavity& cavity, VertexId v) {
    Vertex<D>& centre = store_.vertex(v);
    kernel_.visit_neighbours(cavity, v, [&](VertexId w) {
        Vertex<D>& other = store_.vertex(w);
        const double d2 = distance2<D>(centre.x, other.x);
        if (centre.marker == Marker::input && d2 < centre.nearest2) centre.nearest2 = d2;
        if (other.marker != Marker::input || !(d2 < other.nearest2)) return;
        other.nearest2 = d2;
        queue_.push(w);
    });
}

template <int D> void CertificateRule<D>::queue_bad(CellId c) {
    const Cell<D>& cell = store_.cell(c);
    if (!(cell.radius2 < infinity)) return;
    for (const VertexId w : cell.vertex) {
        const Vertex<D>& vertex = store_.vertex(w);
        if (!vertex.queued && vertex.marker != Marker::exempt && cell.radius2 > least_bad2(vertex)) queue_.push(w);
    }
}

// Walks around v's cell. False when the gap is too small for that.
template <int D> bool CertificateRule<D>::view_cell(VertexId v, CellView* view) {
    *view = CellView{};
    const double* const p = store_.point(v);
    const double* const input = store_.point(nearest_input(v));
    return kernel_.visit_star(v, [&](CellId c) {
        const Cell<D>& cell = store_.cell(c);
        if (!(cell.radius2 < infinity)) return;  // a ghost
        view->farthest.offer(cell.centre, distance2<D>(cell.centre, p), c);
        view->from_input.offer(cell.centre, distance2<D>(cell.centre, input), c);
    });
}

template <int D> bool CertificateRule<D>::is_bad(VertexId v, const CellView& view) const {
    const Vertex<D>& vertex = store_.vertex(v);
    const double hi = square_root(view.from_input.distance2 < cut2_ ? view.from_input.distance2 : cut2_);
    const double d = square_root(local_distance2(vertex));
    if (vertex.marker == Marker::input) return 2 * hi > bound_.input * d;
    const double lo = least_distance(d, square_root(view.farthest.distance2), as_computed);
    if (hi > bound_.ratio2 * lo) return true;
    return hi > focus_.ratio2 * lo && hi > goal_.from && lo < goal_.to;
}

// Towards the corner that defines hi, or the farthest one; see the header for how far.
template <int D> Verdict CertificateRule<D>::judge(VertexId v, Split<D>* split) {
    CellView view;
    if (!view_cell(v, &view)) return Verdict::out_of_memory;
    if (!is_bad(v, view)) return Verdict::good;
    const double* const p = store_.point(v);
    const Vertex<D>& vertex = store_.vertex(v);
    const double least2 = least_bad2(vertex);
    const Corner<D>* corner = &view.from_input;
    double whole2 = distance2<D>(corner->x, p);
    double level = 0;  // from this fraction of the way on the nearest input is no nearer than from v
    if (whole2 < least2 && bound_at(vertex).ratio2 <= 2) {
        corner = &view.farthest;
        whole2 = corner->distance2;
    } else if (vertex.marker == Marker::steiner) {
        level = 1 - (corner->distance2 - local_distance2(vertex)) / whole2;
    }
    const double wanted2 = overshoot * overshoot * least2;
    double fraction = wanted2 < whole2 ? square_root(wanted2 / whole2) : 1;
    if (fraction < level) fraction = level;
    split->place(p, *corner, fraction);
    split->empty2 = distance2<D>(split->x, p);
    split->input = nearest_input(v);
    return Verdict::bad;
}

}  // namespace

template <int D>
Status mesh_by_certificate(Store<D>& store, const double* points, std::size_t n, const MeshRequest& request,
                           const Work& work, MeshResult<D>* result) {
    return mesh_by_rule<D, CertificateRule<D>>(store, points, n, request, work, result);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status mesh_by_certificate<D>(Store<D>&, const double*, std::size_t, const MeshRequest&, const Work&,     \
                                           MeshResult<D>*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
