#include "mesh/mesh_points.hpp"

#include "mesh/loop/certificate_rule.hpp"
#include "mesh/loop/hierarchy_rule.hpp"
#include "mesh/loop/quality_rule.hpp"
#include "mesh/loop/thesis_cages.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {

namespace {

Status mesh_by_method(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                      const Work& work, AnyMeshResult* result) {
    const bool has_cages = request.method == MeshMethod::hierarchy;
    if constexpr (built::thesis_cages) {
        if (has_cages && request.cages == CageKind::thesis)
            return mesh_by_thesis_cages(store, points, n, request, work, result);
    }
    return with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        if constexpr (built::cages) {
            if (has_cages) return mesh_by_hierarchy<D>(store, points, n, request, work, result);
        }
        if constexpr (built::certificate) {
            if (request.method == MeshMethod::certificate)
                return mesh_by_certificate<D>(store, points, n, request, work, result);
        }
        return mesh_by_quality<D>(store, points, n, request, work, result);
    });
}

}  // namespace

Status mesh_points(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                   const Work& work, AnyMeshResult* result) {
    const Status status = mesh_by_method(store, points, n, request, work, result);
    store.locate_arrays();  // a store of the dimension may have done the work
    result->domain.dim = store.dim;
    return status;
}

}  // namespace netmesh
