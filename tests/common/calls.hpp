// The calls on a context, whose block belongs to somebody else, with one dimension, seed and monitor for all of them.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/inputs.hpp"
#include "common/read.hpp"

// A request of the points, of a dimension that stands in it.
inline netmesh::Request on(inputs::Points&&, netmesh::Request) = delete;  // requests point into their points
inline netmesh::Request on(const inputs::Points& points, netmesh::Request request) {
    request.set_points(request.points.dim, points);
    return request;
}

// The filter of a number, as reports have it.
inline const netmesh_filter* filter_of(netmesh_filter_id id) {
    const netmesh_filter* found = id == NETMESH_FILTER_AUTO   ? &netmesh_filter_auto
                                  : id == NETMESH_FILTER_NONE ? &netmesh_filter_simplices
                                                              : nullptr;
    netmesh::for_each_filter([&](const netmesh_filter_info& info) {
        if (info.id == id) found = info.filter;
    });
    return found;
}

// On what the context holds.
inline netmesh::Request persist_by(const netmesh_filter* filter, std::uint32_t k = 0,
                                   netmesh_values values = NETMESH_VALUES_OPEN) {
    netmesh::Request request(filter);
    request.k = k;
    request.values = values;
    return request;
}

class Calls {
public:
    explicit Calls(int dim, netmesh_context* of = nullptr) : context(of) {
        request.points.dim = static_cast<std::uint32_t>(dim);
    }
    std::uint32_t dim() const { return request.points.dim; }

    // Jobs in the block as it is.
    netmesh_status delaunay_in_block(const inputs::Points& points) {
        const netmesh::Request r = delaunay_request(points);
        return netmesh_mesh(context, &r);
    }
    netmesh_status mesh_in_block(const inputs::Points& points, const netmesh_filter* filter = nullptr) {
        const netmesh::Request r = mesh_request(points, filter);
        return netmesh_mesh(context, &r);
    }
    netmesh_status persist(netmesh::Request r) {
        r.monitor = request.monitor;
        const netmesh_status status = netmesh_persist(context, &r);
        made_ = netmesh::Request(r.filter == &netmesh_filter_auto ? filter_of(report().diagram.filter) : r.filter);
        made_.k = r.k;
        made_.values = r.values;
        made_.max_degree = r.max_degree;
        made_.keep_zero_pairs = r.keep_zero_pairs;
        return status;
    }
    netmesh_status persist(const netmesh_filter* filter = &netmesh_filter_complete) {
        return persist(persist_by(filter));
    }
    netmesh_status persist(const netmesh_function& function, netmesh::Request r) {
        r.filter = &netmesh_filter_function;
        r.function = &function;
        const netmesh_status status = persist(r);
        made_.function = nullptr;  // the caller's may be gone
        return status;
    }
    // More of the diagram that persist has made.
    netmesh_status represent() {
        netmesh::Request r = made_;
        r.cycles = &netmesh_cycles;
        r.monitor = request.monitor;
        return netmesh_persist(context, &r);
    }
    netmesh_status bound_bars() {
        netmesh::Request r = made_;
        r.bounds = &netmesh_bounds;
        r.monitor = request.monitor;
        return netmesh_persist(context, &r);
    }
    netmesh_status bound_bars(const netmesh_function& function) {
        netmesh::Request r = made_;
        r.bounds = &netmesh_bounds;
        r.monitor = request.monitor;
        r.function = &function;
        return netmesh_persist(context, &r);
    }
    netmesh_status vineyard(netmesh::Request r) {
        r.vines = &netmesh_vines;
        r.monitor = request.monitor;
        return netmesh_persist(context, &r);
    }
    netmesh_status vineyard(const netmesh_filter* filter, std::uint32_t k_first, std::uint32_t k_last) {
        netmesh::Request r(filter);
        r.k = k_first;
        r.k_last = k_last;
        return vineyard(r);
    }
    netmesh_status fit(const inputs::Points& points, bool bounds = false) {
        netmesh::Request r = fit_request(points);
        r.bounds = bounds ? &netmesh_bounds : nullptr;
        return persist(r);
    }
    netmesh_status check(std::uint32_t what = NETMESH_CHECK_ALL) {
        auto r = netmesh::sized<netmesh_check_request>();
        r.what = what;
        r.monitor = request.monitor;
        const netmesh::Request promised = promises();
        r.promised = &promised;
        return netmesh_check(context, &r);
    }
    netmesh_status analyse(netmesh_analysis* analysis, std::uint32_t what = NETMESH_ANALYSE_ALL, double tolerance = 0) {
        auto r = netmesh::sized<netmesh_analyse_request>();
        r.what = what;
        r.tolerance = tolerance;
        r.monitor = request.monitor;
        const netmesh::Request promised = promises();
        r.promised = &promised;
        *analysis = netmesh::sized<netmesh_analysis>();
        return netmesh_analyse(context, &r, analysis);
    }

    // Requests of all jobs.
    netmesh::Request plain(const netmesh_filter* filter) const {
        netmesh::Request r(filter);
        r.points.dim = dim();
        r.monitor = request.monitor;
        r.seed = request.seed;
        return r;
    }
    netmesh::Request delaunay_request(const inputs::Points& points) const {
        netmesh::Request r = on(points, plain(nullptr));
        r.mesh.method = &netmesh_method_delaunay;
        return r;
    }
    // As `request` says; by SVR where it names neither method nor ratio. filter: what the mesh is for, null: itself.
    netmesh::Request mesh_request(const inputs::Points& points, const netmesh_filter* filter = nullptr) const {
        netmesh::Request r = on(points, request);
        r.filter = filter;
        const bool by_ratio = r.goal.ratio > 0;
        if (r.mesh.method == nullptr) r.mesh.method = by_ratio ? &netmesh_method_certificate : &netmesh_method_svr;
        return r;
    }
    // What `request` says of a mesh that is there.
    netmesh::Request promises() const {
        netmesh::Request r = request;
        if (r.mesh.method == nullptr && !(r.goal.ratio > 0)) r.mesh.method = &netmesh_method_svr;
        if (r.goal.eps > 0) r.filter = &netmesh_filter_tight;
        return r;
    }
    netmesh::Request alpha_request(const inputs::Points& points) const {
        return on(points, plain(&netmesh_filter_alpha));
    }
    netmesh::Request auto_request(const inputs::Points& points) const {
        return on(points, plain(&netmesh_filter_auto));
    }
    netmesh::Request points_request(const inputs::Points& points, const netmesh_filter* filter, std::uint32_t k = 1,
                                    std::uint32_t max_degree = 1) const {
        netmesh::Request r = on(points, plain(filter));
        const bool has_k = filter == &netmesh_filter_barycentric_cech || filter == &netmesh_filter_barycentric_rips;
        r.k = has_k ? k : 0;
        r.max_degree = max_degree;
        return r;
    }
    netmesh::Request nested_request(const inputs::Points& points, const netmesh_filter* filter, std::uint32_t k_last,
                                    std::uint32_t max_degree = 1) const {
        netmesh::Request r = on(points, plain(filter));
        r.k_last = k_last;
        r.max_degree = max_degree;
        r.vines = &netmesh_vines;
        return r;
    }
    // By 1 + eps unless request.goal says a ratio.
    netmesh::Request scales_request(const inputs::Points& points) const {
        netmesh::Request r = on(points, plain(&netmesh_filter_scales));
        r.mesh.tau = request.mesh.tau;
        r.goal.eps = 0.5;
        return r;
    }
    netmesh::Request fit_request(const inputs::Points& points) const {
        netmesh::Request r = on(points, plain(&netmesh_filter_complete));
        r.goal.ratio = request.goal.ratio;
        r.goal.focus_from = request.goal.focus_from;
        r.goal.focus_to = request.goal.focus_to;
        r.fit = &netmesh_fit;
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
    netmesh::Request request;  // what meshes have to promise; dimension, seed and monitor of every call

protected:
    netmesh::Request made_;  // of the diagram that was made last, without its source
};
