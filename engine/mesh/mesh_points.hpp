// From points to a mesh: a function for each method, so that programs hold those that they name.
#pragma once
#include <cstddef>

#include "memory/work.hpp"
#include "mesh/mesh_request.hpp"
#include "numerics/input_rows.hpp"

namespace netmesh {

// Meshes points[n][store.dim]; request.method and request.cages say the same as the function does. Afterwards the store
// is compact; vertices are the inputs (input order), then Steiner and exempt vertices as they came; balls depend on
// their cells alone. What is promised of cells, domain, vertex.nearest2 and vertex.origin stands with each method's
// rule.
//
// ok, out_of_memory, cancelled (both: a Delaunay mesh of what was inserted, the quality is not promised), out_of_range
// and too_close (rows in result->input), invalid_argument (the size asked for at some vertex, row_a the nearest input,
// is not positive or not resolved by its coordinates: below 64 units in the last place; or what the goal of the
// certificate or the boundary net of the reference asks for is not resolved, the latter with row_a none), internal (an
// audit finds an input in other D-balls than it is stored in, or an encroached cage), and what take_input says.
using Mesher = Status(AnyStore& store, const InputRows& points, std::size_t n, const MeshRequest& request,
                      const Work& work, AnyMeshResult* result);
Mesher mesh_of_quality, mesh_with_cages, mesh_with_thesis_cages, mesh_for_certificate;

}  // namespace netmesh
