// The second stage of circumsphere.hpp: what the float stage leaves open, in numbers of two doubles.
#pragma once
#include "geometry/circumsphere.hpp"

namespace netmesh {

// Where size counts the exact stage comes next.
#ifdef __OPTIMIZE_SIZE__
constexpr bool has_close_look = false;
#else
constexpr bool has_close_look = true;
#endif

// Of one simplex of k+1 points in R^dim, 1 <= k <= dim. Bit 0 of each: whether out->within, out->radius are right. Not
// certain: simplices that are flat for twice the precision, sizes far from 1, ties, and what is next to them.
Certainty look_closely(std::uint32_t k, std::uint32_t dim, const double* const* point, Circumsphere* out);

}  // namespace netmesh
