#include "jobs/diagram_of_mesh.hpp"

#include "jobs/diagram_of_packed.hpp"
#include "jobs/mesh_filtration.hpp"

namespace netmesh {

Status diagram_of_mesh(const AnyMesh& mesh, const PersistRequest& request, const Work& work, FilterDiagram* out) {
    *out = FilterDiagram{};
    CountedPairs found = {};
    const MeshEnds ends = {work.arena.low_mark(), work.arena.high_mark()};
    ArenaScope scope(work.arena);
    Evaluation evaluation = {work.arena.take_low<double>(mesh.vertices())};
    if (evaluation.value == nullptr) return Status::out_of_memory;
    AnyMesh filtered = mesh;
    Status status = clip_cells(request.filter, work, &filtered);
    if (status == Status::ok) status = evaluate(filtered, request.filter, work, &evaluation);
    out->culprit = evaluation.culprit;
    if (status == Status::ok)
        status =
            diagram_of_packed<true>(mesh.store, ends, mesh_filtration(filtered, evaluation.value, evaluation.zero_born),
                                    request.diagram, work, &found);
    if (status != Status::ok) return status;
    if (filtered.present != nullptr) out->clip_radius = filtered.domain.radius;
    out->pairs = found.pairs;
    out->simplices = found.simplices;
    out->certificate = evaluation.certificate;
    out->value = evaluation.value;
    scope.keep_low_from_now();
    return Status::ok;
}

}  // namespace netmesh
