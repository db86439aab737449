// Persistence of a listed filtration by the reduction of its boundaries, one dimension of columns at a time: union-find
// for edges, union-find of the dual graph for the top dimension where that is possible, and the reduction of columns
// from the top down for what lies between.
#include "homology/matrix/components.hpp"
#include "homology/matrix/matrix.hpp"
#include "homology/matrix/reduction.hpp"

namespace netmesh {
namespace {

using Simplices = FilteredComplex::Simplices;

class Homology {
public:
    Homology(const FilteredComplex& complex, DiagramRequest request, const Work& work)
        : complex_(complex), max_degree_(request.max_degree), top_(top_dimension(complex, max_degree_)),
          arena_(work.arena), progress_{work.monitor}, writer_(work.arena, request) {}

    Status run();
    PairList finish() { return writer_.finish_without_cycles(); }

private:
    class Recorder;

    bool reserve();
    Status begin();
    bool has_two_cofaces_at_most(std::uint32_t k);
    Status unite_top(std::uint32_t k);
    Status reduce(std::uint32_t k);
    Status add_loops();
    const Simplices& of(std::uint32_t k) const { return complex_.of[k]; }

    const FilteredComplex& complex_;
    std::uint32_t max_degree_, top_;
    Arena& arena_;
    Progress progress_;
    PairWriter writer_;
    std::uint32_t* owner_ = nullptr;  // [largest count]
    BitSet joining_;                  // edges that join two components
    BitSet paired_, paired_above_;    // (k-1)-simplices, k-simplices that are pivots: they give birth
    std::uint64_t* paired_words_[2] = {};
    std::uint64_t* tree_words_ = nullptr;
};

bool Homology::reserve() {
    const std::uint32_t most = largest_count(complex_, top_), edges = complex_.edge_count();
    owner_ = arena_.take_high<std::uint32_t>(most);
    tree_words_ = arena_.take_high<std::uint64_t>(BitTree::words_needed(most));
    std::uint64_t* const joining = arena_.take_high<std::uint64_t>(BitSet::words_needed(edges));
    paired_words_[0] = arena_.take_high<std::uint64_t>(BitSet::words_needed(most));
    paired_words_[1] = arena_.take_high<std::uint64_t>(BitSet::words_needed(most));
    if (owner_ == nullptr || tree_words_ == nullptr || joining == nullptr || paired_words_[0] == nullptr ||
        paired_words_[1] == nullptr) {
        return false;
    }
    joining_.adopt(joining, edges);
    return true;
}

// Counts in owner_.
bool Homology::has_two_cofaces_at_most(std::uint32_t k) {
    const std::size_t faces = std::size_t{of(k).count} * (k + 1);
    for (std::uint32_t f = 0; f < of(k - 1).count;)
        for (const std::uint64_t piece = arena_.piece(f, of(k - 1).count, 3); f < piece; ++f) {
            owner_[f] = 0;
        }
    for (std::size_t i = 0; i < faces;)
        for (const std::uint64_t piece = arena_.piece(i, faces, 6); i < piece; ++i) {
            if (++owner_[of(k).faces[i]] == 3) return false;
        }
    return true;
}

// Degree k-1 for k = dimension when no (k-1)-simplex has more than two cofaces: seen backwards, each of them joins its
// two cofaces, or its coface and the outside.
Status Homology::unite_top(std::uint32_t k) {
    const HighScope scope(arena_);
    const std::uint32_t rows = of(k - 1).count, columns = of(k).count, outside = columns;
    const std::size_t faces = std::size_t{columns} * (k + 1);
    const std::uint32_t* const face = of(k).faces;
    std::uint32_t* const first = owner_;
    std::uint32_t* const second = arena_.take_high<std::uint32_t>(rows);
    std::uint32_t* const parent = arena_.take_high<std::uint32_t>(std::size_t{columns} + 1);
    if (second == nullptr || parent == nullptr || faces >= none) return Status::out_of_memory;
    for (std::uint32_t f = 0; f < rows;)
        for (const std::uint64_t piece = arena_.piece(f, rows, 4); f < piece; ++f) {
            first[f] = second[f] = none;
        }
    for (std::uint32_t i = 0; i < faces;)
        for (const std::uint64_t piece = arena_.piece(i, faces, 12); i < piece; ++i) {
            const std::uint32_t f = face[i];
            (first[f] == none ? first : second)[f] = i;
        }
    for (std::uint32_t j = 0; j <= columns; ++j) {
        arena_.step(j, 3);
        parent[j] = j;
    }
    for (std::uint32_t f = rows; f-- > 0;) {
        if (progress_.stop(1)) return Status::cancelled;
        if (first[f] == none) continue;
        const std::uint32_t one = first[f], other = second[f];
        std::uint32_t a = one / (k + 1), b = other == none ? outside : other / (k + 1);
        if (!unite(parent, a, b, [](std::uint32_t x, std::uint32_t y) { return x > y; })) continue;
        paired_.insert(f);
        if (!writer_.add(of(k - 1).value[f], of(k).value[b], k - 1)) return Status::out_of_memory;
    }
    for (std::uint32_t j = 0; j < columns && k <= max_degree_;)
        for (const std::uint64_t piece = arena_.piece(j, columns, 15); j < piece && k <= max_degree_; ++j) {
            if (parent[j] == j && !writer_.add_essential(of(k).value[j], k)) return Status::out_of_memory;
        }
    progress_.done += columns;
    return Status::ok;
}

// Columns from the first to the last; those of simplices that are pivots themselves are zero (clearing).
class Homology::Recorder {
public:
    using Columns = ListedColumns<BoundaryMatrix, KeptSums>;
    Recorder(Homology& homology, Columns& columns, std::uint32_t k) : h_(homology), columns_(columns), k_(k) {}

    bool next(std::uint32_t* j) {
        for (; next_ < h_.of(k_).count; ++next_, ++h_.progress_.done) {
            h_.arena_.step(next_, 10);
            if (h_.paired_above_.has(next_)) continue;
            ++h_.progress_.done;
            *j = next_++;
            return true;
        }
        return false;
    }
    Status pair(std::uint32_t j) {
        const std::uint32_t pivot = columns_.pivot();
        h_.paired_.insert(pivot);
        const bool fits = h_.writer_.add(h_.of(k_ - 1).value[pivot], h_.of(k_).value[j], k_ - 1);
        return fits && columns_.own_pivot(j) ? Status::ok : Status::out_of_memory;
    }
    Status zero(std::uint32_t j) {
        if (k_ > h_.max_degree_) return Status::ok;
        return h_.writer_.add_essential(h_.of(k_).value[j], k_) ? Status::ok : Status::out_of_memory;
    }

private:
    Homology& h_;
    Columns& columns_;
    std::uint32_t k_, next_ = 0;
};

// Edges that join components are no pivots of triangles, whose columns leave them out.
Status Homology::reduce(std::uint32_t k) {
    const HighScope scope(arena_);
    const std::uint32_t rows = of(k - 1).count;
    if (rows == 0) return Status::ok;
    ColumnStore store;
    store.open(arena_);
    Recorder::Columns columns({of(k), k, k == 2 ? &joining_ : nullptr}, {&store}, rows, owner_, tree_words_, progress_);
    Recorder recorder(*this, columns, k);
    return reduce_columns(columns, recorder);
}

// Essential classes of degree 1.
Status Homology::add_loops() {
    for (std::uint32_t e = 0; e < of(1).count;)
        for (const std::uint64_t piece = arena_.piece(e, of(1).count, 15); e < piece; ++e) {
            if (joining_.has(e) || paired_above_.has(e)) continue;
            if (!writer_.add_essential(of(1).value[e], 1)) return Status::out_of_memory;
        }
    return Status::ok;
}

// Memory, and degree 0.
Status Homology::begin() {
    std::uint64_t total = 0;
    for (std::uint32_t k = 1; k <= top_; ++k) total += of(k).count;
    progress_.monitor.begin(NETMESH_STAGE_REDUCE, total);
    if (!reserve()) return Status::out_of_memory;
    const Status status = unite_edges(owner_, of(0).count, complex_.edge_count(),
                                      ComponentWriter{complex_, writer_, joining_, progress_});
    if (status == Status::ok && top_ > 0) NETMESH_VALIDATE_WHOLE(killers_violation(of(1), 1, of(0).count, joining_));
    paired_above_.adopt(paired_words_[0], of(top_).count);
    return status;
}

Status Homology::run() {
    Status status = begin();
    for (std::uint32_t k = top_; k >= 2 && status == Status::ok; --k) {
        paired_.adopt(paired_words_[(top_ - k + 1) % 2], of(k - 1).count);
        const bool dual = k == complex_.dimension && has_two_cofaces_at_most(k);
        status = dual ? unite_top(k) : reduce(k);
        if (status == Status::ok) NETMESH_VALIDATE_WHOLE(pivots_violation(of(k), k, of(k - 1).count, paired_));
        paired_above_ = paired_;
    }
    return status == Status::ok && complex_.dimension >= 1 && max_degree_ >= 1 ? add_loops() : status;
}

}  // namespace

Status persist_homology(const FilteredComplex& complex, DiagramRequest request, const Work& work, PairList* out) {
    if (complex.dimension > FilteredComplex::dimension_max) return Status::invalid_argument;
    Homology homology(complex, limited(request, complex), work);
    return write_diagram(homology, work.arena, out);
}

}  // namespace netmesh
