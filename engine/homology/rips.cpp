// Cohomology of a Rips complex from the lowest degree up. The simplices of a dimension are met from the last to the
// first, by their last edge and cliques among the vertices that it is joined to by earlier edges; most are in apparent
// pairs, which the same walk sees. The others are columns, but for those that end a class (clearing). A column is made
// again from the simplices that were added to it.
#include "homology/rips.hpp"

#include "homology/column_store.hpp"
#include "homology/key_heap.hpp"
#include "homology/pair_writer.hpp"
#include "homology/rips_simplices.hpp"
#include "homology/union_find.hpp"
#include "numerics/sort.hpp"

namespace netmesh {
namespace {

// Simplices that end a class and what their columns are, by open addressing.
class PivotTable {
public:
    // For so many pivots. False: out of memory.
    bool open(std::uint32_t pivots, Arena& arena) {
        bits_ = 4;
        while ((std::uint64_t{1} << bits_) < pivots + std::uint64_t{pivots} / 2) ++bits_;
        const std::size_t slots = std::size_t{1} << bits_;
        key_ = arena.take_high<std::uint64_t>(slots);
        column_ = arena.take_high<std::uint32_t>(slots);
        for (std::size_t i = 0; i < slots && key_ != nullptr; ++i) key_[i] = no_key;
        return key_ != nullptr && column_ != nullptr;
    }
    void insert(std::uint64_t key, std::uint32_t column) {
        const std::size_t at = place_of(key);
        key_[at] = key;
        column_[at] = column;
    }
    // The column of a pivot, `none` if it is not one.
    std::uint32_t find(std::uint64_t key) const {
        const std::size_t at = place_of(key);
        return key_[at] == key ? column_[at] : none;
    }
    bool has(std::uint64_t key) const { return key_[place_of(key)] == key; }
    // Moves the keys up so that they end at `end`; the columns are gone. Returns where they begin.
    std::size_t keep_keys(Arena& arena, std::size_t end) {
        const std::size_t bytes = sizeof(std::uint64_t) << bits_;
        auto* const to = reinterpret_cast<std::uint64_t*>(arena.at(end - bytes));
        __builtin_memmove(to, key_, bytes);
        key_ = to;
        column_ = nullptr;
        return end - bytes;
    }

private:
    std::size_t place_of(std::uint64_t key) const {
        const std::size_t mask = (std::size_t{1} << bits_) - 1;
        std::size_t at = static_cast<std::size_t>(key * 0x9E3779B97F4A7C15u >> (64 - bits_));
        while (key_[at] != no_key && key_[at] != key) at = (at + 1) & mask;
        return at;
    }

    std::uint64_t* key_ = nullptr;
    std::uint32_t *column_ = nullptr, bits_ = 4;
};

class Rips {
public:
    Rips(RipsGraph& graph, std::uint32_t max_degree, bool keep_zero, const Work& work)
        : graph_(graph), max_degree_(max_degree), arena_(work.arena), monitor_(work.monitor),
          writer_(work.arena, max_degree, keep_zero), heap_(work.arena) {}

    Status run();
    PairList finish() { return writer_.finish(); }
    std::uint64_t simplices() const { return simplices_; }

private:
    Status unite_edges();
    Status collect(std::uint32_t p);
    Status collect_edges();
    Status walk_cliques(std::uint32_t p, std::uint32_t edge);
    bool note(std::uint32_t p, std::uint32_t edge, const std::uint32_t* candidates, std::uint32_t i);
    bool add_column(std::uint64_t key);
    std::uint32_t lune(std::uint32_t edge, std::uint32_t* out, std::uint32_t most) const;

    Status reduce_all(std::uint32_t p);
    Status reduce(std::uint32_t p, std::uint32_t j);
    bool is_free(const RipsSimplex& coface) const;
    bool add(std::uint64_t key, std::uint32_t p);
    bool add_owner(const RipsSimplex& pivot, std::uint32_t p, bool* found);
    bool claim(std::uint32_t p, std::uint32_t j, std::uint64_t pivot);
    std::uint64_t column(std::uint32_t j) const { return columns_[-1 - static_cast<std::ptrdiff_t>(j)]; }
    double value_of(std::uint64_t key) const { return graph_.value[simplices_of_.edge_of(key)]; }
    bool stop(std::uint32_t work) { return monitor_.advance(done_, work); }

    RipsGraph& graph_;
    std::uint32_t max_degree_;
    Arena& arena_;
    Monitor& monitor_;
    PairWriter writer_;
    RipsSimplices simplices_of_;
    KeyHeap heap_;
    Bits negative_;                        // edges that join two components
    std::uint32_t* candidates_ = nullptr;  // [max_degree][vertices], of the walk
    std::uint32_t chosen_[RipsSimplex::vertices_max] = {};
    PivotTable pivots_below_, pivots_;  // of the degree below, of this one
    std::uint64_t* columns_ = nullptr;  // the end of the list, which grows downwards
    std::uint32_t column_count_ = 0;
    std::uint32_t* added_at_ = nullptr;           // [column] where the list of what was added to it is, 0: nothing
    std::uint64_t* added_ = nullptr;              // the end of these lists, which grow downwards: count, then keys
    std::uint64_t added_words_ = 0, adding_ = 0;  // in them; in the list of the column at work
    std::uint64_t simplices_ = 0, done_ = 0;
    std::uint32_t work_ = 0;
};

Status Rips::unite_edges() {
    const std::uint32_t n = graph_.vertices;
    std::uint64_t* const words = arena_.take_high<std::uint64_t>(Bits::words_needed(graph_.edge_count));
    const std::size_t high = arena_.high_mark();
    std::uint32_t* const parent = arena_.take_high<std::uint32_t>(n);
    if (words == nullptr || parent == nullptr) return Status::out_of_memory;
    negative_.adopt(words, graph_.edge_count);
    for (std::uint32_t v = 0; v < n; ++v) parent[v] = v;
    for (std::uint32_t e = 0; e < graph_.edge_count; ++e) {
        if (stop(1)) return Status::cancelled;
        const std::uint32_t a = find_root(parent, simplices_of_.smaller_end(e));
        const std::uint32_t b = find_root(parent, simplices_of_.larger_end(e));
        if (a == b) continue;
        parent[a < b ? b : a] = a < b ? a : b;
        negative_.insert(e);
        if (!writer_.add(0, graph_.value[e], 0)) return Status::out_of_memory;
    }
    for (std::uint32_t v = 0; v < n; ++v) {
        if (parent[v] == v && !writer_.add_essential(0, 0)) return Status::out_of_memory;
    }
    arena_.release_high(high);
    simplices_ = std::uint64_t{n} + graph_.edge_count;
    return Status::ok;
}

// The first vertices, `most` at most, that both ends of an edge are joined to by earlier edges.
std::uint32_t Rips::lune(std::uint32_t edge, std::uint32_t* out, std::uint32_t most) const {
    const std::uint32_t* const a = simplices_of_.row(simplices_of_.smaller_end(edge));
    const std::uint32_t* const b = simplices_of_.row(simplices_of_.larger_end(edge));
    std::uint32_t count = 0;
    for (std::uint32_t w = 0; w < graph_.vertices && count < most; ++w) {
        out[count] = w;
        count += a[w] < edge && b[w] < edge ? 1 : 0;
    }
    return count;
}

bool Rips::add_column(std::uint64_t key) {
    if (column_count_ == none - 1 || !arena_.extend_high(sizeof key)) return false;
    columns_[-1 - static_cast<std::ptrdiff_t>(column_count_++)] = key;
    return true;
}

// An edge that has a coface of its own value makes an apparent pair with the first one.
Status Rips::collect_edges() {
    for (std::uint32_t e = graph_.edge_count; e-- > 0;) {
        if (stop(1)) return Status::cancelled;
        if (negative_.has(e)) continue;
        std::uint32_t first;
        const bool fits = lune(e, &first, 1) > 0 ? writer_.add(graph_.value[e], graph_.value[e], 1)
                                                 : add_column(simplices_of_.key_of(e, nullptr, 0));
        if (!fits) return Status::out_of_memory;
    }
    return Status::ok;
}

// The p-simplex of the chosen vertices and the i-th candidate. All candidates are joined to the chosen ones, so with
// the first of them it is the first coface of what was chosen; with a later one it is not.
bool Rips::note(std::uint32_t p, std::uint32_t edge, const std::uint32_t* candidates, std::uint32_t i) {
    ++simplices_;
    if (i == 0) return true;  // ends a class at once
    const std::uint32_t* const row = simplices_of_.row(candidates[i]);
    for (std::uint32_t c = 0; c < i; ++c) {
        if (row[candidates[c]] < edge) return writer_.add(graph_.value[edge], graph_.value[edge], p);
    }
    chosen_[0] = candidates[i];
    const std::uint64_t key = simplices_of_.key_of(edge, chosen_, p - 1);
    return pivots_below_.has(key) || add_column(key);
}

// The p-simplices, p >= 2, with this last edge: from the largest vertex down, each time the last candidate first.
Status Rips::walk_cliques(std::uint32_t p, std::uint32_t edge) {
    const std::uint32_t n = graph_.vertices;
    std::uint32_t left[RipsSimplex::vertices_max];
    left[0] = lune(edge, candidates_, n);
    if (stop(n / 64 + left[0] / 16)) return Status::cancelled;
    for (std::uint32_t depth = 0;;) {
        std::uint32_t* const candidates = candidates_ + std::size_t{depth} * n;
        if (depth == p - 2) {
            for (std::uint32_t i = left[depth]; i-- > 0;) {
                if (!note(p, edge, candidates, i)) return Status::out_of_memory;
            }
            left[depth] = 0;
        }
        if (left[depth] == 0) {
            if (depth-- == 0) return Status::ok;
            continue;
        }
        const std::uint32_t i = --left[depth];
        chosen_[p - 2 - depth] = candidates[i];
        const std::uint32_t* const row = simplices_of_.row(candidates[i]);
        std::uint32_t* const next = candidates + n;
        std::uint32_t count = 0;
        for (std::uint32_t c = 0; c < i; ++c) {
            next[count] = candidates[c];
            count += row[candidates[c]] < edge ? 1 : 0;
        }
        left[++depth] = count;
        if (stop(1 + i / 16)) return Status::cancelled;
    }
}

Status Rips::collect(std::uint32_t p) {
    columns_ = reinterpret_cast<std::uint64_t*>(arena_.at(arena_.high_mark()));
    column_count_ = 0;
    if (p == 1) return collect_edges();
    for (std::uint32_t e = graph_.edge_count; e-- > 0;) {
        const Status status = walk_cliques(p, e);
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

// Whether no column has this pivot.
bool Rips::is_free(const RipsSimplex& coface) const {
    return pivots_.find(coface.key) == none && simplices_of_.apparent_facet(coface) == no_key;
}

// Adds the cofaces of a p-simplex to the column at work and notes it. False: out of memory.
bool Rips::add(std::uint64_t key, std::uint32_t p) {
    if (!arena_.extend_high(sizeof key)) return false;
    added_[-1 - static_cast<std::ptrdiff_t>(added_words_ + adding_++)] = key;
    RipsSimplex s;
    simplices_of_.read(key, p, &s);
    work_ += 1 + graph_.vertices / 32;
    return simplices_of_.each_coface(s, [this](std::uint64_t coface) { return heap_.push(coface); });
}

// Adds the column that has this pivot. False: out of memory.
bool Rips::add_owner(const RipsSimplex& pivot, std::uint32_t p, bool* found) {
    const std::uint32_t owner = pivots_.find(pivot.key);
    const std::uint64_t facet = owner == none ? simplices_of_.apparent_facet(pivot) : no_key;
    *found = owner != none || facet != no_key;
    if (!*found) return true;
    if (!heap_.push(pivot.key)) return false;
    if (owner == none) return add(facet, p);
    if (!add(column(owner), p)) return false;
    const std::uint32_t at = added_at_[owner];
    const std::uint64_t count = at == 0 ? 0 : added_[-static_cast<std::ptrdiff_t>(at)];
    for (std::uint64_t i = 1; i <= count; ++i) {
        if (!add(added_[-static_cast<std::ptrdiff_t>(at) + static_cast<std::ptrdiff_t>(i)], p)) return false;
    }
    return true;
}

// Column j has this pivot; what was added to it twice is left out of its list.
bool Rips::claim(std::uint32_t p, std::uint32_t j, std::uint64_t pivot) {
    std::uint64_t* const list = added_ - added_words_ - adding_;
    sort(list, adding_, [](std::uint64_t a, std::uint64_t b) { return a < b; });
    std::uint64_t kept = 0;
    for (std::uint64_t i = 0; i < adding_; ++i) {
        if (kept > 0 && list[kept - 1] == list[i]) {
            --kept;
        } else {
            list[kept++] = list[i];
        }
    }
    __builtin_memmove(list + (adding_ - kept), list, sizeof *list * static_cast<std::size_t>(kept));
    arena_.release_high(arena_.high_mark() + sizeof *list * static_cast<std::size_t>(adding_ - kept));
    added_at_[j] = 0;
    if (kept > 0) {
        if (added_words_ + kept + 1 >= none || !arena_.extend_high(sizeof *list)) return false;
        added_words_ += kept + 1;
        added_[-static_cast<std::ptrdiff_t>(added_words_)] = kept;
        added_at_[j] = static_cast<std::uint32_t>(added_words_);
    }
    pivots_.insert(pivot, j);
    return writer_.add(value_of(column(j)), value_of(pivot), p);
}

Status Rips::reduce(std::uint32_t p, std::uint32_t j) {
    RipsSimplex s, pivot;
    adding_ = 0;
    simplices_of_.read(column(j), p, &s);
    const std::uint64_t first = simplices_of_.first_coface(s);
    if (first != no_key) {  // an emergent pair: the first of all its cofaces
        simplices_of_.read(first, p + 1, &pivot);
        if (is_free(pivot)) return claim(p, j, first) ? Status::ok : Status::out_of_memory;
    }
    heap_.open();
    bool fits = simplices_of_.each_coface(s, [this](std::uint64_t coface) { return heap_.push(coface); });
    std::uint64_t key = no_key;
    for (bool found = true; fits && found;) {
        if (stop(1 + work_)) return Status::cancelled;
        work_ = 0;
        key = heap_.pop_pivot();
        if (key == no_key) break;
        simplices_of_.read(key, p + 1, &pivot);
        fits = add_owner(pivot, p, &found);
    }
    heap_.close();
    if (!fits) return Status::out_of_memory;
    if (key != no_key) return claim(p, j, key) ? Status::ok : Status::out_of_memory;
    arena_.release_high(arena_.high_mark() + sizeof key * static_cast<std::size_t>(adding_));
    return writer_.add_essential(value_of(column(j)), p) ? Status::ok : Status::out_of_memory;
}

Status Rips::reduce_all(std::uint32_t p) {
    if (!pivots_.open(column_count_, arena_)) return Status::out_of_memory;
    added_at_ = arena_.take_high<std::uint32_t>(column_count_);
    if (added_at_ == nullptr) return Status::out_of_memory;
    added_ = reinterpret_cast<std::uint64_t*>(arena_.at(arena_.high_mark()));
    added_words_ = 0;
    for (std::uint32_t j = 0; j < column_count_; ++j, ++done_) {
        const Status status = reduce(p, j);
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

Status Rips::run() {
    monitor_.begin(NETMESH_STAGE_REDUCE, 0);
    if (!simplices_of_.open(graph_, max_degree_, arena_)) return Status::out_of_memory;
    Status status = unite_edges();
    if (max_degree_ >= 2) candidates_ = arena_.take_high<std::uint32_t>(std::size_t{max_degree_} * graph_.vertices);
    if (max_degree_ >= 2 && candidates_ == nullptr) return Status::out_of_memory;
    const std::size_t high = arena_.high_mark();
    for (std::uint32_t p = 1; p <= max_degree_ && p < graph_.vertices && status == Status::ok; ++p) {
        status = collect(p);
        if (status == Status::ok) status = reduce_all(p);
        if (status != Status::ok) return status;
        arena_.release_high(pivots_.keep_keys(arena_, high));
        pivots_below_ = pivots_;
    }
    return status;
}

}  // namespace

Status persist_rips(RipsGraph& graph, std::uint32_t max_degree, bool keep_zero, const Work& work,
                    PairList* out, std::uint64_t* simplices) {
    if (!rips_has_numbers(graph, max_degree)) return Status::invalid_argument;
    ArenaScope scope(work.arena);
    Rips rips(graph, max_degree, keep_zero, work);
    const Status status = rips.run();
    if (status != Status::ok) return status;
    *out = rips.finish();
    *simplices = rips.simplices();
    scope.keep_low_from_now();
    return Status::ok;
}

}  // namespace netmesh
