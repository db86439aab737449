// From points in the plane to the diagram of their alpha complex.
#pragma once
#include "jobs/alpha_of_points.hpp"

namespace netmesh {

// As alpha_of_points, for D = 2, but that the pairs are left somewhere above the arena's low mark, with what was taken
// on the way. internal: the plane is not served.
//
// Memory, in 16-bit words up to 8,192 points and in 32-bit words beyond: 42 and 68 bytes a point while points are
// inserted; 58 and 82, and 12 for each edge with no point in its smallest circle, when radii are known; in the end 12
// for each such edge, 8 for each bar of degree 1 and 24 for each bar. Uniform points have 2 such edges and nearly 2
// bars each.
Status alpha_of_plane(const AlphaOfPoints& request, const Work& work, AlphaDiagram* out);
// There is no code for wide words in it: of up to few_points_max points.
Status alpha_of_few_in_plane(const AlphaOfPoints& request, const Work& work, AlphaDiagram* out);

}  // namespace netmesh
