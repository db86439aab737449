// The reduction of boundaries without the shortcuts of matrix/homology.cpp: a reduced column is the cycle of the pair
// that it makes. Classes that never die have no such column; theirs are traced back through the additions that made
// their column zero.
#include "homology/cycles/cycles.hpp"

#include "homology/cycles/spanning_forest.hpp"
#include "homology/matrix/components.hpp"
#include "homology/matrix/ranked_matrix.hpp"
#include "homology/matrix/reduction.hpp"

namespace netmesh {
namespace {

using Simplices = FilteredComplex::Simplices;

// Writes a pair with what `cycle` holds, and empties that.
Status write_with_cycle(PairWriter& writer, ColumnStore& store, double birth, double death, std::uint32_t degree,
                        CountedColumn& cycle) {
    if (!writer.keeps(birth, death, degree)) {
        cycle.clear();
        return Status::ok;
    }
    std::uint32_t handle;
    std::uint32_t* const simplices = store.append(cycle.members(), none, &handle);
    if (simplices == nullptr) return Status::out_of_memory;
    cycle.take(simplices);
    return writer.add(birth, death, degree, handle) ? Status::ok : Status::out_of_memory;
}

// Boundaries of a quotient.
struct QuotientBoundary : BoundaryMatrix {
    std::uint32_t pivot_of(std::uint32_t j) const {
        const std::uint32_t* const faces = simplices.faces + std::size_t{j} * (k + 1);
        std::uint32_t pivot = none;
        for (std::uint32_t i = 0; i <= k; ++i) {
            if ((pivot == none || faces[i] > pivot) && is_in_boundary(faces, k, faces[i])) pivot = faces[i];
        }
        return pivot;
    }
    bool has_repeats(std::uint32_t j) const {
        return has_repeated_facets(simplices.faces + std::size_t{j} * (k + 1), k);
    }
};

template <bool is_quotient> class Tracer {
public:
    Tracer(const FilteredComplex& complex, DiagramRequest request, const Work& work)
        : complex_(complex), max_degree_(request.max_degree), top_(top_dimension(complex, max_degree_)),
          arena_(work.arena), progress_{work.monitor}, writer_(work.arena, request) {}

    Status run(Representatives* out);

private:
    class Recorder;
    struct Components;

    bool reserve();
    Status close_edges();
    Status reduce(std::uint32_t k);
    const Simplices& of(std::uint32_t k) const { return complex_.of[k]; }

    const FilteredComplex& complex_;
    std::uint32_t max_degree_, top_;
    Arena& arena_;
    Progress progress_;
    PairWriter writer_;
    ColumnStore store_;
    std::uint64_t* column_words_[3] = {};
    std::uint32_t* owner_ = nullptr;
    SpanningForest forest_;
    BitSet joining_;                // edges that join two components
    BitSet paired_, paired_above_;  // (k-1)-simplices, k-simplices that are pivots: they give birth
    std::uint64_t* paired_words_[2] = {};
};

template <bool is_quotient> bool Tracer<is_quotient>::reserve() {
    const std::uint32_t most = largest_count(complex_, top_), edges = complex_.edge_count();
    owner_ = arena_.take_high<std::uint32_t>(most);
    for (std::uint64_t*& words : column_words_) {
        words = arena_.take_high<std::uint64_t>(BitTree::words_needed(most));
        if (words == nullptr) return false;
    }
    for (std::uint64_t*& words : paired_words_) {
        words = arena_.take_high<std::uint64_t>(BitSet::words_needed(most));
        if (words == nullptr) return false;
    }
    std::uint64_t* const joining = arena_.take_high<std::uint64_t>(BitSet::words_needed(edges));
    if (owner_ == nullptr || joining == nullptr || !forest_.reserve(of(0).count, arena_)) return false;
    joining_.adopt(joining, edges);
    return true;
}

// Degree 0: the cycle of a component that dies is its oldest vertex and the oldest of the one that takes it in.
template <bool is_quotient> struct Tracer<is_quotient>::Components {
    Tracer& tracer;
    ComponentWriter edges;
    CountedColumn& cycle;

    Status visit(std::uint32_t e) { return edges.visit(e); }
    EdgeEnds ends(std::uint32_t e) const { return edges.ends(e); }
    Status merge(std::uint32_t e, std::uint32_t older, std::uint32_t younger) {
        edges.joining.insert(e);
        cycle.toggle(older);
        cycle.toggle(younger);
        return write_with_cycle(tracer.writer_, tracer.store_, tracer.of(0).value[younger], tracer.of(1).value[e], 0,
                                cycle);
    }
    Status keep(std::uint32_t v) {
        cycle.toggle(v);
        return write_with_cycle(tracer.writer_, tracer.store_, tracer.of(0).value[v], __builtin_inf(), 0, cycle);
    }
};

// Essential classes of degree 1: an edge and the way back through the forest of the edges before it.
template <bool is_quotient> Status Tracer<is_quotient>::close_edges() {
    if (complex_.dimension == 0 || max_degree_ == 0) return Status::ok;
    const Simplices& edges = of(1);
    CountedColumn cycle;
    cycle.adopt(column_words_[0], edges.count > 0 ? edges.count : 1);
    forest_.grow(edges.faces, edges.count, [this](std::uint32_t e) { return joining_.has(e); });
    for (std::uint32_t e = 0; e < edges.count;)
        for (const std::uint64_t piece = arena_.piece(e, edges.count, 10); e < piece; ++e) {
            if (joining_.has(e) || paired_above_.has(e)) continue;
            cycle.toggle(e);
            forest_.path(edges.faces[2 * std::size_t{e}], edges.faces[2 * std::size_t{e} + 1],
                         [&cycle](std::uint32_t tree_edge) { cycle.toggle(tree_edge); });
            if (progress_.stop(1 + static_cast<std::uint32_t>(cycle.members() / 16))) return Status::cancelled;
            const Status status = write_with_cycle(writer_, store_, edges.value[e], __builtin_inf(), 1, cycle);
            if (status != Status::ok) return status;
        }
    return Status::ok;
}

template <bool is_quotient> class Tracer<is_quotient>::Recorder {
public:
    using Matrix = std::conditional_t<is_quotient, QuotientBoundary, BoundaryMatrix>;
    using Columns = ListedColumns<Matrix, KeptSums>;
    Recorder(Tracer& tracer, const Matrix& matrix, Columns& columns, std::uint32_t k)
        : t_(tracer), matrix_(matrix), columns_(columns), k_(k) {
        sources_.adopt(t_.column_words_[1], t_.of(k).count);
        cycle_.adopt(t_.column_words_[2], t_.of(k).count);
        if (is_quotient) boundary_.adopt(t_.column_words_[2], t_.of(k - 1).count);
    }

    // What is a pivot itself gives birth to a pair that is written already.
    bool next(std::uint32_t* j) {
        for (; next_ < t_.of(k_).count; ++next_, ++t_.progress_.done) {
            t_.arena_.step(next_, 10);
            if (t_.paired_above_.has(next_)) continue;
            ++t_.progress_.done;
            *j = next_++;
            return true;
        }
        return false;
    }
    // The cycle is the reduced column, which is kept as that, or as the number of the simplex whose boundary it is.
    Status pair(std::uint32_t j) {
        const std::uint32_t pivot = columns_.pivot();
        t_.paired_.insert(pivot);
        if (!columns_.own_pivot(j)) return Status::out_of_memory;
        const std::uint32_t owner = columns_.owner(), cycle = owner == j ? j + 1 : owner;
        if constexpr (is_quotient) {
            if (owner == j && matrix_.has_repeats(j)) return write_boundary(j, pivot);
        }
        const bool fits = t_.writer_.add(t_.of(k_ - 1).value[pivot], t_.of(k_).value[j], k_ - 1, cycle);
        return fits ? Status::ok : Status::out_of_memory;
    }
    // The cycle is j and the columns whose sum its boundary is. Reduced columns in that sum are replaced by what they
    // came from, from the last to the first, so each is met once.
    Status zero(std::uint32_t j) {
        if (k_ > t_.max_degree_) return Status::ok;
        sources_.toggle(j);
        for (std::uint32_t at; (at = sources_.top()) != none;) {
            t_.arena_.pass(1);
            sources_.toggle(at);
            cycle_.toggle(at);
            if (at != j && columns_.is_given(at)) continue;
            const Status status = add_sources_of(at);
            if (status != Status::ok) return status;
        }
        return write_with_cycle(t_.writer_, t_.store_, t_.of(k_).value[j], __builtin_inf(), k_, cycle_);
    }

private:
    // The boundary of j as it is, without what is there twice.
    Status write_boundary(std::uint32_t j, std::uint32_t pivot) {
        matrix_.add(j, boundary_);
        return write_with_cycle(t_.writer_, t_.store_, t_.of(k_ - 1).value[pivot], t_.of(k_).value[j], k_ - 1,
                                boundary_);
    }
    // The columns that were added to that of `at` when it was reduced.
    Status add_sources_of(std::uint32_t at) {
        for (columns_.load(at); !columns_.is_zero();) {
            if (!columns_.has_owner()) return Status::internal;
            t_.arena_.pass(1);
            const std::uint32_t source = columns_.owner_number();
            if (source == at) break;
            sources_.toggle(source);
            const Status status = columns_.add_owner();
            if (status != Status::ok) return status;
        }
        columns_.clear();
        return Status::ok;
    }

    Tracer& t_;
    const Matrix& matrix_;
    Columns& columns_;
    CountedColumn sources_, cycle_, boundary_;  // boundary_ and cycle_ in one place, which is empty between them
    std::uint32_t k_, next_ = 0;
};

template <bool is_quotient> Status Tracer<is_quotient>::reduce(std::uint32_t k) {
    const std::uint32_t rows = of(k - 1).count;
    if (rows == 0 || of(k).count == 0) return Status::ok;
    typename Recorder::Matrix matrix;
    matrix.simplices = of(k);
    matrix.k = k;
    matrix.dropped = nullptr;
    typename Recorder::Columns columns(matrix, {&store_}, rows, owner_, column_words_[0], progress_);
    Recorder recorder(*this, matrix, columns, k);
    return reduce_columns(columns, recorder);
}

template <bool is_quotient> Status Tracer<is_quotient>::run(Representatives* out) {
    const std::size_t high = arena_.high_mark();
    std::uint64_t total = 0;
    for (std::uint32_t k = 1; k <= top_; ++k) total += of(k).count;
    progress_.monitor.begin(NETMESH_STAGE_REDUCE, total);
    if (!reserve()) return Status::out_of_memory;
    const std::size_t store_top = arena_.high_mark();
    store_.open(arena_);
    CountedColumn cycle;
    cycle.adopt(column_words_[0], of(0).count);
    Status status = unite_edges(owner_, of(0).count, complex_.edge_count(),
                                Components{*this, {complex_, writer_, joining_, progress_}, cycle});
    paired_above_.adopt(paired_words_[0], of(top_).count);
    for (std::uint32_t k = top_; k >= 2 && status == Status::ok; --k) {
        paired_.adopt(paired_words_[(top_ - k + 1) % 2], of(k - 1).count);
        status = reduce(k);
        if (status == Status::ok) NETMESH_VALIDATE_WHOLE(pivots_violation(of(k), k, of(k - 1).count, paired_));
        paired_above_ = paired_;
    }
    if (status == Status::ok) status = close_edges();
    if (status != Status::ok) return status;
    // The store moves up over what only the reduction needed.
    const std::size_t bytes = store_top - arena_.high_mark();
    move_bytes(arena_.at(high - bytes), arena_.at(store_top - bytes), bytes, arena_);
    arena_.release_high(high - bytes);
    *out = {writer_.finish(), {0, high}};
    return Status::ok;
}

template <bool is_quotient>
Status trace(const FilteredComplex& complex, DiagramRequest request, const Work& work, Representatives* out) {
    if (complex.dimension > FilteredComplex::dimension_max) return Status::invalid_argument;
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    work.arena.release_high(high & ~(Arena::alignment - 1));
    Tracer<is_quotient> tracer(complex, limited(request, complex), work);
    const Status status = tracer.run(out);
    if (status == Status::ok) return status;
    work.arena.release_low(low);
    work.arena.release_high(high);
    return status;
}

}  // namespace

Status persist_with_cycles(const FilteredComplex& complex, DiagramRequest request, const Work& work,
                           Representatives* out) {
    return trace<false>(complex, request, work, out);
}

Status persist_quotient_with_cycles(const FilteredComplex& complex, DiagramRequest request, const Work& work,
                                    Representatives* out) {
    return trace<true>(complex, request, work, out);
}

Cycle cycle_of(const FilteredComplex& complex, const CycleStore& store, const Arena& arena, const Pair& pair) {
    if (pair.cycle < ColumnStore::stored) {
        const std::uint32_t k = pair.degree + 1;
        return {complex.of[k].faces + std::size_t{pair.cycle - 1} * (k + 1), k + 1};
    }
    const std::uint32_t* const column =
        ColumnStore::column_below(arena, static_cast<std::size_t>(store.top), pair.cycle);
    return {column + 2, column[1]};
}

Cycle lower_star_cycle(const CycleStore& store, const Arena& arena, const Pair& pair) {
    const auto* const cycle =
        reinterpret_cast<const std::uint32_t*>(arena.at(store.begin + (std::size_t{pair.cycle} - 1) * 16));
    return {cycle + 1, cycle[0]};
}

}  // namespace netmesh
