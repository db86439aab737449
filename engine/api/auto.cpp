// The exact alpha complex where it is affordable, else a mesh.
#include "api/requests.hpp"
#include "api/triangulation.hpp"
#include "numerics/square_root.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {
namespace {

// Cells that a conflict which takes more than a cached ball counts for, and one that is a tie. Measured by bench_auto.
constexpr double hard_work = 5, tie_work = 2;

// What the cells of the block may hold: fewer bytes a cell than any alpha complex takes. A triangulation has D + 1
// simplices a cell at least, each of 3 D + 14 bytes (alpha_of_triangulation.hpp).
template <int D> Allowance allowance_of(const Arena& arena, std::size_t points) {
    constexpr std::size_t cell_bytes = sizeof(Cell<D>) + (D + 1) * (3 * D + 14);
    const std::size_t vertices =
        points < arena.bytes() / sizeof(Vertex<D>) ? points * sizeof(Vertex<D>) : arena.bytes();
    Allowance allowance = {};
    allowance.work_each = figures<D>.affordable_work;
    allowance.by_hard = hard_work;
    allowance.by_tie = tie_work;
    allowance.cells_max = (arena.bytes() - vertices) / cell_bytes;
    return allowance;
}

// What the two requests on points have in common with the one that both come from.
template <class Request> void set_points(const netmesh_auto_request& from, Request* to) {
    to->monitor = from.monitor;
    to->points = from.points;
    to->point_count = from.point_count;
    to->point_format = from.point_format;
    to->point_stride_bytes = from.point_stride_bytes;
    to->seed = from.seed;
    to->purpose = NETMESH_PURPOSE_PERSIST;
}

netmesh_delaunay_request triangulation_of(const netmesh_auto_request& request) {
    netmesh_delaunay_request triangulation;
    netmesh_delaunay_request_init(&triangulation, sizeof triangulation, request.dim);
    set_points(request, &triangulation);
    return triangulation;
}

netmesh_mesh_request mesh_of(const netmesh_auto_request& request) {
    netmesh_mesh_request mesh;
    netmesh_mesh_request_init(&mesh, sizeof mesh, request.dim);
    set_points(request, &mesh);
    if (built::certificate) mesh.certificate.ratio = square_root(2 + tau_of(request.dim, 0));
    return mesh;
}

netmesh_status persist_by(netmesh_context* context, netmesh_filter filter, const netmesh_auto_request& request) {
    netmesh_persist_request persist;
    netmesh_persist_request_init(&persist, sizeof persist);
    persist.filter = filter;
    persist.monitor = request.monitor;
    persist.max_degree = request.max_degree;
    persist.keep_zero_pairs = request.keep_zero_pairs;
    return netmesh_persist(context, &persist);
}

netmesh_status take_alpha(netmesh_context* context, const netmesh_auto_request& request, Allowance* allowance) {
    clear(context);
    const netmesh_status status = triangulate_points(context, triangulation_of(request), allowance);
    return status == NETMESH_OK ? persist_by(context, NETMESH_FILTER_ALPHA, request) : status;
}

netmesh_status take_mesh(netmesh_context* context, const netmesh_auto_request& request) {
    const netmesh_mesh_request mesh = mesh_of(request);
    const netmesh_status status = netmesh_mesh(context, &mesh);
    return status == NETMESH_OK ? persist_by(context, NETMESH_FILTER_COMPLETE, request) : status;
}

// Why there is no alpha diagram, when a mesh may help; else ASKED.
netmesh_why why_not_alpha(netmesh_status status, const Allowance& allowance) {
    if (allowance.is_spent) return allowance.is_dear ? NETMESH_WHY_CELLS : NETMESH_WHY_MEMORY;
    switch (status) {
    case NETMESH_OUT_OF_MEMORY: return NETMESH_WHY_MEMORY;
    case NETMESH_FLAT: return NETMESH_WHY_FLAT;
    case NETMESH_OUT_OF_RANGE: return NETMESH_WHY_RANGE;
    default: return NETMESH_WHY_ASKED;
    }
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

size_t netmesh_plan_auto(const netmesh_auto_request* from) {
    netmesh_auto_request request;
    if (read_struct(from, &request, sizeof request) != NETMESH_FIELD_NONE) return 0;
    if (complaint_about_dim(request.dim).text != nullptr) return 0;
    // Uniform points have few cells: alpha complexes of them are affordable.
    if (built::alpha) {
        const netmesh_delaunay_request triangulation = triangulation_of(request);
        return netmesh_plan_delaunay(&triangulation);
    }
    const netmesh_mesh_request mesh = mesh_of(request);
    return netmesh_plan_mesh(&mesh);
}

netmesh_status netmesh_persist_auto(netmesh_context* context, const netmesh_auto_request* from) {
    netmesh_auto_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    const Complaint complaint = complaint_about_points(request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    Allowance allowance = with_dimension(request.dim, [&](auto dimension) {
        return allowance_of<decltype(dimension)::value>(context->arena, request.point_count);
    });
    netmesh_why why = NETMESH_WHY_NOT_BUILT;
    netmesh_status status = NETMESH_OK;
    std::size_t peak = 0;
    if (built::alpha) {
        status = take_alpha(context, request, &allowance);
        peak = context->arena.bytes_peak();
        why = status == NETMESH_OK ? NETMESH_WHY_AFFORDABLE : why_not_alpha(status, allowance);
    }
    if (why != NETMESH_WHY_AFFORDABLE && why != NETMESH_WHY_ASKED) {
        status = take_mesh(context, request);
        // What has no mesh may have an alpha diagram, or needs more memory for it.
        const bool has_no_mesh = status == NETMESH_TOO_CLOSE || status == NETMESH_OUT_OF_RANGE;
        if (has_no_mesh && (why == NETMESH_WHY_CELLS || why == NETMESH_WHY_MEMORY)) {
            status = take_alpha(context, request, nullptr);
            why = NETMESH_WHY_NO_MESH;
        }
    }
    if (status != NETMESH_OK) {
        clear(context);
        return status;
    }
    context->arena.raise_peak(peak);
    if (why == NETMESH_WHY_MEMORY) context->arena.use_all();
    context->diagram.why = why;
    context->diagram.tried_points = allowance.points_tried;
    context->diagram.tried_cells = allowance.cells_made;
    return status;
}

}  // extern "C"
