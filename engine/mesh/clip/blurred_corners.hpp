// Corners of a cell that coordinates hardly resolve, for AspectRule (aspect_rule.hpp).
#pragma once
#include "mesh/clip/clipped_cell.hpp"

namespace netmesh {

// *blur: how far corners of v's cell may be from where they are computed; only those known worse than by
// corner_error_max count. False when the gap is too small for v's star.
bool find_blur(const AnyStore& store, VertexId v, double* blur);

// Offers corners of v's cell in the ball, and where edges that leave the ball cross its sphere, by their distance from
// v. How many cells are at v, whose star has then been visited; 0 when the gap is too small for it.
std::uint32_t offer_corners(const AnyStore& store, const AnyDomain& ball, VertexId v, AnyCorner* farthest);

}  // namespace netmesh
