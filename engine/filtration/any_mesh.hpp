// A mesh that is filtered.
#pragma once
#include "filtration/filter.hpp"
#include "mesh/any_domain.hpp"

namespace netmesh {

// A complete, compact mesh without cages; its inputs are vertices 0..inputs-1.
struct AnyMesh {
    AnyStore store;
    AnyDomain domain;
    double cut;  // rho of the certificates: a radius of a ball that contains the inputs, rounded up
    std::uint32_t inputs;
    bool is_clipped;  // refined for cells clipped to the domain's ball
    // Not null: cells are clipped to the ball of `domain`, and what is filtered is the nerve of the clipped cells.
    const std::uint8_t* present = nullptr;  // [vertices], that of `part`
    AnyPart part = {};

    AnyMesh(const AnyStore& store, const AnyDomain& domain, std::uint32_t inputs, bool is_clipped)
        : store(store), domain(domain), cut(domain.enclosing_radius * up), inputs(inputs), is_clipped(is_clipped) {}
    // Is the cell of v, or what the ball leaves of it, there?
    bool has(VertexId v) const { return present == nullptr || present[v] != VertexPart::absent; }
    std::uint32_t vertices() const { return store.state.vertex_count; }
    // Null: all of the mesh.
    const AnyPart* filtered_part() const { return present == nullptr ? nullptr : &part; }
};

}  // namespace netmesh
