// Degree 0 of a Rips filtration: a tree, whatever the distances are of.
#pragma once
#include "filtration/distance_graph.hpp"
#include "jobs/diagram_of_complex.hpp"

namespace netmesh {

// No edge is stored: all distances are looked at twice. Of *out pairs, at the arena's low end, and simplices.
// invalid_argument (*fault), out_of_memory, cancelled.
Status persist_tree(const DistanceSource& source, double threshold, bool keep_zero, const Work& work,
                    ComplexDiagram* out, DistanceLimits* limits, DistanceFault* fault);

}  // namespace netmesh
