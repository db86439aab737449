#include "jobs/persist_filter.hpp"

#include "jobs/persist_alpha.hpp"
#include "jobs/persist_packed.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {

template <int D>
Status persist_filter(const FilteredMesh<D>& mesh, const PersistRequest& request, const Work& work,
                      FilterDiagram* out) {
    *out = FilterDiagram{};
    const Store<D>& store = mesh.store;
    CountedPairs found = {};
    if (built::alpha && request.filter.filter == NETMESH_FILTER_ALPHA) {
        const Status status = persist_alpha<D>({store.view(), store.point(0), Store<D>::vertex_stride}, request.diagram,
                                               work, &found, &out->value_error);
        out->pairs = found.pairs;
        out->simplices = found.simplices;
        return status;
    }
    const std::size_t behind = work.arena.low_mark();
    ArenaScope scope(work.arena);
    Evaluation evaluation = {work.arena.take_low<double>(mesh.vertices())};
    if (evaluation.value == nullptr) return Status::out_of_memory;
    ClippedCells<D> cells;
    Status status = clip_cells<D>(mesh, request.filter, work, &cells);
    const FilteredMesh<D> filtered = cells.of(mesh);
    if (status == Status::ok) status = evaluate(filtered, request.filter, work, &evaluation);
    out->culprit = evaluation.culprit;
    if (status == Status::ok)
        status =
            persist_packed<D>(mesh.store, behind, {store.view(), evaluation.value, evaluation.zero_born, filtered.part},
                              request.diagram, work, &found);
    if (status != Status::ok) return status;
    if (cells.is_there) out->clip_radius = cells.ball.radius;
    out->pairs = found.pairs;
    out->simplices = found.simplices;
    out->certificate = evaluation.certificate;
    out->value = evaluation.value;
    scope.keep_low_from_now();
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status persist_filter<D>(const FilteredMesh<D>&, const PersistRequest&, const Work&, FilterDiagram*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
