// A mesh made by the inner layers, and the block that it lives in.
#pragma once
#include "common/block.hpp"
#include "common/inputs.hpp"
#include "common/mesh_points.hpp"
#include "common/mesh_requests.hpp"

template <int D> struct Meshed {
    explicit Meshed(std::size_t bytes = std::size_t{1} << 26) : block(bytes), store(block.arena, state) {}
    Meshed(const inputs::Points& points, const netmesh::MeshRequest& request, std::size_t bytes = std::size_t{1} << 26)
        : Meshed(bytes) {
        mesh(points, request);
    }
    netmesh::Status mesh(const inputs::Points& points, const netmesh::MeshRequest& request) {
        return status = netmesh::mesh_points<D>(store, points.data(), points.size() / D, request,
                                                {block.arena, monitor}, &result);
    }
    std::uint32_t inputs() const { return static_cast<std::uint32_t>(result.input.rows - result.input.duplicates); }

    Block block;
    netmesh::StoreState state = {};
    netmesh::Store<D> store;
    netmesh::Monitor monitor;
    netmesh::MeshResult<D> result = {};
    netmesh::Status status = netmesh::Status::no_result;
};
