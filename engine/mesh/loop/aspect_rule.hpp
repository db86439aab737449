// What rules have in common by which a cell is bad when its clipped aspect ratio is above tau.
#pragma once
#include <cstdint>

#include "mesh/clip/blurred_corners.hpp"
#include "mesh/loop/refinement.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

// What cells are held to while inputs are missing is figures_of().waiting_tau, or tau if that is more. A Steiner point
// that is there before the inputs around it stands where these do not want it: held to tau from the first input on
// meshes of uniform points are larger by 8%, of clusters in space by 30%. In the plane 16 in place of 32 makes those of
// uniform points larger by 1.5%. From three dimensions on sizes are within 3% of one another, and 32 takes more time
// than 16, 7% in three dimensions and 30% in four and five: cells of bad ratio border many others.
//
// It is no matter of size alone. A Steiner point at a distance l = pull_back waiting_tau / 2 nn(v) from its vertex v
// yields to inputs at (1 - yield_radius) l or more from v. Where that is less than nn(v), one input after the other can
// come nearer while the corner that v was split for stays, and ratios grow without bound. In five and six dimensions
// the two are equal but for roundings.
template <int D>
constexpr bool yields_no_nearer = (1 - yield_radius) * (1 + 0x1p-40) * figures<D>.pull_back* figures<D>.waiting_tau >=
                                  2;
#define NETMESH_HOLDS(D) static_assert(yields_no_nearer<D>);
NETMESH_EACH_DIMENSION(NETMESH_HOLDS)
#undef NETMESH_HOLDS

// Then cells are refined by scales, vertices with the nearest neighbours first: nearest distances up to the root of
// this times the least one. Layers of vertices have to grow outwards from all close inputs; where they grow from one
// into what is coarse about the next, meshes of close pairs in space are larger by a third. 16 in place of 2 makes
// meshes of uniform points larger by .7% and saves 2 to 4% of the time a vertex. Within a scale one vertex follows the
// other, each with all that its splits lead to: what is near in space is near in memory.
constexpr double scale_span2 = 2;

// What is refined is the farthest corner of a clipped cell: a Voronoi corner inside the ball that the cell is clipped
// to, or a point where a Voronoi edge crosses its sphere. Where none of these is too far another point of the sphere
// may be, see clipped_cell.hpp: those are looked for when it is a vertex's turn. A new vertex leaves other cells no
// larger than they were, so only those whose nearest neighbour it becomes and its own can become bad.
//
// Where coordinates hardly resolve the distances between vertices, a corner in coordinates is not where it is in truth.
// Let no corner of v's cell be wrong by more than b ("blur"). A point x of the true cell in the ball is a convex
// combination of its corners; the same one of the computed corners is within b of x, so within b of the ball. So the
// true cell clipped to the ball reaches no farther than the computed one, clipped to the ball enlarged by b, and b.
// v is split at a point within b of its true cell when this says that it may reach too far. The new vertex is at least
// tau / 2 nn(v) - 3 b from all others, as far as nn(v) or farther as long as
//
//   (tau / 2 - 1) nn(v) >= 3 b,
//
// or f(v) - 3 b where f(v) is the size asked for. b is less than 2.15 sqrt(D) units in the last place of the largest
// coordinate (keep_sphere: 4.2 u |c|), so the proof of 3.3 holds as soon as distances of inputs and sizes are at least
// 6.5 sqrt(D) (2 / (tau - 2) + 1) units: finest().
//
// `Rule` also has
//
//   bool may_be_bad(double corner2, const Vertex<D>& v)   can a corner at this squared distance from v spoil its cell?
template <int D, class Rule> class AspectRule : public Refinement<D, Rule> {
    using Base = Refinement<D, Rule>;

public:
    AspectRule(Store<D>& store, const MeshRequest& request, const Work& work, MeshResult<D>& result)
        : Base(store, request, work, result), tight_(request.tau * (1 - tau_margin)), tau_(tight_) {}

    // A hair larger than what is promised, so that no corner on the sphere itself depends on roundings.
    double choose_domain() {
        this->domain_.radius = promised_radius() * (1 + tau_margin);
        return figures_of<D>(this->store_.dim).frame_factor * this->domain_.radius;
    }
    double promised_radius() const { return this->domain_.enclosing_radius * this->request_.domain_factor; }
    // From 2^26 units on all corners are known well enough.
    double finest() const { return finest_distance(this->store_.dim, this->request_.tau); }
    // Is v's cell, or that of the cage that waits in its place, judged? By what distance does it wait?
    bool is_judged(VertexId v) const {
        return this->store_.vertex(v).cell != none && this->store_.vertex(v).marker != Marker::exempt;
    }
    double queued_distance2(VertexId v) const { return this->store_.vertex(v).nearest2; }
#ifdef NETMESH_VALIDATE
    const char* clean_violation() const {
        if (!is_held_to_tau()) return nullptr;
        return aspect_violation<D>(this->store_, this->request_.tau, [this](VertexId) { return this->domain_; });
    }
#endif

protected:
    bool is_bad(double corner2, double nearest2) const { return 4 * corner2 > tau_ * tau_ * nearest2; }

    // The squared distance that a corner must be beyond to be bad.
    double least_bad2(const Vertex<D>& vertex) const { return 0.25 * tau_ * tau_ * vertex.nearest2; }
    // The same where sizes are asked for, at most.
    double least_beyond2(const Vertex<D>& vertex) const {
        const double bad2 = least_bad2(vertex), sized2 = this->sizes_.bound2(vertex);
        return sized2 < bad2 ? sized2 : bad2;
    }

    // Positions of those vertices of a new cell whose cells its corner can make bad, as bits.
    unsigned positions_of_bad(const Cell<D>& cell) const {
        unsigned bad = 0;
        for (int i = 0; i <= this->store_.dim; ++i) {
            const Vertex<D>& vertex = this->store_.vertex(cell.vertex[i]);
            if (!this->queue_.has(vertex) && vertex.marker != Marker::exempt && rule().may_be_bad(cell.radius2, vertex))
                bad |= 1u << i;
        }
        return bad;
    }
    void queue_positions(const Cell<D>& cell, unsigned positions) {
        for (int i = 0; i <= this->store_.dim; ++i)
            if (positions >> i & 1u) this->queue_.push(cell.vertex[i]);
    }
    // v has just filled the cavity. Queues it when its cell has a corner outside of the ball that is too far from v, or
    // not known: then some point of the sphere may be too far too.
    [[gnu::noinline]] void queue_new(const Cavity& cavity, const Domain<D>& ball, VertexId v) {
        const Vertex<D>& vertex = this->store_.vertex(v);
        if (this->queue_.has(vertex) || vertex.marker == Marker::exempt) return;
        if (may_be_blurred(vertex)) return this->queue_.push(v);
        for (std::uint32_t k = 0; k < cavity.facets; ++k) {
            const Cell<D>& cell = this->store_.cell(this->kernel_.new_cell(k));
            if (!rule().may_be_bad(cell.radius2, vertex) || (cell.radius2 < infinity && ball.contains(cell.centre)))
                continue;
            this->queue_.push(v);
            return;
        }
    }
    // A point of v's clipped cell that is neither a corner nor on an edge, and farther from v than the root of bound2.
    // distance2 of *found is negative when there is none. Just before, v's star of `count` cells has been visited.
    [[gnu::noinline]] void find_beyond(const Domain<D>& ball, VertexId v, double bound2, std::uint32_t count,
                                       Corner<D>* found) const {
        netmesh::find_beyond<D>(this->store_, ball, this->store_.point(v), v, bound2, count, found);
    }
    // The same beyond what v's cell may have by tau or by the size asked for.
    void find_sized_beyond(const Domain<D>& ball, VertexId v, std::uint32_t count, Corner<D>* found) const {
        const double bad2 = least_bad2(this->store_.vertex(v)), limit2 = this->sizes_.limit2(v);
        find_beyond(ball, v, limit2 < bad2 ? limit2 : bad2, count, found);
    }

    // Can a corner of v's cell be known worse than by corner_error_max because of its coordinates? Then its distance R
    // from v is below 2^-28.8 times their size.
    bool may_be_blurred(const Vertex<D>& vertex) const {
        return vertex.nearest2 < 0x1p-55 * dot<D>(this->store_.dim, vertex.x, vertex.x);
    }
    // v's cell, as computed, is good in the ball: may it be bad in truth? Then *found is a point of the computed cell
    // that is farther from v than what the cell may have, less the blur; otherwise its distance2 is negative. False
    // when the gap is too small for v's star.
    [[gnu::cold, gnu::noinline]] bool find_blurred(const Domain<D>& ball, VertexId v, Corner<D>* found) {
        *found = Corner<D>(this->store_.dim);
        const AnyStore store(this->store_);
        double blur;
        if (!find_blur(store, v, &blur)) return false;
        if (blur == 0) return true;
        const double bad2 = least_bad2(this->store_.vertex(v)), limit2 = this->sizes_.limit2(v);
        const double least = square_root(limit2 < bad2 ? limit2 : bad2);
        // A cell flatter than coordinates make it: its neighbours have about the same corner.
        if (blur > 0.25 * least) blur = 0.25 * least;
        const double least2 = (least - blur) * (least - blur);
        Domain<D> wide = ball;
        wide.radius += blur;
        AnyCorner corner(this->store_.dim);
        const std::uint32_t cells = offer_corners(store, wide, v, &corner);
        *found = corner.of_dimension<D>();
        if (cells > 0 && !(found->distance2 > least2)) find_beyond(wide, v, least2, cells, found);
        return cells > 0;
    }

    // The corner is outside of the ball: which of its edges cross the sphere too far from these vertices? A crossing
    // on an edge from an old outer cell need not be looked at: the edge has only become shorter.
    void queue_bad_crossings(const Domain<D>& ball, const Cell<D>& cell, unsigned positions) {
        for (int i = 0; i <= this->store_.dim; ++i) {
            const unsigned others = positions & ~(1u << i);
            if (others == 0) continue;
            const Cell<D>& behind = this->store_.cell(cell.neighbour[i].cell());
            if (!(behind.radius2 < infinity)) continue;
            double z[2][DimensionOf<D>::most];
            const int crossings = sphere_crossings(ball, cell.centre, behind.centre, z);
            for (int j = 0; j < crossings; ++j)
                for (int k = 0; k <= this->store_.dim; ++k) {
                    const VertexId w = cell.vertex[k];
                    if ((others >> k & 1u) == 0) continue;
                    if (rule().may_be_bad(distance2<D>(this->store_.dim, z[j], this->store_.point(w)),
                                          this->store_.vertex(w)))
                        this->queue_.push(w);
                }
        }
    }

    // Splits the cell of v, or of a cage about v, in the direction of a corner: at most `wanted` away from v.
    void split_towards(VertexId v, const Corner<D>& corner, double wanted, Split<D>* split) const {
        const double* const p = this->store_.point(v);
        const double whole = square_root(corner.distance2);
        split->place(p, corner, wanted < whole ? wanted / whole : 1);
        split->empty2 = distance2<D>(this->store_.dim, split->x, p);
        split->input = this->nearest_input(v);
    }
    // A Steiner point is not put farther from its vertex than this times the distance that makes a corner bad, by D:
    // the cell then loses no more than it must, and meshes get smaller than with whole corners. 1 is the limit of 3.3's
    // proof. Smaller values make more layers of vertices, larger ones more vertices a layer.
    //
    // Any point x of v's clipped cell at tau / 2 nn(v) or more from v would do for the proof: v is nearest to it, so it
    // is as far from all other vertices. Others were measured, and meshes became larger: a point as far away on a
    // Voronoi edge that ends in the corner (off-centres), the mean of the bad corners, the place on the way to one of
    // them that does away with most of them, whole corners that are only a little too far.
    double pull_back() const { return figures_of<D>(this->store_.dim).pull_back; }
    // The distance at which 3.3 puts a Steiner point, for a nearest neighbour this far away.
    double wanted_distance(double nearest, double pull) const { return pull * 0.5 * tau_ * nearest; }

    // For a rule that cleans by scales when all inputs are in.
    void wait_for_inputs() {
        const double waiting_tau = figures_of<D>(this->store_.dim).waiting_tau;
        if (tau_ < waiting_tau) tau_ = waiting_tau;
    }
    void stop_waiting() { tau_ = tight_; }
    // Is no cell put off that is bad?
    bool is_held_to_tau() const { return !(tau_ > tight_) && !this->queue_.puts_off(); }
    // Restores the quality of all cells, which are looked at once, and again as they may become bad by then.
    Status clean_by_scales();

    const double tight_;  // a hair less than the request's
    double tau_;          // what cells are held to

private:
    void put_off(VertexId v) { this->queue_.put_off(v, rule().queued_distance2(v)); }
    Rule& rule() { return static_cast<Rule&>(*this); }
    const Rule& rule() const { return static_cast<const Rule&>(*this); }
};

template <int D, class Rule> Status AspectRule<D, Rule>::clean_by_scales() {
    auto& store = this->store_;
    for (VertexId v(0); v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 10); v < piece; ++v)
            if (rule().is_judged(v)) put_off(v);
    for (double least2; (least2 = this->queue_.take_least_put_off()) < infinity;) {
        const double most2 = scale_span2 * least2;
        this->queue_.set_limit(most2);
        for (VertexId v(0); v < store.state.vertex_count;)
            for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 10); v < piece; ++v) {
                if (!this->queue_.is_put_off(store.vertex(v))) continue;
                if (rule().queued_distance2(v) > most2) {
                    put_off(v);
                    continue;
                }
                rule().requeue(v);
                const Status status = this->clean();
                if (status != Status::ok) return status;
            }
    }
    this->queue_.set_limit(infinity);
    return this->clean();
}

}  // namespace netmesh
