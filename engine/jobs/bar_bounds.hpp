// For each bar of a filter on a mesh, where the true bar surely is, and the ratio near each scale: interleaving by
// scale instead of by one ratio.
//
// With lo_v <= F <= hi_v on the cell (or clump) of v and t_v the filter's value, the cover at scale b lies in the
// sublevel set of F at phi(b) = max(b, hi_v over t_v <= b), and the sublevel set at a in the cover at psi(a) = max(a,
// t_v over lo_v <= a): mesh_filter.hpp, and by the same arguments function_filter.hpp and tight_filter.hpp, each with
// its own cover. Hence the true birth is in [psi^-(b), phi(b)], psi^-(b) = min(b, lo_v over t_v >= b), the true death
// likewise, and a bar of the filter stands for a class of F when its death is after psi(phi(birth)). A bad cell spoils
// only the scales from its value to its hi.
//
// None of that takes products: it holds for values of any sign, and only the steps of the curve differ (Spacing). At a
// the shift is e(a) = max(phi(a) - a, a - psi^-(a)) at most, which is no more than the largest hi_v - t_v or t_v - lo_v
// of the cells whose interval contains a. But a bar longer than 2 e(birth) need not be real, as one longer than 2 e for
// the additive bound e of all cells is: phi(birth) may lie in the interval of a cell that is worse. With t_u = 0, hi_u
// = 1, lo_w = 1, t_w = 6 and birth 0 e(0) = 1, and what dies before psi(phi(0)) = 6 may be no true bar.
//
// The basic filter's inputs are there from the start, t_v = 0 <= hi_v = R_v, and the same holds: phi(b) is never below
// the largest R_v of an input, and a true bar that dies before need not be in the diagram.
#pragma once
#include <cstdint>

#include "certificate/interval.hpp"
#include "diagram/pair.hpp"
#include "memory/arena.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

struct BarBounds {
    double birth_low, birth_high, death_low, death_high;
    double certain_after;   // the bar is certified to exist when its death is after this
    std::uint32_t certain;  // or for another reason: 1
    std::uint32_t unused;
};

// A filter's values and intervals, [count] each.
struct FilterBounds {
    const double* value;
    const Interval* interval;
    std::uint32_t count;
};

// How far apart scales are that belong to one step, or of a bar that is worth work: a factor; or a difference.
struct Spacing {
    double difference = 0;  // of a factor of 2, and as much of it as a factor is above 1; 0: factors, of values >= 0

    bool is_difference() const { return difference > 0; }
    double before(double x, double factor) const {
        return is_difference() ? x - difference * (factor - 1) : x / factor;
    }
    double after(double x, double factor) const { return is_difference() ? x + difference * (factor - 1) : x * factor; }
    // What comes before all scales.
    double least() const { return is_difference() ? -infinity : 0; }
};

// For each scale a from `from` up to the next step's: phi(a) <= max(high, a), psi^-(a) >= min(low, a), psi(phi(a)) <=
// max(reach, a), and a birth or death at a is off by the factor c(a) = max(phi(a) / a, a / psi^-(a)) <= ratio at most.
// Before the first step all is exact: c = 1. From the scale on from which the filter's own ratio c holds c(a) <= c, as
// hi_v <= c t_v and t_v <= c lo_v. (0.1.0 said sqrt(psi(phi(a)) / a), see engine/decisions/ratio-by-scale.md.)
struct ScaleStep {
    double from, low, high, reach, ratio;
    double error;  // the same as a difference: e(a) <= error
};

struct ScaleCurve {
    ScaleStep* steps;  // [count], ascending in all but ratio, at the arena's low end
    std::uint64_t count;
};

// bounds[i] of bar i, and the curve. Deaths at infinity are exact. A step comes where one of the three bounds has grown
// by a 16th, of itself or of the spacing's difference; their number is bounded by the logarithm of the spread of
// scales, or by their range over the difference. A birth at 0 is exact where the spacing is a factor: of distances.
// O((vertices
// + bars + steps) log vertices). Scratch: 48 bytes a vertex. out_of_memory.
Status bound_by_scale(const FilterBounds& filter, const BarList& bars, Spacing spacing, Arena& arena, BarBounds* bounds,
                      ScaleCurve* curve);

class JoinShift;
class ScaleGrid;

// The same of one of several diagrams that are joined (join_shift.hpp): births and deaths are bounded within its own
// points' offsets, but what is certain is so of the joined one. What the mesh says by scale goes to the grid.
// Scratch: 48 bytes a vertex. out_of_memory.
Status bound_in_join(const FilterBounds& filter, const BarList& bars, const JoinShift& join, Arena& arena,
                     BarBounds* bounds, ScaleGrid* grid);

// What holds at every scale: the ratio; whether values are true ones rounded, to nearest where the ratio is 1 and to a
// unit in the last place else, or as they are; and the additive bound, beside which there may be no ratio: infinite,
// and values of any sign.
struct UniformBound {
    double ratio;
    bool rounded = false;
    double error = -1;       // negative: none
    bool has_points = true;  // what is born in degree 0 at 0 is; false: they are sets of points, rounded as all is
};

// The same from one bound. Neither the rounding nor the additive bound is in the curve, which begins at 0 or, for
// negative values, the least birth. Deaths at infinity are exact; true ones beyond the largest double count as
// infinite. out_of_memory.
Status bound_by_ratio(const UniformBound& bound, const BarList& bars, Arena& arena, BarBounds* bounds,
                      ScaleCurve* curve);

}  // namespace netmesh
