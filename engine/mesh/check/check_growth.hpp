// What is wrong with a mesh while it grows, found by plain loops over all vertices and cells. For builds with
// NETMESH_VALIDATE: refinement.hpp asks after every insertion, after every step and when the queue is empty.
#pragma once
#ifdef NETMESH_VALIDATE
#include <cstdint>

#include "certificate/interval.hpp"
#include "delaunay/store.hpp"
#include "mesh/clip/clipped_cell.hpp"
#include "numerics/vector.hpp"

namespace netmesh {

// Larger meshes are not checked.
constexpr std::uint32_t validated_vertices_max = 300;
// Distances to nearest neighbours may differ by this: which of two vertices is nearer is decided with roundings.
constexpr double validated_slack = 0x1p-40;

// What the records of a mesh that grows are to say.
struct GrowthFacts {
    std::uint32_t inputs, inserted;
    bool nearest_inputs;   // vertex.origin is the nearest of all inputs; otherwise some input in the mesh
    bool input_distances;  // vertex.nearest2 of a Steiner vertex is to its nearest input
    bool shells;           // exempt vertices come later than Steiner vertices too
};

template <int D> bool is_in_mesh(const Store<D>& store, std::uint32_t v) { return store.vertex(v).cell != none; }

// The input nearest to x, the first of equals.
template <int D> std::uint32_t nearest_of_inputs(const Store<D>& store, std::uint32_t inputs, const double* x) {
    std::uint32_t nearest = 0;
    for (std::uint32_t p = 1; p < inputs; ++p)
        if (distance2<D>(store.dim, x, store.point(p)) < distance2<D>(store.dim, x, store.point(nearest))) nearest = p;
    return nearest;
}

// Squared distance of vertex v to the nearest other one in the mesh.
template <int D> double nearest_distance2(const Store<D>& store, std::uint32_t v) {
    double nearest2 = infinity;
    for (std::uint32_t w = 0; w < store.state.vertex_count; ++w) {
        if (w == v || !is_in_mesh(store, w)) continue;
        const double d2 = distance2<D>(store.dim, store.point(v), store.point(w));
        if (d2 < nearest2) nearest2 = d2;
    }
    return nearest2;
}

inline bool is_about(double value, double expected) {
    return value == expected || absolute(value - expected) <= validated_slack * expected;
}

template <int D> const char* record_violation(const Store<D>& store, std::uint32_t v, const GrowthFacts& facts) {
    const Vertex<D>& vertex = store.vertex(v);
    const bool is_frame = v >= facts.inputs && v < facts.inputs + 2 * static_cast<std::uint32_t>(store.dim);
    if ((vertex.marker == Marker::input) != (v < facts.inputs))
        return "a vertex is marked as an input, or an input not";
    if (is_frame && vertex.marker != Marker::exempt) return "a vertex of the frame is not exempt";
    bool has = false;
    if (vertex.cell < store.state.cell_slots && store.is_live(vertex.cell))
        for (const VertexId w : store.cell(vertex.cell).vertex) has |= w == v;
    if (!has) return "a vertex points to a cell that it does not belong to";
    if (vertex.marker != Marker::input) {
        if (vertex.origin >= facts.inputs) return "a vertex is noted with an input that does not exist";
        if ((facts.nearest_inputs || is_frame) && vertex.origin != nearest_of_inputs(store, facts.inputs, vertex.x))
            return "a vertex is noted with an input that is not its nearest";
        if (!is_frame && !facts.nearest_inputs && !is_in_mesh(store, vertex.origin))
            return "a vertex is noted with an input that is not in the mesh";
    }
    if (!facts.input_distances || vertex.marker == Marker::input) {
        if (!is_about(vertex.nearest2, nearest_distance2(store, v))) return "a nearest distance is wrong";
    } else if (vertex.marker == Marker::steiner) {
        if (vertex.nearest2 != distance2<D>(store.dim, vertex.x, store.point(vertex.origin)))
            return "the distance to a nearest input is wrong";
    }
    return nullptr;
}

// After an insertion: the records of all vertices. O(vertices^2).
template <int D> const char* growth_violation(const Store<D>& store, const GrowthFacts& facts) {
    if (store.state.vertex_count > validated_vertices_max) return nullptr;
    std::uint32_t inserted = 0;
    bool refined = false;
    for (std::uint32_t v = 0; v < store.state.vertex_count; ++v) {
        if (!is_in_mesh(store, v)) continue;
        const Marker marker = store.vertex(v).marker;
        inserted += marker == Marker::input;
        refined |= marker == Marker::steiner;
        if (refined && marker == Marker::exempt && !facts.shells)
            return "an exempt vertex comes after a Steiner vertex";
        const char* const violation = record_violation(store, v, facts);
        if (violation != nullptr) return violation;
    }
    return inserted == facts.inserted ? nullptr : "the count of inputs in the mesh is wrong";
}

// When the queue is empty: is the aspect ratio of the cell of each vertex v that is not exempt, clipped to ball_of(v),
// at most tau? By all corners and crossings, then by planes. O(cells).
template <int D, class BallOf> const char* aspect_violation(Store<D>& store, double tau, BallOf&& ball_of) {
    if (store.state.vertex_count > validated_vertices_max) return nullptr;
    const char* const violation = "a cell is bad and nobody has noticed";
    for (CellId c(0); c < store.state.cell_slots; ++c) {
        const Cell<D>& cell = store.cell(c);
        if (!store.is_live(c) || !(cell.radius2 < infinity)) continue;
        for (int i = 0; i <= store.dim; ++i) {
            const Vertex<D>& vertex = store.vertex(cell.vertex[i]);
            if (vertex.marker == Marker::exempt) continue;
            const double bad2 = 0.25 * tau * tau * vertex.nearest2;
            const Domain<D> ball = ball_of(cell.vertex[i]);
            if (ball.contains(cell.centre)) {
                if (distance2<D>(store.dim, cell.centre, vertex.x) > bad2) return violation;
                continue;
            }
            for (int j = 0; j <= store.dim; ++j) {
                const Cell<D>& behind = store.cell(cell.neighbour[j].cell());
                if (j == i || !(behind.radius2 < infinity)) continue;
                double z[2][DimensionOf<D>::most];
                const int crossings = sphere_crossings(ball, cell.centre, behind.centre, z);
                for (int k = 0; k < crossings; ++k)
                    if (distance2<D>(store.dim, z[k], vertex.x) > bad2) return violation;
            }
        }
    }
    for (VertexId v(0); v < store.state.vertex_count; ++v) {
        const Vertex<D>& vertex = store.vertex(v);
        if (!is_in_mesh(store, v) || vertex.marker == Marker::exempt) continue;
        const double bad2 = 0.25 * tau * tau * vertex.nearest2;
        double reach2 = bad2;
        if (raise_to_poles(store, ball_of(v), v, &reach2) && reach2 > bad2) return violation;
    }
    return nullptr;
}

// The same for refinement by the certificate: hi <= ratio2 lo on the whole cell of each vertex that is not exempt, lo
// and hi as in certificate_rule.hpp, cut at `cut`. O(vertices * cells).
template <int D> const char* ratio_violation(const Store<D>& store, double ratio2, double cut) {
    if (store.state.vertex_count > validated_vertices_max) return nullptr;
    for (VertexId v(0); v < store.state.vertex_count; ++v) {
        const Vertex<D>& vertex = store.vertex(v);
        if (!is_in_mesh(store, v) || vertex.marker == Marker::exempt) continue;
        const double* const input = vertex.marker == Marker::input ? vertex.x : store.point(vertex.origin);
        double far2 = 0, reach2 = 0;
        for (CellId c(0); c < store.state.cell_slots; ++c) {
            const Cell<D>& cell = store.cell(c);
            bool has = false;
            for (const VertexId w : cell.vertex) has |= w == v;
            if (!has || !store.is_live(c) || !(cell.radius2 < infinity)) continue;
            const double here2 = distance2<D>(store.dim, cell.centre, vertex.x),
                         there2 = distance2<D>(store.dim, cell.centre, input);
            if (here2 > far2) far2 = here2;
            if (there2 > reach2) reach2 = there2;
        }
        const double reach = square_root(reach2), hi = reach < cut ? reach : cut, d = square_root(vertex.nearest2);
        const double near = d - square_root(far2);
        const double lo = vertex.marker == Marker::steiner && near > 0.5 * d ? near : 0.5 * d;
        if (hi > ratio2 * lo) return "a cell spoils the certificate and nobody has noticed";
    }
    return nullptr;
}

}  // namespace netmesh
#endif
