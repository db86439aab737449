// Persistence of Vietoris-Rips filtrations of which nothing but the edges is stored. Thesis 6.4.
#pragma once
#include <cstdint>

#include "homology/persistence.hpp"
#include "memory/work.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// The edges of a Rips complex as far as it is wanted: of few vertices with many edges a table of all pairs is made, of
// others a list at each vertex. What stands last at the arena's low end are value and, behind it, ends.
struct RipsGraph {
    static constexpr std::uint32_t vertices_max = 1u << 26, table_max = 0x10000;
    std::uint32_t vertices;    // >= 1
    std::uint32_t edge_count;  // < 2^31
    double* value;             // [edge_count], when the edge enters: >= 0, no NaN, no -0.0; vertices enter at 0
    // [edge_count]. For a table: larger vertex << 16 | smaller one; distinct, in any order. For lists: the smaller
    // vertex, edges in order of the larger one and then the smaller one. Equal values go by larger and smaller vertex.
    std::uint32_t* ends;
    // For lists: [vertices + 1], where the edges of each larger vertex begin. Null: for a table.
    const std::uint32_t* begin = nullptr;
    // Of degrees 0 and 1: when components of the graph are joined by what is not in it, ascending.
    const double* joined_at = nullptr;
    std::uint32_t joins = 0;

    static std::uint32_t edge(std::uint32_t larger, std::uint32_t smaller) { return larger << 16 | smaller; }
    // Calls f(larger, smaller, e) for each edge.
    template <class F> void each_edge(const Arena& arena, F f) const {
        std::uint32_t larger = 0;
        arena.each(edge_count, 8, [&](std::uint64_t at) {
            const auto e = static_cast<std::uint32_t>(at);
            while (begin != nullptr && begin[larger + 1] <= e) ++larger;
            begin != nullptr ? f(larger, ends[e], e) : f(ends[e] >> 16, ends[e] & 0xFFFF, e);
        });
    }
    // A table takes 4 n^2 bytes and is read 8 vertices at a time; lists take 16 bytes an edge.
    static bool takes_lists(std::uint32_t vertices, std::uint64_t edges) {
        return vertices > table_max || edges < std::uint64_t{vertices} * vertices / 32;
    }
};

// Whether persist_rips can number the simplices that it meets.
bool rips_has_numbers(const RipsGraph& graph, std::uint32_t max_degree);

// The diagram of the flag complex of the graph in degrees 0..max_degree (<= 30), at the arena's low end; a simplex
// enters with its last edge. Counted are the simplices of dimension up to max(1, max_degree). Columns of cofaces from
// the lowest degree up, neither they nor the complex being stored: a pair of a simplex with its first coface is found
// from the edges alone. Of the graph's 12 bytes for each edge 4 stay and 8 for each value that differs from the others;
// besides it takes 4 n^2 bytes for n vertices, a quarter for each edge, and about 40 for each simplex that needs a
// column, plus fill. With lists 36 bytes an edge in all instead, and as much for columns. The graph is gone: all from
// its beginning to the pairs is the caller's to give back, as it is without ok. out_of_memory, cancelled.
Status persist_rips(const RipsGraph& graph, DiagramRequest request, const Work& work, CountedPairs* out);

}  // namespace netmesh
