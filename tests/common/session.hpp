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
        const netmesh_delaunay_request r = delaunay_request(points);
        return until_it_fits(netmesh_plan_delaunay(&r), [&] { return netmesh_delaunay(context, &r); });
    }
    netmesh_status mesh(const inputs::Points& points, netmesh_purpose purpose = NETMESH_PURPOSE_MESH) {
        const netmesh_mesh_request r = mesh_request(points, purpose);
        return until_it_fits(netmesh_plan_mesh(&r), [&] { return netmesh_mesh(context, &r); });
    }
    netmesh_status mesh_and_persist(const inputs::Points& points, const netmesh_persist_request& diagram,
                                    netmesh_purpose purpose = NETMESH_PURPOSE_PERSIST) {
        const netmesh_mesh_request r = mesh_request(points, purpose);
        return until_it_fits(netmesh_plan_mesh(&r), [&] {
            netmesh_status status = netmesh_mesh(context, &r);
            if (status == NETMESH_OK) status = persist(diagram);
            if (status == NETMESH_OK && bounds) status = bound_bars();
            if (status != NETMESH_OK || !checks) return status;
            checked = check();
            return checked == NETMESH_OUT_OF_MEMORY ? checked : NETMESH_OK;
        });
    }
    netmesh_status mesh_and_persist(const inputs::Points& points, netmesh_filter filter = NETMESH_FILTER_COMPLETE) {
        return mesh_and_persist(points, persist_by(filter));
    }
    netmesh_status alpha(const inputs::Points& points) {
        const netmesh_delaunay_request r = delaunay_request(points, NETMESH_PURPOSE_PERSIST);
        return until_it_fits(netmesh_plan_delaunay(&r), [&] {
            const netmesh_status status = netmesh_delaunay(context, &r);
            return status == NETMESH_OK ? persist(NETMESH_FILTER_ALPHA) : status;
        });
    }
    // A diagram of the points themselves; see points_request.
    netmesh_status points(const netmesh_points_request& r) {
        return until_it_fits(netmesh_plan_points(&r), [&] { return netmesh_persist_points(context, &r); });
    }
    netmesh_status nested(const netmesh_points_vineyard_request& r) {
        return until_it_fits(netmesh_plan_points_vineyard(&r), [&] { return netmesh_points_vineyard(context, &r); });
    }
    netmesh_status homology(const netmesh_homology_request& r) {
        return until_it_fits(netmesh_plan_homology(&r), [&] { return netmesh_homology(context, &r); });
    }
    netmesh_status scales(const netmesh_scales_request& r) {
        return until_it_fits(netmesh_plan_scales(&r), [&] { return netmesh_persist_scales(context, &r); });
    }

    bool bounds = false;                         // mesh_and_persist goes on to netmesh_bound_bars
    bool checks = false;                         // and to netmesh_check, which may want a larger block than the diagram
    netmesh_status checked = NETMESH_NO_RESULT;  // what that check said

private:
    void* block_ = nullptr;
    std::size_t bytes_ = 0;
};
