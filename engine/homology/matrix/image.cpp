#include "homology/matrix/image.hpp"

#include "homology/matrix/components.hpp"
#include "homology/matrix/reduction.hpp"

namespace netmesh {
namespace {

using Simplices = FilteredComplex::Simplices;

// Boundaries of k-simplices, rows in an order of their own.
struct RankedBoundaryMatrix {
    Simplices simplices;
    std::uint32_t k;
    const std::uint32_t* rank;  // of each face

    std::uint32_t pivot_of(std::uint32_t j) const {
        const std::uint32_t* const faces = simplices.faces + std::size_t{j} * (k + 1);
        std::uint32_t pivot = rank[faces[0]];
        for (std::uint32_t i = 1; i <= k; ++i)
            if (rank[faces[i]] > pivot) pivot = rank[faces[i]];
        return pivot;
    }
    template <class Column> std::uint32_t add(std::uint32_t j, Column& to) const {
        const std::uint32_t* const faces = simplices.faces + std::size_t{j} * (k + 1);
        for (std::uint32_t i = 0; i <= k; ++i) to.toggle(rank[faces[i]]);
        return 1;
    }
    template <class Column> std::uint32_t add_owner(std::uint32_t j, std::uint32_t, Column& to) const {
        return add(j, to);
    }
};

class Image {
public:
    Image(const FilteredComplex& complex, const SimplexSet& whole, const SimplexSet& part, DiagramRequest request,
          const Work& work)
        : complex_(complex), whole_(whole), part_(part), max_degree_(request.max_degree),
          arena_(work.arena), progress_{work.monitor}, writer_(work.arena, request) {}

    Status run();
    PairList finish() { return writer_.finish(); }

private:
    class Ends;
    class Births;

    bool reserve();
    Status end_classes(std::uint32_t k);
    Status find_essential(std::uint32_t k);
    const Simplices& of(std::uint32_t k) const { return complex_.of[k]; }

    const FilteredComplex& complex_;
    const SimplexSet &whole_, &part_;
    std::uint32_t max_degree_;
    Arena& arena_;
    Progress progress_;
    PairWriter writer_;
    std::uint32_t* owner_ = nullptr;  // [largest count]
    std::uint64_t* tree_words_ = nullptr;
    // Simplices of `part`, of the degree at hand and of the one above, that are the last of a cycle of `part`. They are
    // the last of it in `whole` too, as the two have one order, and their columns are zero in both (clearing).
    BitSet cyclic_, cyclic_above_;
    std::uint64_t* cyclic_words_[2] = {};
};

bool Image::reserve() {
    const std::uint32_t most = largest_count(complex_, top_dimension(complex_, max_degree_));
    owner_ = arena_.take_high<std::uint32_t>(most);
    tree_words_ = arena_.take_high<std::uint64_t>(BitTree::words_needed(most));
    for (std::uint64_t*& words : cyclic_words_) words = arena_.take_high<std::uint64_t>(BitSet::words_needed(most));
    return owner_ != nullptr && tree_words_ != nullptr && cyclic_words_[0] != nullptr && cyclic_words_[1] != nullptr;
}

// Columns of `whole`, from the first to the last: those whose pivots are rows of `part` end a class of degree k-1.
class Image::Ends {
public:
    using Columns = ListedColumns<RankedBoundaryMatrix, KeptSums>;
    Ends(Image& image, Columns& columns, std::uint32_t k, const std::uint32_t* row)
        : image_(image), columns_(columns), k_(k), row_(row) {}

    bool next(std::uint32_t* j) {
        while (next_ < image_.of(k_).count) {
            ++image_.progress_.done;
            image_.arena_.step(next_, 10);
            *j = next_++;
            if (!image_.whole_.of[k_].has(*j)) continue;
            if (k_ > image_.max_degree_ || !image_.cyclic_above_.has(*j)) return true;
        }
        return false;
    }
    Status pair(std::uint32_t j) {
        const std::uint32_t row = row_[columns_.pivot()];
        if (!columns_.own_pivot(j)) return Status::out_of_memory;
        if (!image_.part_.of[k_ - 1].has(row)) return Status::ok;
        image_.cyclic_.insert(row);
        const bool fits = image_.writer_.add(image_.of(k_ - 1).value[row], image_.of(k_).value[j], k_ - 1);
        return fits ? Status::ok : Status::out_of_memory;
    }
    Status zero(std::uint32_t) { return Status::ok; }

private:
    Image& image_;
    Columns& columns_;
    std::uint32_t k_;
    const std::uint32_t* row_;  // of each rank
    std::uint32_t next_ = 0;
};

Status Image::end_classes(std::uint32_t k) {
    const HighScope scope(arena_);
    const std::uint32_t rows = of(k - 1).count;
    std::uint32_t* const rank = arena_.take_high<std::uint32_t>(rows);
    std::uint32_t* const row = arena_.take_high<std::uint32_t>(rows);
    if (rank == nullptr || row == nullptr) return Status::out_of_memory;
    std::uint32_t next = 0;
    for (int others = 0; others < 2; ++others) {
        for (std::uint32_t i = 0; i < rows;)
            for (const std::uint64_t piece = arena_.piece(i, rows, 12); i < piece; ++i) {
                if (part_.of[k - 1].has(i) == (others != 0)) continue;
                rank[i] = next;
                row[next++] = i;
            }
    }
    ColumnStore store;
    store.open(arena_);
    Ends::Columns columns({of(k), k, rank}, {&store}, rows, owner_, tree_words_, progress_);
    Ends ends(*this, columns, k, row);
    return reduce_columns(columns, ends);
}

// Columns of `part`, from the first to the last: cycles that end no more.
class Image::Births {
public:
    using Columns = ListedColumns<BoundaryMatrix, KeptSums>;
    Births(Image& image, Columns& columns, std::uint32_t k) : image_(image), columns_(columns), k_(k) {}

    bool next(std::uint32_t* j) {
        while (next_ < image_.of(k_).count) {
            ++image_.progress_.done;
            image_.arena_.step(next_, 10);
            *j = next_++;
            if (image_.part_.of[k_].has(*j) && !image_.cyclic_.has(*j)) return true;
        }
        return false;
    }
    Status pair(std::uint32_t j) { return columns_.own_pivot(j) ? Status::ok : Status::out_of_memory; }
    Status zero(std::uint32_t j) {
        image_.cyclic_.insert(j);
        return image_.writer_.add_essential(image_.of(k_).value[j], k_) ? Status::ok : Status::out_of_memory;
    }

private:
    Image& image_;
    Columns& columns_;
    std::uint32_t k_, next_ = 0;
};

Status Image::find_essential(std::uint32_t k) {
    const HighScope scope(arena_);
    if (k == 0) {
        for (std::uint32_t v = 0; v < of(0).count;)
            for (const std::uint64_t piece = arena_.piece(v, of(0).count, 12); v < piece; ++v) {
                if (!part_.of[0].has(v) || cyclic_.has(v)) continue;
                if (!writer_.add_essential(of(0).value[v], 0)) return Status::out_of_memory;
            }
        return Status::ok;
    }
    ColumnStore store;
    store.open(arena_);
    Births::Columns columns({of(k), k, nullptr}, {&store}, of(k - 1).count, owner_, tree_words_, progress_);
    Births births(*this, columns, k);
    return reduce_columns(columns, births);
}

// From the top degree down.
Status Image::run() {
    std::uint64_t total = 0;
    for (std::uint32_t k = 0; k <= max_degree_; ++k) {
        if (k < complex_.dimension) total += of(k + 1).count;
        if (k > 0) total += of(k).count;
    }
    progress_.monitor.begin(NETMESH_STAGE_REDUCE, total);
    if (!reserve()) return Status::out_of_memory;
    Status status = Status::ok;
    for (std::uint32_t k = max_degree_ + 1; k-- > 0 && status == Status::ok;) {
        cyclic_.adopt(cyclic_words_[k % 2], of(k).count);
        if (k < complex_.dimension) status = end_classes(k + 1);
        if (status == Status::ok) status = find_essential(k);
        cyclic_above_ = cyclic_;
    }
    return status;
}

}  // namespace

Status persist_image(const FilteredComplex& complex, const SimplexSet& whole, const SimplexSet& part,
                     DiagramRequest request, const Work& work, PairList* out) {
    if (complex.dimension > FilteredComplex::dimension_max) return Status::invalid_argument;
    Image image(complex, whole, part, limited(request, complex), work);
    return write_diagram(image, work.arena, out);
}

}  // namespace netmesh
