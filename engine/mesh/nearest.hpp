// Nearest-neighbour distances, kept while vertices come.
#pragma once
#include <cstdint>

#include "delaunay/kernel.hpp"
#include "mesh/bucket_queue.hpp"
#include "numerics/vector.hpp"

namespace netmesh {

// Vertex v has filled the cavity: its nearest2 and those of its neighbours. Neighbours to which it is nearer than any
// vertex before may have become bad and are queued.
template <int D>
void update_nearest(Store<D>& store, const Kernel<D>& kernel, const Cavity& cavity, std::uint32_t v,
                    BucketQueue<D>& queue) {
    Vertex<D>& centre = store.vertex(v);
    kernel.visit_neighbours(cavity, VertexId(v), [&](std::uint32_t w) {
        Vertex<D>& other = store.vertex(w);
        const double d2 = distance2<D>(centre.x, other.x);
        if (d2 < centre.nearest2) centre.nearest2 = d2;
        if (!(d2 < other.nearest2)) return;
        other.nearest2 = d2;
        if (other.marker != Marker::exempt) queue.push(w);
    });
}

}  // namespace netmesh
