// A context in a block of its own that grows until the job fits, for tests and benchmarks that are not about memory.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

#include "common/calls.hpp"

class Session : public Calls {
public:
    explicit Session(int dim) : Calls(dim) { reserve(std::size_t(1) << 20); }
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
            reserve(std::max(2 * bytes_, static_cast<std::size_t>(detail().bytes_wanted)));
        }
    }

    netmesh_status delaunay(const inputs::Points& points) {
        const netmesh::Request r = delaunay_request(points);
        return until_it_fits(netmesh_plan_mesh(&r), [&] { return netmesh_mesh(context, &r); });
    }
    netmesh_status mesh(const inputs::Points& points, const netmesh_filter* filter = nullptr) {
        const netmesh::Request r = mesh_request(points, filter);
        return until_it_fits(netmesh_plan_mesh(&r), [&] { return netmesh_mesh(context, &r); });
    }
    // The mesh for a filter, then the diagram. mesh_for: where it is another one than the diagram's.
    netmesh_status mesh_and_persist(const inputs::Points& points, const netmesh::Request& diagram,
                                    const netmesh_filter* mesh_for = &netmesh_filter_complete) {
        const netmesh::Request r = mesh_request(points, mesh_for);
        return until_it_fits(netmesh_plan_mesh(&r), [&] {
            netmesh_status status = netmesh_mesh(context, &r);
            if (status == NETMESH_OK) status = persist(diagram);
            if (status == NETMESH_OK && bounds) status = bound_bars();
            if (status != NETMESH_OK || !checks) return status;
            checked = check();
            return checked == NETMESH_OUT_OF_MEMORY ? checked : NETMESH_OK;
        });
    }
    netmesh_status mesh_and_persist(const inputs::Points& points,
                                    const netmesh_filter* filter = &netmesh_filter_complete) {
        return mesh_and_persist(points, persist_by(filter));
    }
    // With the triangulation kept.
    netmesh_status alpha(const inputs::Points& points) {
        netmesh::Request r = alpha_request(points);
        r.keep_mesh = 1;
        return persist_until_it_fits(r);
    }
    // Any request of points, distances or simplices.
    netmesh_status persist_until_it_fits(const netmesh::Request& r) {
        return until_it_fits(netmesh_plan(&r), [&] { return persist(r); });
    }

    bool bounds = false;                         // mesh_and_persist goes on to bounds
    bool checks = false;                         // and to netmesh_check, which may want a larger block than the diagram
    netmesh_status checked = NETMESH_NO_RESULT;  // what that check said

private:
    void* block_ = nullptr;
    std::size_t bytes_ = 0;
};
