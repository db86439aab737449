// The filtrations of a triangulation as complexes whose simplices are stored: what representatives are made from.
#pragma once
#include <cstdint>

#include "complex/listed_complex.hpp"
#include "complex/subcomplex.hpp"
#include "filtration/alpha.hpp"
#include "memory/work.hpp"

namespace netmesh {

// Both list the simplices of dimension 0..dimension (at most D) at the arena's low end, linked and in order of value; a
// vertex's label is its number in the triangulation. Scratch as enumerate_faces, and for lower stars a copy of the
// cells' vertices. out_of_memory, cancelled.

// A simplex of more than one vertex enters at the largest of its vertices' values, a vertex v < zero_born_count at 0.
// part: the simplices that are listed, all of the triangulation's when it is null.
Status lower_star_complex(const TriangulationView<any_dimension>& triangulation, const double* value,
                          std::uint32_t zero_born_count, std::uint32_t dimension, const AnyPart* part, const Work& work,
                          ListedComplex* out);

// The alpha filtration (alpha.hpp), for which all dimensions are listed for a while.
Status alpha_complex(const AlphaFiltration<any_dimension>& filtration, std::uint32_t dimension, const Work& work,
                     ListedComplex* out);

}  // namespace netmesh
