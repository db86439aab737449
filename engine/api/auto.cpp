// The exact alpha complex where it is affordable, else a mesh.
#include "api/plan.hpp"
#include "api/request.hpp"
#include "api/settling.hpp"
#include "delaunay/triangulate.hpp"
#include "vocabulary/dimension.hpp"

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

// The filter that was taken becomes the request's.
netmesh_status take_alpha(netmesh_context* context, Allowance* allowance) {
    context->request.filter = &netmesh_filter_alpha;
    const netmesh_status status = triangulate_points(context, allowance);
    return status == NETMESH_OK ? filter_triangulation(context) : status;
}

netmesh_status take_mesh(netmesh_context* context) {
    netmesh_request& r = context->request;
    r.filter = &netmesh_filter_complete;
    settle(Call::persist, 0, &r);
    const netmesh_status status = dispatch(*r.mesh.method, context);
    return status == NETMESH_OK ? filter_mesh(context) : status;
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

// There is no mesh with weights, and none with periods.
netmesh_status take_alone(netmesh_context* context) {
    netmesh_request& r = context->request;
    r.filter = &netmesh_filter_alpha;
    if (r.periods == nullptr) r.keep_mesh = 1;
    const netmesh_status status =
        r.periods != nullptr ? dispatch(*r.periods, context) : dispatch(*r.weighting, context);
    if (status == NETMESH_OK) context->diagram.why = NETMESH_WHY_ALONE;
    return status;
}

netmesh_status run_auto(netmesh_context* context) {
    const netmesh_points& points = context->request.points;
    if (points.dim == 0) return refuse(context, NETMESH_FIELD_POINTS, "this filter begins with points");
    if (context->request.periods != nullptr || context->request.weighting != nullptr) return take_alone(context);
    Allowance allowance = with_dimension(points.dim, [&](auto dimension) {
        return allowance_of<decltype(dimension)::value>(context->arena, points.count);
    });
    netmesh_status status = take_alpha(context, &allowance);
    const std::size_t peak = context->arena.bytes_peak();
    netmesh_why why = status == NETMESH_OK ? NETMESH_WHY_AFFORDABLE : why_not_alpha(status, allowance);
    if (why != NETMESH_WHY_AFFORDABLE && why != NETMESH_WHY_ASKED) {
        status = take_mesh(context);
        // What has no mesh may have an alpha diagram, or needs more memory for it.
        const bool has_no_mesh = status == NETMESH_TOO_CLOSE || status == NETMESH_OUT_OF_RANGE;
        if (has_no_mesh && (why == NETMESH_WHY_CELLS || why == NETMESH_WHY_MEMORY)) {
            status = take_alpha(context, nullptr);
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

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {
extern const netmesh_filter netmesh_filter_auto;
const netmesh_filter netmesh_filter_auto = {NETMESH_FILTER_AUTO,
                                            given::cycles | given::keep_mesh | given::seed | given::weighting |
                                                given::squares | given::periods,
                                            run_auto,
                                            settle_mesh_degree,
                                            nullptr,
                                            nullptr,
                                            nullptr};
}
