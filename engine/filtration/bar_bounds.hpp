// For each bar of a filter on a mesh, where the true bar surely is: interleaving by scale instead of by one ratio.
//
// With lo_v <= F <= hi_v on the cell (or clump) of v and t_v the filter's value, the cover at scale b lies in the sublevel set of F
// at phi(b) = max(b, hi_v over t_v <= b), and the sublevel set at a in the cover at psi(a) = max(a, t_v over lo_v <= a): the
// arguments of mesh_filter.hpp, function_filter.hpp and tight_filter.hpp with each cell's own bounds. Hence the true birth is in
// [psi^-(b), phi(b)], psi^-(b) = min(b, lo_v over t_v >= b), the true death likewise, and a bar of the filter stands for a class of F
// when its death is after psi(phi(birth)). Near scale a the diagrams are within sqrt(psi(phi(a)) / a): a bad cell spoils only the
// scales from its value to its hi.
#pragma once
#include <cstdint>

#include "diagram/pair.hpp"
#include "filtration/mesh_filter.hpp"

namespace netmesh {

struct BarBounds {
    double birth_low, birth_high, death_low, death_high;
    double certain_after;  // the bar is surely real when its death is after this
};

// bounds[i] of pairs[i], for the filter value[count] with interval[count]. Births at 0 are exact, deaths at infinity too.
// O((count + pair_count) log count). Scratch: 48 bytes a vertex. out_of_memory.
Status bound_bars(const double* value, const Interval* interval, std::uint32_t count, const Pair* pairs,
                  std::uint64_t pair_count, Arena& arena, BarBounds* bounds);

}  // namespace netmesh
