#include "vocabulary/dimension.hpp"
#include "api/dispatch.hpp"
#include "filtration/tight_filter.hpp"

namespace netmesh {
namespace {

// Measured on uniform points; the margin covers other seeds and small sets.
constexpr double margin = 1.3;
constexpr double gradient_bytes_per_simplex = 8;
constexpr double alpha_bytes_per_simplex = 48;
constexpr double hierarchy_bytes_per_point = 44;
// Audits: scratch for each vertex and cell, and what is left of the block when lists have taken their share of it.
constexpr double audit_bytes_per_vertex = 40, audit_bytes_per_cell = 16, audit_bytes_per_point = 24;

double power_in_eighths(double x, int k) {
    const double root = square_root(square_root(square_root(x)));
    double p = 1;
    for (int i = 0; i < k; ++i) p *= root;
    return p;
}

template <int D>
double planned_bytes(netmesh_job job, netmesh_method method, std::uint32_t audit, double tau, double eps,
                     double points) {
    const bool tight = job == NETMESH_JOB_PERSIST_TIGHT || job == NETMESH_JOB_PERSIST_SCALES;
    const bool meshes = job == NETMESH_JOB_MESH || job == NETMESH_JOB_PERSIST || tight;
    double vertices = points, cells = points * figures<D>.delaunay_cells_per_point;
    if (meshes) {
        vertices = points * (1 + figures<D>.growth / power_in_eighths(tau - 2, figures<D>.growth_eighths)) + 100;
        double fine = eps > 0 ? (points + (tight ? figures<D>.tight_surroundings : 0)) * figures<D>.over_refined : 0;
        for (int k = 0; k < D && eps > 0; ++k) fine /= eps;
        if (fine > vertices) vertices = fine;
        cells = vertices * figures<D>.mesh_cells_per_vertex;
    }
    double bytes = vertices * sizeof(Vertex<D>) + cells * sizeof(Cell<D>) + 9 * points;
    if (meshes && (method == NETMESH_METHOD_NETMESH || audit != 0)) bytes += hierarchy_bytes_per_point * points;
    if (meshes && audit != 0) {
        bytes += audit_bytes_per_vertex * vertices + audit_bytes_per_cell * cells + audit_bytes_per_point * points;
        const double lists = 16 * figures<D>.audit_balls_per_point * points;
        if (bytes < 3 * lists) bytes = 3 * lists;
        bytes += bytes / 3;
    }
    const double simplices = cells * figures<D>.simplices_per_cell;
    if (job == NETMESH_JOB_PERSIST || tight) bytes += 24 * vertices + gradient_bytes_per_simplex * simplices;
    if (job == NETMESH_JOB_PERSIST_ALPHA) bytes += alpha_bytes_per_simplex * simplices;
    if (job == NETMESH_JOB_PERSIST_SCALES) bytes += points * (sizeof(Vertex<D>) + 32);
    // Small sets are all boundary: a frame, its ghosts, and the cells that join them to the points.
    return margin * bytes + sizeof(netmesh_context) + 16384 + 64 * sizeof(Cell<D>) * figures<D>.mesh_cells_per_vertex;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" size_t netmesh_plan_bytes(netmesh_job job, const netmesh_options* options, uint64_t points) {
    if (!usable(options) || points == 0 || points > (uint64_t{1} << 28)) return 0;
    if (!in_range(job, NETMESH_JOB_DELAUNAY, NETMESH_JOB_PERSIST_SCALES)) return 0;
    if (!in_range(options->method, NETMESH_METHOD_SVR, NETMESH_METHOD_REFINE)) return 0;
    // A mesh that certifies a ratio takes no more than one of the aspect ratio that proves it.
    const double equivalent = options->ratio * options->ratio - 2;
    const double tau = options->ratio > 0 ? (equivalent > 2.1 ? equivalent : 2.1) : tau_of(*options);
    if (!(tau > 2) || !is_finite(tau)) return 0;
    if (!(options->over_refine_eps >= 0)) return 0;
    double size = options->over_refine_eps;
    if (job == NETMESH_JOB_PERSIST_TIGHT || job == NETMESH_JOB_PERSIST_SCALES) {
        if (!is_valid_eps(eps_of(*options))) return 0;
        const double tight = tight_size(eps_of(*options));
        if (!(size > 0 && size < tight)) size = tight;
    }
    const double bytes = with_dimension(options->dim, [&](auto dimension) {
        return planned_bytes<decltype(dimension)::value>(job, options->method, options->audit, tau, size,
                                                         static_cast<double>(points));
    });
    if (!(bytes < 0x1p62) || bytes >= static_cast<double>(SIZE_MAX / 2)) return SIZE_MAX;
    return (static_cast<size_t>(bytes) + Arena::alignment) & ~(Arena::alignment - 1);
}
