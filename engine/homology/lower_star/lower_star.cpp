// Lower-star persistence: the links of all vertices tell degree 0 and the stars where more can happen; a sweep over
// those finds the rest. Of D = 2, where no cycles are wanted, surface.cpp does whole discs, and planar_part.cpp parts
// where no pairs of zero length are wanted.
#include "homology/lower_star/lower_star.hpp"
#include "homology/cycles/cycles.hpp"
#include "homology/lower_star/link.hpp"
#include "homology/lower_star/merge_tree.hpp"
#include "homology/lower_star/planar_part.hpp"
#include "homology/lower_star/surface.hpp"
#include "homology/lower_star/sweep_columns.hpp"
#include "homology/rank.hpp"
#include "memory/arena.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {
namespace {

template <int D> class LowerStars {
public:
    LowerStars(const LowerStarFiltration<D>& filtration, DiagramRequest request, const Work& work)
        : arena_(work.arena), monitor_(work.monitor), writer_(work.arena, request),
          zero_born_count_(filtration.zero_born_count), sweeps_(request.max_degree > 0) {
        ball_.complex = filtration.complex;
        ball_.value = filtration.value;
        ball_.part = filtration.part;
        ball_.vertex_count = ball_.outside = filtration.complex.vertex_count;
    }
    Status run(CycleWriter* cycles = nullptr);
    Status run_with_cycles(std::uint64_t pair_count, CycleStore* store);
    PairList finish() { return writer_.finish_without_cycles(); }
    PairList finish_with_cycles() { return writer_.finish(); }
    std::uint64_t simplex_count() const { return simplex_count_; }

private:
    bool reserve();
    bool reserve_star() {
        if (Link<D>::tells_all(ball_.dim()) && !sweeps_ && !any_large_) return true;
        return star_.reserve(ball_, star_bound_, arena_);
    }
    // Whether lower links in space are enough, where they are small.
    bool sweeps_by_links() const { return D == 3 && !with_cycles_ && !writer_.keeps_zero(); }
    Status classify_in_space(SpaceStar& star, VertexId v, JoinList& joins);
    Status classify_links(JoinList& joins);
    bool classify_small_link(Link<D>& link, VertexId v, JoinList& joins);
    Status classify_stars(JoinList& joins);
    std::uint32_t lowest_neighbour() const;
    bool count_star(VertexId v, const std::uint32_t* counts, bool regular);

    Arena& arena_;
    Monitor& monitor_;
    PairWriter writer_;
    TriangulatedBall<D> ball_;
    Star<D> star_;
    std::uint32_t zero_born_count_;
    bool sweeps_;
    std::uint32_t *below_ = nullptr, *above_ = nullptr, *labels_ = nullptr;
    std::uint64_t star_bound_ = 1, simplex_count_ = 0;
    bool any_large_ = false, with_cycles_ = false;
};

template <int D> bool LowerStars<D>::reserve() {
    const std::uint32_t n = ball_.vertex_count;
    ball_.order = arena_.take_high<std::uint32_t>(n);
    ball_.rank = arena_.take_high<std::uint32_t>(n);
    if (ball_.order == nullptr || ball_.rank == nullptr ||
        !rank_vertices(ball_.value, n, arena_, ball_.order, ball_.rank) || !ball_.list_incidences(arena_)) {
        return false;
    }
    below_ = arena_.take_high<std::uint32_t>(n);
    above_ = arena_.take_high<std::uint32_t>(std::size_t{n} + 1);
    labels_ = arena_.take_high<std::uint32_t>(Link<D>::labels_max(ball_));
    return below_ != nullptr && above_ != nullptr && labels_ != nullptr;
}

// Counts a star; the pairs within a regular one are known from its counts: simplices pair with the next dimension, up
// from the vertex with one edge.
template <int D> bool LowerStars<D>::count_star(VertexId v, const std::uint32_t* counts, bool regular) {
    for (std::uint32_t k = 0; k <= ball_.dim(); ++k) simplex_count_ += counts[k];
    if (!regular) {
        ball_.flags[v] |= TriangulatedBall<D>::irregular;
        return true;
    }
    std::uint32_t paired = 1;
    for (std::uint32_t k = 1; k < ball_.dim() && writer_.keeps_zero(); ++k) {
        paired = counts[k] - paired;
        for (std::uint32_t i = 0; i < paired; ++i) {
            if (!writer_.add(ball_.value[v], ball_.value[v], k)) return false;
        }
    }
    return true;
}

template <int D> bool LowerStars<D>::classify_small_link(Link<D>& link, VertexId v, JoinList& joins) {
    const std::uint32_t pieces = link.lower_pieces();
    if (pieces > 1) {
        std::uint64_t left = link.lower_set();
        while (left != 0) {
            const std::uint32_t u = link.next_piece(ball_, labels_, &left);
            if (u != link.lowest() && !joins.add(ball_.rank[v], u)) return false;
        }
    }
    std::uint32_t counts[DimensionOf<D>::most + 1];
    link.count_simplices(counts);
    bool regular = pieces == 1 && link.upper_pieces() == 1;
    if constexpr (D == 4 || D == any_dimension) {
        if (ball_.dim() == 4) regular = regular && counts[1] + counts[3] == counts[2] + counts[4] + 1;
    }
    return count_star(v, counts, regular);
}

// Of a whole star of few cells. Columns begin only where there are two upper pieces or more.
template <int D> Status LowerStars<D>::classify_in_space(SpaceStar& star, VertexId v, JoinList& joins) {
    if (!star.open(ball_, v, ball_.begin[ball_.vertex_count])) return Status::internal;
    star.close(ball_, v);
    below_[v] = star.lower_count() == 0 ? std::uint32_t{none} : star.lower_vertex(1);
    above_[v] = star.upper_neighbour() == none ? v : star.upper_neighbour();
    for (std::uint32_t i = 1; i < star.lower_pieces(); ++i) {
        if (!joins.add(ball_.rank[v], star.lower_vertex(lowest_bit(star.lower_piece(i))))) return Status::out_of_memory;
    }
    const std::uint32_t counts[DimensionOf<D>::most + 1] = {1, star.lower_count(), star.lower_edges(),
                                                            star.lower_triangles()};
    const std::uint32_t size = counts[0] + counts[1] + counts[2] + counts[3];
    if (size > star_bound_) star_bound_ = size;
    return count_star(v, counts, star.upper_pieces() <= 1) ? Status::ok : Status::out_of_memory;
}

// What it takes of the stack is not there during the sweep, which takes as much.
template <int D> [[gnu::noinline]] Status LowerStars<D>::classify_links(JoinList& joins) {
    Link<D> link(ball_.dim());
    [[maybe_unused]] SpaceStar star;
    monitor_.begin(NETMESH_STAGE_GRADIENT, ball_.vertex_count);
    for (VertexId v(0); v < ball_.vertex_count;)
        for (const std::uint64_t piece = arena_.piece(v, ball_.vertex_count, 10); v < piece; ++v) {
            if (ball_.begin[v] == ball_.begin[v + 1]) return Status::invalid_argument;
            if ((ball_.flags[v] & TriangulatedBall<D>::absent) != 0) {
                below_[v] = above_[v] = ball_.outside;
                continue;
            }
            const bool cut = (ball_.flags[v] & TriangulatedBall<D>::cut) != 0;
            if (monitor_.advance(v, 1 + (ball_.begin[v + 1] - ball_.begin[v]) / 3)) return Status::cancelled;
            if constexpr (D == 3) {
                if (sweeps_by_links() && !cut && SpaceStar::is_small(ball_, v)) {
                    const Status status = classify_in_space(star, v, joins);
                    if (status != Status::ok) return status;
                    continue;
                }
            }
            if (cut && (ball_.flags[v] & TriangulatedBall<D>::on_hull) == 0) {
                link.count(ball_, v);
            } else {
                if (!link.read(ball_, v, labels_)) return Status::internal;
                below_[v] = link.lowest();
                above_[v] = link.highest() == none ? v : link.highest();
            }
            if (link.bound() > star_bound_) star_bound_ = link.bound();
            if (cut) above_[v] = ball_.outside;
            if (Link<D>::tells_all(ball_.dim())) {
                if (cut || !link.small()) {
                    ball_.flags[v] |= TriangulatedBall<D>::large;
                    any_large_ = true;
                } else if (!classify_small_link(link, v, joins)) {
                    return Status::out_of_memory;
                }
            }
        }
    above_[ball_.outside] = ball_.outside;
    return Status::ok;
}

// The lowest of the lower neighbours in the open star, `none` if there are none.
template <int D> std::uint32_t LowerStars<D>::lowest_neighbour() const {
    std::uint32_t best = none;
    for (std::uint32_t i = 1; i < star_.count(); ++i) {
        if (star_.dimension(i) == 1 && (best == none || ball_.rank[star_.vertex(i)] < ball_.rank[best]))
            best = star_.vertex(i);
    }
    return best;
}

// Where Link does not tell enough: lower stars in full.
template <int D> Status LowerStars<D>::classify_stars(JoinList& joins) {
    for (VertexId v(0); v < ball_.vertex_count; ++v) {
        if (Link<D>::tells_all(ball_.dim())) {
            arena_.step(v, 6);
            if ((ball_.flags[v] & TriangulatedBall<D>::large) == 0) continue;
        }
        if ((ball_.flags[v] & TriangulatedBall<D>::absent) != 0) continue;
        if (!star_.open(ball_, v)) return Status::internal;
        if ((ball_.flags[v] & TriangulatedBall<D>::cut) != 0) below_[v] = lowest_neighbour();
        const std::uint32_t first = below_[v] == none ? 0 : star_.piece(ball_.slot[below_[v]]);
        for (std::uint32_t i = 1; i < star_.count(); ++i) {
            if (star_.dimension(i) != 1 || star_.piece(i) != i || i == first) continue;
            if (!joins.add(ball_.rank[v], star_.vertex(i))) return Status::out_of_memory;
        }
        std::uint32_t counts[DimensionOf<D>::most + 1] = {};
        for (std::uint32_t i = 0; i < star_.count(); ++i) ++counts[star_.dimension(i)];
        const bool regular = sweeps_ && star_.match() == 0;
        if (regular) NETMESH_VALIDATE_WHOLE(star_.gradient_violation(0));
        star_.close(ball_);
        if (!count_star(v, counts, regular)) return Status::out_of_memory;
        if (monitor_.advance(v, 1 + 3 * star_.count())) return Status::cancelled;
    }
    return Status::ok;
}

template <int D> Status LowerStars<D>::run(CycleWriter* cycles) {
    with_cycles_ = cycles != nullptr;
    if (!reserve()) return Status::out_of_memory;
    JoinList joins(arena_);
    Status status = classify_links(joins);
    if (status != Status::ok) return status;
    if (!reserve_star()) return Status::out_of_memory;
    {
        const HighScope scope(arena_);
        JoinList large_joins(arena_);
        status = classify_stars(large_joins);
        if (status != Status::ok) return status;
        joins.sort_by_rank();
        large_joins.sort_by_rank();
        const JoinList* const lists[] = {&joins, &large_joins};
        const VertexOrder vertices = {ball_.value, ball_.order, ball_.vertex_count, zero_born_count_};
        if (!join_sublevel(vertices, below_, lists, 2, ball_.rank, writer_, cycles)) return Status::out_of_memory;
    }
    if (!sweeps_) return Status::ok;
    Sweep<D> sweep(ball_, star_, above_, sweeps_by_links(), writer_, cycles, monitor_);
    return sweep.run(arena_);
}

template <int D> Status LowerStars<D>::run_with_cycles(std::uint64_t pair_count, CycleStore* store) {
    if (!writer_.reserve(pair_count)) return Status::out_of_memory;
    CycleWriter cycles(arena_);
    store->begin = cycles.begin();
    return run(&cycles);
}

template <class Stars, int D>
Status persist_with(const LowerStarFiltration<D>& filtration, DiagramRequest request, const Work& work,
                    CountedPairs* out) {
    Stars stars(filtration, request, work);
    const Status status = write_diagram(stars, work.arena, &out->pairs);
    out->simplices = stars.simplex_count();
    return status;
}

template <int D>
Status cycles_with(const LowerStarFiltration<D>& filtration, std::uint32_t max_degree, std::uint64_t pair_count,
                   const Work& work, Representatives* out) {
    ArenaScope scope(work.arena);
    LowerStars<D> stars(filtration, {max_degree}, work);
    const Status status = stars.run_with_cycles(pair_count, &out->store);
    if (status != Status::ok) return status;
    out->pairs = stars.finish_with_cycles();
    scope.keep_low_from_now();
    return Status::ok;
}

// Calls f with the filtration, for D or for all dimensions.
template <int D, class F> Status with_shared(const LowerStarFiltration<D>& filtration, F&& f) {
    if constexpr (shared_dimension<D> == D)
        return f(filtration);
    else
        return f(filtration.template of_dimension<any_dimension>(D).get());
}

}  // namespace

template <int D>
Status persist_lower_star(const LowerStarFiltration<D>& filtration, DiagramRequest request, const Work& work,
                          CountedPairs* out) {
    if (filtration.complex.vertex_count == 0 || filtration.complex.cell_count == 0) return Status::invalid_argument;
    if (request.max_degree > D - 1) request.max_degree = D - 1;
    if constexpr (D == 2) {
        if (!built::certificate || filtration.part == nullptr)
            return persist_with<Surface>(filtration, request, work, out);
        if constexpr (unites_planar_edges) {
            if (!request.keep_zero) return persist_with<PlanarPart>(filtration, request, work, out);
        }
    }
    return with_shared(filtration, [&](const auto& shared) {
        return persist_with<LowerStars<shared_dimension<D>>>(shared, request, work, out);
    });
}

template <int D>
Status lower_star_cycles(const LowerStarFiltration<D>& filtration, std::uint32_t max_degree, std::uint64_t pair_count,
                         const Work& work, Representatives* out) {
    if (filtration.complex.vertex_count == 0 || filtration.complex.cell_count == 0) return Status::invalid_argument;
    if (max_degree > D - 1) max_degree = D - 1;
    return with_shared(filtration,
                       [&](const auto& shared) { return cycles_with(shared, max_degree, pair_count, work, out); });
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status persist_lower_star<D>(const LowerStarFiltration<D>&, DiagramRequest, const Work&, CountedPairs*);  \
    template Status lower_star_cycles<D>(const LowerStarFiltration<D>&, std::uint32_t, std::uint64_t, const Work&,     \
                                         Representatives*);
NETMESH_EACH_INSTANCE(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
