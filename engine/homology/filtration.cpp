// Persistence of an explicit filtration, one dimension of columns at a time: union-find for edges, union-find of the
// dual graph for the top dimension where that is possible, and column reduction from the top down for what lies
// between.
#include "homology/bit_tree.hpp"
#include "homology/column_store.hpp"
#include "homology/pair_writer.hpp"
#include "homology/persist_by.hpp"
#include "homology/union_find.hpp"
#include "memory/arena.hpp"

namespace netmesh {
namespace {

using Simplices = FilteredComplex::Simplices;

class Filtration {
public:
    Filtration(const FilteredComplex& complex, std::uint32_t max_degree, bool keep_zero, const Work& work)
        : complex_(complex), max_degree_(max_degree), arena_(work.arena), monitor_(work.monitor),
          writer_(work.arena, max_degree, keep_zero) {}

    Status run();
    PairList finish() { return writer_.finish(); }

private:
    Status reserve();
    Status unite_edges();
    Status unite_top(std::uint32_t k, bool* done);
    Status reduce(std::uint32_t k);
    Status essential_edges();

    std::uint32_t pivot_of(std::uint32_t k, std::uint32_t j) const;
    std::uint32_t add_boundary(std::uint32_t k, std::uint32_t j);
    std::uint32_t add_column(std::uint32_t k, std::uint32_t owner);
    Status claim(std::uint32_t k, std::uint32_t j, std::uint32_t pivot);
    bool row_dropped(std::uint32_t k, std::uint32_t row) const { return k == 2 && negative_.has(row); }
    bool stop(std::uint32_t work) { return monitor_.advance(done_, work); }
    const Simplices& of(std::uint32_t k) const { return complex_.of[k]; }

    const FilteredComplex& complex_;
    std::uint32_t max_degree_;
    Arena& arena_;
    Monitor& monitor_;
    PairWriter writer_;
    ColumnStore* store_ = nullptr;
    BitTree pivot_column_;
    std::uint64_t members_ = 0;       // of pivot_column_
    std::uint32_t* owner_ = nullptr;  // [largest count]: who has this row as pivot: a column, or stored | handle
    Bits negative_;                   // edges that join two components
    Bits paired_, paired_above_;      // (k-1)-simplices, k-simplices that are pivots: they give birth
    std::uint64_t* paired_words_[2] = {};
    std::uint64_t* tree_words_ = nullptr;
    std::uint64_t done_ = 0;
};

Status Filtration::reserve() {
    std::uint32_t most = 1;
    const std::uint32_t top = max_degree_ + 1 < complex_.dimension ? max_degree_ + 1 : complex_.dimension;
    for (std::uint32_t k = 0; k <= top; ++k) {
        if (of(k).count > most) most = of(k).count;
    }
    owner_ = arena_.take_high<std::uint32_t>(most);
    tree_words_ = arena_.take_high<std::uint64_t>(BitTree::words_needed(most));
    std::uint64_t* negative =
        arena_.take_high<std::uint64_t>(Bits::words_needed(complex_.dimension > 0 ? of(1).count : 0));
    paired_words_[0] = arena_.take_high<std::uint64_t>(Bits::words_needed(most));
    paired_words_[1] = arena_.take_high<std::uint64_t>(Bits::words_needed(most));
    if (owner_ == nullptr || tree_words_ == nullptr || negative == nullptr || paired_words_[0] == nullptr ||
        paired_words_[1] == nullptr) {
        return Status::out_of_memory;
    }
    negative_.adopt(negative, complex_.dimension > 0 ? of(1).count : 0);
    return Status::ok;
}

// Degree 0. The vertices are in order of value, so the older of two roots is the one with the lower number.
Status Filtration::unite_edges() {
    std::uint32_t* parent = owner_;
    for (std::uint32_t v = 0; v < of(0).count; ++v) parent[v] = v;
    const std::uint32_t edges = complex_.dimension > 0 ? of(1).count : 0;
    for (std::uint32_t e = 0; e < edges; ++e) {
        if (stop(1)) return Status::cancelled;
        std::uint32_t a = find_root(parent, of(1).faces[2 * std::size_t{e}]);
        std::uint32_t b = find_root(parent, of(1).faces[2 * std::size_t{e} + 1]);
        if (a == b) continue;
        if (a > b) {
            const std::uint32_t t = a;
            a = b;
            b = t;
        }
        parent[b] = a;
        negative_.insert(e);
        if (!writer_.add(of(0).value[b], of(1).value[e], 0)) return Status::out_of_memory;
    }
    for (std::uint32_t v = 0; v < of(0).count; ++v) {
        if (parent[v] == v && !writer_.add_essential(of(0).value[v], 0)) return Status::out_of_memory;
    }
    done_ += edges;
    return Status::ok;
}

// Degree k-1 for k = dimension when no (k-1)-simplex has more than two cofaces: seen backwards, each of them joins its
// two cofaces, or its coface and the outside. *done: whether that is so.
Status Filtration::unite_top(std::uint32_t k, bool* done) {
    *done = false;
    const HighScope scope(arena_);
    const std::uint32_t rows = of(k - 1).count, columns = of(k).count, outside = columns;
    const std::size_t faces = std::size_t{columns} * (k + 1);
    for (std::uint32_t f = 0; f < rows; ++f) owner_[f] = 0;
    for (std::size_t i = 0; i < faces; ++i) {
        if (++owner_[of(k).faces[i]] == 3) return Status::ok;
    }
    std::uint32_t* first = owner_;
    std::uint32_t* second = arena_.take_high<std::uint32_t>(rows);
    std::uint32_t* parent = arena_.take_high<std::uint32_t>(std::size_t{columns} + 1);
    if (second == nullptr || parent == nullptr) return Status::out_of_memory;
    for (std::uint32_t f = 0; f < rows; ++f) first[f] = second[f] = none;
    for (std::size_t i = 0; i < faces; ++i) {
        const std::uint32_t f = of(k).faces[i];
        (first[f] == none ? first : second)[f] = static_cast<std::uint32_t>(i / (k + 1));
    }
    *done = true;
    for (std::uint32_t j = 0; j <= columns; ++j) parent[j] = j;
    for (std::uint32_t f = rows; f-- > 0;) {
        if (stop(1)) return Status::cancelled;
        if (first[f] == none) continue;
        std::uint32_t a = find_root(parent, first[f]);
        std::uint32_t b = find_root(parent, second[f] == none ? outside : second[f]);
        if (a == b) continue;
        if (a < b) {
            const std::uint32_t t = a;
            a = b;
            b = t;
        }
        parent[b] = a;
        paired_.insert(f);
        if (!writer_.add(of(k - 1).value[f], of(k).value[b], k - 1)) return Status::out_of_memory;
    }
    for (std::uint32_t j = 0; j < columns && k <= max_degree_; ++j) {
        if (parent[j] == j && !writer_.add_essential(of(k).value[j], k)) return Status::out_of_memory;
    }
    done_ += columns;
    return Status::ok;
}

// The largest row of the boundary of simplex j that counts.
std::uint32_t Filtration::pivot_of(std::uint32_t k, std::uint32_t j) const {
    const std::uint32_t* faces = of(k).faces + std::size_t{j} * (k + 1);
    std::uint32_t pivot = none;
    for (std::uint32_t i = 0; i <= k; ++i) {
        if ((pivot == none || faces[i] > pivot) && !row_dropped(k, faces[i])) pivot = faces[i];
    }
    return pivot;
}

std::uint32_t Filtration::add_boundary(std::uint32_t k, std::uint32_t j) {
    const std::uint32_t* faces = of(k).faces + std::size_t{j} * (k + 1);
    for (std::uint32_t i = 0; i <= k; ++i) {
        if (row_dropped(k, faces[i])) continue;
        members_ += pivot_column_.has(faces[i]) ? ~std::uint64_t{0} : 1;
        pivot_column_.toggle(faces[i]);
    }
    return 1;
}

std::uint32_t Filtration::add_column(std::uint32_t k, std::uint32_t owner) {
    if (owner < ColumnStore::stored) return add_boundary(k, owner);
    const std::uint32_t* column = store_->column(owner - ColumnStore::stored);
    for (std::uint32_t i = 0; i < column[1]; ++i) {
        members_ += pivot_column_.has(column[2 + i]) ? ~std::uint64_t{0} : 1;
        pivot_column_.toggle(column[2 + i]);
    }
    return 1 + column[1] / 16;
}

// Column j, reduced in pivot_column_ (or equal to its boundary when that is empty), becomes the owner of its pivot.
Status Filtration::claim(std::uint32_t k, std::uint32_t j, std::uint32_t pivot) {
    paired_.insert(pivot);
    if (!writer_.add(of(k - 1).value[pivot], of(k).value[j], k - 1)) return Status::out_of_memory;
    owner_[pivot] = j;
    if (members_ == 0) return Status::ok;
    if (members_ >= 0xFFFFFFF0u) return Status::out_of_memory;
    std::uint32_t handle;
    std::uint32_t* rows = store_->append(static_cast<std::uint32_t>(members_), j, &handle);
    if (rows == nullptr) return Status::out_of_memory;
    for (; members_ > 0; --members_) {
        *rows = pivot_column_.top();
        pivot_column_.toggle(*rows++);
    }
    owner_[pivot] = ColumnStore::stored | handle;
    return Status::ok;
}

Status Filtration::reduce(std::uint32_t k) {
    const HighScope scope(arena_);
    ColumnStore store(arena_);
    store_ = &store;
    const std::uint32_t rows = of(k - 1).count, columns = of(k).count;
    if (rows == 0) return Status::ok;
    pivot_column_.adopt(tree_words_, rows);
    for (std::uint32_t i = 0; i < rows; ++i) owner_[i] = none;
    for (std::uint32_t j = 0; j < columns; ++j, ++done_) {
        if (paired_above_.has(j)) continue;  // clearing: it gives birth
        if (stop(1)) return Status::cancelled;
        std::uint32_t pivot = pivot_of(k, j);
        if (owner_[pivot] != none) {  // there is one: not all three edges of a triangle join components
            add_boundary(k, j);
            do {
                if (stop(add_column(k, owner_[pivot]))) return Status::cancelled;
                pivot = pivot_column_.top();
            } while (pivot != none && owner_[pivot] != none);
        }
        if (pivot == none) {
            if (k <= max_degree_ && !writer_.add_essential(of(k).value[j], k)) return Status::out_of_memory;
            continue;
        }
        const Status status = claim(k, j, pivot);
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

Status Filtration::essential_edges() {
    for (std::uint32_t e = 0; e < of(1).count; ++e) {
        if (negative_.has(e) || paired_above_.has(e)) continue;
        if (!writer_.add_essential(of(1).value[e], 1)) return Status::out_of_memory;
    }
    return Status::ok;
}

Status Filtration::run() {
    const std::uint32_t dimension = complex_.dimension;
    const std::uint32_t top = max_degree_ + 1 < dimension ? max_degree_ + 1 : dimension;
    std::uint64_t total = 0;
    for (std::uint32_t k = 1; k <= top; ++k) total += of(k).count;
    monitor_.begin(NETMESH_STAGE_REDUCE, total);
    Status status = reserve();
    if (status == Status::ok) status = unite_edges();
    std::uint64_t* above_words = paired_words_[0];
    std::uint64_t* words = paired_words_[1];
    if (status == Status::ok) paired_above_.adopt(above_words, of(top).count);
    for (std::uint32_t k = top; k >= 2 && status == Status::ok; --k) {
        paired_.adopt(words, of(k - 1).count);
        bool done = false;
        if (k == dimension) status = unite_top(k, &done);
        if (status == Status::ok && !done) status = reduce(k);
        paired_above_ = paired_;
        std::uint64_t* t = above_words;
        above_words = words;
        words = t;
    }
    if (status == Status::ok && dimension >= 1 && max_degree_ >= 1) status = essential_edges();
    return status;
}

}  // namespace

Status persist_filtration(const FilteredComplex& complex, std::uint32_t max_degree, bool keep_zero, const Work& work, PairList* out) {
    return persist_by<Filtration>(complex, max_degree, keep_zero, work, out);
}

}  // namespace netmesh
