// Order the faces of each dimension by value, equal ones by number. A face and a coface of it, one dimension up, are an
// apparent pair when the face is the last facet of the coface and the coface the first cofacet of the face (Bauer:
// Ripser, 2021): in the reduction they are a pair as they stand. Those of equal value are seen without an order, for
// the last facet is that of equal value with the greatest number and the first cofacet that with the least. Pairs of
// zero length are no bars, so their faces need no place among the columns, and none in a sorted list but where they are
// rows. In a filtration by radii most faces that are not critical are in such pairs (Bauer, Edelsbrunner: The Morse
// theory of Cech and Delaunay complexes, 2017).
//
// What this saves: sorting, and renaming all boundaries by the sorted order, which jumps about in memory.
#include "homology/matrix/ball.hpp"

#include "homology/bit_set.hpp"
#include "homology/matrix/listed_columns.hpp"
#include "homology/matrix/ranked_matrix.hpp"
#include "homology/matrix/reduction.hpp"
#include "homology/pair_writer.hpp"
#include "homology/union_find.hpp"
#include "memory/prefetch.hpp"
#include "numerics/value_order.hpp"

namespace netmesh {
namespace {

// Numbers of faces of one dimension, in the order of their values.
struct FaceOrder {
    std::uint32_t* face;
    std::uint32_t count;
};

// is_signed: vertices differ in value, and values may be negative. is_quotient: classes of any degree can last, and a
// simplex can have a facet more than once; facets that it has an even number of times are not in its boundary.
template <bool is_signed, bool is_quotient> class BallHomology {
public:
    BallHomology(const FilteredBall& ball, DiagramRequest request, const Work& work)
        : ball_(ball), arena_(work.arena), progress_{work.monitor}, writer_(work.arena, request),
          max_degree_(request.max_degree) {}

    Status run();
    Status run_on_disk();
    PairList finish() { return writer_.finish_without_cycles(); }

private:
    class Recorder;

    const FilteredBall::Simplices& of(std::uint32_t k) const { return ball_.of[k]; }
    bool has_cells() const { return ball_.dimension == ball_.dim; }
    Status begin();
    bool take_bits(std::uint32_t k, BitSet* out);
    Status match(std::uint32_t k, std::uint32_t* mate);
    Status order(std::uint32_t k, FaceOrder* out);
    bool move_up(std::size_t high, FaceOrder* order);
    Status unite_vertices(const FaceOrder& edges, BitSet* joining);
    Status unite_cells(std::uint32_t* parent, const FaceOrder& facets);
    Status unite_top(FaceOrder* facets);
    Status add_loops(const FaceOrder& edges, const BitSet& joining);
    bool lists_degree(std::uint32_t degree) const { return max_degree_ >= degree; }
    Status reduce(std::uint32_t k, const FaceOrder& columns, FaceOrder* rows);

    const FilteredBall& ball_;
    Arena& arena_;
    Progress progress_;
    PairWriter writer_;
    std::uint32_t max_degree_;
    // By dimension. positive_: faces that are known to give birth to a class. taken_: those that end one of zero
    // length.
    BitSet positive_[dimension_most() + 1], taken_[dimension_most() + 1];
    std::uint32_t pairs_[dimension_most() + 1] = {};  // of zero length, by the dimension of the coface
};

template <bool is_signed, bool is_quotient>
bool BallHomology<is_signed, is_quotient>::take_bits(std::uint32_t k, BitSet* out) {
    std::uint64_t* const words = arena_.take_high<std::uint64_t>(BitSet::words_needed(of(k).count));
    if (words != nullptr) out->adopt(words, of(k).count);
    return words != nullptr;
}

template <bool is_signed, bool is_quotient> Status BallHomology<is_signed, is_quotient>::begin() {
    std::uint64_t total = 0;
    for (std::uint32_t k = 1; k <= ball_.dimension; ++k) total += of(k).count;
    progress_.monitor.begin(NETMESH_STAGE_REDUCE, total);
    for (std::uint32_t k = 1; k <= ball_.dimension; ++k) {
        if (!take_bits(k, &positive_[k]) || !take_bits(k, &taken_[k])) return Status::out_of_memory;
    }
    return Status::ok;
}

// Finds the apparent pairs of zero length of (k-1)-faces and k-faces. mate, if any: the k-face's partner, or none.
template <bool is_signed, bool is_quotient>
Status BallHomology<is_signed, is_quotient>::match(std::uint32_t k, std::uint32_t* mate) {
    const HighScope scope(arena_);
    BitSet met;  // (k-1)-faces that have a cofacet of equal value among those before
    if (!take_bits(k - 1, &met)) return Status::out_of_memory;
    const double* const below = of(k - 1).value;
    const std::uint32_t* face = of(k).faces;
    for (std::uint32_t j = 0; j < of(k).count;)
        for (const std::uint64_t piece = arena_.piece(j, of(k).count, 8 * k); j < piece; ++j, face += k + 1) {
            const double value = of(k).value[j];
            std::uint32_t above = 0;
            for (std::uint32_t i = 0; i <= k; ++i) {
                const std::uint32_t next = below[face[i]] == value ? face[i] + 1 : 0;
                above = next > above ? next : above;
            }
            if (is_quotient && ball_.repeats && above != 0 && !is_in_boundary(face, k, above - 1)) above = 0;
            std::uint32_t last = above - 1;
            if (last != none) {
                const bool is_first = !met.has(last);
                for (std::uint32_t i = 0; i <= k; ++i) {
                    if (below[face[i]] == value) met.insert(face[i]);
                }
                if (is_first) {
                    positive_[k - 1].insert(last);
                    taken_[k].insert(j);
                    ++pairs_[k];
                    if (writer_.keeps_zero() && !writer_.add(value, value, k - 1)) return Status::out_of_memory;
                } else {
                    last = none;
                }
            }
            if (mate != nullptr) mate[j] = last;
        }
    return Status::ok;
}

// Lists the faces that end no class of zero length. Facets of cells, which union-find takes, only if nothing is known
// of them; what is a row further down can be positive.
template <bool is_signed, bool is_quotient>
Status BallHomology<is_signed, is_quotient>::order(std::uint32_t k, FaceOrder* out) {
    const bool are_facets = has_cells() && k + 1 == ball_.dim;
    const std::uint32_t count = of(k).count - pairs_[k] - (are_facets ? pairs_[k + 1] : 0);
    out->face = arena_.take_high<std::uint32_t>(count);
    out->count = count;
    const HighScope scope(arena_);
    double* const value = arena_.take_high<double>(count);
    if (out->face == nullptr || value == nullptr) return Status::out_of_memory;
    const auto is_listed = [this, k, are_facets](std::uint32_t f) {
        return !(taken_[k].has(f) | (positive_[k].has(f) & are_facets));  // no branches, which nobody could foresee
    };
    const bool sorted = sort_listed<is_signed>(of(k).value, of(k).count, is_listed, value, out->face, arena_);
    return sorted ? Status::ok : Status::out_of_memory;
}

// Gives back what was taken at the high end since it was at `high`, but for this order. False: out of memory.
template <bool is_signed, bool is_quotient>
bool BallHomology<is_signed, is_quotient>::move_up(std::size_t high, FaceOrder* order) {
    const std::uint32_t* const from = order->face;
    arena_.release_high(high);
    order->face = arena_.take_high<std::uint32_t>(order->count);
    if (order->face == nullptr) return false;
    move_bytes(order->face, from, sizeof(std::uint32_t) * order->count, arena_);
    return true;
}

// Degree 0. joining, if any: the edges that join two components.
template <bool is_signed, bool is_quotient>
Status BallHomology<is_signed, is_quotient>::unite_vertices(const FaceOrder& edges, BitSet* joining) {
    struct Graph {
        BallHomology& h;
        const FaceOrder& edges;
        BitSet* joining;

        Status visit(std::uint32_t) { return h.progress_.stop(1) ? Status::cancelled : Status::ok; }
        EdgeEnds ends(std::uint32_t i) const {
            constexpr std::uint32_t far = 24;
            if (i + far < edges.count) prefetch(h.of(1).faces + 2 * std::size_t{edges.face[i + far]});
            const std::uint32_t* const vertex = h.of(1).faces + 2 * std::size_t{edges.face[i]};
            return {vertex[0], vertex[1]};
        }
        Status merge(std::uint32_t i, std::uint32_t, std::uint32_t younger) {
            const std::uint32_t e = edges.face[i];
            if (joining != nullptr) joining->insert(e);
            return h.writer_.add(h.of(0).value[younger], h.of(1).value[e], 0) ? Status::ok : Status::out_of_memory;
        }
        Status keep(std::uint32_t v) {
            return h.writer_.add_essential(h.of(0).value[v], 0) ? Status::ok : Status::out_of_memory;
        }
    };
    const HighScope scope(arena_);
    std::uint32_t* const parent = arena_.take_high<std::uint32_t>(of(0).count);
    if (parent == nullptr) return Status::out_of_memory;
    Status status;
    if constexpr (is_signed) {
        const double* const value = of(0).value;
        const auto is_older = [value](std::uint32_t x, std::uint32_t y) {
            return value[x] != value[y] ? value[x] < value[y] : x < y;
        };
        status = unite_edges(parent, of(0).count, edges.count, Graph{*this, edges, joining}, is_older);
    } else {
        status = unite_edges(parent, of(0).count, edges.count, Graph{*this, edges, joining});
    }
    progress_.done += edges.count;
    return status;
}

// Degree dim-1, backwards: a facet joins its two cells, or its cell and the outside. A cell whose facet is its mate
// belongs to what is beyond that from the start on: no other facet of it comes before.
// parent: [cells + 1], the mates of cells; taken over.
template <bool is_signed, bool is_quotient>
Status BallHomology<is_signed, is_quotient>::unite_cells(std::uint32_t* parent, const FaceOrder& facets) {
    const std::uint32_t dim = ball_.dim, columns = of(dim).count, width = dim + 1, outside = columns;
    std::uint32_t* const first = arena_.take_high<std::uint32_t>(of(dim - 1).count);
    if (first == nullptr || columns >= none >> 3) return Status::out_of_memory;
    arena_.each(of(dim - 1).count, 1, [first](std::uint64_t f) { first[f] = none; });
    // Faces give up their places, each the i-th of a cell c, 8 c + i: that of the last coface leads to that of the
    // other one.
    std::uint32_t* const faces = of(dim).faces;
    const auto at = [=](std::uint32_t place) { return faces + std::size_t{place >> 3} * width + (place & 7); };
    arena_.each(columns, 12 * width, [=](std::uint64_t c) {
        for (std::uint32_t i = 0; i < width; ++i) {
            const std::uint32_t place = static_cast<std::uint32_t>(c) << 3 | i, f = *at(place);
            *at(place) = first[f];
            first[f] = place;
        }
    });
    const auto sides = [=](std::uint32_t f) {
        const std::uint32_t one = first[f], other = *at(one);
        return EdgeEnds{one >> 3, other == none ? outside : other >> 3};
    };
    for (std::uint32_t j = 0; j < columns;)
        for (const std::uint64_t piece = arena_.piece(j, columns, 15); j < piece; ++j) {
            if (parent[j] == none) {
                parent[j] = j;
            } else {
                const EdgeEnds cells = sides(parent[j]);
                parent[j] = cells.a == j ? cells.b : cells.a;
            }
        }
    parent[outside] = outside;
    const double* const value = of(dim).value;
    const auto is_older = [=](std::uint32_t x, std::uint32_t y) {
        if (x == outside || y == outside) return x == outside;
        return value[x] != value[y] ? value[x] > value[y] : x > y;
    };
    for (std::uint32_t i = facets.count; i-- > 0;) {
        if (progress_.stop(1)) return Status::cancelled;
        constexpr std::uint32_t far = 24, near = 8;
        if (jumps_matter && i >= far) {
            prefetch(first + facets.face[i - far]);
            prefetch(at(first[facets.face[i - 2 * near]]));
            const EdgeEnds later = sides(facets.face[i - near]);
            prefetch(parent + later.a);
            prefetch(parent + later.b);
        }
        const std::uint32_t f = facets.face[i];
        EdgeEnds cells = sides(f);
        if (!unite(parent, cells.a, cells.b, is_older)) continue;
        positive_[dim - 1].insert(f);
        if (!writer_.add(of(dim - 1).value[f], value[cells.b], dim - 1)) return Status::out_of_memory;
    }
    // Without an outside the last cell of each component closes a class.
    bool fits = true;
    if (is_quotient && lists_degree(dim))
        arena_.each(columns, 3, [&](std::uint64_t j) {
            if (parent[j] == j) fits = fits && writer_.add_essential(value[j], dim);
        });
    if (!fits) return Status::out_of_memory;
    progress_.done += columns;
    return Status::ok;
}

// Degree dim-1, and its facets in order.
template <bool is_signed, bool is_quotient> Status BallHomology<is_signed, is_quotient>::unite_top(FaceOrder* facets) {
    const std::uint32_t dim = ball_.dim;
    const std::size_t high = arena_.high_mark();
    std::uint32_t* const parent = arena_.take_high<std::uint32_t>(std::size_t{of(dim).count} + 1);
    if (parent == nullptr) return Status::out_of_memory;
    Status status = match(dim, parent);
    if (status == Status::ok) status = order(dim - 1, facets);
    BitSet joining;
    const bool has_loops = is_quotient && dim == 2;
    if (status == Status::ok && has_loops && !take_bits(1, &joining)) status = Status::out_of_memory;
    if (status == Status::ok && dim == 2) status = unite_vertices(*facets, has_loops ? &joining : nullptr);
    if (status == Status::ok) status = unite_cells(parent, *facets);
    if (status == Status::ok && has_loops) status = add_loops(*facets, joining);
    if (status == Status::ok && !move_up(high, facets)) status = Status::out_of_memory;
    return status;
}

// Classes of degree 1 that last: edges that neither join components nor begin what a face ends.
template <bool is_signed, bool is_quotient>
Status BallHomology<is_signed, is_quotient>::add_loops(const FaceOrder& edges, const BitSet& joining) {
    bool fits = true;
    arena_.each(edges.count, 6, [&](std::uint64_t i) {
        const std::uint32_t e = edges.face[i];
        if (!joining.has(e) && !positive_[1].has(e)) fits = fits && writer_.add_essential(of(1).value[e], 1);
    });
    return fits ? Status::ok : Status::out_of_memory;
}

template <bool is_signed, bool is_quotient> Status BallHomology<is_signed, is_quotient>::run_on_disk() {
    Status status = begin();
    if (status != Status::ok) return status;
    FaceOrder edges;
    if (has_cells()) return unite_top(&edges);
    status = order(1, &edges);
    return status == Status::ok ? unite_vertices(edges, nullptr) : status;
}

// Columns from the first to the last; those of faces that are positive are zero (clearing).
template <bool is_signed, bool is_quotient> class BallHomology<is_signed, is_quotient>::Recorder {
public:
    using Matrix = RankedMatrix<is_quotient>;
    using Columns = ListedColumns<Matrix, KeptSums>;
    Recorder(BallHomology& homology, Columns& columns, const Matrix& matrix, const std::uint32_t* owner,
             const FaceOrder& order)
        : h_(homology), columns_(columns), matrix_(matrix), owner_(owner), k_(matrix.k), order_(order) {}

    bool next(std::uint32_t* j) {
        for (; next_ < order_.count; ++next_) {
            h_.arena_.step(next_, 10);
            if (jumps_matter) fetch();
            ++h_.progress_.done;
            if (h_.positive_[k_].has(order_.face[next_])) continue;
            *j = order_.face[next_++];
            return true;
        }
        return false;
    }
    Status pair(std::uint32_t j) {
        const std::uint32_t pivot = columns_.pivot();
        if (!columns_.own_pivot(j)) return Status::out_of_memory;
        if (owner_[pivot] == j) matrix_.note_owner(j, pivot);
        return Status::ok;
    }
    // A ball has no class that lasts but the first, so there this is of the highest dimension that is listed.
    Status zero(std::uint32_t j) {
        NETMESH_ASSERT(is_quotient || k_ == h_.ball_.dimension);
        if (!is_quotient || k_ == h_.ball_.dimension) return Status::ok;
        return h_.writer_.add_essential(h_.of(k_).value[j], k_) ? Status::ok : Status::out_of_memory;
    }

private:
    // Columns go by value, so all of theirs is everywhere in memory: asks for what the next ones read, step by step.
    __attribute__((always_inline)) void fetch() const {
        constexpr std::uint32_t far = 24, near = 8;
        if (next_ + far >= order_.count) return;
        prefetch(matrix_.faces + std::size_t{order_.face[next_ + far]} * (k_ + 1));
        const std::uint32_t* const face = matrix_.faces + std::size_t{order_.face[next_ + 2 * near]} * (k_ + 1);
        for (std::uint32_t i = 0; i <= k_; ++i) prefetch(matrix_.rank + face[i]);
        const std::uint32_t pivot = matrix_.pivot_of(order_.face[next_ + near]);
        if (pivot == none) return;
        prefetch(owner_ + pivot);
        prefetch(matrix_.others + std::size_t{pivot} * k_);
    }

    BallHomology& h_;
    Columns& columns_;
    const Matrix& matrix_;
    const std::uint32_t* const owner_;
    std::uint32_t k_, next_ = 0;
    const FaceOrder order_;
};

// Degree k-1. rows: the (k-1)-faces that are not taken, without those that end a class when these are known. They have
// been listed before their columns are reduced, which is a dimension further down.
template <bool is_signed, bool is_quotient>
Status BallHomology<is_signed, is_quotient>::reduce(std::uint32_t k, const FaceOrder& columns, FaceOrder* rows) {
    Status status = order(k - 1, rows);
    if (status != Status::ok) return status;
    const HighScope scope(arena_);
    if (k == 2) {
        BitSet joining;
        if (!take_bits(1, &joining)) return Status::out_of_memory;
        status = unite_vertices(*rows, &joining);
        if (status != Status::ok) return status;
        std::uint32_t kept = 0;
        arena_.each(rows->count, 6, [&](std::uint64_t i) {
            if (!joining.has(rows->face[i])) rows->face[kept++] = rows->face[i];
        });
        rows->count = kept;
    }
    std::uint32_t* const owner = arena_.take_high<std::uint32_t>(rows->count);
    const std::size_t high_kept = arena_.high_mark();
    std::uint32_t* const rank = arena_.take_high<std::uint32_t>(of(k - 1).count);
    std::uint32_t* const others = arena_.take_high<std::uint32_t>(jumps_matter ? std::size_t{rows->count} * k : 0);
    std::uint64_t* const words = arena_.take_high<std::uint64_t>(BitTree::words_needed(rows->count));
    if (rank == nullptr || owner == nullptr || others == nullptr || words == nullptr) return Status::out_of_memory;
    if (rows->count == 0) return Status::ok;
    arena_.each(of(k - 1).count, 1, [rank](std::uint64_t f) { rank[f] = none; });
    arena_.each(rows->count, 6, [&](std::uint64_t i) { rank[rows->face[i]] = static_cast<std::uint32_t>(i); });
    ColumnStore store;
    store.open(arena_);
    const typename Recorder::Matrix matrix = {of(k).faces, rank, k, others, is_quotient && ball_.repeats};
    typename Recorder::Columns reduced(matrix, {&store}, rows->count, owner, words, progress_);
    arena_.each(of(k).count, 8, [&](std::uint64_t at) {
        const std::uint32_t j = static_cast<std::uint32_t>(at);
        if (!taken_[k].has(j)) return;
        const std::uint32_t pivot = matrix.pivot_of(j);
        owner[pivot] = j;
        matrix.note_owner(j, pivot);
    });
    Recorder recorder(*this, reduced, matrix, owner, columns);
    status = reduce_columns(reduced, recorder);
    if (status != Status::ok) return status;
    arena_.each(rows->count, 8, [&](std::uint64_t i) {
        if (owner[i] != none && owner[i] >= ColumnStore::stored) owner[i] = store.column(owner[i])[0];
    });
    arena_.release_high(high_kept);
    // By birth, so that there is little to sort. Edges that nothing ends are loops that last.
    bool fits = true;
    arena_.each(rows->count, 20, [&](std::uint64_t i) {
        constexpr std::uint32_t far = 24;
        if (i + far < rows->count && owner[i + far] != none) {
            prefetch(of(k - 1).value + rows->face[i + far]);
            prefetch(of(k).value + owner[i + far]);
        }
        if (is_quotient && k == 2 && owner[i] == none)
            fits = fits && writer_.add_essential(of(1).value[rows->face[i]], 1);
        if (owner[i] == none || taken_[k].has(owner[i])) return;
        const std::uint32_t face = rows->face[i];
        positive_[k - 1].insert(face);
        fits = fits && writer_.add(of(k - 1).value[face], of(k).value[owner[i]], k - 1);
    });
    return fits ? Status::ok : Status::out_of_memory;
}

template <bool is_signed, bool is_quotient> Status BallHomology<is_signed, is_quotient>::run() {
    Status status = begin();
    const std::uint32_t top = ball_.dimension;
    const std::uint32_t highest = has_cells() ? top - 1 : top;  // of columns that are reduced
    for (std::uint32_t k = 2; k <= highest && status == Status::ok; ++k) status = match(k, nullptr);
    if (status != Status::ok) return status;
    const std::size_t high = arena_.high_mark();
    FaceOrder columns, rows;
    if (!has_cells()) {
        status = order(top, &columns);
        if (status == Status::ok && top == 1) status = unite_vertices(columns, nullptr);
    } else {
        status = unite_top(&columns);
        if (ball_.stacked) writer_.move_down(arena_.offset_of(of(top).faces));
    }
    for (std::uint32_t k = highest; k >= 2 && status == Status::ok; --k) {
        status = reduce(k, columns, &rows);
        if (ball_.stacked) writer_.move_down(arena_.offset_of(of(k).faces));
        if (status == Status::ok && k > 2 && !move_up(high, &rows)) status = Status::out_of_memory;
        columns = rows;
    }
    return status;
}

// In place of BallHomology where nothing is left to reduce.
template <bool is_signed> struct DiskHomology {
    BallHomology<is_signed, false> homology;
    Status run() { return homology.run_on_disk(); }
    PairList finish() { return homology.finish(); }
};

template <bool is_signed, bool is_quotient = false>
Status ball_diagram(const FilteredBall& ball, DiagramRequest request, const Work& work, PairList* out) {
    BallHomology<is_signed, is_quotient> homology(ball, request, work);
    return write_diagram(homology, work.arena, out);
}
template <bool is_signed>
Status disk_diagram(const FilteredBall& ball, DiagramRequest request, const Work& work, PairList* out) {
    DiskHomology<is_signed> homology{{ball, request, work}};
    return write_diagram(homology, work.arena, out);
}

}  // namespace

Status persist_ball(const FilteredBall& ball, DiagramRequest request, const Work& work, PairList* out) {
    return ball_diagram<false>(ball, request, work, out);
}

Status persist_disk(const FilteredBall& ball, DiagramRequest request, const Work& work, PairList* out) {
    return disk_diagram<false>(ball, request, work, out);
}

Status persist_signed_ball(const FilteredBall& ball, DiagramRequest request, const Work& work, PairList* out) {
    return ball_diagram<true>(ball, request, work, out);
}

Status persist_signed_disk(const FilteredBall& ball, DiagramRequest request, const Work& work, PairList* out) {
    return disk_diagram<true>(ball, request, work, out);
}

Status persist_quotient(const FilteredBall& quotient, DiagramRequest request, const Work& work, PairList* out) {
    return ball_diagram<true, true>(quotient, request, work, out);
}

}  // namespace netmesh
