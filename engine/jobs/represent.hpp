// A cycle for each bar of a diagram that diagram_of_mesh made.
#pragma once
#include "complex/listed_complex.hpp"
#include "filtration/filters.hpp"
#include "homology/cycles/cycles.hpp"
#include "jobs/bar_bounds.hpp"

namespace netmesh {

struct RepresentRequest {
    FilterRequest filter;  // as the diagram was made
    const double* value;   // the filter's values; not read for alpha
    DiagramRequest diagram;
    BarList bars;
};

struct Representation {
    PairList pairs;     // the same bars once more, with their cycles
    CycleStore cycles;  // of cycle_of with the complex when it is listed, else of lower_star_cycle
    bool is_listed;     // the complex was made explicit: alpha, and where pairs of zero length are kept
    ListedComplex complex;
};

// At the arena's low end stay the complex, when it is listed, and the pairs, at its high end the cycles of a listed
// complex; without ok nothing stays. About the time and memory of the diagram; of a listed complex 40 bytes a simplex,
// and the cycles. out_of_memory, cancelled, internal (the bars are not those of the diagram).
Status represent(const AnyMesh& mesh, const RepresentRequest& request, const Work& work, Representation* out);

}  // namespace netmesh
