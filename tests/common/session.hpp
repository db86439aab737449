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
#include "common/read.hpp"

template <class Request> Request on(const inputs::Points& points, Request request) {
    request.points = points.data();
    request.point_count = points.size() / request.dim;
    return request;
}

inline netmesh_persist_request persist_by(netmesh_filter filter, std::uint32_t k = 0,
                                          netmesh_values values = NETMESH_VALUES_CERTIFIED) {
    netmesh::requests::Persist request(filter);
    request.k = k;
    request.values = values;
    return request;
}

class Session {
public:
    explicit Session(int dim) : request(static_cast<std::uint32_t>(dim)) { reserve(std::size_t(1) << 20); }
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
            return status == NETMESH_OK && bounds ? bound_bars() : status;
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
    netmesh_status homology(const netmesh_homology_request& r) {
        return until_it_fits(netmesh_plan_homology(&r), [&] { return netmesh_homology(context, &r); });
    }
    netmesh_status scales(const netmesh_scales_request& r) {
        return until_it_fits(netmesh_plan_scales(&r), [&] { return netmesh_persist_scales(context, &r); });
    }

    // Calls in the block as it is, watched by the session's monitor.
    netmesh_status mesh_in_block(const inputs::Points& points, netmesh_purpose purpose = NETMESH_PURPOSE_MESH) {
        const netmesh_mesh_request r = mesh_request(points, purpose);
        return netmesh_mesh(context, &r);
    }
    netmesh_status persist(netmesh_persist_request r) {
        r.monitor = request.monitor;
        return netmesh_persist(context, &r);
    }
    netmesh_status persist(netmesh_filter filter = NETMESH_FILTER_COMPLETE) { return persist(persist_by(filter)); }
    netmesh_status represent() {
        netmesh::requests::Represent r;
        r.monitor = request.monitor;
        return netmesh_represent(context, &r);
    }
    netmesh_status bound_bars() {
        netmesh::requests::Bounds r;
        r.monitor = request.monitor;
        return netmesh_bound_bars(context, &r);
    }
    netmesh_status vineyard(netmesh_filter filter, std::uint32_t k_first, std::uint32_t k_last) {
        netmesh::requests::Vineyard r(filter);
        r.monitor = request.monitor;
        r.k_first = k_first;
        r.k_last = k_last;
        return netmesh_vineyard(context, &r);
    }
    netmesh_status check(std::uint32_t what = NETMESH_CHECK_ALL) {
        netmesh::requests::Check r;
        r.what = what;
        r.monitor = request.monitor;
        r.mesh = &request;
        return netmesh_check(context, &r);
    }
    netmesh_status analyse(netmesh_analysis* analysis, std::uint32_t what = NETMESH_ANALYSE_ALL, double tolerance = 0) {
        netmesh::requests::Analyse r;
        r.what = what;
        r.tolerance = tolerance;
        r.monitor = request.monitor;
        r.mesh = &request;
        *analysis = netmesh::sized<netmesh_analysis>();
        return netmesh_analyse(context, &r, analysis);
    }

    // Requests with the session's dimension, seed and monitor.
    netmesh_delaunay_request delaunay_request(const inputs::Points& points,
                                              netmesh_purpose purpose = NETMESH_PURPOSE_MESH) const {
        netmesh_delaunay_request r = on(points, watched(netmesh::requests::Delaunay(request.dim)));
        r.seed = request.seed;
        r.purpose = purpose;
        return r;
    }
    netmesh_mesh_request mesh_request(const inputs::Points& points,
                                      netmesh_purpose purpose = NETMESH_PURPOSE_MESH) const {
        netmesh_mesh_request r = on(points, request);
        r.purpose = purpose;
        return r;
    }
    netmesh_points_request points_request(const inputs::Points& points, netmesh_filter filter, std::uint32_t k = 1,
                                          std::uint32_t max_degree = 1) const {
        netmesh_points_request r = on(points, watched(netmesh::requests::Points(request.dim, filter)));
        r.k = k;
        r.max_degree = max_degree;
        return r;
    }
    netmesh_scales_request scales_request(const inputs::Points& points) const {
        netmesh_scales_request r = on(points, watched(netmesh::requests::Scales(request.dim)));
        r.seed = request.seed;
        r.tau = request.tau;
        return r;
    }

    netmesh_report report() const { return report_of(context); }
    netmesh_detail detail() const { return detail_of(context); }
    std::vector<netmesh_pair> pairs() const { return read_all(context, netmesh_get_pair); }
    std::vector<netmesh_vertex> vertices() const { return read_all(context, netmesh_get_vertex); }
    // Every cell as its sorted vertices, the list sorted: equal for equal triangulations.
    template <std::size_t K> std::vector<std::array<std::uint32_t, K>> cells() const {
        std::vector<std::array<std::uint32_t, K>> all;
        for (const netmesh_cell& cell : read_all(context, netmesh_get_cell)) {
            std::array<std::uint32_t, K> a;
            std::copy(cell.vertices, cell.vertices + K, a.begin());
            std::sort(a.begin(), a.end());
            all.push_back(a);
        }
        std::sort(all.begin(), all.end());
        return all;
    }

    netmesh_context* context = nullptr;
    netmesh::requests::Mesh request;  // what meshes have to promise; seed and monitor of every call
    bool bounds = false;              // mesh_and_persist goes on to netmesh_bound_bars

private:
    template <class Request> Request watched(Request r) const {
        r.monitor = request.monitor;
        return r;
    }

    void* block_ = nullptr;
    std::size_t bytes_ = 0;
};
