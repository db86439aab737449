// Where the shells of cages of the thesis stand, by netmesh.h: as directions from the centre.
#pragma once
#include "exact.hpp"
#include "mesh_file.hpp"

namespace referee {

using Points = std::vector<Point>;

Points cage_template(int dim);   // 16 on a circle; an icosahedron and the middles of its edges; a 600-cell
Points outer_template(int dim);  // of the outermost cage: the middles of squares on the sides of a cube

}  // namespace referee
