// Whether the stars of points are those among all of their copies.
#pragma once
#include "delaunay/store.hpp"
#include "periods/periodic_points.hpp"

namespace netmesh {

// Of a compact triangulation of copies within `margin`: every cell at one of the points has its ball within the margin,
// as far as there are points, so no copy that is not there is in conflict with it; and no hull facet at one of them has
// points beyond it. *wanted: a margin that would do, as far as balls say; infinity where stars are open.
//
// A facet at a point that is parallel to all vectors of the lattice has no copies beyond it, as with one beyond it the
// point that it is a copy of would be. What is in its plane is left to the cell behind.
//
// A point only loses what is nearest to it when copies are added. Ball and centre of each new cell are, by convexity,
// no farther out than those of the old cells at that point. So a margin that was wanted once is enough.
//
// copy_of [vertices]: the copy that each vertex is. at_points [cell slots]: becomes which cells are at points.
struct StarReach {
    bool are_final;
    double wanted;
};
template <int D>
StarReach reach_of_stars(Store<D>& store, const PeriodicPoints& points, const double* margin, const Weights* weights,
                         const std::uint32_t* copy_of, std::uint8_t* at_points);

}  // namespace netmesh
