#include "jobs/diagram_of_mesh.hpp"

#include "jobs/alpha_of_triangulation.hpp"
#include "jobs/diagram_of_packed.hpp"
#include "jobs/mesh_filtration.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {

Status diagram_of_mesh(const AnyMesh& mesh, const PersistRequest& request, const Work& work, FilterDiagram* out) {
    *out = FilterDiagram{};
    CountedPairs found = {};
    if (built::alpha && request.filter.filter == NETMESH_FILTER_ALPHA) {
        const Status status = with_dimension(static_cast<std::uint32_t>(mesh.store.dim), [&](auto dimension) {
            constexpr int D = decltype(dimension)::value;
            const Store<D> store = mesh.store.of_dimension<D>();
            return alpha_of_triangulation<D>(
                {store.view(), store.point(0), Store<D>::vertex_stride, count_hull_facets(store.view(), work.arena)},
                request.diagram, work, &found);
        });
        out->pairs = found.pairs;
        out->simplices = found.simplices;
        return status;
    }
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
    out->is_short = true;
    out->simplices = found.simplices;
    out->certificate = evaluation.certificate;
    out->value = evaluation.value;
    scope.keep_low_from_now();
    return Status::ok;
}

}  // namespace netmesh
