// A mesh that is filtered, where the dimension is a number at run time.
#pragma once
#include "delaunay/any_store.hpp"
#include "filtration/filter.hpp"

namespace netmesh {

struct AnyMesh {
    AnyStore store;
    double cut;
    std::uint32_t inputs;
    const std::uint8_t* present;  // [vertices], null: all are

    template <int D>
    explicit AnyMesh(const FilteredMesh<D>& mesh)
        : store(mesh.store), cut(mesh.cut()), inputs(mesh.inputs),
          present(mesh.part == nullptr ? nullptr : mesh.part->vertex) {}
    bool has(VertexId v) const { return present == nullptr || present[v] != VertexPart::absent; }
    std::uint32_t vertices() const { return store.state.vertex_count; }
};

inline VertexId nearest_input(const AnyStore& store, VertexId v) {
    const AnyVertex vertex = store.vertex(v);
    return vertex.marker == Marker::input ? v : VertexId(vertex.origin);
}
inline double distance_to_inputs(const AnyStore& store, VertexId v) {
    return distance(store.dim, store.point(v), store.point(nearest_input(store, v)));
}

}  // namespace netmesh
