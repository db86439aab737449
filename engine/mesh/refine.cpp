#include "mesh/refine.hpp"

#include "mesh/corner.hpp"
#include "mesh/insertion.hpp"
#include "mesh/nearest.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

template <int D> class Refinement : public Insertion<D, Refinement<D>> {
    using Base = Insertion<D, Refinement<D>>;
    friend Base;
    using Base::domain_;
    using Base::inputs_;
    using Base::insert;
    using Base::kernel_;
    using Base::monitor_;
    using Base::nearest_input;
    using Base::open_at;
    using Base::queue_;
    using Base::store_;
    using Base::tree_;

public:
    Refinement(Store<D>& store, const RefineOptions& options, Monitor& monitor, Domain<D>& domain)
        : Base(store, monitor, domain), tau_(options.tau * (1 - tau_margin)),
          certify_(options.certify && !options.reference), reference_(options.reference), rule_(options.size) {}

    Status open(const RefineOptions& options);
    Status open_net();
    Status run_reference(const std::uint32_t* order);
    Status reach_sizes(InputReport* input);

private:
    struct CellView {
        Corner<D> clipped;  // farthest corner of the clipped cell
        Corner<D> whole;    // farthest corner of the whole cell
        double reach2;      // squared distance from the nearest input to the farthest corner from it
    };

    Status split(std::uint32_t v, const Corner<D>& corner);
    bool must_yield(const double* x, double empty2, std::uint32_t near, double input2) const;
    Status clean();
    bool look(std::uint32_t v, CellView* view);
    const Corner<D>* bad_corner(std::uint32_t v, const CellView& view) const;
    void update_star(const Cavity& cavity, std::uint32_t v);
    void queue_bad_vertices(std::uint32_t c);
    bool may_spoil_certificate(std::uint32_t v, const double* x) const;
    bool is_bad(double corner2, double nearest2) const { return 4 * corner2 > tau_ * tau_ * nearest2; }
    // Is a corner bad or, as far as the vertex's hint knows, farther than the size asked for?
    bool may_be_bad(double corner2, const Vertex<D>& vertex) const {
        return is_bad(corner2, vertex.nearest2) || (sized_ && corner2 > value_of_size_hint(vertex.size_hint));
    }
    bool is_oversize(std::uint32_t v, double corner2) const;
    Status note_size(std::uint32_t v);
    bool look_at_poles(std::uint32_t v, CellView* view);

    double tau_;
    bool certify_, reference_;
    SizeRule rule_;
    bool sized_ = false;            // sizes are asked for by now
    std::uint32_t refused_ = none;  // row of the input nearest to the vertex whose size is refused
};

template <int D> Status Refinement<D>::open(const RefineOptions& options) {
    smallest_enclosing_ball<D>(store_, inputs_, domain_);
    // A hair larger than what is promised, so that no corner on the sphere itself depends on roundings.
    domain_.radius = domain_.enclosing_radius * options.domain_factor * (1 + tau_margin);
    double reach = frame_factor<D> * domain_.radius;
    if (reference_) {
        const double k = 2 * options.tau / (options.tau - 2);
        reach = domain_.radius = (k * square_root(2) + 2) * 2 * domain_.enclosing_radius;
    }
    return open_at(reach);
}

// The boundary net: with an input inside, each cell joins it to a facet of the net's hull, and the point of the sphere
// farthest from the facet's vertices, which is where the line from the centre through the cell's corner meets the sphere, is
// inserted while it is farther than delta.
template <int D> Status Refinement<D>::open_net() {
    const double delta2 = 4 * domain_.enclosing_radius * domain_.enclosing_radius;
    Status status = insert(0, store_.state.last_cell);
    for (bool covered = false; !covered && status == Status::ok;) {
        covered = true;
        for (std::uint32_t c = 0; c < store_.state.cell_slots && status == Status::ok; ++c) {
            if (!store_.is_live(c) || store_.is_ghost(c) || !(store_.cell(c).radius2 < infinity)) continue;
            const Cell<D>& cell = store_.cell(c);
            const std::uint32_t w = cell.vertex[cell.vertex[0] == 0 ? 1 : 0];
            const double length = square_root(domain_.distance2(cell.centre));
            if (!(length > 0)) continue;
            double z[D];
            for (int k = 0; k < D; ++k)
                z[k] = domain_.centre[k] + domain_.radius / length * (cell.centre[k] - domain_.centre[k]);
            if (!(distance2<D>(z, store_.point(w)) > delta2)) continue;
            double d2;
            if (!store_.has_room(0, 1, 0)) return Status::out_of_memory;
            const std::uint32_t v = make_vertex<D>(store_, z, tree_.nearest(z, 0, none, &d2), Marker::exempt);
            status = insert(v, c);
            if (status == Status::out_of_memory) store_.truncate_vertices(v);
            covered = false;
        }
    }
    return status;
}

// Nearest-neighbour distances around the new vertex v, and the queue: a vertex may have become bad when its nearest
// neighbour came nearer, or because of a new corner.
template <int D> void Refinement<D>::update_star(const Cavity& cavity, std::uint32_t v) {
    update_nearest<D>(store_, kernel_, cavity, v, queue_);
    for (std::uint32_t k = 0; k < cavity.facets; ++k) queue_bad_vertices(kernel_.new_cell(k));
}

// Queues the vertices that the new cell c makes bad. A crossing on an edge from an old outer cell need not be looked at:
// the edge has only become shorter.
template <int D> void Refinement<D>::queue_bad_vertices(std::uint32_t c) {
    const Cell<D>& cell = store_.cell(c);
    if (!(cell.radius2 < infinity)) return;
    unsigned far = 0;  // positions of the vertices for which this corner is far
    for (int i = 0; i <= D; ++i) {
        const Vertex<D>& vertex = store_.vertex(cell.vertex[i]);
        if (!vertex.queued && vertex.marker != Marker::exempt && may_be_bad(cell.radius2, vertex)) far |= 1u << i;
    }
    if (far == 0) return;
    if (domain_.contains(cell.centre)) {
        for (int i = 0; i <= D; ++i)
            if (far >> i & 1u) queue_.push(cell.vertex[i]);
        return;
    }
    if (certify_)
        for (int i = 0; i <= D; ++i)
            if ((far >> i & 1u) && may_spoil_certificate(cell.vertex[i], cell.centre)) {
                queue_.push(cell.vertex[i]);
                far &= ~(1u << i);
            }
    for (int i = 0; i <= D; ++i) {
        const unsigned others = far & ~(1u << i);
        if (others == 0) continue;
        const CellId n = cell.neighbour[i].cell();
        if (!(store_.cell(n).radius2 < infinity)) continue;
        double z[2][D];
        const int crossings = sphere_crossings<D>(domain_, cell.centre, store_.cell(n).centre, z);
        for (int j = 0; j < crossings; ++j)
            for (int k = 0; k <= D; ++k) {
                const std::uint32_t w = cell.vertex[k];
                if ((others >> k & 1u) && may_be_bad(distance2<D>(z[j], store_.point(w)), store_.vertex(w)))
                    queue_.push(w);
            }
    }
}

// Could a corner at x of v's cell spoil the certificate? As lo is at least half of d_P(v), a necessary condition that
// needs no walk around v.
template <int D> bool Refinement<D>::may_spoil_certificate(std::uint32_t v, const double* x) const {
    const double* const input = store_.point(nearest_input(v));
    const double reach2 = distance2<D>(x, input), rho = domain_.enclosing_radius;
    const double hi2 = reach2 < rho * rho ? reach2 : rho * rho;
    if (store_.vertex(v).marker == Marker::input) return 4 * hi2 > tau_ * tau_ * store_.vertex(v).nearest2;
    return 4 * hi2 > (2 + tau_) * (2 + tau_) * distance2<D>(store_.point(v), input);
}

// Walks around v's cell. False when the gap is too small for that.
template <int D> bool Refinement<D>::look(std::uint32_t v, CellView* view) {
    *view = CellView{};
    double least2 = 0.25 * tau_ * tau_ * store_.vertex(v).nearest2;  // a corner that cannot be bad does not matter
    if (sized_ && value_of_size_hint(store_.vertex(v).size_hint) < least2)
        least2 = value_of_size_hint(store_.vertex(v).size_hint);
    const double* const p = store_.point(v);
    const double* const input = store_.point(nearest_input(v));
    return kernel_.visit_star(VertexId(v), [&](CellId c) {
        const Cell<D>& cell = store_.cell(c);
        if (!(cell.radius2 < infinity)) return;  // a ghost, or so flat that its corner is not known
        const double d2 = distance2<D>(cell.centre, p);
        if (domain_.contains(cell.centre))
            view->clipped.offer(cell.centre, d2, c);
        else
            offer_crossings<D>(store_, domain_, v, c, least2, &view->clipped);
        if (!certify_) return;
        view->whole.offer(cell.centre, d2, c);
        const double reach2 = distance2<D>(cell.centre, input);
        if (reach2 > view->reach2) view->reach2 = reach2;
    });
}

// The corner to refine, null when the cell is good.
template <int D> const Corner<D>* Refinement<D>::bad_corner(std::uint32_t v, const CellView& view) const {
    const double nearest2 = store_.vertex(v).nearest2;
    if (is_bad(view.clipped.distance2, nearest2) || is_oversize(v, view.clipped.distance2)) return &view.clipped;
    if (!certify_ || !is_bad(view.whole.distance2, nearest2)) return nullptr;
    const double rho = domain_.enclosing_radius, reach = square_root(view.reach2);
    const double hi = reach < rho ? reach : rho;
    if (store_.vertex(v).marker == Marker::input) return 2 * hi > tau_ * square_root(nearest2) ? &view.whole : nullptr;
    const double d = square_root(distance2<D>(store_.point(v), store_.point(nearest_input(v))));
    const double inner = d - square_root(view.whole.distance2);
    const double lo = inner > 0.5 * d ? inner : 0.5 * d;
    return hi > (2 + tau_) * lo || hi > tau_ * d ? &view.whole : nullptr;
}

// Must a Steiner point at x, with an empty ball of this squared radius, give way to its nearest input, not inserted yet?
template <int D>
bool Refinement<D>::must_yield(const double* x, double empty2, std::uint32_t near, double input2) const {
    if (input2 < yield_radius * yield_radius * empty2 || !(input2 < empty2)) return input2 < empty2;
    double second2;  // f_P(x) squared
    tree_.nearest(x, none, near, &second2);
    return (tau_ - 2) * (tau_ - 2) * second2 > (tau_ + 2) * (tau_ + 2) * input2;
}

// Inserts a Steiner point between v and a bad corner of its cell, or yields to an input near that place.
template <int D> Status Refinement<D>::split(std::uint32_t v, const Corner<D>& corner) {
    const double nearest2 = store_.vertex(v).nearest2;
    const double wanted = reference_ ? infinity : pull_back<D> * 0.5 * tau_ * square_root(nearest2);
    const double whole = square_root(corner.distance2);
    const double fraction = wanted < whole ? wanted / whole : 1;
    const double* const p = store_.point(v);
    double x[D];
    for (int k = 0; k < D; ++k) x[k] = p[k] + fraction * (corner.x[k] - p[k]);
    const double empty2 = distance2<D>(x, p);

    double input2;
    const std::uint32_t near = tree_.nearest(x, nearest_input(v), none, &input2);
    if (store_.vertex(near).cell == none && must_yield(x, empty2, near, input2)) return insert(near, corner.cell);
    if (!store_.has_room(0, 1, 0)) return Status::out_of_memory;
    const std::uint32_t s = make_vertex<D>(store_, x, near, Marker::steiner);
    Status status = sized_ ? note_size(s) : Status::ok;
    if (status == Status::ok) status = insert(s, corner.cell);
    if (status == Status::out_of_memory || status == Status::invalid_argument)
        store_.truncate_vertices(s);
    else if (sized_)
        queue_.push(s);
    return status;
}

// Restores the quality of all cells.
template <int D> Status Refinement<D>::clean() {
    for (;;) {
        const std::uint32_t v = queue_.pop();
        if (v == none) return Status::ok;
        CellView view;
        if (!look(v, &view)) return Status::out_of_memory;
        if (sized_ && view.clipped.distance2 < 0 && !look_at_poles(v, &view)) return Status::out_of_memory;
        const Corner<D>* const corner = bad_corner(v, view);
        if (corner == nullptr) continue;
        const Status status = split(v, *corner);
        if (status != Status::ok) return status;
        queue_.push(v);
    }
}

template <int D> Status Refinement<D>::run_reference(const std::uint32_t* order) {
    monitor_.begin(NETMESH_STAGE_REFINE, inputs_);
    Status status = open_net();
    for (std::uint32_t k = 0; k < inputs_ && status == Status::ok; ++k)
        if (store_.vertex(order[k]).cell == none) status = insert(order[k], store_.state.last_cell);
    return status == Status::ok ? clean() : status;
}

// Is a corner of v's cell farther than the size asked for?
template <int D> bool Refinement<D>::is_oversize(std::uint32_t v, double corner2) const {
    if (!sized_ || !(corner2 > value_of_size_hint(store_.vertex(v).size_hint))) return false;
    const double size = wanted_size<D>(store_, tree_, rule_, v) * (1 - tau_margin);
    return corner2 > size * size;
}

// The farthest point of a clipped cell without corners; no Voronoi edge meets the domain there.
template <int D> bool Refinement<D>::look_at_poles(std::uint32_t v, CellView* view) {
    std::uint32_t count = 0;
    if (!kernel_.visit_star(VertexId(v), [&](CellId) { ++count; })) return false;
    Corner<D>& corner = view->clipped;
    corner.distance2 = farthest_pole<D>(store_, domain_, v, store_.list_top(), count, corner.x, &corner.cell);
    return true;
}

// Evaluates the size rule at v for the first time.
template <int D> Status Refinement<D>::note_size(std::uint32_t v) {
    const double size = wanted_size<D>(store_, tree_, rule_, v);
    double magnitude = 0;
    for (int k = 0; k < D; ++k)
        if (absolute(store_.point(v)[k]) > magnitude) magnitude = absolute(store_.point(v)[k]);
    if (!(size >= separation_min && size >= resolution * magnitude)) {
        refused_ = store_.vertex(nearest_input(v)).origin;
        return Status::invalid_argument;
    }
    store_.vertex(v).size_hint = size_hint_of((1 - 2 * tau_margin) * (size < coordinate_max ? size * size : infinity));
    return Status::ok;
}

// Over-refinement, when all inputs are in: everything is looked at once more.
template <int D> Status Refinement<D>::reach_sizes(InputReport* input) {
    if (!rule_.asks()) return Status::ok;
    const std::uint32_t count = store_.state.vertex_count;
    sized_ = true;
    Status status = Status::ok;
    for (std::uint32_t v = 0; v < count && status == Status::ok; ++v) {
        if (store_.vertex(v).marker == Marker::exempt) continue;
        status = note_size(v);
        queue_.push(v);
    }
    if (status == Status::ok) status = clean();
    if (status == Status::invalid_argument) input->row_a = refused_;
    return status;
}

}  // namespace

template <int D>
Status refine(Store<D>& store, const double* points, std::size_t n, const RefineOptions& options, Monitor& monitor,
              InputReport* input, Domain<D>* domain) {
    const std::size_t low = store.arena.low_mark();
    std::uint32_t* order;
    Status status = take_input<D>(store, points, n, options.seed, monitor, input, &order);
    if (status != Status::ok) return status;
    Refinement<D> refinement(store, options, monitor, *domain);
    status = refinement.check_input(resolution, input);
    if (status == Status::ok) status = refinement.open(options);
    if (status == Status::ok) status = options.reference ? refinement.run_reference(order) : refinement.run(order);
    if (status == Status::ok) status = refinement.reach_sizes(input);
    store.compact((low + Arena::alignment - 1) & ~(Arena::alignment - 1));
    settle_spheres<D>(store);
    if (!options.reference) domain->radius = domain->enclosing_radius * options.domain_factor;
    return status;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status refine<D>(Store<D>&, const double*, std::size_t, const RefineOptions&, Monitor&, InputReport*,     \
                              Domain<D>*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
