// A mesh that a session holds, as arrays that another one can load.
#pragma once
#include <cstdint>
#include <vector>

#include "common/session.hpp"

struct Arrays {
    explicit Arrays(const Session& s) {
        const netmesh_report r = s.report();
        dim = r.dim;
        netmesh_vertex v;
        for (std::uint64_t i = 0; netmesh_get_vertex(s.context, i, &v) == NETMESH_OK; ++i) {
            vertices.insert(vertices.end(), v.coordinates, v.coordinates + dim);
            markers.push_back(static_cast<std::uint8_t>(v.marker));
        }
        netmesh_cell c;
        for (std::uint64_t i = 0; netmesh_get_cell(s.context, i, &c) == NETMESH_OK; ++i)
            cells.insert(cells.end(), c.vertices, c.vertices + dim + 1);
        domain.assign(r.domain, r.domain + dim + 1);
        netmesh_cage cage;
        for (std::uint64_t i = 0; netmesh_get_cage(s.context, i, &cage) == NETMESH_OK; ++i) cages.push_back(cage);
    }
    netmesh_status load(Session& s) const {
        return netmesh_load(s.context, vertices.data(), markers.data(), markers.size(), cells.data(),
                            cells.size() / (dim + 1), domain.empty() ? nullptr : domain.data(), &s.options);
    }
    std::uint32_t dim;
    std::vector<double> vertices, domain;
    std::vector<std::uint8_t> markers;
    std::vector<std::uint32_t> cells;
    std::vector<netmesh_cage> cages;
};
