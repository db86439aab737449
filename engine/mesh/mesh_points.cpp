#include "mesh/mesh_points.hpp"

#include "mesh/loop/certificate_rule.hpp"
#include "mesh/loop/hierarchy_rule.hpp"
#include "mesh/loop/quality_rule.hpp"
#include "mesh/loop/thesis_cages.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// A store of the dimension may have done the work.
Status end(AnyStore& store, Status status, AnyMeshResult* result) {
    store.locate_arrays();
    result->domain.dim = store.dim;
    return status;
}

}  // namespace

Status mesh_of_quality(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                       const Work& work, AnyMeshResult* result) {
    const Status status = with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        return mesh_by_quality<decltype(dimension)::value>(store, points, n, request, work, result);
    });
    return end(store, status, result);
}

Status mesh_with_cages(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                       const Work& work, AnyMeshResult* result) {
    const Status status = with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        return mesh_by_hierarchy<decltype(dimension)::value>(store, points, n, request, work, result);
    });
    return end(store, status, result);
}

Status mesh_for_certificate(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                            const Work& work, AnyMeshResult* result) {
    const Status status = with_dimension(static_cast<std::uint32_t>(store.dim), [&](auto dimension) {
        return mesh_by_certificate<decltype(dimension)::value>(store, points, n, request, work, result);
    });
    return end(store, status, result);
}

Status mesh_with_thesis_cages(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                              const Work& work, AnyMeshResult* result) {
    return end(store, mesh_by_thesis_cages(store, points, n, request, work, result), result);
}

}  // namespace netmesh
