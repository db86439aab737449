#include "mesh/mesh_points.hpp"

#include "mesh/certificate_rule.hpp"
#include "mesh/hierarchy_rule.hpp"
#include "mesh/quality_rule.hpp"
#include "mesh/thesis_cages.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {

template <int D>
Status mesh_points(Store<D>& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                   const Work& work, MeshResult<D>* result) {
    if constexpr (built::cages) {
        if (request.method == MeshMethod::hierarchy && request.cages == CageKind::compact)
            return mesh_by_hierarchy<D>(store, points, n, request, work, result);
    }
    if constexpr (built::thesis_cages) {
        if (request.method == MeshMethod::hierarchy)
            return mesh_by_thesis_cages<D>(store, points, n, request, work, result);
    }
    if constexpr (built::certificate) {
        if (request.method == MeshMethod::certificate)
            return mesh_by_certificate<D>(store, points, n, request, work, result);
    }
    return mesh_by_quality<D>(store, points, n, request, work, result);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status mesh_points<D>(Store<D>&, const InputRows&, std::size_t, const MeshRequest&, const Work&,          \
                                   MeshResult<D>*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
