// Persistent homology over Z/2. No coordinates here: a complex, and the values at which its simplices enter. Thesis
// 6.3.
//
// Every algorithm has a folder: lower_star/ for triangulated balls, matrix/ for complexes that are listed, rips/ for
// complexes that are given by their edges, cycles/ for representatives, vineyard/ for sequences of filtrations. All of
// them put the diagram at the arena's low end in the canonical order (diagram/pair.hpp) and give everything else that
// they took back, whatever the outcome; without Status::ok nothing at all stays. The diagram depends on the filtration
// alone, never on the order of cells, simplices of equal value, or the size of the arena.
#pragma once
#include <cstdint>

#include "diagram/pair.hpp"

namespace netmesh {

// Which pairs are wanted.
struct DiagramRequest {
    std::uint32_t max_degree;  // classes of higher degree are left out
    bool keep_zero = false;    // pairs with birth == death too: a pair for each two simplices
};

// A diagram of a complex that is never stored.
struct CountedPairs {
    PairList pairs;
    std::uint64_t simplices;  // how many simplices the complex has as far as they were counted
};

}  // namespace netmesh
