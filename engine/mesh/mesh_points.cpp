#include "mesh/mesh_points.hpp"

#include "mesh/certificate_rule.hpp"
#include "mesh/hierarchy_rule.hpp"
#include "mesh/quality_rule.hpp"
#include "mesh/thesis_cages.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

template <int D>
Status mesh_points(Store<D>& store, const double* points, std::size_t n, const MeshRequest& request, const Work& work,
                   MeshResult<D>* result) {
    switch (request.method) {
    case MeshMethod::quality:
    case MeshMethod::reference: return mesh_by_quality<D>(store, points, n, request, work, result);
    case MeshMethod::hierarchy:
        if (request.cages == CageKind::compact) return mesh_by_hierarchy<D>(store, points, n, request, work, result);
        return mesh_by_thesis_cages<D>(store, points, n, request, work, result);
    case MeshMethod::certificate: return mesh_by_certificate<D>(store, points, n, request, work, result);
    }
    return Status::internal;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status mesh_points<D>(Store<D>&, const double*, std::size_t, const MeshRequest&, const Work&,             \
                                   MeshResult<D>*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
