// How far the cell of a cage reaches.
#pragma once
#include "mesh/cages/cage.hpp"
#include "mesh/clip/any_corner.hpp"

namespace netmesh {

// Cells on the boundary of a cage: cells[-1 - k], k < count, as list_cage_boundary lists them.
struct CageBoundary {
    const CellId* cells;
    std::uint32_t count;
    CellId operator[](std::uint32_t k) const { return cells[-1 - static_cast<std::ptrdiff_t>(k)]; }
};

// The cell of a cage is that of its vertices together, clipped to the ball of the domain around it. The farthest point
// from the cage's centre of those that are corners within the ball or on edges of the cell; *corner is left as it is
// when there is none. *leaves_ball: there is a corner outside of the ball, or one that is not known. *boundary: stands
// until the next search. False when the gap is too small for the search.
bool find_cage_corner(const AnyStore& store, const Cage& cage, const AnyDomain& ball, AnyCorner* corner,
                      bool* leaves_ball, CageBoundary* boundary);

// Raises *out2, the squared distance from the cage's centre to which its clipped cell is known to reach, to that to
// which it does. O(boundary), and what find_cage_pole takes where a pole may be farther than anything else.
void raise_to_cage_cell(const AnyStore& store, const Cage& cage, const AnyDomain& ball, const CageBoundary& boundary,
                        double* out2);

// Offers what of the clipped cell of a cage is neither a corner nor on an edge but farther from the cage's centre than
// the root of bound2 (clipped_cell.hpp). O(boundary), and as much for each pole of a face of the cage's cell beyond
// that.
void find_cage_pole(const AnyStore& store, const Cage& cage, const AnyDomain& ball, const CageBoundary& boundary,
                    double bound2, AnyCorner* corner);
// The squared distance of that from the cage's centre; negative when there is none.
double distance2_of_cage_pole(const AnyStore& store, const Cage& cage, const AnyDomain& ball,
                              const CageBoundary& boundary, double bound2);

}  // namespace netmesh
