// The faces of a triangulation that are in a part of it.
#pragma once
#include "complex/faces.hpp"
#include "complex/subcomplex.hpp"
#include "complex/triangulation.hpp"
#include "memory/work.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// Leaves of the faces of a triangulation those that are in the part, numbered densely in the same order. The faces may
// have other names for the vertices: name v is vertex vertex_of[v] of the triangulation, and both go to vertex_count.
// Requires: faces as enumerate_faces left them, `facets` last at the arena's low end, where the fewer ones lie after.
// Scratch: a byte for each face, two words for each of the most frequent dimension, a word for each vertex.
// O(faces), and O(2^D log faces) for each cell of the part that has vertices which are cut. out_of_memory, cancelled.
Status keep_faces_in_part(const AnyPart& part, const TriangulationView<any_dimension>& triangulation,
                          const std::uint32_t* vertex_of, const Work& work, Faces<any_dimension>* faces);

}  // namespace netmesh
