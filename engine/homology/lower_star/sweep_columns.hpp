// Columns of a sweep: how they are listed, begun, reduced within a star, and take their pivots.
#pragma once
#include "homology/lower_star/sweep.hpp"

namespace netmesh {

// The list of columns by dimension of their creators, larger ones first, then older columns first.
template <int D> std::uint32_t Sweep<D>::sorted(std::uint32_t columns) {
    std::uint32_t runs[32];  // sorted lists of 2^i columns
    int run_count = 0;
    std::uint32_t taken = 0;
    while (columns != none) {
        std::uint32_t run = columns;
        columns = front_.next(run);
        front_.next(run) = none;
        ++taken;
        for (std::uint32_t bit = 1; (taken & bit) == 0; bit <<= 1) run = merge(runs[--run_count], run);
        runs[run_count++] = run;
    }
    for (std::uint32_t all = none;;) {
        if (run_count == 0) return all;
        all = merge(runs[--run_count], all);
    }
}

template <int D> std::uint32_t Sweep<D>::merge(std::uint32_t a, std::uint32_t b) {
    std::uint32_t first = none, last = none;
    while (a != none || b != none) {
        const bool from_a = b == none || (a != none && before(a, b));
        std::uint32_t& from = from_a ? a : b;
        const std::uint32_t c = from;
        from = front_.next(c);
        (last == none ? first : front_.next(last)) = c;
        last = c;  // the last of all is the last of its list
    }
    return first;
}

// Moves what a column has in the star of rank r into column_, where equal simplices cancel. False: not in the star.
template <int D> bool Sweep<D>::gather(std::uint32_t c, std::uint32_t r) {
    const std::uint32_t n = front_.dimension(c) - 1;
    std::uint32_t ranks[DimensionOf<D>::most] = {};
    while (front_.take_entry(c, r, ranks)) {
        for (std::uint32_t j = 0; j < n; ++j) ranks[j] = ball_.slot[ball_.order[ranks[j + 1]]];
        const std::uint32_t i = star_.simplex_of_any_order(ranks, n);
        if (i == none) return false;
        column_.toggle(star_.position(i));
    }
    return true;
}

template <int D> bool Sweep<D>::start_columns(std::uint32_t k, VertexId v) {
    std::uint32_t left = 0;
    for (std::uint32_t i = 0; i < star_.count(); ++i) {
        left += star_.dimension(i) == k && star_.partner(i) == none && star_.owner(i) == none ? 1 : 0;
    }
    next_age_ += left;
    for (std::uint32_t p = 0, age = next_age_; left > 0; ++p) {
        const std::uint32_t i = star_.at(p);
        if (star_.dimension(i) != k || star_.partner(i) != none || star_.owner(i) != none) continue;
        --left;
        const std::uint32_t c = front_.new_column(age--, ball_.rank[v], k);
        if (c == none) return false;
        add_outer_facet(i);
        for (std::uint32_t f = 0; f < k; ++f) column_.toggle(star_.position(star_.facets(i)[f]));
        if (!reduce(c, v)) return false;
    }
    return true;
}

// Notes the facet of i opposite the vertex of the star for the column at work.
template <int D> void Sweep<D>::add_outer_facet(std::uint32_t i) {
    const std::uint32_t n = star_.dimension(i);
    std::uint32_t* ranks = outer_ + std::size_t{outer_count_++} * n;
    for (std::uint32_t j = 0; j < n; ++j, i = star_.parent(i)) ranks[j] = ball_.rank[star_.vertex(star_.label(i))];
    insertion_sort(ranks, n, [](std::uint32_t a, std::uint32_t b) { return a > b; });
}

// Adds the facets noted to column c, whose entries have N ranks.
template <int D> template <std::uint32_t N> [[gnu::cold]] bool Sweep<D>::add_outer_facets(std::uint32_t c) {
    FacetRanks<N>* const outer = reinterpret_cast<FacetRanks<N>*>(outer_);
    sort_alike(outer, outer_count_, LaterRanks{});
    Run run = no_run;
    for (std::uint32_t i = 0; i < outer_count_; ++i) {
        if (!front_.append(&run, outer[i].rank, N)) return false;
    }
    outer_count_ = 0;
    return front_.add_run(c, run);
}

template <int D> bool Sweep<D>::flush(std::uint32_t c) {
    const std::uint32_t n = front_.dimension(c);  // 2..D-1
    if constexpr (DimensionOf<D>::most > 5) {
        if (n == 5) return add_outer_facets<5>(c);
    }
    if constexpr (DimensionOf<D>::most > 4) {
        if (n == 4) return add_outer_facets<4>(c);
    }
    if constexpr (DimensionOf<D>::most > 3) {
        if (n == 3) return add_outer_facets<3>(c);
    }
    return add_outer_facets<2>(c);
}

// Reduces column_, the part of column c in this star, until it takes a pivot or nothing is left here.
template <int D> bool Sweep<D>::reduce(std::uint32_t c, VertexId v) {
    for (std::uint32_t p = column_.top(); p != none; p = column_.top()) {
        writer_.arena().pass(1);
        const std::uint32_t i = star_.at(p);
        if (star_.is_tail(i)) {
            const std::uint32_t coface = star_.partner(i);
            for (std::uint32_t f = 0; f < star_.dimension(coface); ++f) {
                column_.toggle(star_.position(star_.facets(coface)[f]));
            }
            add_outer_facet(coface);
        } else if (star_.partner(i) != none) {
            column_.toggle(p);  // it ends a class, so it is no pivot
        } else if (star_.owner(i) == none) {
            return take_pivot(c, i, v);
        } else {
            const std::uint32_t older = star_.owner(i);
            const Run positions = front_.local(older);
            writer_.arena().pass(positions.count / 16);
            for (auto at = front_.begin(positions); at.left > 0; front_.advance(&at)) {
                column_.toggle(*front_.entry(at, 1));
            }
            if (!front_.add_column(c, older)) return false;
        }
    }
    if (!flush(c)) return false;
    front_.wait(c);
    return true;
}

template <int D> [[gnu::cold]] bool Sweep<D>::take_pivot(std::uint32_t c, std::uint32_t i, VertexId v) {
    if (!flush(c) || !front_.unite_runs(c)) return false;
    star_.owner(i) = c;
    front_.next(c) = done_columns_;
    done_columns_ = c;
    Run positions = no_run;
    for (std::uint32_t p = column_.top(); p != none; p = column_.top()) {
        column_.toggle(p);
        // No row left pairs up: when i became critical the dimension of their partners was gone from the star.
        if (cycles_ == nullptr && star_.partner(star_.at(p)) != none) continue;
        if (!front_.append(&positions, &p, 1)) return false;
    }
    front_.put_local(c, positions);
    return write_pair(c, star_.dimension(i), v);
}

template <int D> bool Sweep<D>::write_pair(std::uint32_t c, std::uint32_t degree, VertexId v) {
    const std::uint32_t r = front_.creator_rank(c);
    // A regular star has critical simplices only where it was found regular without its gradient, and none at D = 3,
    // where every lower link collapses as far as it can. Its pairs are counted already.
    if (ball_.dim() == 4 && r == ball_.rank[v] && !irregular_) return true;
    const double birth = ball_.value[v], death = ball_.value[ball_.order[r]];
    std::uint32_t cycle = 0;
    if (cycles_ != nullptr && writer_.keeps(birth, death, degree) && !star_cycles_.write_column(c, v, &cycle))
        return false;
    return writer_.add(birth, death, degree, cycle);
}

}  // namespace netmesh
