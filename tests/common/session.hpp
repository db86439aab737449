// A context in a block of its own that grows until the job fits, for tests and benchmarks that are not about memory.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <vector>

#include "common/inputs.hpp"
#include "netmesh.h"

class Session {
public:
    explicit Session(int dim) {
        netmesh_options_init(&options, static_cast<std::uint32_t>(dim));
        reserve(std::size_t(1) << 20);
    }
    ~Session() { std::free(block_); }
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // A fresh context in a block of `bytes`. Untouched pages of a large block cost nothing.
    void reserve(std::size_t bytes) {
        std::free(block_);
        bytes_ = (bytes + 15) / 16 * 16;
        block_ = std::aligned_alloc(16, bytes_);
        if (block_ == nullptr || netmesh_init(block_, bytes_, &context) != NETMESH_OK) throw std::bad_alloc();
    }
    template <class Job> netmesh_status until_it_fits(std::size_t planned, Job job) {
        if (planned > bytes_) reserve(planned);
        for (;;) {
            const netmesh_status status = job();
            if (status != NETMESH_OUT_OF_MEMORY || bytes_ >= std::size_t(1) << 35) return status;
            reserve(std::max(2 * bytes_, static_cast<std::size_t>(netmesh_get_detail(context).bytes_wanted)));
        }
    }

    netmesh_status delaunay(const inputs::Points& points) {
        const std::size_t n = points.size() / options.dim;
        return until_it_fits(netmesh_plan_bytes(NETMESH_JOB_DELAUNAY, &options, n),
                             [&] { return netmesh_delaunay(context, points.data(), n, &options); });
    }
    netmesh_status mesh(const inputs::Points& points, netmesh_job job = NETMESH_JOB_MESH) {
        const std::size_t n = points.size() / options.dim;
        return until_it_fits(netmesh_plan_bytes(job, &options, n),
                             [&] { return netmesh_mesh(context, points.data(), n, job, &options); });
    }
    netmesh_status mesh_and_persist(const inputs::Points& points, netmesh_filter filter = NETMESH_FILTER_COMPLETE,
                                    netmesh_values values = NETMESH_VALUES_CERTIFIED) {
        const std::size_t n = points.size() / options.dim;
        return until_it_fits(netmesh_plan_bytes(NETMESH_JOB_PERSIST, &options, n), [&] {
            const netmesh_status status = netmesh_mesh(context, points.data(), n, NETMESH_JOB_PERSIST, &options);
            if (status != NETMESH_OK) return status;
            const netmesh_status found = netmesh_persist(context, filter, values, NETMESH_DIM_MAX, 0, &options);
            return found == NETMESH_OK && bounds ? netmesh_bound_bars(context, &options) : found;
        });
    }
    netmesh_status alpha(const inputs::Points& points) {
        const std::size_t n = points.size() / options.dim;
        return until_it_fits(netmesh_plan_bytes(NETMESH_JOB_PERSIST_ALPHA, &options, n), [&] {
            const netmesh_status status = netmesh_delaunay(context, points.data(), n, &options);
            return status != NETMESH_OK ? status
                                        : netmesh_persist(context, NETMESH_FILTER_ALPHA, NETMESH_VALUES_CERTIFIED,
                                                          NETMESH_DIM_MAX, 0, &options);
        });
    }
    netmesh_status points(netmesh_filter filter, std::uint32_t k, std::uint32_t max_degree,
                          const inputs::Points& points, bool representatives = false) {
        const std::size_t n = points.size() / options.dim;
        return until_it_fits(netmesh_points_bytes(filter, &options, n, k, max_degree), [&] {
            return netmesh_persist_points(context, points.data(), n, filter, NETMESH_VALUES_CERTIFIED, k, max_degree, 0,
                                          representatives ? 1 : 0, &options);
        });
    }
    netmesh_status check() { return netmesh_check(context, NETMESH_CHECK_ALL, &options); }

    netmesh_report report() const {
        netmesh_report r = {};
        r.struct_bytes = sizeof r;
        netmesh_get_report(context, &r);
        return r;
    }
    std::vector<netmesh_pair> pairs() const {
        std::vector<netmesh_pair> all;
        netmesh_pair pair;
        for (std::uint64_t i = 0; netmesh_get_pair(context, i, &pair) == NETMESH_OK; ++i) all.push_back(pair);
        return all;
    }
    // Every cell as its sorted vertices, the list sorted: equal for equal triangulations.
    template <std::size_t K> std::vector<std::array<std::uint32_t, K>> cells() const {
        std::vector<std::array<std::uint32_t, K>> all;
        netmesh_cell cell;
        for (std::uint64_t i = 0; netmesh_get_cell(context, i, &cell) == NETMESH_OK; ++i) {
            std::array<std::uint32_t, K> a;
            std::copy(cell.vertices, cell.vertices + K, a.begin());
            std::sort(a.begin(), a.end());
            all.push_back(a);
        }
        std::sort(all.begin(), all.end());
        return all;
    }

    netmesh_context* context = nullptr;
    netmesh_options options;
    bool bounds = false;  // mesh_and_persist goes on to netmesh_bound_bars

private:
    void* block_ = nullptr;
    std::size_t bytes_ = 0;
};
