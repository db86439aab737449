// Bottleneck distances of diagrams, in scratch memory of exactly the size that is asked for.
#pragma once
#include <cstdint>
#include <cstdlib>
#include <new>
#include <vector>

#include "common/read.hpp"

inline netmesh_bottleneck_request bottleneck_request(const std::vector<netmesh_pair>& a,
                                                     const std::vector<netmesh_pair>& b,
                                                     netmesh_scale scale = NETMESH_SCALE_PLAIN,
                                                     std::uint32_t degree = NETMESH_ALL_DEGREES) {
    netmesh::Bottleneck request;
    request.pairs_a = a.data();
    request.pairs_b = b.data();
    request.count_a = a.size();
    request.count_b = b.size();
    request.scale = scale;
    request.degree = degree;
    return request;
}

// 16-byte aligned.
class Scratch {
public:
    explicit Scratch(const netmesh_bottleneck_request& request) : Scratch(netmesh_bottleneck_bytes(&request)) {}
    explicit Scratch(std::size_t bytes) : bytes_(bytes) {
        if (posix_memalign(&memory_, 16, bytes_) != 0) throw std::bad_alloc();
    }
    ~Scratch() { std::free(memory_); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    template <class Request> void lend(Request* request) const {
        request->scratch = memory_;
        request->scratch_bytes = bytes_;
    }

private:
    std::size_t bytes_;
    void* memory_ = nullptr;
};

struct Distance {
    netmesh_status status;
    double value;
    int exponent;
};

inline Distance bottleneck(const std::vector<netmesh_pair>& a, const std::vector<netmesh_pair>& b,
                           netmesh_scale scale = NETMESH_SCALE_PLAIN, std::uint32_t degree = NETMESH_ALL_DEGREES) {
    netmesh_bottleneck_request request = bottleneck_request(a, b, scale, degree);
    const Scratch scratch(request);
    scratch.lend(&request);
    auto distance = netmesh::sized<netmesh_distance>();
    const netmesh_status status = netmesh_bottleneck(&request, &distance, nullptr);
    return {status, distance.value, distance.exponent};
}
