// The reduction of filtration.cpp without its shortcuts: a reduced column is the cycle of the pair that it makes.
// Classes that never die have no such column; theirs are traced back through the additions that made their column zero.
#include "homology/cycles.hpp"

#include "homology/bit_tree.hpp"
#include "homology/column_store.hpp"
#include "homology/pair_writer.hpp"
#include "homology/spanning_forest.hpp"
#include "homology/union_find.hpp"

namespace netmesh {
namespace {

using Simplices = FilteredComplex::Simplices;

// A chain under construction: a bit tree that knows its size.
class Chain {
public:
    void adopt(std::uint64_t* words, std::uint32_t size) {
        tree_.adopt(words, size);
        members_ = 0;
    }
    void toggle(std::uint32_t i) {
        members_ += tree_.has(i) ? ~std::uint64_t{0} : 1;
        tree_.toggle(i);
    }
    std::uint32_t top() const { return members_ == 0 ? none : tree_.top(); }
    std::uint64_t members() const { return members_; }
    // Moves the members, from the largest down, to rows[members()].
    void take(std::uint32_t* rows) {
        while (members_ > 0) {
            *rows = tree_.top();
            toggle(*rows++);
        }
    }
    void clear() {
        while (members_ > 0) toggle(tree_.top());
    }

private:
    BitTree tree_;
    std::uint64_t members_ = 0;
};

class Tracer {
public:
    Tracer(const FilteredComplex& complex, std::uint32_t max_degree, bool keep_zero, const Work& work)
        : complex_(complex), max_degree_(max_degree), arena_(work.arena), monitor_(work.monitor),
          writer_(work.arena, max_degree, keep_zero) {}

    Status run(PairList* out, CycleStore* kept);

private:
    Status reserve();
    Status unite_edges();
    Status close_edges();
    Status reduce(std::uint32_t k);
    Status claim(std::uint32_t k, std::uint32_t j, std::uint32_t pivot);
    Status trace(std::uint32_t k, std::uint32_t j);
    Status note(double birth, double death, std::uint32_t degree, Chain& cycle);
    void add_boundary(std::uint32_t k, std::uint32_t j);
    std::uint32_t add_column(std::uint32_t k, std::uint32_t owner);
    std::uint32_t pivot_of(std::uint32_t k, std::uint32_t j) const;
    std::uint32_t creator(std::uint32_t owner) const {
        return owner < ColumnStore::stored ? owner : store_->column(owner - ColumnStore::stored)[0];
    }
    bool stop(std::uint32_t work) { return monitor_.advance(done_, work); }
    const Simplices& of(std::uint32_t k) const { return complex_.of[k]; }

    const FilteredComplex& complex_;
    std::uint32_t max_degree_, top_ = 0, most_ = 1;
    Arena& arena_;
    Monitor& monitor_;
    PairWriter writer_;
    ColumnStore* store_ = nullptr;
    Chain column_, sources_, cycle_;
    std::uint64_t* chain_words_[3] = {};
    std::uint32_t* owner_ = nullptr;
    SpanningForest forest_;
    Bits negative_, paired_, paired_above_;
    std::uint64_t* paired_words_[2] = {};
    std::uint64_t done_ = 0;
};

Status Tracer::reserve() {
    for (std::uint32_t k = 0; k <= top_; ++k) {
        if (of(k).count > most_) most_ = of(k).count;
    }
    const std::uint32_t edges = complex_.dimension > 0 ? of(1).count : 0;
    owner_ = arena_.take_high<std::uint32_t>(most_);
    for (std::uint64_t*& words : chain_words_) {
        words = arena_.take_high<std::uint64_t>(BitTree::words_needed(most_));
        if (words == nullptr) return Status::out_of_memory;
    }
    for (std::uint64_t*& words : paired_words_) {
        words = arena_.take_high<std::uint64_t>(Bits::words_needed(most_));
        if (words == nullptr) return Status::out_of_memory;
    }
    std::uint64_t* const negative = arena_.take_high<std::uint64_t>(Bits::words_needed(edges));
    if (owner_ == nullptr || negative == nullptr || !forest_.reserve(of(0).count, arena_)) return Status::out_of_memory;
    negative_.adopt(negative, edges);
    return Status::ok;
}

// Notes a pair with what `cycle` holds, and empties that.
Status Tracer::note(double birth, double death, std::uint32_t degree, Chain& cycle) {
    if (!writer_.keeps(birth, death, degree)) {
        cycle.clear();
        return Status::ok;
    }
    if (cycle.members() >= 0xFFFFFFF0u) return Status::out_of_memory;
    std::uint32_t handle;
    std::uint32_t* const rows = store_->append(static_cast<std::uint32_t>(cycle.members()), none, &handle);
    if (rows == nullptr) return Status::out_of_memory;
    cycle.take(rows);
    return writer_.add(birth, death, degree, ColumnStore::stored | handle) ? Status::ok : Status::out_of_memory;
}

Status Tracer::unite_edges() {
    std::uint32_t* const parent = owner_;
    cycle_.adopt(chain_words_[0], of(0).count);
    for (std::uint32_t v = 0; v < of(0).count; ++v) parent[v] = v;
    const std::uint32_t edges = complex_.dimension > 0 ? of(1).count : 0;
    for (std::uint32_t e = 0; e < edges; ++e, ++done_) {
        if (stop(1)) return Status::cancelled;
        const std::uint32_t a = find_root(parent, of(1).faces[2 * std::size_t{e}]);
        const std::uint32_t b = find_root(parent, of(1).faces[2 * std::size_t{e} + 1]);
        if (a == b) continue;
        const std::uint32_t older = a < b ? a : b, younger = a < b ? b : a;
        parent[younger] = older;
        negative_.insert(e);
        cycle_.toggle(older);
        cycle_.toggle(younger);
        const Status status = note(of(0).value[younger], of(1).value[e], 0, cycle_);
        if (status != Status::ok) return status;
    }
    for (std::uint32_t v = 0; v < of(0).count; ++v) {
        if (parent[v] != v) continue;
        cycle_.toggle(v);
        const Status status = note(of(0).value[v], __builtin_inf(), 0, cycle_);
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

// Essential classes of degree 1: an edge and the way back through the forest of the edges before it.
Status Tracer::close_edges() {
    if (complex_.dimension == 0 || max_degree_ == 0) return Status::ok;
    const Simplices& edges = of(1);
    cycle_.adopt(chain_words_[0], edges.count > 0 ? edges.count : 1);
    forest_.grow(edges.faces, edges.count, [this](std::uint32_t e) { return negative_.has(e); });
    for (std::uint32_t e = 0; e < edges.count; ++e) {
        if (negative_.has(e) || paired_above_.has(e)) continue;
        cycle_.toggle(e);
        forest_.path(edges.faces[2 * std::size_t{e}], edges.faces[2 * std::size_t{e} + 1],
                     [this](std::uint32_t tree_edge) { cycle_.toggle(tree_edge); });
        if (stop(1 + static_cast<std::uint32_t>(cycle_.members() / 16))) return Status::cancelled;
        const Status status = note(edges.value[e], __builtin_inf(), 1, cycle_);
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

std::uint32_t Tracer::pivot_of(std::uint32_t k, std::uint32_t j) const {
    const std::uint32_t* const faces = of(k).faces + std::size_t{j} * (k + 1);
    std::uint32_t pivot = faces[0];
    for (std::uint32_t i = 1; i <= k; ++i) {
        if (faces[i] > pivot) pivot = faces[i];
    }
    return pivot;
}

void Tracer::add_boundary(std::uint32_t k, std::uint32_t j) {
    const std::uint32_t* const faces = of(k).faces + std::size_t{j} * (k + 1);
    for (std::uint32_t i = 0; i <= k; ++i) column_.toggle(faces[i]);
}

std::uint32_t Tracer::add_column(std::uint32_t k, std::uint32_t owner) {
    if (owner < ColumnStore::stored) {
        add_boundary(k, owner);
        return 1;
    }
    const std::uint32_t* const column = store_->column(owner - ColumnStore::stored);
    for (std::uint32_t i = 0; i < column[1]; ++i) column_.toggle(column[2 + i]);
    return 1 + column[1] / 16;
}

// Column j, reduced in column_ (or equal to its boundary when that is empty), becomes the owner of its pivot.
Status Tracer::claim(std::uint32_t k, std::uint32_t j, std::uint32_t pivot) {
    paired_.insert(pivot);
    owner_[pivot] = j;
    std::uint32_t cycle = j + 1;
    if (column_.members() > 0) {
        if (column_.members() >= 0xFFFFFFF0u) return Status::out_of_memory;
        std::uint32_t handle;
        std::uint32_t* const rows = store_->append(static_cast<std::uint32_t>(column_.members()), j, &handle);
        if (rows == nullptr) return Status::out_of_memory;
        column_.take(rows);
        owner_[pivot] = cycle = ColumnStore::stored | handle;
    }
    return writer_.add(of(k - 1).value[pivot], of(k).value[j], k - 1, cycle) ? Status::ok : Status::out_of_memory;
}

// The cycle of column j, which was reduced to zero: j and the columns whose sum its boundary is. Reduced columns in
// that sum are replaced by what they came from, from the last to the first, so each is met once.
Status Tracer::trace(std::uint32_t k, std::uint32_t j) {
    sources_.toggle(j);
    for (std::uint32_t at; (at = sources_.top()) != none;) {
        sources_.toggle(at);
        cycle_.toggle(at);
        const std::uint32_t unreduced = pivot_of(k, at);
        if (at != j && owner_[unreduced] == at) continue;
        add_boundary(k, at);
        for (std::uint32_t pivot; (pivot = column_.top()) != none;) {
            const std::uint32_t owner = owner_[pivot];
            if (owner == none) return Status::internal;
            const std::uint32_t source = creator(owner);
            if (source == at) break;
            sources_.toggle(source);
            if (stop(add_column(k, owner))) return Status::cancelled;
        }
        column_.clear();
    }
    return note(of(k).value[j], __builtin_inf(), k, cycle_);
}

Status Tracer::reduce(std::uint32_t k) {
    const std::uint32_t rows = of(k - 1).count, columns = of(k).count;
    if (rows == 0 || columns == 0) return Status::ok;
    column_.adopt(chain_words_[0], rows);
    sources_.adopt(chain_words_[1], columns);
    cycle_.adopt(chain_words_[2], columns);
    for (std::uint32_t i = 0; i < rows; ++i) owner_[i] = none;
    for (std::uint32_t j = 0; j < columns; ++j, ++done_) {
        if (paired_above_.has(j)) continue;  // it gives birth to a pair that is noted already
        if (stop(1)) return Status::cancelled;
        std::uint32_t pivot = pivot_of(k, j);
        if (owner_[pivot] != none) {
            add_boundary(k, j);
            do {
                if (stop(add_column(k, owner_[pivot]))) return Status::cancelled;
                pivot = column_.top();
            } while (pivot != none && owner_[pivot] != none);
        }
        if (pivot == none && k > max_degree_) continue;
        const Status status = pivot == none ? trace(k, j) : claim(k, j, pivot);
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

Status Tracer::run(PairList* out, CycleStore* kept) {
    const std::size_t high = arena_.high_mark();
    top_ = max_degree_ + 1 < complex_.dimension ? max_degree_ + 1 : complex_.dimension;
    std::uint64_t total = 0;
    for (std::uint32_t k = 1; k <= top_; ++k) total += of(k).count;
    monitor_.begin(NETMESH_STAGE_REDUCE, total);
    Status status = reserve();
    if (status != Status::ok) return status;
    const std::size_t store_top = arena_.high_mark();
    ColumnStore store(arena_);
    store_ = &store;
    status = unite_edges();
    paired_above_.adopt(paired_words_[0], of(top_).count);
    for (std::uint32_t k = top_; k >= 2 && status == Status::ok; --k) {
        std::uint64_t* const words = paired_words_[(top_ - k + 1) % 2];
        paired_.adopt(words, of(k - 1).count);
        status = reduce(k);
        paired_above_ = paired_;
    }
    if (status == Status::ok) status = close_edges();
    if (status != Status::ok) return status;
    // The store moves up over what only the reduction needed.
    const std::size_t bytes = store_top - arena_.high_mark();
    __builtin_memmove(arena_.at(high - bytes), arena_.at(store_top - bytes), bytes);
    arena_.release_high(high - bytes);
    *kept = {0, high};
    *out = writer_.finish();
    return Status::ok;
}

}  // namespace

Status persist_with_cycles(const FilteredComplex& complex, std::uint32_t max_degree, bool keep_zero, const Work& work, PairList* out, CycleStore* store) {
    if (complex.dimension > FilteredComplex::dimension_max) return Status::invalid_argument;
    if (max_degree > complex.dimension) max_degree = complex.dimension;
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    work.arena.release_high(high & ~(Arena::alignment - 1));
    Tracer tracer(complex, max_degree, keep_zero, work);
    const Status status = tracer.run(out, store);
    if (status == Status::ok) return status;
    work.arena.release_low(low);
    work.arena.release_high(high);
    return status;
}

Cycle cycle_of(const FilteredComplex& complex, const CycleStore& store, const Arena& arena, const Pair& pair) {
    if (pair.cycle < ColumnStore::stored) {
        const std::uint32_t k = pair.degree + 1;
        return {complex.of[k].faces + std::size_t{pair.cycle - 1} * (k + 1), k + 1};
    }
    const std::size_t back = std::size_t{pair.cycle - ColumnStore::stored} * 16;
    const auto* const column = reinterpret_cast<const std::uint32_t*>(arena.at(store.top - back));
    return {column + 2, column[1]};
}

Cycle lower_star_cycle(const CycleStore& store, const Arena& arena, const Pair& pair) {
    const auto* const cycle =
        reinterpret_cast<const std::uint32_t*>(arena.at(store.begin + (std::size_t{pair.cycle} - 1) * 16));
    return {cycle + 1, cycle[0]};
}

}  // namespace netmesh
