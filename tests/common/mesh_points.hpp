// Meshes by the method that a request of the inner layers names.
#pragma once
#include "mesh/mesh_points.hpp"

namespace netmesh {

inline Mesher* mesher_of(const MeshRequest& request) {
    switch (request.method) {
    case MeshMethod::hierarchy: return request.cages == CageKind::thesis ? mesh_with_thesis_cages : mesh_with_cages;
    case MeshMethod::certificate: return mesh_for_certificate;
    default: return mesh_of_quality;
    }
}

template <int D>
Status mesh_points(Store<D>& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                   const Work& work, MeshResult<D>* result) {
    AnyStore any(store);
    AnyMeshResult made = {};
    const Status status = mesher_of(request)(any, points, n, request, work, &made);
    store.locate_arrays();
    *result = made.of_dimension<D>();
    return status;
}

}  // namespace netmesh
