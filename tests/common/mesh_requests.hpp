// Requests for meshes by the inner layers.
#pragma once
#include "mesh/mesh_request.hpp"

inline netmesh::MeshRequest by_quality(double tau, double domain_factor = 1, bool certify_filter = false,
                                       std::uint64_t seed = 1) {
    netmesh::MeshRequest request;
    request.tau = tau;
    request.domain_factor = domain_factor;
    request.certify_filter = certify_filter;
    request.seed = seed;
    return request;
}
inline netmesh::MeshRequest by_reference(double tau) {
    netmesh::MeshRequest request = by_quality(tau);
    request.method = netmesh::MeshMethod::reference;
    return request;
}
inline netmesh::MeshRequest by_hierarchy(double tau, bool finish = false, std::uint64_t seed = 1) {
    netmesh::MeshRequest request = by_quality(tau, 1, false, seed);
    request.method = netmesh::MeshMethod::hierarchy;
    request.finish = finish;
    return request;
}
inline netmesh::MeshRequest by_certificate(const netmesh::RatioGoal& goal) {
    netmesh::MeshRequest request;
    request.method = netmesh::MeshMethod::certificate;
    request.goal = goal;
    request.seed = 1;
    return request;
}
inline netmesh::MeshRequest audited(netmesh::MeshRequest request, bool location, bool quality) {
    request.audit_location = location;
    request.audit_quality = quality;
    return request;
}
