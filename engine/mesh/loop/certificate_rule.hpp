// Refinement by the certificate: the coarsest mesh from which the complete filter (filtration/mesh_filter.hpp) proves
// a ratio.
#pragma once
#include <cstddef>

#include "memory/work.hpp"
#include "mesh/mesh_request.hpp"

namespace netmesh {

// Inputs are inserted in spatial order and after each of them every bad cell is refined, as in quality_rule.hpp, but
// bad is what spoils the certificate, on whole cells or clipped ones, and nothing else. Only inputs need a bounded
// aspect ratio, hi / lo = R / r <= ratio^2 (four fifths of that is what they get, see input_share). A Steiner cell may
// be long where d_P changes little. Afterwards the certified ratio is at most request.goal.ratio; no aspect ratio is
// promised. On the set of 7.7 that takes half of the vertices of a quality mesh that certifies as much.
//
// Write d = d_P(v) over all inputs, inserted or not, n the nearest one, R the distance to v's farthest corner, c the
// ratio asked of the cell. A bad input cell has a corner at more than nn(v) from v. A bad Steiner cell has hi > c^2 lo
// with hi <= d + R and lo = max(d/2, d - R), so its farthest corner is at more than (c^2 - 1) / (c^2 + 1) d from v;
// the one farthest from n, which defines hi, at more than k d, k = c^2/2 - 1. K is the larger constant. A Steiner
// point x goes from v towards the corner that defines hi and stops at 1.1 K d, or at the corner, or, if it would be
// nearer to n there than v is, where it is as far as v. So
//   - x is at k d_P(v) at least from every vertex, and |x - v| <= max(2, 1.1 K) d_P(v);
//   - an uninserted input within nine tenths of |x - v| (yield_radius) is inserted in place of x, so x keeps its
//     distance from those too;
//   - d_P(x) >= d_P(v) while n remains the nearest input. Another one, p, is at .9 k d at least from x and at a
//     constant times d at most from n, so d_P(x) is at least a constant times f_P(p). By induction every Steiner point
//     keeps that from every input. (Without the third place to stop, points spiral into an input when c^2 < 3: those
//     that end a cell may begin the next.)
//   - hi is cut at rho, so a bad cell has d < 2 rho / c^2 and x is within 1 + 2 (1 + 1.1 K) / c^2 enclosing radii of
//     the centre, or 2.1 next to an input: a compact set, and the frame is put outside of it.
// Hence packing (3.6) bounds the number of vertices: by a constant for the annuli of d_P between f_P(p) and rho about
// each input, that is by the size of a quality mesh up to a factor that depends on c alone. For scales of interest and
// c^2 <= 2 the cells next to an input can never be good, their lo being d/2, and k is not positive: when the corner
// that defines hi is nearer than K d, the farthest serves, and cells are refined until hi <= from, so the number of
// layers is finite all the same. An input cell is never asked for more than `ratio`.
//
// Where coordinates hardly resolve distances, a corner counts with three times its error bound: it is computed again
// from the finished mesh, as wrong the other way perhaps, and the certificate adds its error. That is at most a quarter
// of its distance R from v. So a bad cell has R >= .57 K d, and x is nearer to other vertices than to v by half of
// |x - v| at most, which leaves .28 k d at least: as good for the argument.
//
// Cells clipped to the ball B of clip_factor enclosing radii (goal.clipped). hi and R are of the points of the cell in
// B alone; so lo is no less, hi no more than of the whole cell. A cell is bad by a corner in B, by a point where one of
// its edges crosses B's sphere, or by a pole of a face (clipped_cell.hpp): where corners and crossings are good a
// half-space tells whether there is one, and x goes towards a point of the cell in B that is too far from n, not always
// the farthest. What is said above holds with that point in place of the corner: it uses that the point is in the cell,
// so that balls about points on the way to it are empty as far as v, and that it is farther from n than c^2 lo or is
// the farthest from v. What changes:
//   - v is in B, and so is what x goes towards: x is in B. Nothing is inserted outside, which is the compact set.
//   - The frame's hull has to contain B, and the frame's own cells, which nobody refines, have to be good: a frame
//     vertex at F enclosing radii from the centre has d >= (F - 1) rho, lo >= d/2 and hi <= rho, so F >= 1 + 2 / c^2
//     will do, c the smallest ratio asked for. How near it is hardly changes the number of vertices.
//   - A vertex put in leaves the other cells no larger in B than they were, so besides its own only those of inputs can
//     become bad whose nearest neighbour it becomes. Where its cell leaves B it is looked at once, when its turn comes.
// Cells outside of B, if there were any but the frame's, would have no corner nor crossing there, and are good.
//
// Afterwards vertex.nearest2 and vertex.origin (nearest input) are final; `domain` is the smallest enclosing ball, or
// B. too_close: k times the distance of two inputs is too little; invalid_argument: coordinates do not resolve k
// `from`, of scales of interest, or K `from` where k is not positive.
template <int D>
Status mesh_by_certificate(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                           const Work& work, AnyMeshResult* result);

}  // namespace netmesh
