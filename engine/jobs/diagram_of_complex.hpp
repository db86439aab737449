// The diagram of a complex that is listed simplex by simplex.
#pragma once
#include <cstdint>

#include "complex/listed_complex.hpp"
#include "homology/cycles/cycles.hpp"

namespace netmesh {

struct ComplexRequest {
    DiagramRequest diagram;
    bool representatives;
    std::uint32_t counted = FilteredComplex::dimension_max;  // the dimension up to which simplices are counted
};

struct ComplexDiagram {
    PairList pairs;  // at the arena's low end
    std::uint64_t simplices;
    CycleStore cycles;  // of cycle_of, when representatives are asked for: at the arena's high end
};

// Puts a linked complex in order of value and reduces it. out_of_memory, cancelled, internal.
Status diagram_of_complex(ListedComplex& complex, const ComplexRequest& request, const Work& work, ComplexDiagram* out);

}  // namespace netmesh
