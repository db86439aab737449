// A mesh that a context holds, as arrays that another one can load.
#pragma once
#include <cstdint>
#include <vector>

#include "common/calls.hpp"

struct Arrays {
    explicit Arrays(std::uint32_t d) : dim(d) {}
    explicit Arrays(const Calls& c) : dim(c.dim()), cages(read_all(c.context, netmesh_get_cage)) {
        for (const netmesh_vertex& v : read_all(c.context, netmesh_get_vertex)) {
            vertices.insert(vertices.end(), v.coordinates, v.coordinates + dim);
            markers.push_back(static_cast<std::uint8_t>(v.marker));
        }
        for (const netmesh_cell& cell : read_all(c.context, netmesh_get_cell))
            cells.insert(cells.end(), cell.vertices, cell.vertices + dim + 1);
        const netmesh_report r = c.report();
        domain.assign(r.mesh.domain, r.mesh.domain + dim + 1);
    }
    // Points to the arrays here and to what is asked of the mesh, whose monitor watches.
    netmesh_load_request load_request(const netmesh_request& promised) const {
        auto r = netmesh::sized<netmesh_load_request>();
        r.dim = dim;
        r.monitor = promised.monitor;
        r.vertices = vertices.data();
        r.markers = markers.data();
        r.vertex_count = markers.size();
        r.cells = cells.data();
        r.cell_count = cells.size() / (dim + 1);
        r.domain = domain.empty() ? nullptr : domain.data();
        r.promised = &promised;
        return r;
    }
    netmesh_status load(Calls& c) const {
        const netmesh::Request promised = c.promises();
        const netmesh_load_request r = load_request(promised);
        return netmesh_load(c.context, &r);
    }
    netmesh_status load_cages(Calls& c) const {
        auto r = netmesh::sized<netmesh_cages_request>();
        r.monitor = c.request.monitor;
        r.cages = cages.data();
        r.cage_count = cages.size();
        return netmesh_load_cages(c.context, &r);
    }

    std::uint32_t dim;
    std::vector<double> vertices, domain;
    std::vector<std::uint8_t> markers;
    std::vector<std::uint32_t> cells;
    std::vector<netmesh_cage> cages;
};
