// What the Voronoi cells of a mesh reach, rounded outwards: the numbers that interval.hpp takes.
#pragma once
#include <cstdint>

#include "certificate/rounding.hpp"
#include "delaunay/any_store.hpp"
#include "delaunay/sphere.hpp"
#include "memory/prefetch.hpp"
#include "numerics/vector.hpp"

namespace netmesh {

template <int D> VertexId nearest_input(const Store<D>& store, VertexId v) {
    return store.vertex(v).marker == Marker::input ? v : VertexId(store.vertex(v).origin);
}

// The distance from v to its nearest input; 0 for inputs.
template <int D> double distance_to_inputs(const Store<D>& store, VertexId v) {
    return distance<D>(store.dim, store.point(v), store.point(nearest_input<D>(store, v)));
}

// out_radius[v]: R_v or more, over all corners of v's cell; reach[v - first], v >= first: the largest distance from a
// corner to v's nearest input or more; reach may be null. The unbounded sides of cells on the hull are not seen.
// Needs balls of corner_error_max, as those of meshes are: see blurred_error. O(cells).
template <int D> void measure_cells(const Store<D>& store, double* out_radius, double* reach, std::uint32_t first = 0) {
    constexpr std::uint32_t ahead = 8;
    const std::uint32_t count = store.state.vertex_count;
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = store.arena.piece(v, count, 4); v < piece; ++v) {
            out_radius[v] = 0;
        }
    if (reach == nullptr) first = count;
    for (VertexId v(first); v < count;)
        for (const std::uint64_t piece = store.arena.piece(v, count, 4); v < piece; ++v) {
            reach[v - first] = 0;
        }
    for (CellId c(0); c < store.state.cell_slots;)
        for (const std::uint64_t piece = store.arena.piece(c, store.state.cell_slots, 30 * (D + 1)); c < piece; ++c) {
            if (D == 2 && c + 2 * ahead < store.state.cell_slots) {  // in space a vertex is in four times as many cells
                for (const VertexId v : store.cell(c + 2 * ahead).vertex) {
                    prefetch(&store.vertex(v));
                    prefetch(out_radius + v);
                    if (v >= first) prefetch(reach + (v - first));
                }
                for (const VertexId v : store.cell(c + ahead).vertex) prefetch(store.point(nearest_input<D>(store, v)));
            }
            const Cell<D>& cell = store.cell(c);
            const double radius = square_root(cell.radius2);
            const double doubt = static_cast<double>(cell.error) * radius;
            const double r = (radius + (cell.error > blurred_error ? corner_error_max * radius : doubt)) * up;
            for (const VertexId v : cell.vertex) {
                out_radius[v] = out_radius[v] > r ? out_radius[v] : r;  // without branches; also r if that is no number
                if (v < first) continue;
                const double far = (distance<D>(cell.centre, store.point(nearest_input<D>(store, v))) + doubt) * up;
                double& farthest = reach[v - first];
                farthest = farthest > far ? farthest : far;
            }
        }
}

// The same, where the dimension is a number at run time.
inline VertexId nearest_input(const AnyStore& store, VertexId v) {
    const AnyVertex vertex = store.vertex(v);
    return vertex.marker == Marker::input ? v : VertexId(vertex.origin);
}
inline double distance_to_inputs(const AnyStore& store, VertexId v) {
    return distance(store.dim, store.point(v), store.point(nearest_input(store, v)));
}
void measure_cells(const AnyStore& store, double* out_radius, double* reach, std::uint32_t first = 0);

}  // namespace netmesh
