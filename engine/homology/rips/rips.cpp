// Cohomology of a Rips complex from the lowest degree up. The simplices of a dimension are met from the last to the
// first, by their last edge and cliques among the vertices that it is joined to by earlier edges; most are in apparent
// pairs, which the same walk sees. The others are columns, but for those that end a class (clearing).
#include "homology/rips/rips.hpp"

#include "homology/bit_set.hpp"
#include "homology/matrix/reduction.hpp"
#include "homology/pair_writer.hpp"
#include "homology/rips/rips_columns.hpp"
#include "homology/union_find.hpp"
#include "numerics/real.hpp"

namespace netmesh {
namespace {

class Rips {
public:
    Rips(const RipsGraph& graph, const RipsSimplices& simplices, DiagramRequest request, const Work& work)
        : graph_(graph), simplices_of_(simplices), vertices_(simplices.vertices()), edges_(simplices.edges()),
          max_degree_(request.max_degree), arena_(work.arena), progress_{work.monitor}, writer_(work.arena, request),
          columns_(simplices, work.arena, progress_) {}

    Status run();
    PairList finish() { return writer_.finish(); }
    std::uint64_t simplices() const { return simplices_; }

private:
    struct Components;
    struct Recorder;

    bool take_bits(BitSet* out);
    Status join_components();
    Status collect(std::uint32_t p);
    Status find_last_edges();
    Status collect_edges();
    Status walk_cliques(std::uint32_t p, std::uint32_t edge);
    bool visit_simplex(std::uint32_t p, std::uint32_t edge, const std::uint32_t* candidates, std::uint32_t i);
    bool list_column(std::uint64_t key);
    std::uint32_t lune(std::uint32_t edge, std::uint32_t* out) const;
    std::uint32_t cost_of_lune(std::uint32_t edge) const {
        const std::uint32_t ends[] = {simplices_of_.smaller_end(edge), simplices_of_.larger_end(edge)};
        return simplices_of_.cost_of(ends, 2) / 4;
    }
    Status reduce(std::uint32_t p);
    double value_of(std::uint64_t key) const { return simplices_of_.value(simplices_of_.edge_of(key)); }
    // A pair of two simplices that enter with this edge. False: out of memory.
    bool add_zero(std::uint32_t edge, std::uint32_t p) {
        if (!writer_.keeps_zero()) return true;
        const double value = simplices_of_.value(edge);
        return writer_.add(value, value, p);
    }

    const RipsGraph& graph_;
    const RipsSimplices& simplices_of_;
    std::uint32_t joins_ = 0;  // of components, by what is not in the graph
    std::uint32_t vertices_, edges_, max_degree_;
    Arena& arena_;
    Progress progress_;
    PairWriter writer_;
    RipsColumns columns_;
    BitSet joining_;                       // edges that join two components
    BitSet last_;                          // with lists: edges that are last of a triangle
    std::uint32_t* candidates_ = nullptr;  // [max_degree][vertices], of the walk
    std::uint32_t chosen_[RipsSimplex::vertices_max] = {};
    PivotTable pivots_below_;        // of the degree below: p-simplices that end a class
    std::uint64_t* list_ = nullptr;  // the end of the list of columns, which grows downwards
    std::uint32_t list_count_ = 0;
    std::uint64_t simplices_ = 0;
};

// Degree 0; all vertices enter at 0.
struct Rips::Components {
    Rips& rips;

    Status visit(std::uint32_t) { return rips.progress_.stop(1) ? Status::cancelled : Status::ok; }
    EdgeEnds ends(std::uint32_t e) const {
        return {rips.simplices_of_.smaller_end(e), rips.simplices_of_.larger_end(e)};
    }
    Status merge(std::uint32_t e, std::uint32_t, std::uint32_t) {
        rips.joining_.insert(e);
        return rips.writer_.add(0, rips.simplices_of_.value(e), 0) ? Status::ok : Status::out_of_memory;
    }
    Status keep(std::uint32_t) {
        const bool is_joined = rips.joins_ < rips.graph_.joins;
        const double death = is_joined ? rips.graph_.joined_at[rips.joins_++] : infinity;
        return rips.writer_.add(0, death, 0) ? Status::ok : Status::out_of_memory;
    }
};

// A bit for each edge.
bool Rips::take_bits(BitSet* out) {
    const std::size_t count = BitSet::words_needed(edges_);
    std::uint64_t* const words = arena_.take_high<std::uint64_t>(count);
    if (words == nullptr) return false;
    arena_.each(count, 1, [words](std::uint64_t i) { words[i] = 0; });
    out->adopt_filled(words);
    return true;
}

Status Rips::join_components() {
    const bool is_taken = take_bits(&joining_);
    const HighScope scope(arena_);
    std::uint32_t* const parent = arena_.take_high<std::uint32_t>(vertices_);
    if (!is_taken || parent == nullptr) return Status::out_of_memory;
    simplices_ = std::uint64_t{vertices_} + edges_;
    return unite_edges(parent, vertices_, edges_, Components{*this});
}

// The vertices that both ends of an edge are joined to by earlier edges.
std::uint32_t Rips::lune(std::uint32_t edge, std::uint32_t* out) const {
    const std::uint32_t ends[] = {simplices_of_.smaller_end(edge), simplices_of_.larger_end(edge)};
    std::uint32_t count = 0;
    if (simplices_of_.has_lists()) {
        simplices_of_.each_joined(ends, 2, edge, vertices_, [&](std::uint32_t w, std::uint32_t, auto) {
            out[count++] = w;
            return true;
        });
        return count;
    }
    const std::uint32_t *const a = simplices_of_.row(ends[0]).table, *const b = simplices_of_.row(ends[1]).table;
    for (std::uint32_t w = 0; w < vertices_; ++w) {
        out[count] = w;
        count += a[w] < edge && b[w] < edge ? 1 : 0;
    }
    return count;
}

bool Rips::list_column(std::uint64_t key) {
    if (list_count_ == none - 1 || !arena_.extend_high(sizeof key)) return false;
    list_[-1 - static_cast<std::ptrdiff_t>(list_count_++)] = key;
    return true;
}

// Which edges are last of a triangle, of all edges at a vertex one after the other: they are near each other in lists,
// and those that follow in rank are not.
Status Rips::find_last_edges() {
    if (!take_bits(&last_)) return Status::out_of_memory;
    for (std::uint32_t v = 0; v < vertices_; ++v) {
        const RipsRow row = simplices_of_.row(v);
        for (const RipsRow::Joined* at = row.begin; at != row.end && at->vertex < v; ++at) {
            const std::uint32_t ends[] = {v, at->vertex};
            if (progress_.stop(1 + simplices_of_.cost_of(ends, 2))) return Status::cancelled;
            if (simplices_of_.is_last_of_triangle(at->rank)) last_.insert(at->rank);
        }
    }
    return Status::ok;
}

// An edge that has a coface of its own value makes an apparent pair with the first one.
Status Rips::collect_edges() {
    const bool is_found = simplices_of_.has_lists();
    const Status status = is_found ? find_last_edges() : Status::ok;
    if (status != Status::ok) return status;
    list_ = reinterpret_cast<std::uint64_t*>(arena_.at(arena_.high_mark()));
    for (std::uint32_t e = edges_; e-- > 0;) {
        if (progress_.stop(1 + (is_found ? 0 : cost_of_lune(e)))) return Status::cancelled;
        if (joining_.has(e)) continue;
        const bool is_last = is_found ? last_.has(e) : simplices_of_.is_last_of_triangle(e);
        const bool fits = is_last ? add_zero(e, 1) : list_column(simplices_of_.key_of(e, nullptr, 0));
        if (!fits) return Status::out_of_memory;
    }
    return Status::ok;
}

// The p-simplex of the chosen vertices and the i-th candidate. All candidates are joined to the chosen ones, so with
// the first of them it is the first coface of what was chosen; with a later one it is not.
bool Rips::visit_simplex(std::uint32_t p, std::uint32_t edge, const std::uint32_t* candidates, std::uint32_t i) {
    ++simplices_;
    if (i == 0) return true;  // ends a class at once
    const RipsRow row = simplices_of_.row(candidates[i]);
    const RipsRow::Joined* at = row.begin;
    for (std::uint32_t c = 0; c < i; ++c) {
        if (row.rank_of(candidates[c], &at) < edge) return add_zero(edge, p);
    }
    chosen_[0] = candidates[i];
    const std::uint64_t key = simplices_of_.key_of(edge, chosen_, p - 1);
    return pivots_below_.has(key) || list_column(key);
}

// The p-simplices, p >= 2, with this last edge: from the largest vertex down, each time the last candidate first.
Status Rips::walk_cliques(std::uint32_t p, std::uint32_t edge) {
    const std::uint32_t n = vertices_;
    std::uint32_t left[RipsSimplex::vertices_max];
    left[0] = lune(edge, candidates_);
    if (progress_.stop(cost_of_lune(edge) + left[0] / 16)) return Status::cancelled;
    for (std::uint32_t depth = 0;;) {
        std::uint32_t* const candidates = candidates_ + std::size_t{depth} * n;
        if (depth == p - 2) {
            for (std::uint32_t i = left[depth]; i-- > 0;) {
                if (!visit_simplex(p, edge, candidates, i)) return Status::out_of_memory;
            }
            left[depth] = 0;
        }
        if (left[depth] == 0) {
            if (depth-- == 0) return Status::ok;
            continue;
        }
        const std::uint32_t i = --left[depth];
        chosen_[p - 2 - depth] = candidates[i];
        const RipsRow row = simplices_of_.row(candidates[i]);
        const RipsRow::Joined* at = row.begin;
        std::uint32_t* const next = candidates + n;
        std::uint32_t count = 0;
        for (std::uint32_t c = 0; c < i; ++c) {
            next[count] = candidates[c];
            count += row.rank_of(candidates[c], &at) < edge ? 1 : 0;
        }
        left[++depth] = count;
        if (progress_.stop(1 + i / 16 + (row.table == nullptr ? simplices_of_.cost_of(&candidates[i], 1) : 0)))
            return Status::cancelled;
    }
}

Status Rips::collect(std::uint32_t p) {
    list_count_ = 0;
    if (p == 1) return collect_edges();
    list_ = reinterpret_cast<std::uint64_t*>(arena_.at(arena_.high_mark()));
    for (std::uint32_t e = edges_; e-- > 0;) {
        const Status status = walk_cliques(p, e);
        if (status != Status::ok) return status;
    }
    return Status::ok;
}

// Columns in the order of their list.
struct Rips::Recorder {
    Rips& rips;
    std::uint32_t p, next_column;

    bool next(std::uint32_t* j) {
        if (next_column == rips.list_count_) return false;
        ++rips.progress_.done;
        *j = next_column++;
        return true;
    }
    Status pair(std::uint32_t j) {
        const double birth = rips.value_of(rips.columns_.column(j)), death = rips.value_of(rips.columns_.pivot());
        return rips.columns_.own_pivot(j) && rips.writer_.add(birth, death, p) ? Status::ok : Status::out_of_memory;
    }
    Status zero(std::uint32_t j) {
        rips.columns_.forget();
        const double birth = rips.value_of(rips.columns_.column(j));
        return rips.writer_.add_essential(birth, p) ? Status::ok : Status::out_of_memory;
    }
};

Status Rips::reduce(std::uint32_t p) {
    if (!columns_.begin(p, list_, list_count_)) return Status::out_of_memory;
    Recorder recorder = {*this, p, 0};
    return reduce_columns(columns_, recorder);
}

Status Rips::run() {
    Status status = join_components();
    if (max_degree_ >= 2) candidates_ = arena_.take_high<std::uint32_t>(std::size_t{max_degree_} * vertices_);
    if (max_degree_ >= 2 && candidates_ == nullptr) return Status::out_of_memory;
    const std::size_t high = arena_.high_mark();
    for (std::uint32_t p = 1; p <= max_degree_ && p < vertices_ && status == Status::ok; ++p) {
        status = collect(p);
        if (status == Status::ok) status = reduce(p);
        if (status != Status::ok) return status;
        arena_.release_high(columns_.pivots().keep_keys(arena_, high));
        pivots_below_ = columns_.pivots();
    }
    return status;
}

}  // namespace

Status persist_rips(const RipsGraph& graph, DiagramRequest request, const Work& work, CountedPairs* out) {
    if (!rips_has_numbers(graph, request.max_degree)) return Status::invalid_argument;
    work.monitor.begin(NETMESH_STAGE_REDUCE, 0);
    const HighScope scope(work.arena);
    RipsSimplices simplices;
    if (!simplices.open(graph, request.max_degree, work.arena)) return Status::out_of_memory;
    Rips rips(graph, simplices, request, work);
    const Status status = write_diagram(rips, work.arena, &out->pairs);
    out->simplices = rips.simplices();
    return status;
}

}  // namespace netmesh
