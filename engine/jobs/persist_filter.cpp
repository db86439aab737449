#include "jobs/persist_filter.hpp"

#include "jobs/persist_alpha.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

template <int D>
Status persist_filter(const FilteredMesh<D>& mesh, const DiagramRequest& request, const Work& work, FilterDiagram* out) {
    *out = FilterDiagram{};
    const Store<D>& store = mesh.store;
    if (request.filter.filter == NETMESH_FILTER_ALPHA)
        return persist_alpha<D>(store.view(), store.point(0), Store<D>::vertex_stride, request.max_degree,
                                request.keep_zero, work, &out->pairs, &out->simplices);
    ArenaScope scope(work.arena);
    Evaluation evaluation = {work.arena.take_low<double>(mesh.vertices())};
    if (evaluation.value == nullptr) return Status::out_of_memory;
    Status status = evaluate<D>(mesh, request.filter, work, &evaluation);
    out->culprit = evaluation.culprit;
    if (status == Status::ok)
        status = persist_lower_star<D>(store.view(), evaluation.value, evaluation.zero_born, request.max_degree,
                                       request.keep_zero, work, &out->pairs, &out->simplices);
    if (status != Status::ok) return status;
    out->certificate = evaluation.certificate;
    out->value = evaluation.value;
    scope.keep_low_from_now();
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status persist_filter<D>(const FilteredMesh<D>&, const DiagramRequest&, const Work&, FilterDiagram*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
