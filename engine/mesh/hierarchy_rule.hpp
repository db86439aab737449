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
// Memory above that of the other methods: 44 bytes an input; with audits what they say.
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
// refinement ends where it would end without cages. Its cells were clipped to the ball of e r; now those beside that
// sphere reach as far as the shell, so until they are refined ratios are as large as the gap was beside their in-radii.
// 4.8's bound on intermediate meshes does not hold then: a chain of 11 inputs in the plane, each an eighth to a fifth
// as far from the last one as the one before, with three far away, comes to 2e6 and degree 33. The shell of a
// neighbouring cage and Steiner points inside it are as near as its centre, up to a quarter, and do not count as
// encroaching. Vertices whose cells are no longer clipped to a released cage are found by a look at all cells after the
// last insertion; those next to the shell at once.
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
// FinishMesh releases all cages and cleans. Steiner points are pulled back towards their vertices, so the layers that
// grow out of a shell are those that growing the cage step by step would give. What it leaves is a mesh as that of
// SVR, and so is over-refined as one (quality_rule.hpp) where sizes are asked for.
template <int D>
Status mesh_by_hierarchy(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                         const Work& work, AnyMeshResult* result);

}  // namespace netmesh
