// Certified bars: bars that are certified to exist though the bounds of all cells of their scales together do not tell:
// classes that a cover within the offsets has and a cover around them keeps.
//
// With lo_v <= F <= hi_v on each cell let X_a be the union of the cells with hi_v <= a and Y_a that of the cells with
// lo_v <= a, both with the balls of the other inputs, of radius min(a, lo_v) as in mesh_filter.hpp (min(a, just under
// r_p) as in tight_filter.hpp). Then X_a, F's sublevel set P_a and Y_a contain each other in this order: where x in P_a
// has its cell's (clump's) lo_v > a, the cell is an input's and x in the ball of radius a. Both are filtrations of the
// same Delaunay triangulation. Now let scales b_0 < b_1 < ... be such that no cell has lo_v
// <= b_i and hi_v > b_{i+1}:
//
//     X_0 c P_0 c Y_0 c X_1 c P_1 c Y_1 c ...            (X_i for X_{b_i}, ...)
//
// is one filtration of spaces. Its bars restricted to the X and Y are those of one lower-star filtration; restricted to
// the P they are the true bars, as far as these scales see them. A bar that is alive at X_i and Y_j, i <= j, belongs to
// a true bar that is born at b_i or before and dies after b_j; when it is not alive at Y_m and X_q, m < i, q > j, the
// true birth is after b_m and the true death at b_q or before. All bars of one such sequence of covers belong to
// different true bars.
//
// A bar of the filter's diagram whose birth and death are within these bounds is certified with them. Claims that come
// from different sequences, or from the interleaving of bar_bounds.hpp, could be about the same true bar; they stand
// together only where their bounds exclude that.
//
// Most scales need no sequence, and other sequences tell which. At a scale s it has no more bars alive from X_s to Y_s
// than the rank of that inclusion in homology. Let each cell with hi_v <= e have lo_v <= l. For all s from l to e it
// factors into X_s c X_e c Y_l c Y_s, and its rank is no more than that of the inclusion in the middle. The diagram of
// a sequence has that rank where X_e and Y_l are between some X_i and Y_i: as many bars as are alive from one to the
// other. As many claims, each of which is of a bar alive at s, leave nothing to be found there.
#pragma once
#include <cstdint>

#include "complex/subcomplex.hpp"
#include "complex/triangulation.hpp"
#include "jobs/bar_bounds.hpp"
#include "memory/work.hpp"

namespace netmesh {

struct CertifiedBarsRequest {
    TriangulationView<any_dimension> complex;
    FilterBounds filter;      // of the vertices; values serve to order simplices within a level
    std::uint32_t zero_born;  // as in homology/lower_star/lower_star.hpp: inputs of covers that begin with balls
    BarList bars;
    const AnyPart* part = nullptr;  // what is filtered of the complex; null: all of it
    Spacing spacing = {};
    const JoinShift* join = nullptr;  // the diagram is one of several: a class has to be one of all points
};

// Marks more of the bars as certain, with bounds[i] as proven, in degrees that have no zero-born classes. Sequences of
// covers go through the middles, quarters and eighths of the longest bars not yet marked, as far as these are not ruled
// out: at most eight, each the cost of a diagram. Scratch: 36 bytes a vertex, 144 a bar, and what persist_lower_star
// needs. out_of_memory, cancelled.
Status find_certified_bars(const CertifiedBarsRequest& request, const Work& work, BarBounds* bounds);

}  // namespace netmesh
