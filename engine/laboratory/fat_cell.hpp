// In-ball and out-ball of one Voronoi cell (thesis 5.1), clipped to a ball where it is not inside.
//
// The proofs of 5.3 carry over to cells v each cut by a convex set B_v, where edge (u, v) counts when the facet of u
// and v has a point x in B_u and B_v: they use that the cut cells are convex and hold x and their in-balls, which are
// disjoint; that out-balls hold the cut cells; and 5.3.3 that |x - v| is at most 2 R_v, which is why out_radius is
// never below half of reach, wherever v is. 5.4 (of p: all edges of its cell) and 5.5 (all corners) are said of a p
// whose own cell is not cut. Where B_v is one of two balls, one inside the other, any x of the inner one will do.
#pragma once
#include <cstdint>

#include "memory/arena.hpp"
#include "mesh/any_domain.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

struct FatCell {
    std::uint32_t corners;  // of the whole cell: D-balls at its vertex
    std::uint32_t degree;   // Delaunay neighbours
    std::uint32_t met;      // of them those whose facet has a corner in the ball or an edge across its sphere
    bool known;             // false: doubles do not know a corner, and nothing else is said
    bool bounded;           // not on the hull
    bool whole;             // all corners are in the ball: not clipped
    double nearest;         // distance to the nearest neighbour
    double reach;           // to the farthest point of the clipped cell, or more
    double in_centre[dimension_max],
        in_radius;  // of a ball in the clipped cell, the largest up to rounding; 0: none was found
    double out_centre[dimension_max],
        out_radius;  // of a ball around it, the smallest one where the cell is whole; reach / 2 at least
};

// On a compact store with recomputed balls; Vertex::next is used.
class FatCells {
public:
    // part[vertices], or null: of neighbours only those with part[w] <= most are counted in `met`.
    FatCells(const AnyStore& store, const AnyDomain& ball, Arena& arena, const std::uint8_t* part, std::uint8_t most)
        : dim(store.dim), store_(store), ball_(ball), arena_(arena), part_(part), most_(most) {}

    // A ball that holds all vertices and all corners that are known, with as much room again: what clips the unbounded
    // cells of a triangulation without a domain. Facets meet it, as each has a corner.
    static AnyDomain surrounding_ball(const AnyStore& store);
    // Is this corner known well enough, and are the squares of the cell's edges numbers that doubles hold?
    static bool knows(const AnyStore& store, CellId c);

    // Of an inserted vertex. Scratch: its star. out_of_memory.
    Status measure(VertexId v, FatCell* cell);

private:
    void add_neighbour(VertexId v, VertexId w, FatCell* cell);
    void add_corners(VertexId v, CellId c, FatCell* cell);
    void add_point(const double* x);
    void note_facets(const AnyCell& cell, int left_out);
    void measure_in_ball(VertexId v, FatCell* cell);

    const int dim;
    const AnyStore store_;
    const AnyDomain ball_;
    Arena& arena_;
    const std::uint8_t* const part_;
    const std::uint8_t most_;
    VertexId* neighbour_;
    bool* meets_;
    double *plane_, *point_;  // mirror images of the in-ball's origin, dim numbers each; points of the clipped cell
    std::uint32_t points_;
    double doubt_;  // of the corners
};

// The fattest of what is looked at of a cell: all of it when it is inside the domain, else the piece in the domain or
// that in the surrounding ball, whichever has the smaller beta. Without a domain (radius 0) there is the ball alone.
class FattestCells {
public:
    enum class Piece : std::uint32_t { whole, in_domain, in_ball };

    FattestCells(const AnyStore& store, const AnyDomain& domain, Arena& arena, const std::uint8_t* part = nullptr,
                 std::uint8_t most = 0);
    FattestCells(const FattestCells&) = delete;
    FattestCells& operator=(const FattestCells&) = delete;

    double radius() const { return around_.radius; }
    // As FatCells::measure; `met` is of facets that meet the domain.
    Status measure(VertexId v, FatCell* cell, Piece* piece);

private:
    const AnyDomain around_, first_;
    const bool has_domain_;
    FatCells in_first_, in_ball_;
};

}  // namespace netmesh
