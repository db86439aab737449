// NetMesh (thesis 4.5, 4.7): a hierarchical mesh, whose size is linear in the number of inputs whatever their spread.
#pragma once
#include <cstddef>

#include "memory/work.hpp"
#include "mesh/mesh_request.hpp"

namespace netmesh {

// Afterwards quality is hierarchical (definition 4.5, clipped, see cage.hpp): tau bounds the aspect ratio of the cell
// of each vertex that is not exempt, clipped to the ball of its domain, and of the cell of each cage, clipped to the
// ball of the domain around it. Shell vertices are exempt. The cages stand at result->cages at the low end of the
// arena before the cells, parents before or behind their children. vertex.nearest2 is final; where cages are left,
// vertex.origin is some input near by and not always the nearest.
//
// Memory above that of the other methods: 52 bytes an input; with audits what they say.
//
// How the thesis's operations are carried out here, and why they differ where they do:
//
// InsertInput. The thesis makes a cage about the nearest neighbour u of an input p that is not medial, with a radius
// out of |u - p|, and lets it grow when more inputs turn out to encroach on it from inside. Here the radius looks
// ahead: ring searches among all inputs, inserted or not, climb from |u - p| outwards until the annulus that a cage
// needs is empty. That is the radius that the cage keeps: no input ever encroaches on it, from inside or outside, so
// there is no GrowCage; and as its whole clearance must be free of vertices, it is not born encroached (meshing by the
// trigger mediality <= e alone would). The inputs met on the way are inserted before p, the farthest first, with or
// without a cage at the end: so each input is medial up to a constant when its turn comes, and a set without gaps
// keeps its quality at every step. The nearest neighbour in M_Omega: the nearest mesh vertex, or the centre of the
// largest cage that contains it but not p.
//
// ReleaseCage happens when a Steiner point comes nearer than a cage's clearance, which only gaps not much wider than a
// cage needs let happen. Cages are never made again about the same inputs, as their shells stay as vertices, so
// refinement ends where it would end without cages. The shell of a neighbouring cage and Steiner points inside it are
// as near as its centre, up to a quarter, and do not count as encroaching.
//
// The cells in a cage are clipped to the ball of e r. If a vertex beside that sphere has an input a millionth of r
// away, its whole cell, out to the shell, has a ratio of a million. So before a cage is released the ball grows to
// grown_most r, by steps, and cells are refined in between. Let ball B of radius b contain v, and its cell in B reach
// R. A point x of the cell that is at most b + d from the centre of B, and the point w of the cell that is r_v, v's
// in-radius, nearer to the centre than v, have z = (1 - l) x + l w between them, which is in B for l = d / (d + r_v).
// |z - v| <= R gives
//
//   |x - v| <= (1 + d / r_v) R + d.
//
// B has grown by g so far; next it grows by the larger one of g and the least r_v of all vertices that a larger ball
// could make bad. It does when those of r_v <= g are good, which is how the queue has it. Others: d / r_v <= 1. Those
// that reach the sphere all the same: they are g - tau r_v from the inputs or farther, as all inputs are within e r, so
// r_v >= g / (tau + 2 K) by 4.8's bound of feature sizes. So ratios stay below a constant, and there are as many steps
// as it takes to double the least r_v until it is r. What is put into a growing cage from outside makes cells
// smaller. With the cage its own cell goes, of in-radius R: it is held to released_tau before. The cells of the shell
// and of vertices in the ball, of r_v >= r / 4 / (tau + 2 K) where they leave it, are parts of that, so of ratios of at
// most released_tau R / r_v, where R < 2.5 r.
//
// A run that is cut off while a ball grows leaves that cage as a released one: it has no room to end what it was
// about, and no cage may be kept that something has come too near to. Cells about its shell may then be worse than
// those of any mesh before, and than what an audit of the run has seen.
//
// FinishMesh releases all cages at once without that. Beside shells the cells of its intermediate meshes are as long as
// the gaps are wide. Cells that a released cage has kept apart from others are found by a look at all cells after the
// last insertion, too.
//
// YieldingInsert. A shell vertex never yields: the thesis's gamma is .25, and no input is nearer to it than .4 of the
// way to the centre. A Steiner point yields to an input within nine tenths of its empty ball's radius and to no other:
// the rule by f_P that quality_rule.hpp adds is for the proof of termination for tau near 2 without cages. An input
// that a Steiner point yields to is inserted without going back to others: it is medial as it stands.
//
// While inputs are missing cells, and those of cages, are held to waiting_tau (aspect_rule.hpp). By tau 2.5 or 3.08 a
// Steiner point would yield to inputs nearer to its vertex than any neighbour, one after the other, and meshes of close
// pairs in space would have twice the vertices.
//
// FinishMesh cleans after that. Steiner points are pulled back towards their vertices, so the layers that
// grow out of a shell are those that growing the cage step by step would give. What it leaves is a mesh as that of
// SVR, and so is over-refined as one (quality_rule.hpp) where sizes are asked for.
template <int D>
Status mesh_by_hierarchy(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                         const Work& work, AnyMeshResult* result);

}  // namespace netmesh
