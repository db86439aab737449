// Lower-star persistence of a part of a triangulated disc, by its vertices and edges alone: degree 0 is a union of
// edges upwards and degree 1, by duality, one downwards (triangulated_ball.hpp), where a vertex of the hull, or with a
// simplex that is not in the part, is joined to `outside`. Takes 31 bytes a vertex or so. Pairs of zero length are not
// known.
#pragma once
#include "homology/lower_star/lower_star.hpp"
#include "homology/pair_writer.hpp"
#include "memory/work.hpp"

namespace netmesh {

// Small code goes without: stars tell all of it, and are there for cycles.
#ifdef __OPTIMIZE_SIZE__
constexpr bool unites_planar_edges = false;
#else
constexpr bool unites_planar_edges = true;
#endif

class PlanarPart {
public:
    PlanarPart(const LowerStarFiltration<2>& filtration, DiagramRequest request, const Work& work)
        : complex_(filtration.complex), part_(*filtration.part), value_(filtration.value), arena_(work.arena),
          monitor_(work.monitor), writer_(work.arena, request), zero_born_count_(filtration.zero_born_count),
          with_loops_(request.max_degree > 0) {}

    Status run();
    PairList finish() { return writer_.finish_without_cycles(); }
    std::uint64_t simplex_count() const { return simplex_count_; }

private:
    static constexpr std::uint8_t is_seen = 1, is_joined = 2;  // to `outside`

    bool has(CellId c) const { return part_.cell[c] != 0; }
    bool is_in(std::uint32_t v) const { return part_.vertex[v] != VertexPart::absent; }
    double birth(std::uint32_t v) const { return v < zero_born_count_ ? 0.0 : value_[v]; }
    bool reserve();
    Status read_vertices();
    std::uint8_t edges_of(CellId c) const;
    // act(later, earlier) for these edges, by the ranks of their ends.
    template <class Act> void each_edge(CellId c, Act&& act) const;
    // Lists, by the rank of one end of each edge, the rank of the other one: of the later end, or of the earlier one.
    void list_edges(bool by_later);
    bool join_upwards();
    bool join_downwards();

    TriangulationView<2> complex_;
    const Subcomplex<2>& part_;
    const double* value_;
    Arena& arena_;
    Monitor& monitor_;
    PairWriter writer_;
    std::uint32_t zero_born_count_;
    bool with_loops_;
    std::uint32_t *order_ = nullptr, *rank_ = nullptr;
    std::uint32_t* parent_ = nullptr;  // by rank
    std::uint32_t* begin_ = nullptr;   // [vertices + 1] by rank, into end_
    std::uint32_t* end_ = nullptr;     // ranks
    std::uint8_t* flags_ = nullptr;    // of vertices
    std::uint8_t* edges_ = nullptr;    // of cells
    std::uint64_t simplex_count_ = 0;
};

}  // namespace netmesh
