#include "jobs/diagram_of_complex.hpp"

#include "homology/matrix/matrix.hpp"

namespace netmesh {
namespace {

// Whether most simplices are of the highest dimension that matters.
bool is_skeleton(const FilteredComplex& complex, std::uint32_t max_degree) {
    const std::uint32_t top = max_degree < complex.dimension ? max_degree + 1 : complex.dimension;
    return top > 0 && complex.of[top].count / 2 > complex.of[top - 1].count;
}

}  // namespace

Status diagram_of_complex(ListedComplex& complex, const ComplexRequest& request, const Work& work,
                          ComplexDiagram* out) {
    *out = {};
    const Status status = order_by_value(complex, work.arena);
    if (status != Status::ok) return status;
    for (std::uint32_t k = 0; k <= complex.dimension && k <= request.counted; ++k) out->simplices += complex.count[k];
    const FilteredComplex filtered = complex.filtered();
    if (request.representatives) {
        Representatives found = {};
        const Status reduced = persist_with_cycles(filtered, request.diagram, work, &found);
        out->pairs = found.pairs;
        out->cycles = found.store;
        return reduced;
    }
    return is_skeleton(filtered, request.diagram.max_degree)
               ? persist_cohomology(filtered, request.diagram, work, &out->pairs)
               : persist_homology(filtered, request.diagram, work, &out->pairs);
}

}  // namespace netmesh
