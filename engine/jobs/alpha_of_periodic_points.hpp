// From points with periods to the diagram of their alpha complex modulo the lattice.
#pragma once
#include "complex/listed_complex.hpp"
#include "homology/cycles/cycles.hpp"
#include "memory/work.hpp"
#include "periods/periodic_points.hpp"

namespace netmesh {

struct AlphaOfPeriodicPoints {
    PeriodicInput input;
    std::uint64_t seed;
    DiagramRequest diagram;  // max_degree: at most D
    bool squares;            // with weights: values are powers, not their signed roots
};

// The quotient complex that cycles name simplices of. A simplex is a set of copies, up to translation.
struct QuotientCycles {
    CycleStore store;
    ListedComplex complex;                          // linked and ordered; rows[0] says nothing
    std::uint32_t* vertices[dimension_most() + 1];  // [count][k + 1], copies
    // [copies][1 + axes]: the row of the input, and how many of each given vector take what stands there to the copy.
    std::int32_t* copies;
    std::uint32_t axes;
};

struct PeriodicAlphaDiagram {
    CountedPairs found;
    std::uint32_t distinct;  // after merging, without hidden ones
    PeriodicReport report;
    HiddenPoints hidden;  // with weights; the list stays at the arena's high end
    bool is_far;          // out_of_range: row_a is too many periods away for cycles
};

// Copies within a margin are triangulated with the points. Where that was not enough the margin becomes as wide as the
// cells at points say, at last as wide as copies can matter. Of the cells at points the faces get values, and those
// that are one modulo the lattice become one.
//
// The pairs are put at the arena's low end, and what `cycles` has at the high end; everything else is given back, and
// without ok nothing stays. cycles: null where none are wanted. ok, not_finite,
// invalid_argument, flat, out_of_memory, out_of_range, cancelled.
template <int D>
Status alpha_of_periodic_points(const AlphaOfPeriodicPoints& request, const Work& work, PeriodicAlphaDiagram* out,
                                QuotientCycles* cycles);

}  // namespace netmesh
