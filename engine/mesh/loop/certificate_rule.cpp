#include "mesh/loop/certificate_rule.hpp"

#include "certificate/interval.hpp"
#include "delaunay/load.hpp"
#include "mesh/clip/clipped_cell.hpp"
#include "mesh/loop/refinement.hpp"
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
    double ratio2, reach2, step, input;   // c^2, K^2, k, largest R / r of an input's cell
    double ratio4, input2, input_reach2;  // c^4, the square of `input`, a quarter of that

    explicit Bound(double ratio) : ratio2(ratio * ratio * (1 - tau_margin)) {
        const double near = (ratio2 - 1) / (ratio2 + 1), far = 0.5 * ratio2 - 1;
        reach2 = near > far ? near * near : far * far;
        step = far > 0 ? far : near;
        input = input_share * ratio2 > input_least ? input_share * ratio2 : ratio2 < input_least ? ratio2 : input_least;
        ratio4 = ratio2 * ratio2;
        input2 = input * input;
        input_reach2 = 0.25 * input * input;
    }
    // Of whole cells nothing is refined farther from the domain's centre, in enclosing radii.
    double extent() const {
        const double steiner = 1 + 2 * (1 + overshoot * square_root(reach2)) / ratio2;
        return steiner > 2.1 ? steiner : 2.1;
    }
};

double lesser(double a, double b) { return a < b ? a : b; }

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
        : Base(store, request, work, result), goal_(request.goal), from_(goal_.from * (1 - tau_margin)),
          to_(goal_.to * (1 + tau_margin)), bound_(goal_.ratio),
          focus_(goal_.focus > 0 && goal_.focus < goal_.ratio ? goal_.focus : goal_.ratio),
          least_reach2_(
              lesser(lesser(bound_.reach2, bound_.input_reach2), lesser(focus_.reach2, focus_.input_reach2))) {}

    // A Steiner point comes as near to others as `step` times its distance to the inputs.
    double finest() const { return bound_.step < 1 ? resolution / bound_.step : resolution; }
    Status check_goal();
    double choose_domain();
    void update_distances(const Cavity& cavity, VertexId v);
    void queue_bad(CellId c);
    void queue_new(const Cavity& cavity, VertexId v);
    Verdict judge(VertexId v, Split<D>* split);
    bool must_yield(const Split<D>& split, const NearestInput& nearest) const {
        return nearest.distance2 < yield_radius * yield_radius * split.empty2;
    }
    void note_steiner(VertexId v, const NearestInput& nearest) {
        store_.vertex(v).nearest2 = nearest.distance2;  // see local_distance2
    }
    void restore_distances() { measure_edges(store_); }
#ifdef NETMESH_VALIDATE
    const char* clean_violation() {
        return goal_.clipped ? clipped_violation()
                             : ratio_violation<D>(store_, goal_.ratio * goal_.ratio, domain_.enclosing_radius);
    }
#endif

private:
    struct CellView {
        explicit CellView(int dim) : farthest(dim), from_input(dim) {}

        Corner<D> farthest;       // from the vertex; `distance2` at most, here and below
        Corner<D> from_input;     // from the nearest input; `distance2` is to that
        std::uint32_t cells = 0;  // in the star
        bool may_be_bad = false;  // by some corner
        double blur = 0;          // three times what corners may be wrong by, where that matters, see farthest2
    };

    // Of an input to its nearest neighbour, of a Steiner vertex to its nearest input. While a mesh is refined the
    // record of a Steiner vertex holds that where the squared distance to its nearest neighbour, of which this rule
    // makes no use, belongs: also what the queue goes by.
    static double local_distance2(const Vertex<D>& vertex) { return vertex.nearest2; }

    // The squared distance of a corner of this cell from some point, d2 as computed: what the certificate may make of
    // it, where the corner is known worse than tau_margin allows for.
    static double farthest2(const Cell<D>& cell, double d2) {
        const double share = static_cast<double>(cell.error);
        if (!(share > corner_error_max)) return d2;
        const double most = square_root(d2) + 3 * share * square_root(cell.radius2);
        return most * most;
    }

    const Bound& bound_at(const Vertex<D>& vertex) const;
    double least_bad2(const Vertex<D>& vertex) const;
    bool is_surely_good(VertexId v, const CellView& view) const;
    bool view_cell(VertexId v, CellView* view);
    bool leaves_ball(const CellView& view) const;
    void view_whole(VertexId v, CellView* view) const;
    void clip(VertexId v, CellView* view) const;
    bool is_bad(VertexId v, const CellView& view) const;
    // A point on the sphere, or a hair outside as computed.
    void put_inside(double* x) const {
        const double share = domain_.radius / square_root(domain_.distance2(x)) * (1 - 0x1p-50);
        for (int k = 0; k < store_.dim; ++k) x[k] = domain_.centre[k] + share * (x[k] - domain_.centre[k]);
    }
    double largest_good(const Vertex<D>& vertex, double lo) const;
    bool find_bad_pole(VertexId v, CellView* view) const;
#ifdef NETMESH_VALIDATE
    const char* clipped_violation();
#endif

    const RatioGoal goal_;
    // A hair beyond the scales of interest: what a certificate, rounded outwards, counts to them is of interest here.
    const double from_, to_;
    const Bound bound_, focus_;
    const double least_reach2_;  // least_bad2 over local_distance2 is no less
    double cut2_ = 0;            // squared enclosing radius
};

template <int D> Status CertificateRule<D>::check_goal() {
    if (!(goal_.focus > 0)) return Status::ok;
    double size = 0;
    for (std::uint32_t v = 0; v < inputs_;)
        for (const std::uint64_t piece = store_.arena.piece(v, inputs_, 500 * store_.dim); v < piece; ++v) {
            for (int k = 0; k < store_.dim; ++k)
                if (absolute(store_.point(v)[k]) > size) size = absolute(store_.point(v)[k]);
        }
    return goal_.from * focus_.step < resolution * size ? Status::invalid_argument : Status::ok;
}

template <int D> double CertificateRule<D>::choose_domain() {
    domain_.radius = domain_.enclosing_radius;
    cut2_ = domain_.enclosing_radius * domain_.enclosing_radius;
    if (goal_.clipped) {
        domain_.radius *= clip_factor;
        const double around = 1.05 * square_root(store_.dim), good = (1 + 2 / focus_.ratio2) * (1 + 0x1p-10);
        return domain_.radius * (around > good ? around : good);
    }
    const double factor =
        1.05 * square_root(store_.dim) * focus_.extent();  // the smaller a ratio, the larger its extent
    const double least = figures_of<D>(store_.dim).frame_factor;
    return domain_.radius * (factor > least ? factor : least);
}

// The bound that may hold for a cell, as far as d_P of its vertex tells: a focused one has d/2 <= lo < to, and
// from < hi <= c^2 d or else it is bad anyhow.
template <int D> const Bound& CertificateRule<D>::bound_at(const Vertex<D>& vertex) const {
    if (!(goal_.focus > 0) || vertex.marker == Marker::input) return bound_;
    const double above = from_ / bound_.ratio2, below = 2 * to_, d2 = local_distance2(vertex);
    return d2 > above * above && d2 < below * below ? focus_ : bound_;
}

// A cell without a corner farther from the vertex than this (squared) is good.
template <int D> double CertificateRule<D>::least_bad2(const Vertex<D>& vertex) const {
    const Bound& bound = bound_at(vertex);
    const bool is_input = vertex.marker == Marker::input;
    const double d2 = local_distance2(vertex);
    const double most2 = is_input ? bound.input2 : bound.ratio4;  // 4 hi^2 over d2, at most, if good for sure
    if (4 * cut2_ <= most2 * d2) return infinity;
    return (is_input ? bound.input_reach2 : bound.reach2) * d2;
}

// An input's cell may have become bad because its nearest neighbour came nearer.
template <int D> void CertificateRule<D>::update_distances(const Cavity& cavity, VertexId v) {
    auto&& centre = store_.vertex(v);
    kernel_.visit_neighbours(cavity, v, [&](VertexId w) {
        auto&& other = store_.vertex(w);
        const double d2 = distance2<D>(store_.dim, centre.x, other.x);
        if (centre.marker == Marker::input && d2 < centre.nearest2) centre.nearest2 = d2;
        if (other.marker != Marker::input || !(d2 < other.nearest2)) return;
        other.nearest2 = d2;
        queue_.push(w);
    });
}

template <int D> void CertificateRule<D>::queue_bad(CellId c) {
    const Cell<D>& cell = store_.cell(c);
    if (!(cell.radius2 < infinity)) return;
    if (goal_.clipped && !domain_.contains(cell.centre)) return;  // see queue_new
    const double reach2 = farthest2(cell, cell.radius2);
    for (const VertexId w : cell.vertex) {
        const Vertex<D>& vertex = store_.vertex(w);
        if (!(reach2 > least_reach2_ * local_distance2(vertex))) continue;  // most cells
        if (!vertex.queued && vertex.marker != Marker::exempt && reach2 > least_bad2(vertex)) queue_.push(w);
    }
}

// Corners outside of the ball stand for edges and faces that the sphere crosses. A new vertex leaves the other clipped
// cells no larger than they were, and their d_P what it was, so only its own can have become bad there.
template <int D> void CertificateRule<D>::queue_new(const Cavity& cavity, VertexId v) {
    const Vertex<D>& vertex = store_.vertex(v);
    if (!goal_.clipped || vertex.queued || vertex.marker == Marker::exempt) return;
    const double least2 = least_bad2(vertex);
    for (std::uint32_t k = 0; k < cavity.facets; ++k) {
        const Cell<D>& cell = store_.cell(kernel_.new_cell(k));
        if (farthest2(cell, cell.radius2) > least2) return queue_.push(v);
    }
}

// Walks around v's cell. False when the gap is too small for that.
template <int D> bool CertificateRule<D>::view_cell(VertexId v, CellView* view) {
    *view = CellView(store_.dim);
    const double least2 = least_bad2(store_.vertex(v));
    return kernel_.visit_star(v, [&](CellId c) {
        const Cell<D>& cell = store_.cell(c);
        ++view->cells;
        if (is_within(cell, least2) || !(cell.radius2 < infinity)) return;  // not of ghosts
        view->may_be_bad = true;
        const double share = static_cast<double>(cell.error), wrong = 3 * share * square_root(cell.radius2);
        if (goal_.clipped && share > corner_error_max && wrong > view->blur) view->blur = wrong;
    });
}

// Has the cell that has just been walked around a corner outside of the ball?
template <int D> bool CertificateRule<D>::leaves_ball(const CellView& view) const {
    for (std::uint32_t k = 0; k < view.cells && goal_.clipped; ++k) {
        const Cell<D>& cell = store_.cell(store_.list_top()[-1 - static_cast<std::ptrdiff_t>(k)]);
        if (cell.radius2 < infinity && !domain_.contains(cell.centre)) return true;
    }
    return false;
}

// The corners of v's cell, which has just been walked around.
template <int D> void CertificateRule<D>::view_whole(VertexId v, CellView* view) const {
    const double* const p = store_.point(v);
    const double* const input = store_.point(nearest_input(v));
    for (std::uint32_t k = 0; k < view->cells; ++k) {
        const CellId c = store_.list_top()[-1 - static_cast<std::ptrdiff_t>(k)];
        const Cell<D>& cell = store_.cell(c);
        if (!(cell.radius2 < infinity)) continue;
        view->farthest.offer(cell.centre, farthest2(cell, distance2<D>(store_.dim, cell.centre, p)), c);
        view->from_input.offer(cell.centre, farthest2(cell, distance2<D>(store_.dim, cell.centre, input)), c);
    }
}

// Is no point of v's clipped cell, which has just been walked around, so far from its nearest input that the cell is
// bad even with the least lo? For most cells near the sphere that are good.
template <int D> bool CertificateRule<D>::is_surely_good(VertexId v, const CellView& view) const {
    if (!view.may_be_bad) return true;
    if (!goal_.clipped || view.blur > 0) return false;
    const Vertex<D>& vertex = store_.vertex(v);
    const double d = square_root(local_distance2(vertex)), most = largest_good(vertex, 0.5 * d);
    const double near = vertex.marker == Marker::input ? most : most > d ? most - d : 0;
    const Cut cut(domain_, store_.point(nearest_input(v)), most * most);
    return !may_reach_beyond<D>(store_, cut, v, near * near, store_.list_top(), view.cells);
}

template <int D> bool CertificateRule<D>::is_bad(VertexId v, const CellView& view) const {
    const Vertex<D>& vertex = store_.vertex(v);
    const double hi = square_root(view.from_input.distance2 < cut2_ ? view.from_input.distance2 : cut2_);
    const double d = square_root(local_distance2(vertex));
    if (vertex.marker == Marker::input) return 2 * hi > bound_.input * d;
    const double lo = least_distance(d, square_root(view.farthest.distance2), as_computed);
    if (hi > bound_.ratio2 * lo) return true;
    return hi > focus_.ratio2 * lo && hi > from_ && lo < to_;
}

// A larger hi makes v's cell bad when its lo is this.
template <int D> double CertificateRule<D>::largest_good(const Vertex<D>& vertex, double lo) const {
    if (vertex.marker == Marker::input) return bound_.input * lo;
    const double most = bound_.ratio2 * lo, in_focus = focus_.ratio2 * lo > from_ ? focus_.ratio2 * lo : from_;
    return lo < to_ && in_focus < most ? in_focus : most;
}

// Makes the view of v's cell that has just been taken one of its corners in the ball and of the points where its edges
// cross the sphere. Corners that may be wrong: of the ball that is larger by that, see aspect_rule.hpp.
template <int D> void CertificateRule<D>::clip(VertexId v, CellView* view) const {
    view->farthest = view->from_input = Corner<D>(store_.dim);
    const double* const p = store_.point(v);
    const double* const input = store_.point(nearest_input(v));
    Domain<D> ball = domain_;
    ball.radius += view->blur;
    const auto at_most2 = [&](double d2) {
        const double most = square_root(d2) + view->blur;
        return view->blur > 0 ? most * most : d2;
    };
    for (std::uint32_t k = 0; k < view->cells; ++k) {
        const CellId c = store_.list_top()[-1 - static_cast<std::ptrdiff_t>(k)];
        const Cell<D>& cell = store_.cell(c);
        if (!(cell.radius2 < infinity)) continue;
        const auto offer = [&](const double* x) {
            view->farthest.offer(x, at_most2(distance2<D>(store_.dim, x, p)), c);
            view->from_input.offer(x, at_most2(distance2<D>(store_.dim, x, input)), c);
        };
        if (ball.contains(cell.centre))
            offer(cell.centre);
        else
            visit_crossings<D>(
                store_, ball, v, c, 0, [](const Cell<D>&, const Cell<D>&) { return true; }, offer);
    }
    // v last: where the blur drowns all differences, the cell is split at a corner that was seen.
    view->farthest.offer(p, at_most2(0), store_.vertex(v).cell);
    view->from_input.offer(p, at_most2(distance2<D>(store_.dim, p, input)), store_.vertex(v).cell);
}

// By its corners and crossings v's clipped cell is good: is it bad by another point of the sphere? Then from_input is
// such a point.
template <int D> bool CertificateRule<D>::find_bad_pole(VertexId v, CellView* view) const {
    const Vertex<D>& vertex = store_.vertex(v);
    const double* const input = store_.point(nearest_input(v));
    const double d = square_root(local_distance2(vertex));
    Domain<D> ball = domain_;
    ball.radius += view->blur;
    Corner<D> found(store_.dim);
    const auto is_beyond = [&](double lo) {
        const double most = largest_good(vertex, lo) - view->blur;
        if (!(most > 0 && most * most < cut2_)) return false;
        find_beyond<D>(store_, ball, input, v, most * most, view->cells, &found);
        return !(found.distance2 < 0);
    };
    double lo = 0.5 * d;
    if (is_beyond(lo)) {
        // With a smaller out-radius than d / 2 lo is larger; but poles may be farther away than corners.
        if (vertex.marker == Marker::steiner) {
            if (4 * view->farthest.distance2 < d * d)
                offer_poles(store_, ball, vertex.x, v, store_.list_top(), view->cells, &view->farthest);
            lo = least_distance(d, square_root(view->farthest.distance2) + view->blur, as_computed);
        }
        if (!(lo > 0.5 * d) || is_beyond(lo)) {
            view->from_input = found;
            view->farthest.offer(found.x, distance2<D>(store_.dim, found.x, vertex.x), found.cell);
            return true;
        }
    }
    return false;
}

// Towards the corner that defines hi, or the farthest one; see the header for how far.
template <int D> Verdict CertificateRule<D>::judge(VertexId v, Split<D>* split) {
    CellView view(store_.dim);
    if (!view_cell(v, &view)) return Verdict::out_of_memory;
    if (is_surely_good(v, view)) return Verdict::good;
    const bool leaves = leaves_ball(view);
    if (!leaves || view.blur > 0) {
        view_whole(v, &view);
        if (!is_bad(v, view)) return Verdict::good;
    }
    if (leaves) {
        clip(v, &view);
        if (!is_bad(v, view) && !find_bad_pole(v, &view)) return Verdict::good;
    }
    const double* const p = store_.point(v);
    const Vertex<D>& vertex = store_.vertex(v);
    const double least2 = least_bad2(vertex);
    const Corner<D>* corner = &view.from_input;
    double whole2 = distance2<D>(store_.dim, corner->x, p);
    double level = 0;  // from this fraction of the way on the nearest input is no nearer than from v
    if (whole2 < least2 && bound_at(vertex).ratio2 <= 2) {
        corner = &view.farthest;
        whole2 = distance2<D>(store_.dim, corner->x, p);
    } else if (vertex.marker == Marker::steiner) {
        level = 1 - (distance2<D>(store_.dim, corner->x, store_.point(nearest_input(v))) - local_distance2(vertex)) /
                        whole2;
    }
    // So flat are the cells about v that none of its corners is known: there is nothing to split towards, and the
    // certificate will tell what that costs.
    if (!(whole2 > 0)) return Verdict::good;
    const double wanted2 = overshoot * overshoot * least2;
    double fraction = wanted2 < whole2 ? square_root(wanted2 / whole2) : 1;
    if (fraction < level) fraction = level;
    split->place(p, *corner, fraction);
    if (goal_.clipped && !domain_.contains(split->x)) put_inside(split->x);
    split->empty2 = distance2<D>(store_.dim, split->x, p);
    split->input = nearest_input(v);
    return Verdict::bad;
}

#ifdef NETMESH_VALIDATE
// Some cell of a mesh whose queue is empty is bad beyond all margins.
template <int D> const char* CertificateRule<D>::clipped_violation() {
    if (store_.state.vertex_count > validated_vertices_max) return nullptr;
    for (VertexId v(0); v < store_.state.vertex_count; ++v) {
        const Vertex<D>& vertex = store_.vertex(v);
        CellView view(store_.dim);
        if (!is_in_mesh(store_, v) || vertex.marker == Marker::exempt || !view_cell(v, &view)) continue;
        view_whole(v, &view);
        const bool leaves = leaves_ball(view);
        if (leaves) clip(v, &view);
        const double hi2 = view.from_input.distance2 < cut2_ ? view.from_input.distance2 : cut2_;
        const double d = square_root(local_distance2(vertex)), R = square_root(view.farthest.distance2);
        const double lo = vertex.marker == Marker::input ? 0.5 * d : least_distance(d, R, as_computed);
        const double most = goal_.ratio * goal_.ratio * lo;
        if (hi2 > most * most) return "a cell spoils the certificate and nobody has noticed";
        Corner<D> found(store_.dim);
        if (!leaves || !(most * most < cut2_)) continue;
        find_beyond<D>(store_, domain_, store_.point(nearest_input(v)), v, most * most, view.cells, &found);
        if (!(found.distance2 < 0)) return "a cell spoils the certificate at a pole and nobody has noticed";
    }
    return nullptr;
}
#endif

}  // namespace

template <int D>
Status mesh_by_certificate(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                           const Work& work, AnyMeshResult* result) {
    return mesh_by<D, CertificateRule>(store, points, n, request, work, result);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status mesh_by_certificate<D>(AnyStore&, const InputRows&, std::size_t, const MeshRequest&, const Work&,  \
                                           AnyMeshResult*);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
