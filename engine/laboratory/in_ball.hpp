// The in-ball of a Voronoi cell (thesis 5.1).
#pragma once
#include <cstdint>

namespace netmesh {

// The largest ball inside the cell { x : u_i . x <= b_i }, where u_i = w_i / |w_i|, b_i = |w_i| / 2: that of the origin
// among the points w[count][dim], none of them 0; scale is any length of the cell's order, for steps to be compared
// with. *centre and the radius returned are those of a ball that is inside up to rounding of its last operations,
// whatever the search did; it is the largest when the search ended by itself. The linear program in dim+1 unknowns, by
// an active set that is followed from the ball about the origin: O(count) a step, about 2 dim steps, 60 (dim+1) at
// most.
double largest_inscribed_ball(int dim, const double* w, std::uint32_t count, double scale, double* centre);

}  // namespace netmesh
