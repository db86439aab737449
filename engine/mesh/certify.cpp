#include "mesh/certify.hpp"

#include "delaunay/load.hpp"
#include "mesh/corner.hpp"
#include "mesh/insertion.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// A Steiner point is put this much farther from its vertex than the nearest corner that can be bad.
constexpr double overshoot = 1.1;

// What R / r of an input's cell is held to, over what the certificate needs; but no less than a tau that is cheap to reach. In between
// a filter value of its own, r, stays nearer to the one that it is given: most of the true error is there. Sets of a hundred points
// asked for 2.25: share 1, true ratio 2.0-2.25; 0.8, 1.6-1.8 and 1.2 times the vertices; 0.6, 1.4 and 1.6 times.
constexpr double input_share = 0.8, input_least = 2.2;

// A ratio asked for, and the K of certify.hpp that goes with it.
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

// While it runs nearest2 of a Steiner vertex is the squared distance to the nearest input.
template <int D> class Certification : public Insertion<D, Certification<D>> {
    using Base = Insertion<D, Certification<D>>;
    friend Base;
    using Base::domain_;
    using Base::inputs_;
    using Base::insert;
    using Base::kernel_;
    using Base::nearest_input;
    using Base::open_at;
    using Base::queue_;
    using Base::store_;
    using Base::tree_;

public:
    Certification(Store<D>& store, const RatioGoal& goal, Monitor& monitor, Domain<D>& domain)
        : Base(store, monitor, domain), goal_(goal), bound_(goal.ratio),
          focus_(goal.focus > 0 && goal.focus < goal.ratio ? goal.focus : goal.ratio) {}

    Status open();
    // invalid_argument: coordinates do not resolve the scales of interest; else as that of Insertion.
    Status check(InputReport* input);

private:
    struct CellView {
        Corner<D> farthest;    // from the vertex
        Corner<D> from_input;  // from the nearest input; `distance2` is to that
    };

    Status split(std::uint32_t v, const CellView& view);
    Status clean();
    bool look(std::uint32_t v, CellView* view);
    bool is_bad(std::uint32_t v, const CellView& view) const;
    void update_star(const Cavity& cavity, std::uint32_t v);
    double least_bad2(const Vertex<D>& vertex) const;
    const Bound& bound_at(const Vertex<D>& vertex) const;

    RatioGoal goal_;
    Bound bound_, focus_;
    double cut2_ = 0;  // squared enclosing radius
};

// A Steiner point comes as near to others as `step` times its distance to the inputs.
template <int D> Status Certification<D>::check(InputReport* input) {
    const Status status = this->check_input(bound_.step < 1 ? resolution / bound_.step : resolution, input);
    if (status != Status::ok || !(goal_.focus > 0)) return status;
    double size = 0;
    for (std::uint32_t v = 0; v < inputs_; ++v)
        for (int k = 0; k < D; ++k)
            if (absolute(store_.point(v)[k]) > size) size = absolute(store_.point(v)[k]);
    return goal_.from * focus_.step < resolution * size ? Status::invalid_argument : Status::ok;
}

template <int D> Status Certification<D>::open() {
    smallest_enclosing_ball<D>(store_, inputs_, domain_);
    domain_.radius = domain_.enclosing_radius;
    cut2_ = domain_.enclosing_radius * domain_.enclosing_radius;
    const double factor = 1.05 * square_root(D) * focus_.extent();  // the smaller a ratio, the larger its extent
    const double reach = domain_.radius * (factor > frame_factor<D> ? factor : frame_factor<D>);
    return open_at(reach);
}

// The bound that may hold for a cell, as far as d_P of its vertex tells: a focused one has d/2 <= lo < to, and from < hi <= c^2 d
// or else it is bad anyhow.
template <int D> const Bound& Certification<D>::bound_at(const Vertex<D>& vertex) const {
    if (!(goal_.focus > 0) || vertex.marker == Marker::input) return bound_;
    const double above = goal_.from / bound_.ratio2, below = 2 * goal_.to;
    return vertex.nearest2 > above * above && vertex.nearest2 < below * below ? focus_ : bound_;
}

// A cell without a corner farther from the vertex than this (squared) is good.
template <int D> double Certification<D>::least_bad2(const Vertex<D>& vertex) const {
    const Bound& bound = bound_at(vertex);
    const bool is_input = vertex.marker == Marker::input;
    const double most =
        is_input ? bound.input : bound.ratio2;  // 2 hi over the root of nearest2, at most, if good for sure
    if (4 * cut2_ <= most * most * vertex.nearest2) return infinity;
    return is_input ? 0.25 * most * most * vertex.nearest2 : bound.reach2 * vertex.nearest2;
}

// A cell may have become bad by a new corner, an input's also because its nearest neighbour came nearer.
template <int D> void Certification<D>::update_star(const Cavity& cavity, std::uint32_t v) {
    Vertex<D>& centre = store_.vertex(v);
    kernel_.visit_neighbours(cavity, VertexId(v), [&](std::uint32_t w) {
        Vertex<D>& other = store_.vertex(w);
        const double d2 = distance2<D>(centre.x, other.x);
        if (centre.marker == Marker::input && d2 < centre.nearest2) centre.nearest2 = d2;
        if (other.marker != Marker::input || !(d2 < other.nearest2)) return;
        other.nearest2 = d2;
        queue_.push(w);
    });
    for (std::uint32_t k = 0; k < cavity.facets; ++k) {
        const Cell<D>& cell = store_.cell(kernel_.new_cell(k));
        if (!(cell.radius2 < infinity)) continue;
        for (const std::uint32_t w : cell.vertex) {
            const Vertex<D>& vertex = store_.vertex(w);
            if (!vertex.queued && vertex.marker != Marker::exempt && cell.radius2 > least_bad2(vertex)) queue_.push(w);
        }
    }
}

// Walks around v's cell. False when the gap is too small for that.
template <int D> bool Certification<D>::look(std::uint32_t v, CellView* view) {
    *view = CellView{};
    const double* const p = store_.point(v);
    const double* const input = store_.point(nearest_input(v));
    return kernel_.visit_star(VertexId(v), [&](CellId c) {
        const Cell<D>& cell = store_.cell(c);
        if (!(cell.radius2 < infinity)) return;  // a ghost
        view->farthest.offer(cell.centre, distance2<D>(cell.centre, p), c);
        view->from_input.offer(cell.centre, distance2<D>(cell.centre, input), c);
    });
}

template <int D> bool Certification<D>::is_bad(std::uint32_t v, const CellView& view) const {
    const Vertex<D>& vertex = store_.vertex(v);
    const double hi = square_root(view.from_input.distance2 < cut2_ ? view.from_input.distance2 : cut2_);
    const double d = square_root(vertex.nearest2);
    if (vertex.marker == Marker::input) return 2 * hi > bound_.input * d;
    const double inner = d - square_root(view.farthest.distance2);
    const double lo = inner > 0.5 * d ? inner : 0.5 * d;
    if (hi > bound_.ratio2 * lo) return true;
    return hi > focus_.ratio2 * lo && hi > goal_.from && lo < goal_.to;
}

// Inserts a Steiner point between v and a corner of its bad cell, or yields to an input near that place.
template <int D> Status Certification<D>::split(std::uint32_t v, const CellView& view) {
    const double* const p = store_.point(v);
    const Vertex<D>& vertex = store_.vertex(v);
    const double least2 = least_bad2(vertex);
    const Corner<D>* corner = &view.from_input;
    double whole2 = distance2<D>(corner->x, p), level = 0;
    if (whole2 < least2 && bound_at(vertex).ratio2 <= 2) {
        corner = &view.farthest;
        whole2 = corner->distance2;
    } else if (vertex.marker == Marker::steiner) {
        level =
            1 - (corner->distance2 - vertex.nearest2) / whole2;  // from there on the nearest input is no nearer than v
    }
    const double wanted2 = overshoot * overshoot * least2;
    double fraction = wanted2 < whole2 ? square_root(wanted2 / whole2) : 1;
    if (fraction < level) fraction = level;
    double x[D];
    for (int k = 0; k < D; ++k) x[k] = p[k] + fraction * (corner->x[k] - p[k]);

    double input2;
    const std::uint32_t near = tree_.nearest(x, nearest_input(v), none, &input2);
    if (input2 < yield_radius * yield_radius * distance2<D>(x, p) && store_.vertex(near).cell == none)
        return insert(near, corner->cell);
    if (!store_.has_room(0, 1, 0)) return Status::out_of_memory;
    const std::uint32_t s = make_vertex<D>(store_, x, near, Marker::steiner);
    store_.vertex(s).nearest2 = input2;
    const Status status = insert(s, corner->cell);
    if (status == Status::out_of_memory) store_.truncate_vertices(s);
    return status;
}

// Brings all cells below what is asked of them.
template <int D> Status Certification<D>::clean() {
    for (;;) {
        const std::uint32_t v = queue_.pop();
        if (v == none) return Status::ok;
        CellView view;
        if (!look(v, &view)) return Status::out_of_memory;
        if (!is_bad(v, view)) continue;
        const Status status = split(v, view);
        if (status != Status::ok) return status;
        queue_.push(v);
    }
}

}  // namespace

template <int D>
Status certify(Store<D>& store, const double* points, std::size_t n, const CertifyOptions& options, Monitor& monitor,
               InputReport* input, Domain<D>* domain) {
    const std::size_t low = store.arena.low_mark();
    std::uint32_t* order;
    Status status = take_input<D>(store, points, n, options.seed, monitor, input, &order);
    if (status != Status::ok) return status;
    Certification<D> certification(store, options.goal, monitor, *domain);
    status = certification.check(input);
    if (status == Status::ok) status = certification.open();
    if (status == Status::ok) status = certification.run(order);
    store.compact((low + Arena::alignment - 1) & ~(Arena::alignment - 1));
    settle_spheres<D>(store);
    measure_edges<D>(store);
    return status;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status certify<D>(Store<D>&, const double*, std::size_t, const CertifyOptions&, Monitor&, InputReport*,   \
                               Domain<D>*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
