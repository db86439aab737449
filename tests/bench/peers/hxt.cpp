#include <gmsh.h>

#include "contestants.hpp"

namespace bench {

// Through gmsh's own call: HXT on one thread, then gmsh makes its tetrahedra of the result. Its time for that alone is
// about three quarters. HXT moves no point, but triangulates a box around them: what it returns at the hull may differ.
void hxt_delaunay_3(Trial& trial, const inputs::Points& points) {
    constexpr double hxt = 10;
    gmsh::initialize();
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("General.Verbosity", 0);
    gmsh::option::setNumber("Mesh.Algorithm3D", hxt);
    std::vector<std::size_t> tets;
    trial.start();
    gmsh::model::mesh::tetrahedralize(points, tets);
    trial.stop();
    trial.figure(cells, static_cast<double>(tets.size() / 4));
    gmsh::finalize();
}

}  // namespace bench
