// A hierarchical mesh and what it lives in, and what may be asked of it.
#pragma once
#include <doctest/doctest.h>

#include "common/block.hpp"
#include "common/inputs.hpp"
#include "delaunay/check.hpp"
#include "mesh/hierarchy_quality.hpp"
#include "mesh/netmesh.hpp"

// What the store violates as a Delaunay triangulation; null: nothing.
template <int D> const char* delaunay_violation(const netmesh::Store<D>& store) {
    netmesh::CheckResult r = netmesh::check_combinatorial<D>(store);
    if (r.violation == nullptr) r = netmesh::check_geometric<D>(store);
    if (r.violation == nullptr) r = netmesh::check_delaunay<D>(store);
    return r.violation;
}

template <int D> struct Hierarchical {
    Hierarchical(const inputs::Points& points, const netmesh::HierarchyOptions& options,
                 std::size_t bytes = std::size_t{1} << 24)
        : block(bytes), store(block.arena, state) {
        status = netmesh::netmesh<D>(store, points.data(), points.size() / D, options, monitor, &input, &domain, &cages,
                                     &report);
    }
    netmesh::HierarchyQuality quality() {
        netmesh::HierarchyQuality q;
        REQUIRE(netmesh::measure_hierarchy<D>(store, cages, report.cages, domain, block.arena, &q) ==
                netmesh::Status::ok);
        return q;
    }
    double vertices_per_input() const { return double(state.vertex_count) / double(input.rows); }

    Block block;
    netmesh::StoreState state = {};
    netmesh::Store<D> store;
    netmesh::Monitor monitor;
    netmesh::InputReport input;
    netmesh::Domain<D> domain = {};
    netmesh::Cage* cages;
    netmesh::HierarchyReport report;
    netmesh::Status status;
};
