// From a mesh to the diagram of a filter on it.
#pragma once
#include "filtration/filters.hpp"
#include "homology/persistence.hpp"

namespace netmesh {

struct PersistRequest {
    FilterRequest filter;  // of source mesh
    DiagramRequest diagram;
};

struct FilterDiagram {
    PairList pairs = {};          // of the short form (BarList)
    std::uint64_t simplices = 0;  // of the filtered complex
    Certificate certificate = {};
    const double* value = nullptr;  // [vertices]
    double clip_radius = 0;         // of the ball that cells were clipped to; 0: they are whole
    std::uint32_t culprit = 0;      // as of Evaluation
};

// Diagram of the request's filter in degrees 0..max_degree (at most D-1). The filter's values, then the pairs are put
// at the arena's low end; without ok nothing stays but the culprit. What evaluate and persist_lower_star
// say.
Status diagram_of_mesh(const AnyMesh& mesh, const PersistRequest& request, const Work& work, FilterDiagram* out);

}  // namespace netmesh
