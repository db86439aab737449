// Bars that surely are real though the bounds of all cells of their scales together do not tell: classes that a cover within the
// offsets has and a cover around them keeps.
//
// With lo_v <= F <= hi_v on each cell let X_a be the union of the cells with hi_v <= a and Y_a that of the cells with lo_v <= a,
// inputs' balls before as in mesh_filter.hpp. Then X_a, F's sublevel set P_a and Y_a contain each other in this order:
// where x in P_a has its cell's (clump's) lo_v > a, the cell is an input's and x in the ball of radius a. Both are filtrations of
// the same Delaunay triangulation. Now let scales b_0 < b_1 < ... be such that no cell has lo_v <= b_i and hi_v > b_{i+1}:
//
//     X_0 c P_0 c Y_0 c X_1 c P_1 c Y_1 c ...            (X_i for X_{b_i}, ...)
//
// is one filtration of spaces. Its bars restricted to the X and Y are those of one lower-star filtration with 2 n + 1 levels;
// restricted to the P they are the true bars, as far as these scales see them. A bar that is alive at X_i and Y_j, i <= j,
// belongs to a true bar that is born at b_i or before and dies after b_j; when it is not alive at Y_m and X_q, m < i, q > j, the true
// birth is after b_m and the true death at b_q or before. All bars of one such chain belong to different true bars.
//
// A bar of the filter's diagram whose birth and death are within these bounds is said to be real with them. Claims that come from
// different chains, or from the interleaving of bar_bounds.hpp, could be about the same true bar; they stand together only where
// their bounds exclude that.
#pragma once
#include <cstdint>

#include "complex/triangulation.hpp"
#include "filtration/bar_bounds.hpp"
#include "vocabulary/monitor.hpp"
#include "memory/work.hpp"

namespace netmesh {

// Marks more of the bars pairs[i] as certain, with bounds[i] as proven, in degrees that have no zero-born classes. Chains go
// through the middles and quarters of the longest bars not yet marked: at most eight, each the cost of a diagram. interval, value: of the
// vertices, the values serve to order simplices within a level. zero_born: as in homology/lower_star/lower_star.hpp.
// Scratch: 36 bytes a vertex, 144 a bar, and what persist_lower_star needs. out_of_memory, cancelled.
template <int D>
Status find_sure_bars(const TriangulationView<D>& complex, const double* value, const Interval* interval,
                      std::uint32_t zero_born, const Pair* pairs, std::uint64_t pair_count, const Work& work, BarBounds* bounds);

}  // namespace netmesh
