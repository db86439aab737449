// The frame: the 2 D exempt vertices around everything with which a mesh begins.
#pragma once
#include <cstdint>

#include "delaunay/any_kernel.hpp"
#include "mesh/any_domain.hpp"
#include "mesh/input_tree.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

// A new vertex at x, not inserted yet. Room for it must be there.
template <int D> inline VertexId make_vertex(Store<D>& store, const double* x, std::uint32_t origin, Marker marker) {
    const VertexId made = store.new_vertex();
    auto&& v = store.vertex(made);
    copy<D>(store.dim, x, v.x);
    v.nearest2 = infinity;
    v.cell = none;
    v.next = none;
    v.origin = origin;
    v.marker = marker;
    v.queued = 0;
    v.size_hint = 0;
    return made;
}

// Starts the triangulation with 2 D exempt vertices at `reach` from the domain's centre along each axis; their
// nearest2 and origin are final as long as no vertex comes nearer. *steps: cells that were passed. out_of_memory.
Status open_frame(AnyStore store, const AnyInputTree& tree, const AnyDomain& domain, double reach,
                  std::uint64_t* steps);

}  // namespace netmesh
