// The diagram of a filtered complex that the caller gives simplex by simplex. Thesis 6.2, 6.3.
#pragma once
#include <cstdint>

#include "jobs/persist_complex.hpp"
#include "netmesh.h"

namespace netmesh {

// Simplex i has the vertices vertices[starts[i] .. starts[i + 1]) and enters at values[i].
struct SimplexList {
    const std::uint32_t* vertices;
    const std::uint64_t* starts;  // [count + 1]
    const double* values;         // [count]
    std::uint64_t count;          // >= 1

    std::uint64_t size(std::uint64_t i) const { return starts[i + 1] - starts[i]; }
};

// Why the list is not a filtered complex; NETMESH_FAULT_NONE: a value is not finite.
struct SimplexFault {
    netmesh_fault kind = NETMESH_FAULT_NONE;
    std::uint64_t simplex = 0;  // its place in the list
    std::uint64_t other = 0;    // see netmesh_fault
};

struct SimplicesDiagram {
    ComplexDiagram diagram;
    std::uint32_t max_degree;  // at most the dimension
    std::uint64_t input_fingerprint;
    SimplexFault fault;
    ListedComplex complex;  // with representatives it stays for cycle_of; else its counts alone are of use
};

// The pairs are put at the arena's low end, with representatives behind the complex, whose cycles stay at the high end.
// Without ok memory is as the reduction left it. not_a_complex and not_finite (out->fault), out_of_memory, cancelled,
// internal.
Status persist_simplices(const SimplexList& list, const ComplexRequest& request, const Work& work,
                         SimplicesDiagram* out);

// Bytes that a complex of `count` simplices with `vertices` vertices in all takes, but for the fill of the reduction.
double simplices_bytes(std::uint64_t count, std::uint64_t vertices);

}  // namespace netmesh
