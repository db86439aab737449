// Disjoint sets whose root is always the oldest member, as the elder rule wants it.
#pragma once
#include <cstdint>

#include "vocabulary/status.hpp"

namespace netmesh {

// Root of the set of i; parent[root] == root. Halves the path: O(log n) amortised.
// Index: std::uint32_t, or shorter where there are few.
template <class Index> inline std::uint32_t find_root(Index* parent, std::uint32_t i) {
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

// Joins the sets of a and b, which become the roots of the two: of the older one and of the younger one that it takes
// in. is_older(x, y): whether root x is older than root y. False when a and b were in one set.
template <class Index, class IsOlder> bool unite(Index* parent, std::uint32_t& a, std::uint32_t& b, IsOlder is_older) {
    a = find_root(parent, a);
    b = find_root(parent, b);
    if (a == b) return false;
    if (is_older(b, a)) {
        const std::uint32_t t = a;
        a = b;
        b = t;
    }
    parent[b] = static_cast<Index>(a);
    return true;
}

struct EdgeEnds {
    std::uint32_t a, b;
};

// Degree 0 of a complex whose edges are numbered in the order in which they enter: an edge that joins two components
// ends the younger one. is_older(v, w): vertex v enters before w; left out: they are numbered in that order, too.
// parent: [vertices], filled here. Graph:
//   Status visit(e)                    before edge e
//   EdgeEnds ends(e)
//   Status merge(e, older, younger)    edge e joins two components, whose oldest vertices are these
//   Status keep(v)                     at the end: v is the oldest vertex of a component
template <class Graph, class IsOlder>
Status unite_edges(std::uint32_t* parent, std::uint32_t vertices, std::uint32_t edges, Graph graph, IsOlder is_older) {
    for (std::uint32_t v = 0; v < vertices; ++v) parent[v] = v;
    for (std::uint32_t e = 0; e < edges; ++e) {
        Status status = graph.visit(e);
        if (status != Status::ok) return status;
        EdgeEnds roots = graph.ends(e);
        if (!unite(parent, roots.a, roots.b, is_older)) continue;
        status = graph.merge(e, roots.a, roots.b);
        if (status != Status::ok) return status;
    }
    for (std::uint32_t v = 0; v < vertices; ++v) {
        const Status status = parent[v] == v ? graph.keep(v) : Status::ok;
        if (status != Status::ok) return status;
    }
    return Status::ok;
}
template <class Graph>
Status unite_edges(std::uint32_t* parent, std::uint32_t vertices, std::uint32_t edges, Graph graph) {
    return unite_edges(parent, vertices, edges, graph, [](std::uint32_t x, std::uint32_t y) { return x < y; });
}

}  // namespace netmesh
