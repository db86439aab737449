// What may be asked of a mesh with cages.
#pragma once
#include <doctest/doctest.h>

#include <string>

#include "common/meshed.hpp"
#include "delaunay/check.hpp"
#include "mesh/check/hierarchy_quality.hpp"

// What a checker has found, as a text that a failing CHECK prints; "": nothing.
inline std::string found(const netmesh::CheckResult& r) { return r.violation == nullptr ? "" : r.violation; }

// What the store violates as a Delaunay triangulation.
template <int D> std::string delaunay_violation(const netmesh::Store<D>& store) {
    netmesh::CheckResult r = netmesh::check_combinatorial(store);
    if (r.violation == nullptr) r = netmesh::check_geometric(store);
    if (r.violation == nullptr) r = netmesh::check_delaunay(store);
    return found(r);
}

template <int D> struct Hierarchical : Meshed<D> {
    Hierarchical(const inputs::Points& points, const netmesh::MeshRequest& request,
                 std::size_t bytes = std::size_t{1} << 24)
        : Meshed<D>(points, request, bytes) {}
    netmesh::HierarchyQuality quality() {
        netmesh::HierarchyQuality q;
        REQUIRE(netmesh::measure_hierarchy(this->store,
                                           {this->result.cages, this->result.hierarchy.cages, this->result.domain},
                                           this->block.arena, &q) == netmesh::Status::ok);
        return q;
    }
    double vertices_per_input() const { return double(this->state.vertex_count) / double(this->result.input.rows); }
};
