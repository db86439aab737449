// The one loop of every way of meshing: locate, cavity, observers, fill, star, clean.
#pragma once
#include <cstddef>
#include <cstdint>

#include "certificate/cells.hpp"
#include "delaunay/any_kernel.hpp"
#include "delaunay/load.hpp"
#include "memory/work.hpp"
#include "mesh/audit/observers.hpp"
#include "mesh/check/check_growth.hpp"
#include "mesh/loop/bucket_queue.hpp"
#include "mesh/loop/frame.hpp"
#include "mesh/loop/input_order.hpp"
#include "mesh/loop/separation.hpp"
#include "mesh/loop/sizes.hpp"
#include "mesh/loop/split.hpp"
#include "mesh/mesh_request.hpp"

namespace netmesh {

// `Rule` is a class that derives from Refinement<D, Rule> and says which cells are bad and where to split them. It has
// to have
//
//   double choose_domain()                           sets domain_.radius; the distance of the frame from the centre
//   void queue_bad(CellId c)                         queues vertices whose cells new cell c may have made bad
//   Verdict judge(VertexId v, Split<D>* split)       is the cell of v, which was queued, bad, and where is it split?
//   bool must_yield(const Split<D>&, NearestInput)   must a Steiner point give way to that input, not inserted yet?
//
// and may hide, with functions of its own, those below that say "unless the rule knows better". A mesh by some rule is
// made by mesh_by_rule<D, Rule>.
template <int D, class Rule> class Refinement {
public:
    Refinement(Store<D>& store, const MeshRequest& request, const Work& work, MeshResult<D>& result)
        : request_(request), result_(result), store_(store), kernel_(store, corner_error_max, VertexCells::kept),
          monitor_(work.monitor), domain_(result.domain), observers_(request),
          sizes_(store, tree_, request.size, tau_margin) {}

    // The inputs are in the store and nothing else: may they be meshed? Then the domain and the frame around it.
    Status open();
    // Inserts the inputs in the order of their turns and finishes the mesh. order[inputs]: scratch with an audit of
    // location.
    Status run(std::uint32_t* order);
    // The mesh is whole, compact from `low` on.
    Status close(std::size_t low, Status status);

    // What follows holds unless the rule knows better.

    static constexpr bool searches_rings = false;  // is InputTree::farthest_in_ring asked for?
    static constexpr bool heeds_sizes = false;     // does queue_bad heed sizes_?
    // In records of vertices (check_growth.hpp): is `origin` always the nearest input, is `nearest2` of a Steiner
    // vertex to that input, do exempt vertices come and go?
    static constexpr bool notes_nearest_inputs = true, keeps_input_distances = false, makes_shells = false;
    // What the rule keeps at the arena's low end, before anything else; n inputs at most.
    Status reserve(std::size_t) { return Status::ok; }
    // Least distance of inputs over their coordinates.
    double finest() const { return resolution; }
    // Can what is asked for be resolved? The inputs, their tree and the domain are there. invalid_argument.
    Status check_goal() { return Status::ok; }
    // What stands in the mesh before the first input has its turn.
    Status begin() { return Status::ok; }
    // Input p has its turn: it is inserted and the quality of all cells restored.
    Status take_turn(VertexId p) {
        const Status status = rule().insert_input(p, observers_.start_for(store_.state, p), false);
        return status == Status::ok ? clean() : status;
    }
    // Inserts input p; `cleaning`: as a Steiner point yields to it.
    Status insert_input(VertexId p, CellId from, bool cleaning) {
        const Status status = insert(p, from);
        return status == Status::ok ? finish_step(p, cleaning) : status;
    }
    // Distances kept with vertices and the like, when v has just filled the cavity.
    void update_distances(const Cavity& cavity, VertexId v) { update_nearest(cavity, v); }
    // Queues v, which has just filled the cavity, where queue_bad cannot tell from single cells that its own is bad.
    void queue_new(const Cavity&, VertexId) {}
    // The input that a Steiner point yields to, none when it need not; then *nearest is its nearest input.
    VertexId yields_to(const Split<D>& split, NearestInput* nearest) const {
        nearest->input = VertexId(tree_.nearest(split.x, split.input, none, &nearest->distance2));
        const bool yields = store_.vertex(nearest->input).cell == none && rule().must_yield(split, *nearest);
        return yields ? nearest->input : VertexId(none);
    }
    // The record of a new Steiner point is there, its insertion follows.
    void note_steiner(VertexId, const NearestInput&) {}
    // After each vertex inserted but for those of shells and nets.
    Status after_step() { return Status::ok; }
    // The cell judged bad under v's name has been split: it is queued again.
    void requeue(VertexId v) { queue_.push(v); }
    // All inputs are in and clean.
    Status finish_mesh() { return Status::ok; }
    // Cages that there are or were; null: the rule makes none.
    Hierarchy<D>* hierarchy() { return nullptr; }
    // What the rule leaves at the low end: the offset where the mesh begins.
    std::size_t keep_results(std::size_t low) { return low; }
    // Makes vertex.nearest2 what it is called, when the rule has kept something else there. Whether the run ended well
    // or not.
    void restore_distances() {}
    // The radius that is promised for the domain, without the margin.
    double promised_radius() const { return domain_.radius; }
#ifdef NETMESH_VALIDATE
    // What is wrong with all that the rule keeps, after a step; what is bad although the queue is empty.
    const char* step_violation() const { return nullptr; }
    const char* clean_violation() const { return nullptr; }
#endif

protected:
    // Inserts vertex v, whose record is complete, near cell `from`. Nothing has changed when memory runs out.
    Status insert(VertexId v, CellId from) {
        Cavity cavity;
        return find_cavity(v, from, &cavity) ? fill(v, cavity) : Status::out_of_memory;
    }
    bool find_cavity(VertexId v, CellId from, Cavity* cavity) {
        const double* const q = store_.point(v);
        return kernel_.find_cavity(q, v, kernel_.locate(q, v, from), cavity);
    }
    // The vertex nearest to p, which is one of the cells in conflict. Those are finite, as the frame's hull contains
    // the domain.
    VertexId nearest_in_conflict(VertexId p, const Cavity& cavity) {
        VertexId nearest = none;
        double best2 = infinity;
        const auto look = [&](VertexId w) {
            ++passed_;
            const double d2 = distance2<D>(store_.dim, store_.point(p), store_.point(w));
            if (!(d2 < best2)) return;
            best2 = d2;
            nearest = w;
        };
        visit_cavity_vertices(kernel_, store_, cavity, look);
        return nearest;
    }
    Status fill(VertexId v, const Cavity& cavity);
    void update_nearest(const Cavity& cavity, VertexId v);
    Status finish_step(VertexId v, bool cleaning);
    Status clean();
    Status yielding_insert(const Split<D>& split);

#ifdef NETMESH_VALIDATE
    const char* insertion_violation() const {
        const GrowthFacts facts = {inputs_, inserted_, Rule::notes_nearest_inputs, Rule::keeps_input_distances,
                                   Rule::makes_shells};
        const char* const violation = growth_violation<D>(store_, facts);
        return violation == nullptr && store_.state.vertex_count <= validated_vertices_max ? queue_.violation()
                                                                                           : violation;
    }
#endif

    VertexId nearest_input(VertexId v) const { return VertexId(netmesh::nearest_input(store_, v)); }

    const MeshRequest& request_;
    MeshResult<D>& result_;
    Store<D>& store_;
    Kernel<D> kernel_;
    Monitor& monitor_;
    Domain<D>& domain_;
    InputTree<D> tree_;
    BucketQueue<D> queue_;
    Observers observers_;
    Sizes<D> sizes_;
    std::uint32_t inputs_ = 0, inserted_ = 0;
    std::uint64_t passed_ = 0;  // LocationCounts::passed without the cells that the kernel counts
    std::uint64_t last_ = 0;    // LocationCounts::last

private:
    Status reach_sizes();
    Status note_size(VertexId v);
    Rule& rule() { return static_cast<Rule&>(*this); }
    const Rule& rule() const { return static_cast<const Rule&>(*this); }
};

template <int D, class Rule> Status Refinement<D, Rule>::open() {
    inputs_ = store_.state.vertex_count;
    Status status = tree_.build(store_, store_.arena, inputs_, Rule::searches_rings);
    if (status == Status::ok) status = check_separation(store_, tree_, rule().finest(), &result_.input);
    if (status != Status::ok) return status;
    smallest_enclosing_ball<D>(store_, inputs_, domain_);
    const double reach = rule().choose_domain();
    status = rule().check_goal();
    if (status != Status::ok) return status;
    // Squared distances are measured down from that of the frame.
    if (queue_.open(store_, store_.arena, 16 * reach * reach) != Status::ok) return Status::out_of_memory;
    if (observers_.open(store_.dim, store_.arena, inputs_) != Status::ok) return Status::out_of_memory;
    if (store_.open_cells() != Status::ok) return Status::out_of_memory;
    status = open_frame(store_, tree_, domain_, reach, &passed_);
    return status == Status::ok ? observers_.start(store_) : status;
}

template <int D, class Rule> Status Refinement<D, Rule>::run(std::uint32_t* order) {
    monitor_.begin(NETMESH_STAGE_REFINE, inputs_);
    Status status = rule().begin();
    InputOrder turns(store_, observers_.lists(), order, inputs_, request_.seed, &result_.audit.location);
    while (status == Status::ok) {
        const VertexId input = turns.next();
        if (input == none) break;
        status = rule().take_turn(input);
    }
    if (status == Status::ok) status = rule().finish_mesh();
    if (Rule::heeds_sizes && sizes_.are_asked() && status == Status::ok) status = reach_sizes();
    return status == Status::cancelled && observers_.lists_are_full() ? Status::out_of_memory : status;
}

template <int D, class Rule> Status Refinement<D, Rule>::close(std::size_t low, Status status) {
    observers_.report(&result_.audit);
    low = rule().keep_results(low);
    result_.location = {tree_.touches(), observers_.list_looks(), kernel_.steps() + passed_, last_};
    store_.compact((low + Arena::alignment - 1) & ~(Arena::alignment - 1));
    recompute_balls<D>(store_);
    rule().restore_distances();
    domain_.radius = rule().promised_radius();
    return status;
}

template <int D, class Rule> Status Refinement<D, Rule>::fill(VertexId v, const Cavity& cavity) {
    if (!kernel_.can_fill(cavity, 0)) return Status::out_of_memory;
    if (observers_.locates() && !observers_.before_fill(store_, cavity, v)) return Status::internal;
    kernel_.fill(cavity, v);
    // Of thousands of facets, about a hull or a shell; in the plane and in space there are not that many.
    constexpr bool may_be_large = D == any_dimension || D > 3;
    if (may_be_large) monitor_.pass(cavity.facets / 2);
    if (store_.vertex(v).marker == Marker::input) ++inserted_;
    rule().update_distances(cavity, v);
    for (std::uint32_t k = 0; k < cavity.facets; ++k) {
        if (may_be_large && k % 256 == 255) monitor_.pass(800);
        rule().queue_bad(kernel_.new_cell(k));
    }
    rule().queue_new(cavity, v);
    NETMESH_VALIDATE_WHOLE(insertion_violation());
    // The mesh is whole, only the lists are not: the job stops as if it had been asked to.
    if (observers_.locates() && !observers_.after_fill(store_, cavity, v)) return Status::cancelled;
    monitor_.mesh_size(store_.state.vertex_count - inputs_ + inserted_, store_.live_cells());
    return monitor_.advance(inserted_, 4 + 4 * cavity.facets) ? Status::cancelled : Status::ok;
}

// nearest2 of v and of its neighbours. Those to which it is nearer than any vertex before may have become bad and are
// queued.
template <int D, class Rule> void Refinement<D, Rule>::update_nearest(const Cavity& cavity, VertexId v) {
    auto&& centre = store_.vertex(v);
    kernel_.visit_neighbours(cavity, v, [&](VertexId w) {
        auto&& other = store_.vertex(w);
        const double d2 = distance2<D>(store_.dim, centre.x, other.x);
        if (d2 < centre.nearest2) centre.nearest2 = d2;
        if (!(d2 < other.nearest2)) return;
        other.nearest2 = d2;
        if (other.marker != Marker::exempt) queue_.push(w);
    });
}

template <int D, class Rule> Status Refinement<D, Rule>::finish_step(VertexId v, bool cleaning) {
    const Status status = rule().after_step();
    if (status == Status::ok) NETMESH_VALIDATE_WHOLE(rule().step_violation());
    if (status != Status::ok || !observers_.measures()) return status;
    return observers_.measure(store_, tree_, rule().hierarchy(), domain_, v, cleaning);
}

// Restores the quality of all cells.
template <int D, class Rule> Status Refinement<D, Rule>::clean() {
    for (;;) {
        const VertexId v = queue_.pop();
        if (v == none) NETMESH_VALIDATE_WHOLE(rule().clean_violation());
        if (v == none) return Status::ok;
        Split<D> split;
        const Verdict verdict = rule().judge(v, &split);
        if (verdict == Verdict::good) {
            if (monitor_.advance(inserted_, 5 * store_.dim)) return Status::cancelled;
            continue;
        }
        if (verdict == Verdict::out_of_memory) return Status::out_of_memory;
        const Status status = yielding_insert(split);
        if (status != Status::ok) return status;
        rule().requeue(v);
    }
}

// YieldingInsert (4.4): a Steiner point, or the input that it yields to.
template <int D, class Rule> Status Refinement<D, Rule>::yielding_insert(const Split<D>& split) {
    NearestInput nearest;
    const VertexId input = rule().yields_to(split, &nearest);
    if (input != none) return rule().insert_input(input, split.cell, true);
    if (!store_.has_room(0, 1, 0)) return Status::out_of_memory;
    const VertexId v = make_vertex<D>(store_, split.x, nearest.input, Marker::steiner);
    rule().note_steiner(v, nearest);
    const bool sized = Rule::heeds_sizes && sizes_.have_started();
    Status status = sized ? note_size(v) : Status::ok;
    if (status == Status::ok) status = insert(v, split.cell);
    if (status == Status::out_of_memory || status == Status::invalid_argument)
        store_.truncate_vertices(v);
    else if (sized)
        queue_.push(v);
    return status == Status::ok ? finish_step(v, true) : status;
}

template <int D, class Rule> [[gnu::cold]] Status Refinement<D, Rule>::note_size(VertexId v) {
    const Status status = sizes_.note(v, rule().finest());
    if (status != Status::ok) result_.input.row_a = store_.vertex(nearest_input(v)).origin;
    return status;
}

// Over-refinement, when all inputs are in: everything is looked at once more.
template <int D, class Rule> [[gnu::cold]] Status Refinement<D, Rule>::reach_sizes() {
    const std::uint32_t count = store_.state.vertex_count;
    observers_.stop_measuring_features();
    sizes_.start();
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = store_.arena.piece(v, count, 500 * store_.dim); v < piece; ++v) {
            if (store_.vertex(v).marker == Marker::exempt) continue;
            const Status status = note_size(v);
            if (status != Status::ok) return status;
            queue_.push(v);
        }
    return clean();
}

template <int D, class Rule>
Status mesh_by_rule(Store<D>& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                    const Work& work, MeshResult<D>* result) {
    *result = MeshResult<D>{};
    const std::size_t low = store.arena.low_mark();
    Rule rule(store, request, work, *result);
    Status status = rule.reserve(n);
    std::uint32_t* order;
    if (status == Status::ok) status = take_input(store, points, n, request.seed, work.monitor, &result->input, &order);
    if (status != Status::ok) return status;
    status = rule.open();
    if (status == Status::ok) status = rule.run(order);
    status = rule.close(low, status);
    return status == Status::ok && work.monitor.has_stopped() ? Status::cancelled : status;
}

// What mesh_points does for one method, where D is the dimension of the store: by a rule for D alone or for any.
template <int D, template <int> class Rule, int E = shared_dimension<D>>
Status mesh_by(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request, const Work& work,
               AnyMeshResult* result) {
    if constexpr (E == any_dimension) {
        return mesh_by_rule<E, Rule<E>>(store, points, n, request, work, result);
    } else {
        Store<D> own = store.of_dimension<D>();
        MeshResult<D> made;
        const Status status = mesh_by_rule<D, Rule<D>>(own, points, n, request, work, &made);
        *result = made.template of_dimension<any_dimension>();
        return status;
    }
}

}  // namespace netmesh
