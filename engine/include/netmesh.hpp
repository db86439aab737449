// netmesh for C++: the C interface of netmesh.h with spans of results and typed calls. Header only, nothing numeric in it,
// no exceptions, no allocation. See netmesh.h for what each call does, costs and returns.
#ifndef NETMESH_HPP
#define NETMESH_HPP

#include <cstddef>
#include <cstdint>

#include "netmesh.h"

namespace netmesh {

struct Options : netmesh_options {
    explicit Options(std::uint32_t dim) : netmesh_options{} { netmesh_options_init(this, dim); }
};

// Bytes to plan for, netmesh_plan_bytes.
inline std::size_t plan_bytes(netmesh_job job, const netmesh_options& options, std::uint64_t points) {
    return netmesh_plan_bytes(job, &options, points);
}

// Bottleneck distance, netmesh_bottleneck; scratch of netmesh_bottleneck_bytes(count_a, count_b), 16-byte aligned.
inline netmesh_status bottleneck(const netmesh_pair* a, std::size_t count_a, const netmesh_pair* b, std::size_t count_b,
                                 void* scratch, std::size_t scratch_bytes, netmesh_distance* distance,
                                 netmesh_scale scale = NETMESH_SCALE_PLAIN,
                                 std::uint32_t degree = NETMESH_ALL_DEGREES) {
    return netmesh_bottleneck(a, count_a, b, count_b, degree, scale, scratch, scratch_bytes, nullptr, nullptr,
                              distance);
}

// A context in a block that the caller keeps alive. Copying the object copies the handle, not the context.
class Engine {
public:
    // status() tells whether the block was accepted; every other call on a refused one returns INVALID_ARGUMENT.
    Engine(void* block, std::size_t block_bytes) { status_ = netmesh_init(block, block_bytes, &context_); }
    netmesh_status status() const { return status_; }
    netmesh_context* context() const { return context_; }

    netmesh_status delaunay(const double* points, std::size_t n, const netmesh_options& options) {
        return status_ = netmesh_delaunay(context_, points, n, &options);
    }
    netmesh_status mesh(const double* points, std::size_t n, const netmesh_options& options,
                        netmesh_job for_job = NETMESH_JOB_MESH) {
        return status_ = netmesh_mesh(context_, points, n, for_job, &options);
    }
    netmesh_status persist(netmesh_filter filter, const netmesh_options& options,
                           netmesh_values values = NETMESH_VALUES_CERTIFIED,
                           std::uint32_t max_degree = NETMESH_DIM_MAX) {
        return status_ = netmesh_persist(context_, filter, values, max_degree, 0, &options);
    }
    netmesh_status homology(const std::uint32_t* vertices, const std::uint64_t* starts, const double* values,
                            std::uint64_t count, const netmesh_options& options, bool representatives = false,
                            std::uint32_t max_degree = NETMESH_DEGREE_MAX) {
        return status_ = netmesh_homology(context_, vertices, starts, values, count, max_degree, 0,
                                          representatives ? 1 : 0, &options);
    }
    // k is read by the barycentric filters alone.
    netmesh_status persist_points(const double* points, std::size_t n, netmesh_filter filter,
                                  const netmesh_options& options, std::uint32_t max_degree = 1, std::uint32_t k = 1,
                                  bool representatives = false, netmesh_values values = NETMESH_VALUES_CERTIFIED) {
        return status_ = netmesh_persist_points(context_, points, n, filter, values, k, max_degree, 0,
                                                representatives ? 1 : 0, &options);
    }
    netmesh_status represent(const netmesh_options& options) { return status_ = netmesh_represent(context_, &options); }
    netmesh_status check(const netmesh_options& options, std::uint32_t what = NETMESH_CHECK_ALL) {
        return status_ = netmesh_check(context_, what, &options);
    }
    netmesh_status analyse(netmesh_analysis* analysis, const netmesh_options& options,
                           std::uint32_t what = NETMESH_ANALYSE_ALL, double tolerance = 0) {
        analysis->struct_bytes = sizeof *analysis;
        return status_ = netmesh_analyse(context_, what, tolerance, &options, analysis);
    }

    netmesh_detail detail() const { return netmesh_get_detail(context_); }
    netmesh_report report() const {
        netmesh_report r = {};
        r.struct_bytes = sizeof r;
        netmesh_get_report(context_, &r);
        return r;
    }
    // Calls visit(netmesh_pair) for each pair of the diagram, in order.
    template <class Visit> void for_each_pair(Visit&& visit) const {
        netmesh_pair pair;
        for (std::uint64_t i = 0; netmesh_get_pair(context_, i, &pair) == NETMESH_OK; ++i) visit(pair);
    }
    // Calls visit(index, netmesh_vertex), visit(index, netmesh_cell) for each vertex, cell.
    template <class Visit> void for_each_vertex(Visit&& visit) const {
        netmesh_vertex vertex;
        for (std::uint64_t i = 0; netmesh_get_vertex(context_, i, &vertex) == NETMESH_OK; ++i) visit(i, vertex);
    }
    template <class Visit> void for_each_cell(Visit&& visit) const {
        netmesh_cell cell;
        for (std::uint64_t i = 0; netmesh_get_cell(context_, i, &cell) == NETMESH_OK; ++i) visit(i, cell);
    }

    template <class Visit> void for_each_cage(Visit&& visit) const {
        netmesh_cage cage;
        for (std::uint64_t i = 0; netmesh_get_cage(context_, i, &cage) == NETMESH_OK; ++i) visit(i, cage);
    }

private:
    netmesh_context* context_ = nullptr;
    netmesh_status status_;
};

}  // namespace netmesh

#endif
