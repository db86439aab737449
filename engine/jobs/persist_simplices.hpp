// The diagram of a filtered complex that the caller gives simplex by simplex. Thesis 6.2, 6.3.
#pragma once
#include <cstdint>

#include "jobs/persist_complex.hpp"

namespace netmesh {

// Simplex i has the vertices vertices[starts[i] .. starts[i + 1]) and enters at values[i].
struct SimplexList {
    const std::uint32_t* vertices;
    const std::uint64_t* starts;  // [count + 1]
    const double* values;         // [count]
    std::uint64_t count;          // >= 1

    std::uint64_t size(std::uint64_t i) const { return starts[i + 1] - starts[i]; }
};

// Why the list is not a filtered complex.
struct SimplexFault {
    const char* text = nullptr;
    std::uint64_t simplex = 0;  // its place in the list
    std::uint64_t other = 0;  // the place of the equal simplex before it or of the face that enters later, or which of
                              // its vertices, in ascending order, a missing face lacks
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
