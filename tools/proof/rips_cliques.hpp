// The simplices of a Rips complex, for proofs. An edge has its rank, the place in the order of edges; a simplex of
// dimension p >= 1 is its last edge and its p - 1 other vertices, packed into a key whose order is that of the
// simplices: first the rank, then the others, the largest first.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "tools/proof/rips_edges.hpp"

namespace netmesh::tool {

class EdgeMatrix;

class RipsCliques {
public:
    using Matrix = EdgeMatrix;
    using Key = std::uint64_t;
    static constexpr Key no_key = ~Key{0};
    static constexpr std::uint32_t dimension_max = 62;

    explicit RipsCliques(const RipsEdges& edges);

    // Whether simplices of this dimension have keys.
    bool has_keys(std::uint32_t dimension) const {
        return dimension <= dimension_max && rank_bits_ + (dimension - 1) * vertex_bits_ < 64;
    }
    std::uint32_t last_edge(Key key, std::uint32_t p) const {
        return static_cast<std::uint32_t>(key >> (p - 1) * vertex_bits_);
    }
    double value(Key key, std::uint32_t p) const { return edges_[last_edge(key, p)].value; }
    // Calls f(key) for the p-simplices from the last to the first that are in no shortcut pair.
    template <class F> void each_column(std::uint32_t p, F f) const;
    // Calls f(key) for the cofaces of a p-simplex.
    template <class F> void each_coface(Key key, std::uint32_t p, F f) const;
    // The facet that this simplex of dimension q >= 2 is in a shortcut pair with, no_key if there is none.
    Key shortcut_facet(Key key, std::uint32_t q) const;

    // Of a last edge and the other vertices, ascending.
    Key key_of(std::uint32_t edge, const std::uint32_t* other, std::uint32_t count) const {
        Key key = edge;
        while (count > 0) key = key << vertex_bits_ | other[--count];
        return key;
    }
    std::uint32_t vertices() const { return vertices_; }
    std::uint32_t edge_count() const { return static_cast<std::uint32_t>(edges_.size()); }
    const RipsEdge& edge(std::uint32_t rank) const { return edges_[rank]; }

private:
    struct Joined {
        std::uint32_t vertex, rank;
    };
    struct Simplex {
        std::uint32_t count, last_edge;
        std::uint32_t vertex[dimension_max + 1], other[dimension_max];  // ascending
    };
    using Row = const Joined*;

    Row begin_of(std::uint32_t v) const { return joined_.data() + begin_[v]; }
    Row end_of(std::uint32_t v) const { return joined_.data() + begin_[v + 1]; }
    void read(Key key, std::uint32_t p, Simplex* s) const;
    // Calls f(w, the latest rank, which vertex that edge leads to) for the vertices below `end` that are joined to all
    // of these by edges before `before`, ascending; stops when f returns false.
    template <class F>
    void each_joined(const std::uint32_t* vertex, std::uint32_t count, std::uint32_t before, std::uint32_t end,
                     F f) const;
    // The candidates before `last` that v is joined to by edges before `edge`.
    void keep_joined(const std::vector<std::uint32_t>& from, std::size_t last, std::uint32_t v, std::uint32_t edge,
                     std::vector<std::uint32_t>* to) const;
    bool is_joined_to_any(const std::vector<std::uint32_t>& candidates, std::size_t last, std::uint32_t v,
                          std::uint32_t edge) const;

    const std::vector<RipsEdge>& edges_;
    std::uint32_t vertices_, rank_bits_ = 1, vertex_bits_ = 1;
    std::vector<std::size_t> begin_;
    std::vector<Joined> joined_;  // at each vertex the edges, by the other end
};

inline RipsCliques::RipsCliques(const RipsEdges& edges)
    : edges_(edges.edges), vertices_(edges.vertices), begin_(edges.vertices + std::size_t{1}),
      joined_(2 * edges.edges.size()) {
    while (edges_.size() >> rank_bits_ != 0) rank_bits_++;
    while ((vertices_ - 1) >> vertex_bits_ != 0) vertex_bits_++;
    for (const RipsEdge& e : edges_) {
        begin_[e.larger]++;
        begin_[e.smaller]++;
    }
    for (std::size_t v = 1; v <= vertices_; v++) begin_[v] += begin_[v - 1];
    for (std::uint32_t rank = 0; rank < edge_count(); rank++) {
        joined_[--begin_[edges_[rank].larger]] = {edges_[rank].smaller, rank};
        joined_[--begin_[edges_[rank].smaller]] = {edges_[rank].larger, rank};
    }
    for (std::uint32_t v = 0; v < vertices_; v++)
        std::sort(joined_.begin() + static_cast<std::ptrdiff_t>(begin_[v]),
                  joined_.begin() + static_cast<std::ptrdiff_t>(begin_[v + 1]),
                  [](const Joined& a, const Joined& b) { return a.vertex < b.vertex; });
}

inline void RipsCliques::read(Key key, std::uint32_t p, Simplex* s) const {
    const std::uint32_t others = p - 1;
    s->count = p + 1;
    for (std::uint32_t i = 0; i < others; i++, key >>= vertex_bits_)
        s->other[i] = static_cast<std::uint32_t>(key & ((Key{1} << vertex_bits_) - 1));
    s->last_edge = static_cast<std::uint32_t>(key);
    const std::uint32_t ends[] = {edges_[s->last_edge].smaller, edges_[s->last_edge].larger};
    std::merge(s->other, s->other + others, ends, ends + 2, s->vertex);
}

template <class F>
void RipsCliques::each_joined(const std::uint32_t* vertex, std::uint32_t count, std::uint32_t before, std::uint32_t end,
                              F f) const {
    Row at[dimension_max + 1];
    for (std::uint32_t i = 0; i < count; i++) at[i] = begin_of(vertex[i]);
    for (const Row last = end_of(vertex[0]); at[0] != last && at[0]->vertex < end; ++at[0]) {
        const std::uint32_t w = at[0]->vertex;
        std::uint32_t latest = at[0]->rank, far = 0, i = 1;
        for (; i < count; i++) {
            const Row other_last = end_of(vertex[i]);
            while (at[i] != other_last && at[i]->vertex < w) ++at[i];
            if (at[i] == other_last) return;
            if (at[i]->vertex != w) break;
            if (at[i]->rank > latest) latest = at[i]->rank, far = i;
        }
        if (i == count && latest < before && !f(w, latest, far)) return;
    }
}

template <class F> void RipsCliques::each_coface(Key key, std::uint32_t p, F f) const {
    Simplex s;
    read(key, p, &s);
    const std::uint32_t others = s.count - 2;
    each_joined(s.vertex, s.count, UINT32_MAX, UINT32_MAX, [&](std::uint32_t w, std::uint32_t rank, std::uint32_t far) {
        std::uint32_t other[dimension_max + 1], count = 0;
        if (rank < s.last_edge) {
            for (std::uint32_t i = 0; i < others && s.other[i] < w; i++) other[count++] = s.other[i];
            other[count] = w;
            for (std::uint32_t i = count++; i < others; i++) other[count++] = s.other[i];
        } else {
            for (std::uint32_t i = 0; i < s.count; i++)
                if (i != far) other[count++] = s.vertex[i];
        }
        f(key_of(rank < s.last_edge ? s.last_edge : rank, other, count));
        return true;
    });
}

inline RipsCliques::Key RipsCliques::shortcut_facet(Key key, std::uint32_t q) const {
    Simplex s;
    read(key, q, &s);
    std::uint32_t facet[dimension_max + 1] = {}, count = 0;
    for (std::uint32_t i = 0; i < s.count; i++)
        if (s.vertex[i] != s.other[0]) facet[count++] = s.vertex[i];
    bool is_first = true;
    each_joined(facet, count, s.last_edge, s.other[0],
                [&](std::uint32_t, std::uint32_t, std::uint32_t) { return is_first = false; });
    return is_first ? key_of(s.last_edge, s.other + 1, s.count - 3) : no_key;
}

inline void RipsCliques::keep_joined(const std::vector<std::uint32_t>& from, std::size_t last, std::uint32_t v,
                                     std::uint32_t edge, std::vector<std::uint32_t>* to) const {
    to->clear();
    Row at = begin_of(v);
    for (std::size_t i = 0; i < last; i++) {
        while (at != end_of(v) && at->vertex < from[i]) ++at;
        if (at == end_of(v)) return;
        if (at->vertex == from[i] && at->rank < edge) to->push_back(from[i]);
    }
}

inline bool RipsCliques::is_joined_to_any(const std::vector<std::uint32_t>& candidates, std::size_t last,
                                          std::uint32_t v, std::uint32_t edge) const {
    Row at = begin_of(v);
    for (std::size_t i = 0; i < last; i++) {
        while (at != end_of(v) && at->vertex < candidates[i]) ++at;
        if (at == end_of(v)) return false;
        if (at->vertex == candidates[i] && at->rank < edge) return true;
    }
    return false;
}

// The others of a simplex are chosen from the largest down, each among the candidates, which are joined to all that is
// chosen. The smallest one, v, makes a shortcut pair with the simplex without it if it is the first candidate. With the
// first candidate before it that is joined to it, if there is one, the simplex makes the other kind of shortcut pair.
template <class F> void RipsCliques::each_column(std::uint32_t p, F f) const {
    std::vector<std::vector<std::uint32_t>> candidates(p);
    std::vector<std::size_t> left(p);
    std::vector<std::uint32_t> chosen(p);
    for (std::uint32_t edge = edge_count(); edge-- > 0;) {
        const std::uint32_t ends[] = {edges_[edge].smaller, edges_[edge].larger};
        candidates[0].clear();
        each_joined(ends, 2, edge, UINT32_MAX, [&](std::uint32_t w, std::uint32_t, std::uint32_t) {
            candidates[0].push_back(w);
            return p > 1;
        });
        if (p == 1) {
            if (candidates[0].empty()) f(Key{edge});
            continue;
        }
        left[0] = candidates[0].size();
        for (std::uint32_t depth = 0;;) {
            if (left[depth] == 0) {
                if (depth-- == 0) break;
                continue;
            }
            const std::size_t i = --left[depth];
            const std::uint32_t v = candidates[depth][i];
            chosen[p - 2 - depth] = v;
            if (depth == p - 2) {
                if (i > 0 && !is_joined_to_any(candidates[depth], i, v, edge)) f(key_of(edge, chosen.data(), p - 1));
                continue;
            }
            keep_joined(candidates[depth], i, v, edge, &candidates[depth + 1]);
            left[depth + 1] = candidates[depth + 1].size();
            depth++;
        }
    }
}

}  // namespace netmesh::tool
