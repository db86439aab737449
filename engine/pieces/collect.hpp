// The diagram out of the bars of all pieces.
#pragma once
#include "homology/persistence.hpp"
#include "include/netmesh/pieces.h"
#include "memory/work.hpp"
#include "pieces/residual.hpp"

namespace netmesh {

// One piece for each node of the tree, in any order. The pairs are put at the arena's low end, in the
// canonical order and in the short form (BarList).
// invalid_argument with *fault a static text and *at the place of the piece that it is about; out_of_memory, cancelled,
// and what opening a piece says.
Status collect_pieces(const netmesh_collect_request& pieces, const Work& work, PieceJob* job, CountedPairs* out,
                      const char** fault, std::size_t* at);

}  // namespace netmesh
