// A triangulation of few points in the plane that is kept, in 26 bytes a point beside the coordinates.
#pragma once
#include "delaunay/plane_cells.hpp"
#include "delaunay/triangulate.hpp"
#include "memory/work.hpp"

namespace netmesh {

// Cells as triangulate makes them, in their order and with vertices numbered as there; point place[v] is vertex v.
struct FewCells {
    PlaneTriangulation<NarrowWords> mesh;
    std::uint16_t* place;
};

// Of at most NarrowWords::points_max points. The cells are put at the low end, at the high end the points and below
// them `place`. state: counts. Memory: 64 bytes a point while points are put in order, then 42. As triangulate, but
// that without ok nothing of use stays. internal: the plane is not served.
Status triangulate_few(StoreState& state, const InputRows& points, std::size_t n, std::uint64_t seed, const Work& work,
                       InputReport* input, FewCells* out);

}  // namespace netmesh
