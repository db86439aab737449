// enumerate_faces_along where lists follow the order.
#pragma once
#include <cstddef>
#include <cstdint>

#include "complex/faces.hpp"
#include "complex/triangulation.hpp"
#include "memory/work.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// As enumerate_faces_along, but that both ends of the arena are the caller's to give back when the status is not ok.
// low: where the low end is once the cells have been read. Requires lists_follow_order<D>.
template <int D>
Status enumerate_along(const TriangulationView<D>& complex, const FaceCounting& counting, std::uint32_t* order,
                       const Work& work, std::size_t low, Faces<D>* out);

}  // namespace netmesh
