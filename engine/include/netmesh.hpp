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

// Bytes of block to plan for, netmesh_homology_bytes and netmesh_points_bytes.
inline std::size_t homology_bytes(std::uint64_t count, std::uint64_t vertices) {
    return netmesh_homology_bytes(count, vertices);
}
inline std::size_t points_bytes(netmesh_filter filter, const netmesh_options& options, std::uint64_t points,
                                std::uint32_t max_degree = 1, std::uint32_t k = 1) {
    return netmesh_points_bytes(filter, &options, points, k, max_degree);
}

inline const char* status_text(netmesh_status status) { return netmesh_status_text(status); }

// A context in a block that the caller keeps alive. Copying the object copies the handle, not the context.
class Engine {
public:
    // status() tells whether the block was accepted; every other call on a refused one returns INVALID_ARGUMENT.
    Engine(void* block, std::size_t block_bytes) { status_ = netmesh_init(block, block_bytes, &context_); }
    // The context in a byte copy of a block, netmesh_adopt.
    static Engine adopt(void* block) {
        Engine engine;
        engine.status_ = netmesh_adopt(block, &engine.context_);
        return engine;
    }
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
    // Takes over a mesh; domain: D centre coordinates and a radius, or null for a Delaunay triangulation.
    netmesh_status load(const double* vertices, const std::uint8_t* markers, std::size_t vertex_count,
                        const std::uint32_t* cells, std::size_t cell_count, const double* domain,
                        const netmesh_options& options) {
        return status_ = netmesh_load(context_, vertices, markers, vertex_count, cells, cell_count, domain, &options);
    }
    netmesh_status load_cages(const netmesh_cage* cages, std::size_t count, const netmesh_options& options) {
        return status_ = netmesh_load_cages(context_, cages, count, &options);
    }
    netmesh_status persist_function(const netmesh_function& function, const netmesh_options& options,
                                    netmesh_values values = NETMESH_VALUES_CERTIFIED,
                                    std::uint32_t max_degree = NETMESH_DIM_MAX) {
        return status_ = netmesh_persist_function(context_, &function, values, max_degree, 0, &options);
    }
    netmesh_status persist_scales(const double* points, std::size_t n, const netmesh_options& options,
                                  netmesh_values values = NETMESH_VALUES_CERTIFIED,
                                  std::uint32_t max_degree = NETMESH_DIM_MAX) {
        return status_ = netmesh_persist_scales(context_, points, n, values, max_degree, 0, &options);
    }
    netmesh_status vineyard(netmesh_filter filter, std::uint32_t k_first, std::uint32_t k_last,
                            const netmesh_options& options, netmesh_values values = NETMESH_VALUES_CERTIFIED,
                            std::uint32_t max_degree = NETMESH_DIM_MAX) {
        return status_ = netmesh_vineyard(context_, filter, k_first, k_last, values, max_degree, &options);
    }
    netmesh_status bound_bars(const netmesh_options& options) {
        return status_ = netmesh_bound_bars(context_, &options);
    }
    // ratios[vertices], domains[vertices].
    netmesh_status measure_cells(double* ratios, std::uint32_t* domains) {
        return status_ = netmesh_measure_cells(context_, ratios, domains);
    }
    // order[inputs], theta[inputs].
    netmesh_status well_paced_order(std::uint32_t* order, double* theta) {
        return status_ = netmesh_well_paced_order(context_, order, theta);
    }
    netmesh_status pace(const std::uint32_t* order, double* theta) {
        return status_ = netmesh_pace(context_, order, theta);
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

    // Calls visit(index, netmesh_bar_bounds) for each pair, visit(netmesh_scale_step), after bound_bars.
    template <class Visit> void for_each_bar_bounds(Visit&& visit) const {
        netmesh_bar_bounds bounds;
        for (std::uint64_t i = 0; netmesh_get_bar_bounds(context_, i, &bounds) == NETMESH_OK; ++i) visit(i, bounds);
    }
    template <class Visit> void for_each_scale_step(Visit&& visit) const {
        netmesh_scale_step step;
        for (std::uint64_t i = 0; netmesh_get_scale_step(context_, i, &step) == NETMESH_OK; ++i) visit(step);
    }
    // Calls visit(netmesh_simplex) for each simplex of the representative of a pair.
    template <class Visit> netmesh_status for_each_in_cycle(std::uint64_t pair, Visit&& visit) const {
        std::uint64_t count;
        const netmesh_status status = netmesh_get_cycle(context_, pair, &count);
        netmesh_simplex simplex;
        for (std::uint64_t i = 0; status == NETMESH_OK && i < count; ++i)
            if (netmesh_get_cycle_simplex(context_, pair, i, &simplex) == NETMESH_OK) visit(simplex);
        return status;
    }
    // Calls visit(netmesh_vine_point) in the order of vines and k.
    template <class Visit> void for_each_vine_point(Visit&& visit) const {
        netmesh_vine_point point;
        for (std::uint64_t i = 0; netmesh_get_vine_point(context_, i, &point) == NETMESH_OK; ++i) visit(point);
    }
    // Of the diagram at one k of the vineyard; 0 where there is none.
    double vine_ratio(std::uint32_t k) const {
        double ratio = 0;
        return netmesh_get_vine_ratio(context_, k, &ratio) == NETMESH_OK ? ratio : 0;
    }
    template <class Visit> void for_each_cage(Visit&& visit) const {
        netmesh_cage cage;
        for (std::uint64_t i = 0; netmesh_get_cage(context_, i, &cage) == NETMESH_OK; ++i) visit(i, cage);
    }

private:
    Engine() = default;
    netmesh_context* context_ = nullptr;
    netmesh_status status_ = NETMESH_NO_RESULT;
};

}  // namespace netmesh

#endif
