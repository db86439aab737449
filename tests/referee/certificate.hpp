// What `# ratio C` promises: the distance d to the nearest input, cut at rho, the radius of a ball about the domain's
// centre that contains all inputs, is known on every Voronoi cell up to a factor of C^2. With v the cell's vertex, n
// its nearest input, R the distance from v to the cell's farthest corner and s = |x - v| for x in the cell:
//   an input v        d(x) = s, between half the distance to the nearest vertex (below that the cell has the ball
//                     about v) and R;
//   another v         d(x) >= s, as x is no nearer to an input than to v, and d(x) >= d(v) - s, so at least the larger
//                     of d(v) / 2 and d(v) - R; at most |x - n|, which is largest at a corner;
//   an unbounded cell at least d(v) / 2, and nothing above.
// In a mesh that says `# clipped` cells end at the domain's ball: the largest distances are those of clipped cells
// (voronoi.hpp), and a vertex whose cell does not meet the ball (nerve.hpp) counts nowhere.
// Where vertices have values t, sampled points x of the domain are compared with them: d(x) <= C t(v), and
// d(x) >= t(v) / C outside of the in-balls of inputs.
#pragma once
#include "quality.hpp"

namespace referee {

void judge_certificate(const Mesh& mesh, const Diagram& diagram, const Hull& hull, Verdict* verdict);
void sample_values(const Mesh& mesh, const Diagram& diagram, std::size_t samples, Random& random, Verdict* verdict);

}  // namespace referee
