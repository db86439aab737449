// A mesh that a session holds, as arrays that another one can load.
#pragma once
#include <cstdint>
#include <vector>

#include "common/session.hpp"

struct Arrays {
    explicit Arrays(std::uint32_t d) : dim(d) {}
    explicit Arrays(const Session& s) : dim(s.request.dim), cages(read_all(s.context, netmesh_get_cage)) {
        for (const netmesh_vertex& v : read_all(s.context, netmesh_get_vertex)) {
            vertices.insert(vertices.end(), v.coordinates, v.coordinates + dim);
            markers.push_back(static_cast<std::uint8_t>(v.marker));
        }
        for (const netmesh_cell& c : read_all(s.context, netmesh_get_cell))
            cells.insert(cells.end(), c.vertices, c.vertices + dim + 1);
        const netmesh_report r = s.report();
        domain.assign(r.mesh.domain, r.mesh.domain + dim + 1);
    }
    // Points to the arrays here and to what the session asks of meshes.
    netmesh_load_request load_request(const Session& s) const {
        netmesh::requests::Load r(dim);
        r.monitor = s.request.monitor;
        r.vertices = vertices.data();
        r.markers = markers.data();
        r.vertex_count = markers.size();
        r.cells = cells.data();
        r.cell_count = cells.size() / (dim + 1);
        r.domain = domain.empty() ? nullptr : domain.data();
        r.mesh = &s.request;
        return r;
    }
    netmesh_status load(Session& s) const {
        const netmesh_load_request r = load_request(s);
        return netmesh_load(s.context, &r);
    }
    netmesh_status load_cages(Session& s) const {
        netmesh::requests::Cages r;
        r.monitor = s.request.monitor;
        r.cages = cages.data();
        r.cage_count = cages.size();
        return netmesh_load_cages(s.context, &r);
    }

    std::uint32_t dim;
    std::vector<double> vertices, domain;
    std::vector<std::uint8_t> markers;
    std::vector<std::uint32_t> cells;
    std::vector<netmesh_cage> cages;
};
