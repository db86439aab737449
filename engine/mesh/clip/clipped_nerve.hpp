// The nerve of the Voronoi cells of a mesh, clipped to a ball B of centre o and radius r.
//
// Let F_s be the Voronoi face dual to the simplex s of the Delaunay triangulation: the points that are nearest to all
// of its vertices alike. The clipped cells of the vertices of s have a point in common when F_s meets B, so their
// nerve is K = {s : m(s) <= r}, m(s) the distance from o to F_s. It is closed under faces, and has the homology of a
// point as its cells are convex and cover B.
//
// Which simplices. F_s is the part of the flat of points equidistant from the vertices of s that is as near to them
// as to w, for each cofacet s + w. Its boundary consists of the faces of the cofacets. Let x_s be the point of the flat
// nearest to o; in a cell's it is the only one, the centre of the circumscribed ball. So m(s) = |x_s - o| when x_s is
// in F_s, and the least m of the cofacets otherwise. Hence K consists of
//   - the cells with their centre in B, and their faces;
//   - the simplices with x_s in B and in F_s, and their faces.
// From the cells down: a simplex with a cofacet in K is in K and nothing has to be decided. One with none is in K if
// x_s is in B and in F_s.
//
// Cospherical points. The triangulation is that of lifts raised by infinitely small weights (predicates.cpp), and m is
// meant for the faces F_s that those weights have. As the weights vanish, a face tends to {x in the flat : as near as
// to w, for the w of all cofacets}, and so m(s) to its value there: the faces are not empty, only right-hand sides of
// their inequalities depend on the weights, and the distance between two such polyhedra is at most a constant times the
// change of the right-hand sides (Hoffman). So the rules above hold for the limits, and when no limit of m is exactly r
// then K is the nerve of the weighted cells as soon as the weights are small enough: all that has been said of nerves
// holds although faces of positive dimension may have shrunk to points. No limit is exactly r when each decision about
// B is certain: a cofacet with x_s on its boundary has the same m, and is asked first.
//
// Rounding. Decisions are made on proven bounds (equal_foot.hpp), those about centres of cells by the cell's record
// where that does, then in doubles, then in 1,024 bits. When one remains undecided the nerve is not certain. B may be
// chosen: the next radius has other decisions.
#pragma once
#include "complex/subcomplex.hpp"
#include "memory/work.hpp"
#include "mesh/any_domain.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// The nerve for the ball of `ball`, in *part: arrays at the low end of the arena, cell_count + vertex_count bytes and
// the set of faces. !*certain: some decision was not, nothing is kept, and *part is not written.
// A compact store. Vertex::cell is not needed. Changes the marks of cells. A few EqualFoots for each cell near the
// sphere, one comparison for the others. In the gap: the list of the cells around a simplex.
// out_of_memory, cancelled: nothing is kept.
Status find_clipped_nerve(const AnyStore& store, const AnyDomain& ball, const Work& work, AnyPart* part, bool* certain);

constexpr int clip_radii = 60;

// For the first of the radii domain->radius (1 - k 2^-16), k < clip_radii, whose nerve is certain; domain->radius
// becomes that one. All must be above domain->enclosing_radius; those that are not count as uncertain. !*found: none
// is certain, and domain is as it was. Otherwise as find_clipped_nerve.
Status choose_clipped_nerve(const AnyStore& store, AnyDomain* domain, const Work& work, AnyPart* part, bool* found);

}  // namespace netmesh
