// A second opinion on how far clipped Voronoi cells reach. It shares no code with clipped_cell.hpp, which meshes are
// made and measured by.
#pragma once
#include <cstdint>

#include "mesh/any_domain.hpp"
#include "mesh/cages/cage.hpp"

namespace netmesh {

struct ReachRequest {
    AnyDomain outermost;
    const double* limit2;                    // [vertices]: squared, +infinity for vertices that may reach anywhere
    const Cage* cages = nullptr;             // with domains or neither
    const std::uint32_t* domains = nullptr;  // [vertices]: the cage to whose ball v's cell is clipped; none: outermost
};

// Does the cell of each vertex v, clipped to its ball, stay within limit2[v] of v? Returns the first vertex found whose
// cell does not, or of which that is not decided; none when all do.
//
// By what clipped_cell.hpp proves of planes, with the limit as s. A cell cut by the half-space has no corner beyond the
// limit, or it has. Then, unless v itself is in the half-space, the cut cell may still lie beyond the limit as a whole:
// it does unless the point of it nearest to v, the foot of v on some face in the plane, is within the limit. Where it
// lies beyond and v is outside of the ball, the point of the whole cell nearest to the ball's centre tells whether any
// of it is in the ball.
//
// Corners come from vertices, neighbour words and coordinates alone, relative to a vertex, by elimination in numbers of
// 106 bits, in 1,024 bits where those leave a corner or its side of the plane open. What 1,024 bits leave open as well,
// an exactly flat cell for one, is not decided: no honest mesh has it. No vertex with a finite limit may be on the
// hull. A compact store with room for the star of a vertex in its gap. O(cells).
Status check_reach(const AnyStore& store, const ReachRequest& request, std::uint32_t* beyond);

}  // namespace netmesh
