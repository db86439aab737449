// Lower-star persistence of a triangulated disc. The link of a vertex is a circle, closed by `outside` at the hull, and
// has an edge from lower to upper vertices in each cell of which the vertex is neither the first nor the last. With two
// of them or none the lower and the upper part are in one piece each, and any vertex stands for a piece: one pass over
// the cells tells all that. Only around the other vertices, and around those of the hull, a walk leads from cell to
// cell. Degrees 0 and 1 are merge trees. Four words a vertex are kept, nothing else.
#pragma once
#include "homology/lower_star/lower_star.hpp"
#include "homology/lower_star/merge_tree.hpp"
#include "homology/lower_star/triangulated_ball.hpp"
#include "homology/pair_writer.hpp"
#include "memory/work.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {

class Surface {
public:
    Surface(const LowerStarFiltration<2>& filtration, DiagramRequest request, const Work& work)
        : complex_(filtration.complex), value_(filtration.value), arena_(work.arena), monitor_(work.monitor),
          writer_(work.arena, request), zero_born_count_(filtration.zero_born_count),
          with_loops_(request.max_degree > 0) {}

    Status run();
    PairList finish() { return writer_.finish_without_cycles(); }
    // Of a disc, where each edge is in two cells or in one and on the hull.
    std::uint64_t simplex_count() const {
        const std::uint64_t cells = complex_.cell_count;
        return complex_.vertex_count + (3 * cells + hull_edges_) / 2 + cells;
    }

private:
    // What a walk around a vertex has seen.
    struct Circle {
        VertexId vertex;              // walked around
        std::uint32_t rank;           // of it
        std::uint32_t seen, changes;  // link vertices; changes between lower and upper
        std::uint32_t lower_vertices;
        std::uint32_t lowest, highest;  // of the lower, of the upper link vertices, by rank
        std::uint32_t run_best;         // the same of the run of lower or upper ones at work
        bool first_lower, last_lower;
    };
    struct Corner {
        CellId cell;
        std::uint32_t from, to;  // positions of the two link vertices in the cell, in the direction of the walk
    };
    // u is not `outside`: a walk around a vertex of the hull begins there, so it is never compared as the later one.
    bool is_after(std::uint32_t u, std::uint32_t w) const { return w != outside() && rank_[u] > rank_[w]; }
    std::uint32_t outside() const { return complex_.vertex_count; }
    bool reserve();
    void read_cell(CellId c);
    static constexpr std::uint32_t ahead = 12;                      // cells
    [[gnu::always_inline]] void prefetch_vertices(CellId c) const;  // see memory/prefetch.hpp
    [[gnu::always_inline]] void prefetch_walks(CellId c) const;
    bool read_link(VertexId v, CellId cell, JoinList& joins);
    bool add_zero_pairs(const Circle& circle);
    bool advance(VertexId v, Corner* corner) const;
    bool walk(Circle* circle, Corner* corner, bool open, JoinList* joins, bool* closed) const;
    bool add_link_vertex(Circle* circle, std::uint32_t u, JoinList* joins) const;
    bool end_run(const Circle& circle, JoinList* joins) const;

    TriangulationView<2> complex_;
    const double* value_;
    Arena& arena_;
    Monitor& monitor_;
    PairWriter writer_;
    std::uint32_t zero_born_count_;
    bool with_loops_;
    // Until all links are read, above_ has in two bits in how many cells its vertex is neither first nor last; all set:
    // a walk is to come. A disc has at most two vertices more than cells, so that vertices leave these bits free.
    static constexpr std::uint32_t crossing = 1u << 30, walk_to_come = 3 * crossing;
    static_assert(FacetId::cells_max < crossing - 2, "bits of a vertex are free");
    std::uint32_t *order_ = nullptr, *rank_ = nullptr, *below_ = nullptr, *above_ = nullptr;
    std::uint32_t hull_edges_ = 0;
};

}  // namespace netmesh
