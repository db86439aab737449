// Simplices modulo translations.
#pragma once
#include "complex/faces.hpp"
#include "memory/work.hpp"
#include "periods/periodic_points.hpp"

namespace netmesh {

// Two simplices are one where a translation takes one to the other. The one whose vertex of the least point is that
// point itself stands for all. These are moved to the front, with their values, and their facets become
// those that stand for them: a simplex can have a facet twice, or more often. Each of faces->count becomes how many. At
// most 2^31 - 1 of a dimension.
//
// Translations move every simplex: none is taken to itself. So the quotient of the union of balls has the homology of
// the quotient complex, whose simplices are whole although vertices may be one.
//
// vertices, if any: [dimension + 1], of each that stands the vertices are listed, [count][k + 1], at the arena's low
// end.
//
// *repeats becomes whether one of them has a facet more than once.
//
// Of dimensions 0..dimension. faces: all of the cells at points, with last_vertex. Scratch: 5 bytes a face,
// and up to 16 for those near the border of one dimension. out_of_memory, cancelled; internal: a
// facet is in no orbit.
Status take_orbits(const PeriodicPoints& points, const Copies& copies, int dimension, const Work& work, AnyFaces* faces,
                   double* const* value, std::uint32_t** vertices, bool* repeats);

}  // namespace netmesh
