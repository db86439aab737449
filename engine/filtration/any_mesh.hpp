// A mesh that is filtered, where the dimension is a number at run time.
#pragma once
#include "filtration/filter.hpp"
#include "mesh/any_domain.hpp"

namespace netmesh {

struct AnyMesh {
    AnyStore store;
    AnyDomain domain;
    double cut;
    std::uint32_t inputs;
    const std::uint8_t* present;  // [vertices], null: all are

    template <int D>
    AnyMesh(const FilteredMesh<D>& mesh)
        : store(mesh.store), domain(mesh.domain), cut(mesh.cut()), inputs(mesh.inputs),
          present(mesh.part == nullptr ? nullptr : mesh.part->vertex) {}
    bool has(VertexId v) const { return present == nullptr || present[v] != VertexPart::absent; }
    std::uint32_t vertices() const { return store.state.vertex_count; }
};

}  // namespace netmesh
