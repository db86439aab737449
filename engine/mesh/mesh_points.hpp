// From points to a mesh.
#pragma once
#include <cstddef>

#include "memory/work.hpp"
#include "mesh/mesh_request.hpp"
#include "numerics/input_rows.hpp"

namespace netmesh {

// Meshes points[n][store.dim] by the method asked for. Afterwards the store is compact; vertices are the inputs (input
// order), then Steiner and exempt vertices as they came; balls depend on their cells alone. What is promised of cells,
// domain, vertex.nearest2 and vertex.origin stands with each method's rule.
//
// ok, out_of_memory, cancelled (both: a Delaunay mesh of what was inserted, the quality is not promised), out_of_range
// and too_close (rows in result->input), invalid_argument (the size asked for at some vertex, row_a the nearest input,
// is not positive or not resolved by its coordinates: below 64 units in the last place; or what the goal of the
// certificate or the boundary net of the reference asks for is not resolved, the latter with row_a none), internal (an
// audit finds an input in other D-balls than it is stored in, or an encroached cage), and what take_input says.
Status mesh_points(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                   const Work& work, AnyMeshResult* result);
template <int D>
Status mesh_points(Store<D>& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                   const Work& work, MeshResult<D>* result) {
    AnyStore any(store);
    AnyMeshResult made = {};
    const Status status = mesh_points(any, points, n, request, work, &made);
    store.locate_arrays();
    *result = made.of_dimension<D>();
    return status;
}

}  // namespace netmesh
