// Persistence of a map: what the homology of a subcomplex becomes in a complex around it.
#pragma once
#include "complex/filtered_complex.hpp"
#include "homology/bit_set.hpp"
#include "homology/persistence.hpp"
#include "memory/work.hpp"

namespace netmesh {

// Simplices of a listed complex, a bit each, of dimensions up to the complex's.
struct SimplexSet {
    BitSet of[FilteredComplex::dimension_max + 1];
};

// The image of H(part) in H(whole), two subcomplexes of `complex` with part in whole, filtered as it is: at each value
// the classes of `whole` that hold a cycle of `part`. A bar begins with a bar of `part` and ends with a bar of `whole`.
// With part = whole it is the diagram of `whole`. Cohen-Steiner, Edelsbrunner, Harer, Morozov: Persistent homology for
// kernels, images, and cokernels (2009): boundaries in `whole` are reduced with the rows of `part` before all others,
// so that a pivot among them says that a cycle of `part` has become a boundary in `whole`.
// Degrees 0..max_degree; cycles of the complex's top dimension never end. Takes about 13 bytes for each simplex of the
// most frequent dimension, plus fill. invalid_argument (dimension), out_of_memory, cancelled.
Status persist_image(const FilteredComplex& complex, const SimplexSet& whole, const SimplexSet& part,
                     DiagramRequest request, const Work& work, PairList* out);

}  // namespace netmesh
