// The Rips filtration of data that is known by its distances.
#pragma once
#include <cstdint>

#include "filtration/distance_graph.hpp"
#include "jobs/diagram_of_complex.hpp"

namespace netmesh {

struct DistancesRequest {
    DistanceSource source;    // not read where there are entries
    DistanceEntries entries;  // entries.count 0: there are none
    double threshold;         // >= 0
    std::uint32_t max_degree;
    bool keep_zero, representatives;
};

struct DistancesDiagram {
    ComplexDiagram diagram;
    std::uint64_t input_fingerprint;
    DistanceFault fault;    // after invalid_argument; without one there are too many simplices to number
    ListedComplex complex;  // with representatives
};

// The pairs are put at the arena's low end, with representatives behind the complex, whose cycles stay at the high end;
// without ok nothing stays. invalid_argument, out_of_memory, cancelled, internal.
Status diagram_of_distances(const DistancesRequest& request, const Work& work, DistancesDiagram* out);

// As points_bytes. edges: at most.
double distances_bytes(const DistancesRequest& request, std::uint64_t n);

}  // namespace netmesh
