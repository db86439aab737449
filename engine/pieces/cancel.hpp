// Pairs of simplices that a piece decides by itself, and what stays of it.
#pragma once
#include "memory/work.hpp"
#include "pieces/residual.hpp"

namespace netmesh {

// Cancels what can be cancelled in piece.node: bars become those of the node, at the arena's high end; states, ends,
// sides and columns are what stays. Columns that change are written at the low end, where they stay, as does what was
// taken beside the bars at the high end. Arrays of `piece` are written, but not the rows of its columns.
// out_of_memory, cancelled; internal: something is left at the root.
Status cancel_pairs(Piece* piece, const Work& work);

}  // namespace netmesh
