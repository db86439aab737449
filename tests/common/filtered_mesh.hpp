// A mesh that is filtered, with its dimension; passed for an AnyMesh.
#pragma once
#include "filtration/any_mesh.hpp"

template <int D> struct FilteredMesh {
    netmesh::Store<D>& store;
    netmesh::Domain<D> domain;
    std::uint32_t inputs;
    bool is_clipped = false;
    const netmesh::Subcomplex<D>* part = nullptr;  // null: all of the mesh

    std::uint32_t vertices() const { return store.state.vertex_count; }
    double cut() const { return domain.enclosing_radius * netmesh::up; }
    bool has(netmesh::VertexId v) const { return part == nullptr || part->vertex[v] != netmesh::VertexPart::absent; }
    operator netmesh::AnyMesh() const {
        netmesh::AnyMesh mesh(store, domain, inputs, is_clipped);
        if (part == nullptr) return mesh;
        mesh.part = part->template of_dimension<netmesh::any_dimension>(D);
        mesh.present = mesh.part.vertex;
        return mesh;
    }
};
