// The diagram of a filtered complex that the caller gives simplex by simplex. Thesis 6.2, 6.3.
#pragma once
#include <cstdint>

#include "jobs/diagram_of_complex.hpp"
#include "jobs/list_simplices.hpp"

namespace netmesh {

struct SimplicesDiagram {
    ComplexDiagram diagram;
    std::uint32_t max_degree;  // at most the dimension
    ListedSimplices listed;    // with representatives the complex stays for cycle_of; else its counts alone are of use
};

// The pairs are put at the arena's low end, with representatives behind the complex, whose cycles stay at the high end.
// Without ok memory is as the reduction left it. not_a_complex and not_finite (out->listed.fault), out_of_memory,
// cancelled, internal.
Status diagram_of_simplices(const SimplexList& list, const ComplexRequest& request, const Work& work,
                            SimplicesDiagram* out);

// Bytes that a complex of `count` simplices with `vertices` vertices in all takes, but for the fill of the reduction.
double simplices_bytes(std::uint64_t count, std::uint64_t vertices);

}  // namespace netmesh
