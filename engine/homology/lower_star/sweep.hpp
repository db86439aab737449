// Degrees 1 to D-1 by one sweep over lower stars from the last to the first. Only stars where something can happen are
// visited: irregular ones, whose lower link is not contractible as far as is known, and those where a column waits.
//
// A column is what is left of the boundary of a critical simplex while it is reduced. In a star the columns are
// reduced from the top dimension down. A critical k-simplex that no (k+1)-column has taken as its pivot by then never
// will be one: it ends a class and starts a column. To a column are added boundaries of the gradient's pairs and
// columns whose pivots it meets, which are older, until it takes a pivot of its own, in this star or in a later one.
// What it holds besides its pivot's star is dropped then, since no younger column can need it in another star. For k =
// D columns are components of cells (cell_components.hpp).
//
// Simplices that end a class are no pivots, and a column leaves them out. When cycles are wanted it does not: then it
// is a boundary at all times, whose last simplex always gives birth, and a cycle of its pair when it takes its pivot.
//
// This is not the loop of matrix/reduction.hpp: columns are not reduced one after the other but all of them star by
// star, and a column stops at each star that holds a part of it.
#pragma once
#include "homology/lower_star/cell_components.hpp"
#include "homology/lower_star/front.hpp"
#include "homology/lower_star/space_star.hpp"
#include "homology/lower_star/star.hpp"
#include "homology/lower_star/star_cycles.hpp"
#include "homology/lower_star/triangulated_ball.hpp"
#include "homology/pair_writer.hpp"
#include "memory/prefetch.hpp"
#include "numerics/sort.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {

// Ranks of a facet's vertices, the largest first, and the order in which later ones come first. They know no
// dimension of space, so that their sort stands once in the program.
template <std::uint32_t N> struct FacetRanks { std::uint32_t rank[N]; };
struct LaterRanks {
    template <std::uint32_t N> bool operator()(const FacetRanks<N>& a, const FacetRanks<N>& b) const {
        for (std::uint32_t j = 0; j + 1 < N; ++j) {
            if (a.rank[j] != b.rank[j]) return a.rank[j] > b.rank[j];
        }
        return a.rank[N - 1] > b.rank[N - 1];
    }
};

template <int D> class Sweep {
public:
    // above[vertex_count + 1]: for each vertex a higher vertex of its link or `outside`, itself if there is none.
    // by_links: whether small stars in space are swept by their links; no cycles then, and no pairs of zero length.
    // cycles: null when none are wanted.
    Sweep(const TriangulatedBall<D>& ball, Star<D>& star, std::uint32_t* above, bool by_links, PairWriter& writer,
          CycleWriter* cycles, Monitor& monitor)
        : ball_(ball), star_(star), above_(above), by_links_(by_links), writer_(writer), monitor_(monitor),
          cycles_(cycles), star_cycles_(ball, star, front_, cycles, monitor),
          components_(ball, star, above, writer, cycles == nullptr ? nullptr : &star_cycles_) {}

    // Needs the ball's `irregular` flags. ok, out_of_memory, cancelled, internal.
    Status run(Arena& arena);

private:
    Status visit(std::uint32_t r);
    Status visit_link(std::uint32_t r);
    bool join_above(SpaceStar& star, VertexId v);
    Status reduce_in_link(const SpaceStar& star, std::uint32_t r);
    [[gnu::always_inline]] void prefetch_stars();  // see memory/prefetch.hpp
    bool reserve_columns(Arena& arena);
    bool add_zero_pairs(double value);
    Status reduce_columns_at(std::uint32_t r);
    std::uint32_t sorted(std::uint32_t columns);
    bool start_columns(std::uint32_t k, VertexId v);
    bool gather(std::uint32_t c, std::uint32_t r);
    bool reduce(std::uint32_t c, VertexId v);
    void add_outer_facet(std::uint32_t i);
    // The same of an edge in a link.
    void add_edge(std::uint32_t a, std::uint32_t b) {
        a = ball_.rank[a];
        b = ball_.rank[b];
        std::uint32_t* const ranks = outer_ + std::size_t{2} * outer_count_++;
        ranks[0] = a > b ? a : b;
        ranks[1] = a > b ? b : a;
    }
    template <std::uint32_t N> bool add_outer_facets(std::uint32_t c);
    bool flush(std::uint32_t c);
    bool take_pivot(std::uint32_t c, std::uint32_t i, VertexId v);
    bool write_pair(std::uint32_t c, std::uint32_t degree, VertexId v);
    bool before(std::uint32_t a, std::uint32_t b) {
        const std::uint32_t ka = front_.dimension(a), kb = front_.dimension(b);
        return ka != kb ? ka > kb : front_.age(a) > front_.age(b);
    }
    std::uint32_t merge(std::uint32_t a, std::uint32_t b);
#ifdef NETMESH_VALIDATE
    const char* owners_violation(std::uint32_t k);
#endif

    const TriangulatedBall<D>& ball_;
    Star<D>& star_;
    std::uint32_t* const above_;
    const bool by_links_;
    PairWriter& writer_;
    Monitor& monitor_;
    Front front_;
    CycleWriter* cycles_;
    StarCycles<D> star_cycles_;
    CellComponents<D> components_;
    BitTree column_;  // of the star at work, by position
    std::uint64_t* column_words_ = nullptr;
    std::uint32_t* outer_ = nullptr;  // ranks of facets in other stars, for the column at work
    std::uint32_t outer_count_ = 0;
    std::uint32_t done_columns_ = none;  // took a pivot in the star at work
    std::uint32_t next_age_ = 0;
    std::uint32_t critical_ = 0;  // simplices of the star at work
    bool irregular_ = false;      // the star at work
    std::uint32_t work_ = 0;
};

template <int D> Status Sweep<D>::run(Arena& arena) {
    if (cycles_ != nullptr && !star_cycles_.reserve(arena)) return Status::out_of_memory;
    if (ball_.dim() > 2 && !reserve_columns(arena)) return Status::out_of_memory;
    if (!front_.reserve(ball_.vertex_count, arena)) return Status::out_of_memory;
    for (std::uint32_t r = 0; r < ball_.vertex_count;)
        for (const std::uint64_t piece = arena.piece(r, ball_.vertex_count, 8); r < piece; ++r) {
            if ((ball_.flags[ball_.order[r]] & TriangulatedBall<D>::irregular) != 0) front_.waiting().insert(r);
        }
    monitor_.begin(NETMESH_STAGE_REDUCE, ball_.vertex_count);
    for (std::uint32_t r = front_.waiting().top(); r != none; r = front_.waiting().top()) {
        front_.waiting().toggle(r);
        work_ = 1;
        const Status status = visit(r);
        if (status != Status::ok) return status;
        NETMESH_VALIDATE_WHOLE(front_.violation(ball_.vertex_count, r));
        if (monitor_.advance(ball_.vertex_count - r, work_)) return Status::cancelled;
    }
    return ball_.dim() > 2 && front_.column_count() != 0 ? Status::internal : Status::ok;
}

template <int D> bool Sweep<D>::reserve_columns(Arena& arena) {
    column_words_ = arena.take_high<std::uint64_t>(BitTree::words_needed(star_.capacity()));
    outer_ = arena.take_high<std::uint32_t>(std::size_t{star_.capacity()} * (ball_.dim() - 1));
    return column_words_ != nullptr && outer_ != nullptr;
}

// A star is visited because it is irregular or because a column waits there. In the plane there are no columns.
template <int D> Status Sweep<D>::visit(std::uint32_t r) {
    const VertexId v(ball_.order[r]);
    if constexpr (D == 3) {
        const bool is_whole = (ball_.flags[v] & TriangulatedBall<D>::cut) == 0;
        if (by_links_ && is_whole && SpaceStar::is_small(ball_, v)) return visit_link(r);
    }
    irregular_ = (ball_.flags[v] & TriangulatedBall<D>::irregular) != 0;
    if (!star_.open(ball_, v)) return Status::internal;
    critical_ = star_.match();
    NETMESH_VALIDATE_WHOLE(star_.gradient_violation(critical_));
    work_ += 3 * star_.count();
    for (std::uint32_t i = 0; i < star_.count(); ++i) star_.owner(i) = none;
    Status status = critical_ > 0 ? components_.unite_critical_facets(v) : Status::ok;
    if (status == Status::ok && !add_zero_pairs(ball_.value[v])) status = Status::out_of_memory;
    if (ball_.dim() > 2 && status == Status::ok) status = reduce_columns_at(r);
    star_.close(ball_);
    return status;
}

template <int D> Status Sweep<D>::visit_link(std::uint32_t r) {
    const VertexId v(ball_.order[r]);
    SpaceStar star;
    if (!star.open(ball_, v, ball_.begin[v + 1])) return Status::internal;
    prefetch_stars();
    work_ += (ball_.begin[v + 1] - ball_.begin[v]) / 2;
    const bool joins = (ball_.flags[v] & TriangulatedBall<D>::irregular) != 0;
    const Status status = joins && !join_above(star, v) ? Status::out_of_memory : reduce_in_link(star, r);
    star.close(ball_, v);
    return status;
}

// Degree 2 at v, and the columns that begin there. False: out of memory.
template <int D> bool Sweep<D>::join_above(SpaceStar& star, VertexId v) {
    const auto is_older = [this](std::uint32_t x, std::uint32_t y) {
        return y != ball_.outside && (x == ball_.outside || ball_.rank[x] > ball_.rank[y]);
    };
    star.open_upper(ball_, v);
    above_[v] = v;  // a component of its own, which the first piece ends: of no length
    for (std::uint64_t left = star.upper_set(); left != 0;) {
        const std::uint64_t piece = star.upper_piece_of(lowest_bit(left));
        std::uint32_t older = v, younger = star.upper_vertex(lowest_bit(left));
        left &= ~piece;
        if (unite(above_, older, younger, is_older)) {
            if (!writer_.add(ball_.value[v], ball_.value[younger], 2)) return false;
            continue;
        }
        const std::uint32_t c = front_.new_column(++next_age_, ball_.rank[v], 2);
        if (c == none) return false;
        star.surround(ball_, v, piece, [this](std::uint32_t a, std::uint32_t b) { add_edge(a, b); });
        if (!add_outer_facets<2>(c)) return false;
        front_.wait(c);
    }
    return true;
}

// The columns that have arrived, the older ones first.
template <int D> Status Sweep<D>::reduce_in_link(const SpaceStar& star, std::uint32_t r) {
    struct Owner {
        std::uint32_t column;
        std::uint64_t ends, odd;
    };
    Owner owners[64];  // of pieces, by their last one
    std::uint64_t owned = 0;
    std::uint32_t following;
    for (std::uint32_t c = sorted(front_.arrive(r)); c != none; c = following) {
        following = front_.next(c);
        std::uint32_t ranks[DimensionOf<D>::most];
        std::uint64_t ends = 0;
        while (front_.take_entry(c, r, ranks))
            ends ^= std::uint64_t{1} << star.lower_label(ball_, ball_.order[ranks[1]]);
        if ((ends & ~star.lower_set()) != 0) return Status::internal;
        std::uint64_t odd = star.odd_pieces(ends);
        while (odd != 0 && (owned >> highest_bit(odd) & 1) != 0) {
            writer_.arena().pass(1);
            const Owner& older = owners[highest_bit(odd)];
            ends ^= older.ends;
            odd ^= older.odd;
            if (!front_.unite_runs(older.column) || !front_.add_column(c, older.column)) return Status::out_of_memory;
        }
        if (odd == 0) {
            star.join(ends, [this](std::uint32_t a, std::uint32_t b) { add_edge(a, b); });
            if (!add_outer_facets<2>(c)) return Status::out_of_memory;
            front_.wait(c);
        } else {
            owners[highest_bit(odd)] = {c, ends, odd};
            owned |= std::uint64_t{1} << highest_bit(odd);
            if (!write_pair(c, 1, VertexId(ball_.order[r]))) return Status::out_of_memory;
        }
    }
    for (; owned != 0; owned &= owned - 1) front_.drop(owners[lowest_bit(owned)].column);
    return Status::ok;
}

// From the top dimension down: the columns of the star's own critical simplices, then those that have arrived.
template <int D> Status Sweep<D>::reduce_columns_at(std::uint32_t r) {
    const VertexId v(ball_.order[r]);
    column_.adopt(column_words_, star_.count());
    std::uint32_t c = sorted(front_.arrive(r));
    for (std::uint32_t k = ball_.dim() - 1; k >= 2; --k) {
        if (critical_ > 0 && !start_columns(k, v)) return Status::out_of_memory;
        while (c != none && front_.dimension(c) == k) {
            const std::uint32_t following = front_.next(c);
            if (!gather(c, r)) return Status::internal;
            if (!reduce(c, v)) return Status::out_of_memory;
            c = following;
        }
        NETMESH_VALIDATE_WHOLE(owners_violation(k));
        while (done_columns_ != none) {
            const std::uint32_t done = done_columns_;
            done_columns_ = front_.next(done);
            front_.drop(done);
        }
    }
    return Status::ok;
}

#ifdef NETMESH_VALIDATE
// The columns of creators of dimension k that took a pivot in this star: each owns one critical (k-1)-simplex of it,
// and each owner of one is among them. The part of the column in this star has that one for its last simplex.
template <int D> const char* Sweep<D>::owners_violation(std::uint32_t k) {
    std::uint32_t done = 0;
    for (std::uint32_t c = done_columns_; c != none; c = front_.next(c), ++done) {
        std::uint32_t owned = 0;
        for (std::uint32_t i = 0; i < star_.count(); ++i) {
            if (star_.dimension(i) + 1 != k || star_.owner(i) != c) continue;
            ++owned;
            const Run local = front_.local(c);
            std::uint32_t last = 0;
            for (auto at = front_.begin(local); at.left > 0; front_.advance(&at))
                if (*front_.entry(at, 1) > last) last = *front_.entry(at, 1);
            if (star_.partner(i) != none || last != star_.position(i)) return "a column has a wrong pivot";
        }
        if (owned != 1) return "a column took not one pivot but none or several";
    }
    for (std::uint32_t i = 0; i < star_.count(); ++i)
        done -= star_.dimension(i) + 1 == k && star_.partner(i) == none && star_.owner(i) != none;
    return done == 0 ? nullptr : "a pivot is owned by no column";
}
#endif

// Stars next to each other in rank are far apart in memory. While one is worked on, what leads to those that are likely
// next comes step by step: where its incidences begin, they themselves, its cells, what is known of their vertices.
template <int D> inline void Sweep<D>::prefetch_stars() {
    if (!jumps_matter) return;
    std::uint32_t r = front_.waiting().top();
    for (std::uint32_t ahead = 0; ahead < 4 && r != none; ++ahead, r = front_.waiting().near_below(r)) {
        const VertexId v(ball_.order[r]);
        if (ahead == 3) {
            prefetch(ball_.begin + v);
            return;
        }
        const std::uint32_t end = ball_.begin[v + 1];
        constexpr std::uint32_t line = 64 / sizeof(FacetId);
        for (std::uint32_t t = ball_.begin[v]; t < end; t += ahead == 2 ? line : 1) {
            if (ahead == 2) {
                prefetch(ball_.incidence + t);
                continue;
            }
            const VertexId* const p = ball_.complex.vertices(ball_.incidence[t].cell());
            if (ahead == 1) {
                prefetch(p);
                continue;
            }
            for (std::uint32_t j = 0; j < 4; ++j) prefetch(ball_.slot + p[j]), prefetch(ball_.rank + p[j]);
        }
        if (ahead == 1) front_.prefetch(r);
    }
}

// Pairs of the gradient in an irregular star; those of regular ones are counted elsewhere, and so is degree 0.
template <int D> bool Sweep<D>::add_zero_pairs(double value) {
    if (!writer_.keeps_zero() || !irregular_) return true;
    for (std::uint32_t i = 1; i < star_.count(); ++i) {
        if (star_.is_tail(i) && !writer_.add(value, value, star_.dimension(i))) return false;
    }
    return true;
}

}  // namespace netmesh
