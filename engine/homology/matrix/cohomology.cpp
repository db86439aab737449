// Persistence of a listed filtration by columns of cofaces, from the lowest degree up: for skeletons, where simplices
// of the top dimension are many and most of them only close what their like have closed. Those are rows here, which
// are never reduced; and a simplex that kills is left out as a column (clearing).
#include "homology/matrix/components.hpp"
#include "homology/matrix/matrix.hpp"
#include "homology/matrix/reduction.hpp"

namespace netmesh {
namespace {

using Simplices = FilteredComplex::Simplices;

class Cohomology {
public:
    Cohomology(const FilteredComplex& complex, DiagramRequest request, const Work& work)
        : complex_(complex), max_degree_(request.max_degree), arena_(work.arena), progress_{work.monitor},
          writer_(work.arena, request) {}

    Status run();
    PairList finish() { return writer_.finish(); }

private:
    class Recorder;

    bool reserve(std::uint32_t top);
    bool list_cofaces(std::uint32_t k, CoboundaryMatrix* out);
    Status reduce(std::uint32_t k);
    Status add_essential(std::uint32_t k);
    const Simplices& of(std::uint32_t k) const { return complex_.of[k]; }

    const FilteredComplex& complex_;
    std::uint32_t max_degree_;
    Arena& arena_;
    Progress progress_;
    PairWriter writer_;
    std::uint32_t* owner_ = nullptr;
    std::uint64_t* tree_words_[2] = {};
    BitSet kills_, kills_above_;  // k-simplices, (k+1)-simplices
    std::uint64_t* kill_words_[2] = {};
};

bool Cohomology::reserve(std::uint32_t top) {
    const std::uint32_t most = largest_count(complex_, top);
    owner_ = arena_.take_high<std::uint32_t>(most);
    for (int i = 0; i < 2; ++i) {
        tree_words_[i] = arena_.take_high<std::uint64_t>(BitTree::words_needed(most));
        kill_words_[i] = arena_.take_high<std::uint64_t>(BitSet::words_needed(most));
        if (tree_words_[i] == nullptr || kill_words_[i] == nullptr) return false;
    }
    return owner_ != nullptr;
}

// False: out of memory, or more than 2^32 faces in all.
bool Cohomology::list_cofaces(std::uint32_t k, CoboundaryMatrix* out) {
    const std::uint32_t columns = of(k).count, rows = of(k + 1).count;
    const std::uint64_t words = std::uint64_t{rows} * (k + 2);
    std::uint32_t* const start = arena_.take_high<std::uint32_t>(std::size_t{columns} + 1);
    std::uint32_t* const coface =
        words < none ? arena_.take_high<std::uint32_t>(static_cast<std::size_t>(words)) : nullptr;
    if (start == nullptr || coface == nullptr) return false;
    const std::uint32_t* const faces = of(k + 1).faces;
    for (std::uint32_t j = 0; j <= columns; ++j) {
        arena_.step(j, 5);
        start[j] = 0;
    }
    for (std::size_t i = 0; i < words;)
        for (const std::uint64_t piece = arena_.piece(i, words, 4); i < piece; ++i) {
            ++start[faces[i]];
        }
    std::uint32_t sum = 0;
    for (std::uint32_t j = 0; j <= columns; ++j) {
        arena_.step(j, 5);
        sum += start[j];
        start[j] = sum;
    }
    arena_.each(words, 15, [&](std::uint64_t left) {
        const std::size_t i = static_cast<std::size_t>(words - 1 - left);
        coface[--start[faces[i]]] = rows - 1 - static_cast<std::uint32_t>(i / (k + 2));
    });
    *out = {start, coface};
    return true;
}

// Columns from the last to the first.
class Cohomology::Recorder {
public:
    using Columns = ListedColumns<CoboundaryMatrix, KeptSources>;
    Recorder(Cohomology& cohomology, Columns& columns, std::uint32_t k)
        : c_(cohomology), columns_(columns), k_(k), left_(cohomology.of(k).count) {}

    bool next(std::uint32_t* j) {
        while (left_ > 0) {
            ++c_.progress_.done;
            c_.arena_.step(left_, 10);
            if (c_.kills_.has(--left_)) continue;
            *j = left_;
            return true;
        }
        return false;
    }
    Status pair(std::uint32_t j) {
        const std::uint32_t coface = c_.of(k_ + 1).count - 1 - columns_.pivot();
        c_.kills_above_.insert(coface);
        if (!columns_.own_pivot(j)) return Status::out_of_memory;
        const bool fits = c_.writer_.add(c_.of(k_).value[j], c_.of(k_ + 1).value[coface], k_);
        return fits ? Status::ok : Status::out_of_memory;
    }
    Status zero(std::uint32_t j) {
        columns_.forget();
        return c_.writer_.add_essential(c_.of(k_).value[j], k_) ? Status::ok : Status::out_of_memory;
    }

private:
    Cohomology& c_;
    Columns& columns_;
    std::uint32_t k_, left_;
};

Status Cohomology::reduce(std::uint32_t k) {
    const HighScope scope(arena_);
    CoboundaryMatrix cofaces;
    if (!list_cofaces(k, &cofaces)) return Status::out_of_memory;
    ColumnStore store;
    store.open(arena_);
    CountedColumn sources;
    sources.adopt(tree_words_[1], of(k).count);
    Recorder::Columns columns(cofaces, {&store, sources}, of(k + 1).count, owner_, tree_words_[0], progress_);
    Recorder recorder(*this, columns, k);
    return reduce_columns(columns, recorder);
}

// Simplices without cofaces that kill nothing.
Status Cohomology::add_essential(std::uint32_t k) {
    for (std::uint32_t j = 0; j < of(k).count;)
        for (const std::uint64_t piece = arena_.piece(j, of(k).count, 12); j < piece; ++j) {
            if (!kills_.has(j) && !writer_.add_essential(of(k).value[j], k)) return Status::out_of_memory;
        }
    return Status::ok;
}

Status Cohomology::run() {
    const std::uint32_t top = top_dimension(complex_, max_degree_), edges = complex_.edge_count();
    std::uint64_t total = edges;
    for (std::uint32_t k = 1; k < top; ++k) total += of(k).count;
    progress_.monitor.begin(NETMESH_STAGE_REDUCE, total);
    if (!reserve(top)) return Status::out_of_memory;
    kills_.adopt(kill_words_[0], edges);
    Status status = unite_edges(owner_, of(0).count, edges, ComponentWriter{complex_, writer_, kills_, progress_});
    for (std::uint32_t k = 1; k <= max_degree_ && status == Status::ok; ++k) {  // max_degree_ <= dimension
        if (k == complex_.dimension || of(k + 1).count == 0) return add_essential(k);
        kills_above_.adopt(kill_words_[k % 2], of(k + 1).count);
        status = reduce(k);
        if (status == Status::ok)
            NETMESH_VALIDATE_WHOLE(killers_violation(of(k + 1), k + 1, of(k).count, kills_above_));
        kills_ = kills_above_;
    }
    return status;
}

}  // namespace

Status persist_cohomology(const FilteredComplex& complex, DiagramRequest request, const Work& work, PairList* out) {
    if (complex.dimension > FilteredComplex::dimension_max) return Status::invalid_argument;
    Cohomology cohomology(complex, limited(request, complex), work);
    return write_diagram(cohomology, work.arena, out);
}

}  // namespace netmesh
