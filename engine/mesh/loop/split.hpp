// Where a bad cell is split, and what a Steiner point there gives way to.
#pragma once
#include <cstdint>

#include "mesh/clip/corner.hpp"
#include "vocabulary/ids.hpp"

namespace netmesh {

// An uninserted input is inserted in place of a Steiner point when it is nearer than this times the radius of the empty
// ball (thesis 4.4). Larger values give smaller meshes, but from about .95 on refinement runs along curves from input
// to input without a Steiner point: 1 makes meshes of curves smaller by a fifth, and takes time that grows with the
// square of their number.
constexpr double yield_radius = 0.9;
// An input is medial, and inserted, when the clipped cell of its nearest vertex reaches no farther than this times the
// distance to that vertex: 1 / e of thesis 4.4. Smaller values keep intermediate meshes better.
constexpr double mediality = 16;
// Refinement stops a hair before what it is held to: more than the error of the corners that it sees, so the true
// ratios keep the bound.
constexpr double tau_margin = 0x1p-20;
// So the interval of a cell is taken as its ends are computed, not rounded outwards (certificate/interval.hpp).
constexpr double as_computed = 1;

// Where a Steiner point goes.
template <int D> struct Split {
    double x[DimensionOf<D>::most];
    double empty2;   // squared radius of a ball about x that contains no vertex
    VertexId input;  // an inserted input near x, where the search for the nearest one starts
    CellId cell;     // where the search for the cavity starts

    // Puts x this fraction of the way from p to a corner.
    void place(const double* p, const Corner<D>& corner, double fraction) {
        for (int k = 0; k < corner.dim; ++k) x[k] = p[k] + fraction * (corner.x[k] - p[k]);
        cell = corner.cell;
    }
};

struct NearestInput {
    VertexId input;
    double distance2;
};

enum class Verdict { good, bad, out_of_memory };

}  // namespace netmesh
