// Fatness of Voronoi cells (thesis 5): in-ball, out-ball, and what they say about the complexity of the diagram.
#pragma once
#include <cstdint>

#include "delaunay/load.hpp"
#include "memory/work.hpp"
#include "mesh/any_domain.hpp"
#include "vocabulary/monitor.hpp"

namespace netmesh {

// A part of the diagram, and bounds on its complexity by the fatness of its cells. 5's proofs are about two cells at a
// time, so they hold for any set of cells: `edges` are the Delaunay edges between vertices of the part, and so on. beta
// of a cell is rounded up: in-balls are inscribed, out-balls enclose corners and their errors.
struct FatPart {
    std::uint64_t cells;              // Voronoi cells of the part
    double beta_max, beta_mean;       // out-radius over in-radius
    double aspect_max;                // the same for balls about the vertices
    std::uint64_t edges, degree_max;  // degree: neighbours in the part
    double edges_bound;               // 5.3.1: (4 beta)^D cells
    double faces, faces_bound;        // at least the simplices of dimension 1 to D; 5.3.2: (4 beta)^(D^2) cells
    double degree_share;              // 5.3.3: largest degree(p) / ((8 beta)^D (floor(log2 tau_p) + 1))
    double planar_share;   // 5.4.5, D = 2: largest degree(p) / (6 pi / arcsin(1 / (4 beta))), over p with all
                           // neighbours in the part; 0 for D > 2
    double corners_share;  // 5.5.1: largest ratio of what p's corners are at least to what they are:
                           // 2 V_{D-1} / (S_{D-1} (2 beta_p)^D), S the regular simplex in the unit ball
};

struct FatnessAnalysis {
    // Whole cells of vertices that are neither exempt nor on the hull (so the cells are bounded), with corners and
    // squared edges that doubles know; those of them that lie in the domain.
    FatPart bounded, inside;
    // Cells clipped to the domain, of vertices in it: the largest ball inside both, the smallest about the clipped
    // cell's corners. 5's proofs do not speak of them where the sphere bulges beyond its corners, so they bound
    // nothing.
    std::uint64_t clipped;
    double clipped_max, clipped_mean;
    // Every vertex: inputs, Steiner points, shells, the boundary. Of a cell that is not inside the domain two convex
    // pieces are looked at, what is in the domain and what is in FatCells::surrounding_ball, which is all of it when it
    // is bounded; beta is that of the piece that is the fatter one. See fat_cell.hpp. Edges and faces are those that
    // have a corner in the domain (without one: in the ball) or an edge across its sphere.
    FatPart all;
    std::uint64_t left_out;  // cells with a corner that doubles do not know, or with no in-ball that was found
    double all_radius;       // of the surrounding ball
};

Status analyse_fatness(const AnyStore& store, const AnyDomain& domain, const Work& work, FatnessAnalysis* analysis);
// On a compact store, a triangulation or a mesh; the domain is ball(centre, reach), reach 0 for none. Corners are
// solved for anew; uses vertex.next and cell.mark. O(cells) plus the balls, about 2 D^2 multiply-adds a cell and vertex
// times the steps of both searches, three times. Scratch: 1 byte a vertex, and the largest star. out_of_memory,
// cancelled.
template <int D>
Status analyse_fatness(Store<D>& store, const Domain<D>& domain, const Work& work, FatnessAnalysis* analysis) {
    recompute_balls<D>(store);
    return analyse_fatness(AnyStore(store), AnyDomain(domain), work, analysis);
}

// The bound that does not hold, null when all do.
const char* violated_fatness_bound(const FatPart& part);

}  // namespace netmesh
