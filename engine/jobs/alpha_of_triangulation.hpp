// From a Delaunay triangulation to the diagram of its alpha complex.
#pragma once
#include "filtration/alpha.hpp"
#include "homology/persistence.hpp"
#include "memory/work.hpp"
#include "vocabulary/status.hpp"

namespace netmesh {

// Persistent homology of an alpha filtration in degrees 0..max_degree (at most D-1; larger is clamped): in exact
// arithmetic, with births and deaths rounded (alpha.hpp). Counted are the simplices of dimensions
// 0..max_degree+1, which are what is filtered.
//
// The diagram is put at the arena's low end in the canonical order (diagram/pair.hpp), everything else is given back;
// without Status::ok nothing stays. It does not depend on the order in which cells are stored.
// Memory: 16, 19, 22, 29, 32 bytes a simplex of the triangulation in D = 2..6 while radii are found; up to D = 4 also 8
// D + 4 a point; then 16, 19, 22, 25, 28 and what persist_ball takes. Peaks seen: 30, 26, 27, 29, 32. Grids, where most
// radii are equal to others, take 8 more in space. out_of_memory, out_of_range, cancelled; check_failed: a cell is
// flat.
template <int D>
Status alpha_of_triangulation(const AlphaFiltration<D>& filtration, DiagramRequest request, const Work& work,
                              CountedPairs* out);
// The same with weights (alpha.hpp). Memory: up to D = 4 another 8 bytes a point.
template <int D>
Status alpha_of_triangulation(const AlphaFiltration<D>& filtration, const PowerValues& powers, DiagramRequest request,
                              const Work& work, CountedPairs* out);

}  // namespace netmesh
