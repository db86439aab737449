// Persistence of an explicit filtration by columns of cofaces, from the lowest degree up: for skeletons, where
// simplices of the top dimension are many and most of them only close what their like have closed. Those are rows here,
// which are never reduced; and a simplex that kills is left out as a column (clearing).
#include "homology/bit_tree.hpp"
#include "homology/column_store.hpp"
#include "homology/pair_writer.hpp"
#include "homology/persist_by.hpp"
#include "homology/union_find.hpp"
#include "memory/arena.hpp"

namespace netmesh {
namespace {

using Simplices = FilteredComplex::Simplices;

class Cohomology {
public:
    Cohomology(const FilteredComplex& complex, std::uint32_t max_degree, bool keep_zero, const Work& work)
        : complex_(complex), max_degree_(max_degree), arena_(work.arena), monitor_(work.monitor),
          writer_(work.arena, max_degree, keep_zero) {}

    Status run();
    PairList finish() { return writer_.finish(); }

private:
    Status reserve(std::uint32_t top);
    Status unite_edges();
    bool list_cofaces(std::uint32_t k);
    Status reduce(std::uint32_t k);
    Status claim(std::uint32_t k, std::uint32_t j, std::uint32_t row);
    Status essential(std::uint32_t k);
    void add_cofaces(std::uint32_t j);
    std::uint32_t add_column(std::uint32_t owner);
    bool stop(std::uint32_t work) { return monitor_.advance(done_, work); }
    const Simplices& of(std::uint32_t k) const { return complex_.of[k]; }

    const FilteredComplex& complex_;
    std::uint32_t max_degree_;
    Arena& arena_;
    Monitor& monitor_;
    PairWriter writer_;
    ColumnStore* store_ = nullptr;
    std::uint32_t* owner_ = nullptr;
    std::uint32_t *start_ = nullptr, *coface_ = nullptr;  // ascending cofaces of j: coface_[start_[j] .. start_[j+1])
    std::uint32_t rows_ = 0;
    BitTree pivot_column_;  // over rows_ - 1 - row, so that the first row is its top
    BitTree sources_;       // the columns that were added to the one at work
    std::uint64_t source_count_ = 0;
    std::uint64_t* tree_words_[2] = {};
    Bits kills_, kills_above_;  // k-simplices, (k+1)-simplices
    std::uint64_t* kill_words_[2] = {};
    std::uint64_t done_ = 0;
};

Status Cohomology::reserve(std::uint32_t top) {
    std::uint32_t most = 1;
    for (std::uint32_t k = 0; k <= top; ++k) {
        if (of(k).count > most) most = of(k).count;
    }
    owner_ = arena_.take_high<std::uint32_t>(most);
    for (int i = 0; i < 2; ++i) {
        tree_words_[i] = arena_.take_high<std::uint64_t>(BitTree::words_needed(most));
        kill_words_[i] = arena_.take_high<std::uint64_t>(Bits::words_needed(most));
        if (tree_words_[i] == nullptr || kill_words_[i] == nullptr) return Status::out_of_memory;
    }
    return owner_ == nullptr ? Status::out_of_memory : Status::ok;
}

Status Cohomology::unite_edges() {
    std::uint32_t* const parent = owner_;
    for (std::uint32_t v = 0; v < of(0).count; ++v) parent[v] = v;
    const std::uint32_t edges = complex_.dimension > 0 ? of(1).count : 0;
    kills_.adopt(kill_words_[0], edges);
    for (std::uint32_t e = 0; e < edges; ++e, ++done_) {
        if (stop(1)) return Status::cancelled;
        const std::uint32_t a = find_root(parent, of(1).faces[2 * std::size_t{e}]);
        const std::uint32_t b = find_root(parent, of(1).faces[2 * std::size_t{e} + 1]);
        if (a == b) continue;
        const std::uint32_t younger = a < b ? b : a;
        parent[younger] = a < b ? a : b;
        kills_.insert(e);
        if (!writer_.add(of(0).value[younger], of(1).value[e], 0)) return Status::out_of_memory;
    }
    for (std::uint32_t v = 0; v < of(0).count; ++v) {
        if (parent[v] == v && !writer_.add_essential(of(0).value[v], 0)) return Status::out_of_memory;
    }
    return Status::ok;
}

// False: out of memory, or more than 2^32 faces in all.
bool Cohomology::list_cofaces(std::uint32_t k) {
    const std::uint32_t columns = of(k).count;
    const std::uint64_t words = std::uint64_t{of(k + 1).count} * (k + 2);
    start_ = arena_.take_high<std::uint32_t>(std::size_t{columns} + 1);
    coface_ = words < none ? arena_.take_high<std::uint32_t>(static_cast<std::size_t>(words)) : nullptr;
    if (start_ == nullptr || coface_ == nullptr) return false;
    const std::uint32_t* const faces = of(k + 1).faces;
    for (std::uint32_t j = 0; j <= columns; ++j) start_[j] = 0;
    for (std::size_t i = 0; i < words; ++i) ++start_[faces[i]];
    std::uint32_t sum = 0;
    for (std::uint32_t j = 0; j <= columns; ++j) {
        sum += start_[j];
        start_[j] = sum;
    }
    for (std::size_t i = static_cast<std::size_t>(words); i-- > 0;) {
        coface_[--start_[faces[i]]] = static_cast<std::uint32_t>(i / (k + 2));
    }
    return true;
}

void Cohomology::add_cofaces(std::uint32_t j) {
    for (std::uint32_t i = start_[j]; i < start_[j + 1]; ++i) pivot_column_.toggle(rows_ - 1 - coface_[i]);
}

std::uint32_t Cohomology::add_column(std::uint32_t owner) {
    std::uint32_t work = 0;
    const auto add = [this, &work](std::uint32_t j) {
        source_count_ += sources_.has(j) ? ~std::uint64_t{0} : 1;
        sources_.toggle(j);
        add_cofaces(j);
        work += 1 + (start_[j + 1] - start_[j]) / 16;
    };
    if (owner < ColumnStore::stored) {
        add(owner);
        return work;
    }
    const std::uint32_t* const column = store_->column(owner - ColumnStore::stored);
    add(column[0]);
    for (std::uint32_t i = 0; i < column[1]; ++i) add(column[2 + i]);
    return work;
}

// Column j owns `row`; kept are the columns that were added to it, from which it can be made again.
Status Cohomology::claim(std::uint32_t k, std::uint32_t j, std::uint32_t row) {
    kills_above_.insert(row);
    owner_[row] = j;
    if (source_count_ > 0) {
        std::uint32_t handle;
        if (source_count_ >= 0xFFFFFFF0u) return Status::out_of_memory;
        std::uint32_t* sources = store_->append(static_cast<std::uint32_t>(source_count_), j, &handle);
        if (sources == nullptr) return Status::out_of_memory;
        for (; source_count_ > 0; --source_count_) {
            *sources = sources_.top();
            sources_.toggle(*sources++);
        }
        owner_[row] = ColumnStore::stored | handle;
    }
    return writer_.add(of(k).value[j], of(k + 1).value[row], k) ? Status::ok : Status::out_of_memory;
}

Status Cohomology::reduce(std::uint32_t k) {
    const HighScope scope(arena_);
    if (!list_cofaces(k)) return Status::out_of_memory;
    ColumnStore store(arena_);
    store_ = &store;
    rows_ = of(k + 1).count;
    pivot_column_.adopt(tree_words_[0], rows_);
    sources_.adopt(tree_words_[1], of(k).count);
    for (std::uint32_t i = 0; i < rows_; ++i) owner_[i] = none;
    for (std::uint32_t j = of(k).count; j-- > 0; ++done_) {
        if (kills_.has(j)) continue;
        if (stop(1)) return Status::cancelled;
        std::uint32_t row = start_[j] < start_[j + 1] ? coface_[start_[j]] : none;
        if (row != none && owner_[row] != none) {
            add_cofaces(j);
            do {
                if (stop(add_column(owner_[row]))) return Status::cancelled;
                const std::uint32_t top = pivot_column_.top();
                row = top == none ? none : rows_ - 1 - top;
            } while (row != none && owner_[row] != none);
        }
        if (row != none) {
            const Status status = claim(k, j, row);
            if (status != Status::ok) return status;
            while (!pivot_column_.empty()) pivot_column_.toggle(pivot_column_.top());
            continue;
        }
        while (!sources_.empty()) sources_.toggle(sources_.top());
        source_count_ = 0;
        if (!writer_.add_essential(of(k).value[j], k)) return Status::out_of_memory;
    }
    return Status::ok;
}

// Simplices without cofaces that kill nothing.
Status Cohomology::essential(std::uint32_t k) {
    for (std::uint32_t j = 0; j < of(k).count; ++j) {
        if (!kills_.has(j) && !writer_.add_essential(of(k).value[j], k)) return Status::out_of_memory;
    }
    return Status::ok;
}

Status Cohomology::run() {
    const std::uint32_t dimension = complex_.dimension;
    const std::uint32_t top = max_degree_ + 1 < dimension ? max_degree_ + 1 : dimension;
    std::uint64_t total = dimension > 0 ? of(1).count : 0;
    for (std::uint32_t k = 1; k < top; ++k) total += of(k).count;
    monitor_.begin(NETMESH_STAGE_REDUCE, total);
    Status status = reserve(top);
    if (status == Status::ok) status = unite_edges();
    for (std::uint32_t k = 1; k <= max_degree_ && status == Status::ok; ++k) {  // max_degree_ <= dimension
        if (k == dimension || of(k + 1).count == 0) {
            status = essential(k);
            break;
        }
        kills_above_.adopt(kill_words_[k % 2], of(k + 1).count);
        status = reduce(k);
        kills_ = kills_above_;
    }
    return status;
}

}  // namespace

Status persist_skeleton(const FilteredComplex& complex, std::uint32_t max_degree, bool keep_zero, const Work& work, PairList* out) {
    return persist_by<Cohomology>(complex, max_degree, keep_zero, work, out);
}

}  // namespace netmesh
