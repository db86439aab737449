// Diagrams of complexes that are listed, by the reduction of their boundary or coboundary matrices.
#pragma once
#include "complex/filtered_complex.hpp"
#include "homology/persistence.hpp"
#include "memory/work.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// Column reduction with clearing; union-find in degree 0, and in the top degree where no face has more than two
// cofaces. Takes about 5 bytes for each simplex of the most frequent dimension, 4 for each of the top two, plus fill.
// max_degree may equal the dimension (larger counts as that): cycles of the top dimension are then listed as essential
// classes. invalid_argument (dimension), out_of_memory, cancelled.
Status persist_homology(const FilteredComplex& complex, DiagramRequest request, const Work& work, PairList* out);

// The same by columns of cofaces, which only simplices of dimension max_degree and less have: faster by orders of
// magnitude where the highest dimension has the most simplices, as in skeletons of simplices (Rips, Cech). Takes about
// 5 bytes for each simplex of the most frequent dimension, and 4 (k + 2) for each (k+1)-simplex, one k at a time, plus
// fill.
Status persist_cohomology(const FilteredComplex& complex, DiagramRequest request, const Work& work, PairList* out);

}  // namespace netmesh
