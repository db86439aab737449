// The method delaunay_small.
#include "api/plane.hpp"

#include "api/call.hpp"
#include "api/request.hpp"
#include "api/settling.hpp"
#include "delaunay/plane_few.hpp"

namespace netmesh {
namespace {

Complaint settle_few(const Settling& s) {
    if (s.dim != 2) return {NETMESH_FIELD_DIM, "this method is for points in the plane; name netmesh_method_delaunay"};
    return s.r.points.count > NarrowWords::points_max
               ? Complaint{NETMESH_FIELD_POINTS, "more than 8,192 points; name netmesh_method_delaunay"}
               : fine();
}

netmesh_status mesh_few(netmesh_context* context) {
    clear(context);
    const netmesh_request& r = context->request;
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    const Work work = {context->arena, monitor};
    StoreState& state = context->mesh.store;
    InputReport input = {};
    FewCells made;
    const Status status =
        watch.heed(triangulate_few(state, rows_of(r.points), r.points.count, r.seed, work, &input, &made));
    if (status != Status::ok) return fail_and_clear(context, status, nullptr, input.row_a, input.row_b);
    context->complete = true;
    context->input = {true, false, 2, input.rows, input.duplicates, input.fingerprint, state.vertex_count};
    context->mesh.method = NETMESH_METHOD_DELAUNAY;
    KeptPlane& plane = context->plane;
    plane.present = true;
    plane.cells = Slice<PlaneCell<NarrowWords>>::of(context->arena, made.mesh.cells, made.mesh.cell_count);
    plane.points = Slice<double>::of(context->arena, made.mesh.points, 2 * std::uint64_t{made.mesh.point_count});
    plane.place = Slice<std::uint16_t>::of(context->arena, made.place, made.mesh.point_count);
    return finish(context, status);
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {
extern const netmesh_method netmesh_method_delaunay_small;
const netmesh_method netmesh_method_delaunay_small = {
    NETMESH_METHOD_DELAUNAY, MeshMethod::quality, CageKind::compact, given::method, mesh_few, settle_few, true};
}
