// A vineyard of the caller's own (thesis 6.3): one complex, given simplex by simplex, and any sequence of filtrations.
#pragma once
#include <cstdint>

#include "jobs/follow_vines.hpp"
#include "jobs/list_simplices.hpp"

namespace netmesh {

struct ValueVineyardRequest {
    SimplexList list;          // its values are null
    const double* values;      // [steps][list.count], or, by_vertex, [steps][vertices]
    std::uint32_t steps;       // >= 1
    bool by_vertex;            // a value for each simplex of one vertex, in their order: the others enter with the last
    std::uint32_t max_degree;  // more than the dimension counts as the dimension
};

struct ValueVineyard {
    VineList vines;  // steps from 1 on
    std::uint32_t max_degree, vertices;
    std::uint64_t input_fingerprint;
    SimplexFault fault;
    std::uint32_t step;  // of the fault; 0: of the complex
};

// The diagram at each step is that of diagram_of_simplices with its values; vines are those of the straight-line
// homotopies from each step to the next (vineyard.hpp). All values are looked at before the first is used. The vines
// are put at the arena's low end, everything else is given back; without ok nothing stays. not_a_complex and not_finite
// (out->fault, out->step), out_of_memory, cancelled.
Status value_vineyard(const ValueVineyardRequest& request, const Work& work, ValueVineyard* out);

// Bytes that it takes but for most of the fill of the reduction, of `count` simplices with `vertices` vertices in all.
double value_vineyard_bytes(std::uint64_t count, std::uint64_t vertices, std::uint64_t steps);

}  // namespace netmesh
