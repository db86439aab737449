// From a mesh or a Delaunay triangulation to the diagram of a filter on it.
#pragma once
#include "filtration/filters.hpp"
#include "homology/persistence.hpp"

namespace netmesh {

struct PersistRequest {
    FilterRequest filter;  // of source mesh or delaunay
    DiagramRequest diagram;
};

struct FilterDiagram {
    PairList pairs = {};
    bool is_short = false;        // pairs are of the short form (BarList)
    std::uint64_t simplices = 0;  // of the filtered complex
    Certificate certificate = {};
    const double* value = nullptr;  // [vertices] of a filter on meshes; null: alpha
    double clip_radius = 0;         // of the ball that cells were clipped to; 0: they are whole
    std::uint32_t culprit = 0;      // as of Evaluation
};

// Diagram of the request's filter in degrees 0..max_degree (at most D-1). The filter's values, then the pairs are put
// at the arena's low end; without ok nothing stays but the culprit. What evaluate, persist_lower_star and
// alpha_of_triangulation say. A triangulation for the alpha filter needs no domain.
Status diagram_of_mesh(const AnyMesh& mesh, const PersistRequest& request, const Work& work, FilterDiagram* out);

}  // namespace netmesh
