// What every way of meshing begins with (may the input be meshed, the frame that everything stays inside of) and ends with.
#pragma once
#include <cstdint>

#include "vocabulary/dimension.hpp"
#include "delaunay/triangulate.hpp"
#include "mesh/domain.hpp"
#include "mesh/input_tree.hpp"

namespace netmesh {

// What meshing admits: magnitudes of coordinates, distances, and distances over magnitudes.
constexpr double coordinate_max = 0x1p500;
constexpr double separation_min = 0x1p-500;
constexpr double resolution = 64 * 0x1p-52;

// The store holds inputs alone, `tree` is over them. out_of_range: a coordinate above 2^500 or two inputs closer than 2^-500;
// too_close: two inputs closer than `finest` times the magnitude of their coordinates. Rows in *input. O(n log n).
template <int D>
Status check_separation(const Store<D>& store, const InputTree<D>& tree, double finest, InputReport* input);

// A new vertex at x, not inserted yet. Room for it must be there.
template <int D>
inline VertexId make_vertex(Store<D>& store, const double* x, std::uint32_t origin, Marker marker) {
    const VertexId made = store.new_vertex();
    Vertex<D>& v = store.vertex(made);
    for (int k = 0; k < D; ++k) v.x[k] = x[k];
    v.nearest2 = infinity;
    v.cell = none;
    v.next = none;
    v.origin = origin;
    v.marker = marker;
    v.queued = 0;
    v.size_hint = 0;
    return made;
}

// Frame distance over the radius of the domain: the frame's hull, a cross-polytope, must contain the ball of 2.2 radii in
// which everything stays (refine.hpp), so more than 2.2 sqrt(D), and 4 at least for a coarse mesh between domain and frame.
template <int D> constexpr double frame_factor = figures<D>.frame_factor;

// Starts the triangulation with 2 D exempt vertices at `reach` from the domain's centre along each axis; their nearest2 and
// origin are final as long as no vertex comes nearer. out_of_memory.
template <int D>
Status open_frame(Store<D>& store, Kernel<D>& kernel, const InputTree<D>& tree, const Domain<D>& domain, double reach);

// The end of every way of meshing: replaces balls that were derived from others by balls that depend on the cell alone, so
// that what is read off the mesh is the same however it was made, and again after it has been written to a file and loaded.
template <int D> void settle_spheres(Store<D>& store);

}  // namespace netmesh
