// Two requests on one block, timed in pairs, one of each after the other. Of each the least time counts.
#pragma once
#include <netmesh.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace pairs {

inline double uniform(std::uint64_t* state) {
    std::uint64_t z = (*state += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

constexpr std::size_t block_bytes = std::size_t(1) << 30;

struct Timed {
    double least = 1e9;
    netmesh_report report = {};
    double peak() const { return static_cast<double>(report.memory.peak_bytes); }

    void run(void* block, const netmesh_request& request, bool is_mesh) {
        netmesh_context* context;
        if (netmesh_init(block, block_bytes, &context) != NETMESH_OK) std::abort();
        const auto start = std::chrono::steady_clock::now();
        const netmesh_status status = is_mesh ? netmesh_mesh(context, &request) : netmesh_persist(context, &request);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        if (status != NETMESH_OK) std::printf("status %d\n", status);
        report.struct_bytes = sizeof report;
        netmesh_get_report(context, &report);
        least = taken.count() < least ? taken.count() : least;
    }
};

struct Pair {
    Timed without, with;
    double ratio() const { return with.least / without.least; }
};

inline Pair run(void* block, const netmesh_request& without, const netmesh_request& with, int runs,
                bool is_mesh = false) {
    Pair pair;
    for (int i = 0; i < runs; ++i) {
        pair.without.run(block, without, is_mesh);
        pair.with.run(block, with, is_mesh);
    }
    return pair;
}

struct Job {
    std::uint32_t dim;
    std::size_t points;
};

}  // namespace pairs
