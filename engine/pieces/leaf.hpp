// A piece out of points: the simplices at home in a lowest node, and what is undecided of them.
#pragma once
#include "homology/persistence.hpp"
#include "memory/work.hpp"
#include "pieces/residual.hpp"
#include "pieces/source.hpp"
#include "pieces/stars.hpp"

namespace netmesh {

struct LeafRequest {
    PointSource source;
    std::uint32_t pieces;  // a power of 2
    PieceNode node;        // pieces .. 2 pieces - 1
    DiagramRequest diagram;
};

// Puts the piece's bytes at the arena's low end; everything else is given back, without ok all.
// ok, flat (all points are), out_of_memory, out_of_range, cancelled, not_finite, and what the source says.
Status make_leaf(const LeafRequest& request, const Work& work, PieceBytes* out, StarsReport* report);

// What all pieces of this job have in common.
inline PieceJob job_of(const PointSource& source, std::uint32_t pieces, const DiagramRequest& diagram) {
    const std::uint32_t degree = diagram.max_degree < source.from.dim ? diagram.max_degree : source.from.dim - 1;
    return {source.from.dim,         pieces, source.from.count,          source.from.rows,
            source.from.fingerprint, degree, diagram.keep_zero ? 1u : 0u};
}

}  // namespace netmesh
