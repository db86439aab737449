#include "jobs/diagram_of_simplices.hpp"

namespace netmesh {

Status diagram_of_simplices(const SimplexList& list, const ComplexRequest& request, const Work& work,
                            SimplicesDiagram* out) {
    *out = {};
    const std::size_t low = work.arena.low_mark();
    Status status = list_simplices(list, work, &out->listed);
    if (status != Status::ok) return status;
    ListedComplex& complex = out->listed.complex;
    ComplexRequest wanted = request;
    if (wanted.diagram.max_degree > complex.dimension) wanted.diagram.max_degree = complex.dimension;
    out->max_degree = wanted.diagram.max_degree;
    status = diagram_of_complex(complex, wanted, work, &out->diagram);
    if (status != Status::ok || wanted.representatives) return status;
    return move_pairs_down(low, work.arena, &out->diagram.pairs);
}

double simplices_bytes(std::uint64_t count, std::uint64_t vertices) {
    // Rows and values; a table of faces or orders while they are linked, columns and sets while they are reduced.
    constexpr double row = sizeof(std::uint32_t), simplex = sizeof(double) + 32;
    return row * static_cast<double>(vertices) + simplex * static_cast<double>(count);
}

}  // namespace netmesh
