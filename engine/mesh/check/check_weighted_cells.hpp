// Do the cages of a mesh keep the distances that 4.6 asks of additive weights? A second opinion: it shares no
// definition with weighted_cells.hpp, and looks at Delaunay neighbours where that looks at all points of a domain.
#pragma once
#include "delaunay/check.hpp"
#include "mesh/cages/hierarchy_view.hpp"

namespace netmesh {

// Scratch: distances from a cage's centre.
struct CageFigures {
    double farthest, nearest;  // of its shell
    double outside, member;    // nearest vertex that is not in the cage, nearest other member of the domain around it
};

// Two vertices of a cell stand for members of the innermost domain that both are in: themselves, or the cages of that
// domain that they are in. A cage's weight w is the distance from its centre to the farthest of its shell.
//
// - Of two members a and b, one of them a cage: w_a <= (|a - b| - w_b) / 3, and w_b likewise. That is the premise of
//   4.6.1 with e = 1/3, so the in-radius r of each weighted cell and the distance f to the nearest member have
//   r <= f <= 3 r. It gives 4.6.2 for a vertex v, too, with r half of the distance to its nearest neighbour n: if that
//   is in a cage about b then |v - b| <= 2 r + w_b and w_b <= |v - b| / 3, so f <= 3 r.
// - 4.6.2 of a cage, with the in-radius of the cell that its vertices have together: half of the distances from the
//   centre to the nearest vertex outside and to the nearest of its shell.
//
// That nearest vertex is a neighbour of one inside: shrink the ball about the centre with it on its sphere towards it,
// until its last vertex inside is on the sphere too. figures: [cages]. O(cells * depth of the hierarchy).
CheckResult check_weighted_cells(const HierarchyView& mesh, CageFigures* figures);

}  // namespace netmesh
