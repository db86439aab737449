// Wasserstein distances of diagrams, in scratch memory of exactly the size that is asked for.
#pragma once
#include "common/bottleneck.hpp"

inline netmesh_wasserstein_request wasserstein_request(const std::vector<netmesh_pair>& a,
                                                       const std::vector<netmesh_pair>& b, std::uint32_t order,
                                                       double relative_error,
                                                       std::uint32_t degree = NETMESH_ALL_DEGREES) {
    netmesh::Wasserstein request;
    request.pairs_a = a.data();
    request.pairs_b = b.data();
    request.count_a = a.size();
    request.count_b = b.size();
    request.order = order;
    request.relative_error = relative_error;
    request.degree = degree;
    return request;
}

struct Transport {
    netmesh_status status;
    double lower, value;
    int exponent;
};

inline Transport wasserstein(netmesh_wasserstein_request request) {
    const Scratch scratch(netmesh_wasserstein_bytes(&request));
    scratch.lend(&request);
    auto distance = netmesh::sized<netmesh_wasserstein_distance>();
    const netmesh_status status = netmesh_wasserstein(&request, &distance, nullptr);
    return {status, distance.lower, distance.value, distance.exponent};
}
