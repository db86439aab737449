// A complex that the caller gives simplex by simplex. Thesis 6.2, 6.3.
#pragma once
#include <cstdint>

#include "complex/listed_complex.hpp"
#include "memory/work.hpp"
#include "netmesh.h"

namespace netmesh {

// Simplex i has the vertices vertices[starts[i] .. starts[i + 1]) and enters at values[i].
struct SimplexList {
    const std::uint32_t* vertices;
    const std::uint64_t* starts;  // [count + 1]
    const double* values;         // [count], or null: all enter at 0
    std::uint64_t count;          // >= 1

    std::uint64_t size(std::uint64_t i) const { return starts[i + 1] - starts[i]; }
};

// Why the list is not a filtered complex; NETMESH_FAULT_NONE: a value is not finite.
struct SimplexFault {
    netmesh_fault kind = NETMESH_FAULT_NONE;
    std::uint64_t simplex = 0;  // its place in the list
    std::uint64_t other = 0;    // see netmesh_fault
};

struct ListedSimplices {
    ListedComplex complex;  // linked; those of one dimension are in the order of the list
    std::uint64_t input_fingerprint;
    SimplexFault fault;
};

// Puts the complex at the arena's low end. not_a_complex and not_finite (out->fault), out_of_memory, cancelled; what
// was taken then stays.
Status list_simplices(const SimplexList& list, const Work& work, ListedSimplices* out);

// The place in the list of the simplex that is number `index` of dimension k. O(count).
std::uint64_t place_of(const SimplexList& list, std::uint32_t k, std::uint32_t index);

}  // namespace netmesh
