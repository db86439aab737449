// From points with periods to the diagram of their alpha complex modulo the lattice.
#pragma once
#include "homology/persistence.hpp"
#include "memory/work.hpp"
#include "periods/periodic_points.hpp"

namespace netmesh {

struct AlphaOfPeriodicPoints {
    PeriodicInput input;
    std::uint64_t seed;
    DiagramRequest diagram;  // max_degree: at most D
    bool squares;            // with weights: values are powers, not their signed roots
};

struct PeriodicAlphaDiagram {
    CountedPairs found;
    std::uint32_t distinct;  // after merging, without hidden ones
    PeriodicReport report;
    HiddenPoints hidden;  // with weights; the list stays at the arena's high end
};

// Copies within a margin are triangulated with the points. Where that was not enough the margin becomes as wide as the
// cells at points say, at last as wide as copies can matter. Of the cells at points the faces get values, and those
// that are one modulo the lattice become one.
//
// The pairs are put at the arena's low end, everything else is given back; without ok nothing stays. ok, not_finite,
// invalid_argument, flat, out_of_memory, out_of_range, cancelled.
template <int D>
Status alpha_of_periodic_points(const AlphaOfPeriodicPoints& request, const Work& work, PeriodicAlphaDiagram* out);

}  // namespace netmesh
