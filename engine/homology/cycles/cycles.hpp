// Persistence with a representative cycle for every pair. Thesis 6.2, 6.3.
//
// A cycle's boundary is zero, its last simplex enters with the pair's birth, and it becomes a boundary at the pair's
// death; in degree 0 it is a vertex, and for a pair that dies an older vertex that it is then connected to.
#pragma once
#include <cstddef>
#include <cstdint>

#include "complex/filtered_complex.hpp"
#include "homology/lower_star/lower_star.hpp"
#include "homology/persistence.hpp"
#include "memory/work.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// Where the cycles of a diagram are, as offsets in the arena.
struct CycleStore {
    std::uint64_t begin;  // lower_star_cycles: they lie at the arena's low end, behind the pairs
    std::uint64_t top;    // persist_with_cycles: they lie at the arena's high end, down from here
};
struct Cycle {
    // Positions of simplices in the complex; of a lower-star filtration the vertices of simplices in any order,
    // [count][degree + 1].
    const std::uint32_t* simplices;
    std::uint32_t count;
};

// A diagram and where its cycles are.
struct Representatives {
    PairList pairs;
    CycleStore store;
};

// As persist_homology, each pair with a cycle. Besides the diagram at the low end, the store at the high end stays.
// Memory: about 9 bytes for each simplex of the most frequent dimension, 28 for each vertex, and the reduced columns.
// invalid_argument (dimension), out_of_memory, cancelled, internal.
Status persist_with_cycles(const FilteredComplex& complex, DiagramRequest request, const Work& work,
                           Representatives* out);
// The same of a quotient (persist_quotient): a simplex may have a facet more than once, which is in its boundary if
// that is an odd number of times.
Status persist_quotient_with_cycles(const FilteredComplex& complex, DiagramRequest request, const Work& work,
                                    Representatives* out);
// The cycle of a pair that one of these made, the complex being where it was. O(1).
Cycle cycle_of(const FilteredComplex& complex, const CycleStore& store, const Arena& arena, const Pair& pair);

// As persist_lower_star without pairs of zero length, each pair with a cycle; how many pairs there are is known from
// there. Takes as long and as much memory as that, and 4 bytes a cell; a cycle of degree D-1 takes time for every cell
// that it encloses. What stays at the low end is the diagram, then the cycles. out_of_memory, cancelled, internal.
template <int D>
Status lower_star_cycles(const LowerStarFiltration<D>& filtration, std::uint32_t max_degree, std::uint64_t pair_count,
                         const Work& work, Representatives* out);
Status lower_star_cycles(const LowerStarFiltration<any_dimension>& filtration, std::uint32_t max_degree,
                         std::uint64_t pair_count, const Work& work, Representatives* out);
// The cycle of a pair that lower_star_cycles made. O(1).
Cycle lower_star_cycle(const CycleStore& store, const Arena& arena, const Pair& pair);

}  // namespace netmesh
