// A piece out of two.
#pragma once
#include "include/netmesh/pieces.h"
#include "memory/work.hpp"
#include "pieces/residual.hpp"

namespace netmesh {

// Joins the pieces of nodes 2 n and 2 n + 1 of one job, in either order, into that of node n. Puts its bytes at the
// arena's low end; everything else is given back, without ok all. Bars are those of n alone.
// invalid_argument with *fault a static text: bytes are no piece, of the one or of the other by *at, 0 or 1; or they
// are not of two neighbours of one job, which is said of the other. out_of_memory, cancelled; internal: the pieces
// contradict one another.
Status join_pieces(const netmesh_piece& one, const netmesh_piece& other, const Work& work, PieceBytes* out,
                   const char** fault, int* at);

}  // namespace netmesh
