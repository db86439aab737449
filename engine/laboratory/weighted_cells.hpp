// Additively weighted Voronoi cells of cages (thesis 4.6).
#pragma once
#include "mesh/cages/hierarchy_view.hpp"

namespace netmesh {

// A cage as a weighted point c of the domain Omega around it. The points of Omega are its vertices, of weight 0, and
// the centres of the cages directly inside it, each with the distance to the farthest of its shell as weight. With u
// over the others of them,
//
//   x is in the cell of c  when  |x - c| - w_c <= |x - u| - w_u for all u
//   in_radius              r = min (|c - u| - w_u + w_c) / 2
//   feature_size           f = min |c - u|
//   epsilon                e, the least with w_c <= e (|c - u| - w_u) and w_u <= e (|c - u| - w_c) for all u
//
// Towards u the ball of radius r about c comes nearest to leaving the cell, at c + r (u - c) / |u - c|, where both
// sides are equal for the u of the minimum: so r is the in-radius while no w_u reaches c's. Lemma 4.6.1 then says
// 2 r (1 - e) / (1 + e) <= f <= 2 r / (1 - e), where e < 1.
struct WeightedCell {
    double weight, in_radius, feature_size, epsilon;
};

// cells[cage_count]. A frame does not count. O(cages * (vertices + cages)).
void measure_weighted_cells(const HierarchyView& mesh, WeightedCell* cells);

}  // namespace netmesh
