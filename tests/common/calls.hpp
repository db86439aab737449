// The calls on a context, whose block belongs to somebody else, with one dimension, seed and monitor for all of them.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
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

class Calls {
public:
    explicit Calls(int dim, netmesh_context* of = nullptr) : context(of), request(static_cast<std::uint32_t>(dim)) {}

    netmesh_status delaunay_in_block(const inputs::Points& points) {
        const netmesh_delaunay_request r = delaunay_request(points);
        return netmesh_delaunay(context, &r);
    }
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
    netmesh_status bound_bars(const netmesh_function& function) {
        netmesh::requests::Bounds r;
        r.monitor = request.monitor;
        r.function = &function;
        return netmesh_bound_bars(context, &r);
    }
    netmesh_status persist(netmesh_function function, netmesh_persist_request r) {
        r.filter = NETMESH_FILTER_FUNCTION;
        r.function = &function;
        return persist(r);
    }
    netmesh_status vineyard(netmesh_vineyard_request r) {
        r.monitor = request.monitor;
        return netmesh_vineyard(context, &r);
    }
    netmesh_status vineyard(netmesh_filter filter, std::uint32_t k_first, std::uint32_t k_last) {
        netmesh::requests::Vineyard r(filter);
        r.k_first = k_first;
        r.k_last = k_last;
        return vineyard(r);
    }
    netmesh_status fit(const inputs::Points& points, bool bounds = false) {
        netmesh_fit_request r = fit_request(points);
        r.bounds = bounds ? 1 : 0;
        return netmesh_fit(context, &r);
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

    // Requests of all jobs.
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
    netmesh_alpha_request alpha_request(inputs::Points&&) const = delete;  // requests point into their points
    netmesh_alpha_request alpha_request(const inputs::Points& points) const {
        netmesh_alpha_request r = on(points, watched(netmesh::requests::Alpha(request.dim)));
        r.seed = request.seed;
        return r;
    }
    netmesh_auto_request auto_request(inputs::Points&&) const = delete;
    netmesh_auto_request auto_request(const inputs::Points& points) const {
        netmesh_auto_request r = on(points, watched(netmesh::requests::Auto(request.dim)));
        r.seed = request.seed;
        return r;
    }
    netmesh_points_request points_request(inputs::Points&&, netmesh_filter, std::uint32_t = 1,
                                          std::uint32_t = 1) const = delete;
    netmesh_points_request points_request(const inputs::Points& points, netmesh_filter filter, std::uint32_t k = 1,
                                          std::uint32_t max_degree = 1) const {
        netmesh_points_request r = on(points, watched(netmesh::requests::Points(request.dim, filter)));
        r.k = k;
        r.max_degree = max_degree;
        return r;
    }
    netmesh_points_vineyard_request nested_request(const inputs::Points& points, netmesh_filter filter,
                                                   std::uint32_t k_last, std::uint32_t max_degree = 1) const {
        netmesh_points_vineyard_request r = on(points, watched(netmesh::requests::PointsVineyard(request.dim, filter)));
        r.k_last = k_last;
        r.max_degree = max_degree;
        return r;
    }
    netmesh_scales_request scales_request(const inputs::Points& points) const {
        netmesh_scales_request r = on(points, watched(netmesh::requests::Scales(request.dim)));
        r.seed = request.seed;
        r.tau = request.tau;
        return r;
    }
    netmesh_fit_request fit_request(const inputs::Points& points) const {
        netmesh_fit_request r = on(points, watched(netmesh::requests::Fit(request.dim)));
        r.seed = request.seed;
        r.ratio = request.certificate.ratio;
        r.focus_from = request.certificate.focus_from;
        r.focus_to = request.certificate.focus_to;
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

    netmesh_context* context;
    netmesh::requests::Mesh request;  // what meshes have to promise; seed and monitor of every call

private:
    template <class Request> Request watched(Request r) const {
        r.monitor = request.monitor;
        return r;
    }
};
