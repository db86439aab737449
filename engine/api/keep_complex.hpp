// Complexes and cycles that the context keeps.
#pragma once
#include "api/call.hpp"
#include "complex/listed_complex.hpp"
#include "jobs/diagram_of_complex.hpp"

namespace netmesh {

// Representatives of the pairs; high_end: of the arena, above them.
void keep_cycles(netmesh_context* context, const CycleStore& cycles, std::size_t high_end);

// The complex whose simplices the cycles name, once it is linked and ordered.
void keep_complex(netmesh_context* context, const ListedComplex& complex);

// Keeps a diagram, in a context that is empty otherwise; complex: of its cycles, null when there are none.
void keep_diagram(netmesh_context* context, const KeptInput& input, const KeptDiagram& diagram,
                  const ComplexDiagram& made, const ListedComplex* complex);

// What keep_complex has kept as it is now, and the labels of its vertices.
FilteredComplex kept_complex(const netmesh_context* context, const std::uint32_t** labels);

}  // namespace netmesh
