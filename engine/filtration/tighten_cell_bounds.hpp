// The least and the largest distance from the Voronoi cell of a Steiner vertex to the inputs, narrower than the bounds
// of certificate/interval.hpp, which know the cell by its out-radius and one corner alone.
//
// Let Y be the corners of v's cell, so Vor(v) = conv Y.
//
//   lo  dist(p, Vor(v)) >= w.p - max over y in Y of w.y for every unit vector w; the best w comes from the point of
//   conv Y
//       nearest to p (Wolfe's algorithm). The minimum over all inputs is searched in the tree of the inputs with the
//       directions found so far, which bound whole boxes of inputs at once.
//   hi  min over p of |x - p|^2 <= sum of lambda_p |x - p|^2 for any weights lambda >= 0 of sum 1, a convex function of
//   x,
//       so largest at a corner. Weights go step by step to the input nearest to the corner that is worst.
//
// Whatever directions and weights are found, the bounds hold; all are rounded outwards, by the corners' own errors too.
// A cell next to an input has lo = d_P / 2 and often no second input near its far end, so the worst ratio of a mesh
// does not change; larger scales gain. Inputs' bounds are exact as they are.
#pragma once
#include "filtration/any_mesh.hpp"
#include "mesh/input_tree.hpp"

namespace netmesh {

// Narrows interval[v] of every Steiner vertex whose cell's corners are known; intervals hold for min(d_P, mesh.cut()).
// By whole cells, also where they are clipped: what holds there holds of a part. Absent vertices keep theirs. Marks of
// cells are used. About 10-20 us a vertex in D = 4. Scratch: 4 bytes a vertex, 5 an input, 8 D a corner of the largest
// cell. out_of_memory, cancelled.
Status tighten_cell_bounds(const AnyMesh& mesh, const Work& work, Interval* interval);

}  // namespace netmesh
