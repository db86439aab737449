// How far Voronoi cells reach within a ball, as proven bounds: measure_clipped_cells (clipped_cell.hpp) has the same
// distances as they are computed.
//
// A cell of v, clipped to the ball of centre c and radius r. For any s >= 0 what is in the ball and at s or more from v
// lies in the half-space h(x) <= 0,
//
//   h(x) = |x - c|^2 - r^2 - |x - v|^2 + s^2 = 2 (x - v) (v - c) + |v - c|^2 - r^2 + s^2,
//
// so no point of the clipped cell is farther from v than the larger of s and B, B the distance of the farthest corner
// of the whole cell cut by the half-space. That holds whatever s is. It is near the truth when s is: a cell that has
// points on both sides of the sphere of radius s in the half-space has one on it, and that is in the ball.
//
// Roundings. Corners are known within `error` times their radius: a point of a true edge is within d, the larger bound
// of its two ends, of the point of the computed edge at the same share of its length. h changes by 2 |v - c| a unit of
// length, and its own evaluation is off by less than e = 2^-44 (2 |x - v| |v - c| + |v - c|^2 + r^2 + s^2), by
// sum_slack of rounding.hpp. So what is in the half-space of a true edge lies within d of the part of the computed one
// where the computed h is at most 2 |v - c| d + e; it is cut at 2 |v - c| d + 4 e, which leaves 2 e for the quotient
// that says where. A distance is largest at one of the part's two ends, as it is convex.
//
// A vertex v outside of the ball, at |v - c| - r from it: the parts of its cell in the ball are at most that much less
// than B or s below the ball's sphere. Nor are they farther below it than r less the distance from c to the bisector of
// v and any other vertex w, (|v - c|^2 - |w - c|^2) / (2 |v - w|), where that is positive: c is on w's side.
#pragma once
#include "mesh/domain.hpp"

namespace netmesh {

struct ClippedReach {
    double from_vertex;  // no point of the cell in the ball is farther from the vertex
    double below;        // nor farther from the sphere; for vertices in the ball infinite
};

// reach[v], rounded outwards. out_radius[v]: R_v or more of whole cells, as of measure_cells; becomes infinite for
// cells that are unbounded. Uses the marks `queued`, which must be 0 and are again. O(cells). Scratch: 16 bytes a
// vertex and the list of a star. out_of_memory.
template <int D>
Status bound_clipped_cells(Store<D>& store, const Domain<D>& ball, double* out_radius, Arena& arena,
                           ClippedReach* reach);

}  // namespace netmesh
