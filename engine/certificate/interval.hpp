// Where a function surely lies on the Voronoi cell of a mesh vertex: what every certificate is made from.
//
// The function here is d_P, the distance to the nearest input. Let v be the vertex, d = d_P(v), n its nearest input, R
// its out-radius (the distance to its farthest corner), x a point of its cell and s = |x - v| <= R.
//   - v an input: x is nearer to v than to any other input, so d_P(x) = s <= R. Half the distance to the nearest
//     neighbour, r, is the radius of the largest ball about v inside the cell: outside of that ball d_P(x) >= r. Inside
//     it the cover of mesh_filter.hpp has the ball instead of the cell, so r serves as lower end.
//   - v a Steiner vertex: x is no farther from v than from any input, so d_P(x) >= s; and d_P(x) >= d - s. Hence
//     d_P(x) >= max(d / 2, d - R). d_P(x) <= |x - n|, which is largest at a corner.
//   - an unbounded cell: d_P(x) >= d / 2 still holds, and nothing bounds it from above.
#pragma once
#include "certificate/rounding.hpp"
#include "numerics/real.hpp"

namespace netmesh {

struct Interval {
    double lo, hi;
};

// `rounding` is `down` for a proof and 1 for refinement, which takes numbers as they are and stops a hair before its
// goal.

// Lower end on a bounded cell of out-radius R whose vertex is at distance d from the inputs. It holds for any
// 1-Lipschitz function with the value d at the vertex that is nowhere less than the distance to the vertex.
inline double least_distance(double d, double out_radius, double rounding = down) {
    const double inner = (d - out_radius) * rounding;
    return (inner > 0.5 * d ? inner : 0.5 * d) * rounding;
}
// The same on an unbounded cell.
inline double least_distance_unbounded(double d, double rounding = down) { return 0.5 * d * rounding; }

// nearest: from the input to its nearest neighbour in the mesh.
inline Interval input_interval(double nearest, double out_radius, double rounding = down) {
    return {0.5 * nearest * rounding, out_radius};
}
// farthest: from the nearest input to the corner that is farthest from it.
inline Interval steiner_interval(double d, double out_radius, double farthest, double rounding = down) {
    return {least_distance(d, out_radius, rounding), farthest};
}
inline Interval unbounded_interval(double d, double rounding = down) {
    return {least_distance_unbounded(d, rounding), infinity};
}

// The interval of min(F, cut); an end that is not a number becomes `cut`.
inline Interval cut_at(double cut, Interval i) { return {i.lo <= cut ? i.lo : cut, i.hi <= cut ? i.hi : cut}; }

}  // namespace netmesh
