// Voronoi corners for an analysis.
#pragma once
#include <cstdint>

#include "delaunay/sphere.hpp"
#include "delaunay/store.hpp"

namespace netmesh {

// Computes the ball of every cell of a compact store afresh, from its vertices alone: an analysis depends neither on
// how the triangulation was made nor on what was cached. O(cells).
template <int D> void recompute_balls(Store<D>& store) {
    for (std::uint32_t c = 0; c < store.state.cell_slots; ++c) {
        const double* p[D + 1];
        for (int i = 0; i <= D; ++i) p[i] = store.point(store.cell(c).vertex[i]);
        solve_sphere<D>(p, corner_error_max, store.cell(c));
    }
}

}  // namespace netmesh
