// Persistence with a representative cycle for every pair. Thesis 6.2, 6.3.
#pragma once
#include <cstddef>
#include <cstdint>

#include "homology/persistence.hpp"

namespace netmesh {

// Where cycles are kept: at the arena's high end, addressed from its top. A cycle is a set of simplices of the pair's
// degree, as positions in the complex.
struct CycleStore {
    std::uint64_t top;  // offset in the arena at which the store ends; it begins at the arena's high mark
};
struct Cycle {
    const std::uint32_t* simplices;
    std::uint32_t count;
};

// As persist_filtration, each pair with a cycle whose boundary is zero, which enters with the pair's birth and becomes
// a boundary at its death (in degree 0: a vertex, and for a pair that dies an older vertex that it is then connected
// to). Besides the diagram at the low end, the store at the high end stays. Memory: about 9 bytes for each simplex of
// the most frequent dimension, 28 for each vertex, and the reduced columns. invalid_argument (dimension),
// out_of_memory, cancelled, internal.
Status persist_with_cycles(const FilteredComplex& complex, std::uint32_t max_degree, bool keep_zero, Arena& arena,
                           Monitor& monitor, PairList* out, CycleStore* store);

// The cycle of a pair that persist_with_cycles made, the complex being where it was. O(1).
Cycle cycle_of(const FilteredComplex& complex, const CycleStore& store, const Arena& arena, const Pair& pair);

}  // namespace netmesh
