// Delaunay triangulations and meshes from points.
#include "api/measure.hpp"
#include "api/mesh_rules.hpp"
#include "api/triangulation.hpp"
#include "mesh/mesh_points.hpp"
#include "mesh/sizing.hpp"

namespace netmesh {
namespace {

// What was done to the points when a job on them ends with `status`.
void keep_input(netmesh_context* context, std::uint32_t dim, const InputReport& input, Status status) {
    context->complete = status == Status::ok;
    context->input = {true,
                      false,
                      dim,
                      input.rows,
                      input.duplicates,
                      input.fingerprint,
                      static_cast<std::uint32_t>(input.rows - input.duplicates)};
    context->mesh.present = context->mesh.store.cell_slots > 0;
    context->mesh.low_end = context->arena.low_mark();
}

// Cancelled, or out of memory: what there is by then stays. Anything else leaves nothing.
netmesh_status finish_points(netmesh_context* context, Status status, const InputReport& input) {
    const bool stays = status == Status::ok || status == Status::cancelled || status == Status::out_of_memory;
    const char* const text = status == Status::check_failed
                                 ? "no mesh with cages of the thesis was found whose ratios are within tau"
                                 : nullptr;
    return stays && context->mesh.present ? finish(context, status, nullptr, input.row_a, input.row_b)
                                          : fail_and_clear(context, status, text, input.row_a, input.row_b);
}

// Aspect ratio and sizes of a mesh that was just made, as far as it goes.
[[gnu::noinline]] Status measure_made(netmesh_context* context, const AnyStore& store, const SizeRule& sizes,
                                      Status status) {
    KeptMesh& mesh = context->mesh;
    if (!mesh.present) return status;
    if (status == Status::cancelled) {  // who cancels does not wait: corners far outside of the domain are dear
        mesh.aspect_ratio_max = infinity;
        return status;
    }
    HierarchyQuality quality;
    const Status measured = measure_quality(*context, store, &quality);
    mesh.aspect_ratio_max = quality.worst;
    if (status == Status::ok) status = measured;
    if (status == Status::ok && quality.encroached.violation != nullptr) status = Status::internal;
    // Whole cells: nothing else bounds those at the outermost shell.
    if (status == Status::ok && mesh.cage_kind == CageKind::thesis && !(quality.worst <= mesh.tau))
        status = Status::check_failed;
    return status == Status::ok ? measure_sizes(context, store, sizes) : status;
}

void keep_mesh(netmesh_context* context, const MeshRequest& request, const AnyMeshResult& result) {
    KeptMesh& mesh = context->mesh;
    mesh.is_mesh = true;
    keep_domain(result.domain, &mesh);
    mesh.tau = request.method == MeshMethod::certificate ? 0 : request.tau;
    mesh.goal = request.goal;
    mesh.size_eps = request.size.eps;
    if (result.cages != nullptr) mesh.cages = Slice<Cage>::of(context->arena, result.cages, result.hierarchy.cages);
    mesh.cage_kind = request.cages;
    mesh.hierarchy = result.hierarchy;
    mesh.touches = result.location.touches();
    mesh.audit = result.audit;
}

netmesh_status mesh_points_of(netmesh_context* context, const netmesh_mesh_request& request, Monitor& monitor,
                              const Watch& watch) {
    const MeshRequest asked = mesh_request_of(request);
    AnyMeshResult result = {};
    AnyStore store(static_cast<int>(request.dim), context->arena, context->mesh.store);
    Status status =
        mesh_points(store, rows_of(request), request.point_count, asked, {context->arena, monitor}, &result);
    context->mesh.method = request.method;
    context->mesh.audited = request.audit;
    keep_input(context, store.dim, result.input, status);
    keep_mesh(context, asked, result);
    status = watch.heed(measure_made(context, store, asked.size, status));
    context->complete = status == Status::ok;
    if (status != Status::invalid_argument) return finish_points(context, status, result.input);
    clear(context);
    if (asked.method == MeshMethod::certificate)
        return refuse(context, NETMESH_FIELD_FOCUS_FROM, "focus_from is below what coordinates resolve at focus_ratio");
    if (asked.method == MeshMethod::reference && result.input.row_a == none)
        return refuse(context, request.net_spacing != 0 ? NETMESH_FIELD_NET_SPACING : NETMESH_FIELD_TAU,
                      "the boundary net on the sphere of the domain is finer than coordinates there, or the sphere out "
                      "of range");
    const bool by_distance = asked.size.eps == 0 && asked.size.function == nullptr;
    return refuse(context,
                  {by_distance ? NETMESH_FIELD_SIZE_AT_INPUTS : NETMESH_FIELD_SIZES,
                   "the size asked for is not positive or below what coordinates resolve"},
                  result.input.row_a);
}

}  // namespace

netmesh_status triangulate_points(netmesh_context* context, const netmesh_delaunay_request& request,
                                  Allowance* allowance) {
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    return with_dimension(request.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        InputReport input;
        Store<D> store(context->arena, context->mesh.store);
        const Status status = watch.heed(
            triangulate<D>(store, rows_of(request), request.point_count, request.seed, monitor, &input, allowance));
        if (allowance != nullptr && allowance->is_spent) {
            allowance->is_spent = !monitor.has_stopped();
            return finish(context, Status::cancelled);
        }
        keep_input(context, D, input, status);
        return finish_points(context, status, input);
    });
}

}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_delaunay(netmesh_context* context, const netmesh_delaunay_request* from) {
    netmesh_delaunay_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    const Complaint complaint = complaint_about_points(request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    clear(context);
    return triangulate_points(context, request, nullptr);
}

netmesh_status netmesh_mesh(netmesh_context* context, const netmesh_mesh_request* from) {
    netmesh_mesh_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    Complaint complaint = complaint_about_points(request);
    if (complaint.text == nullptr) complaint = complaint_about_numbers(request);
    if (complaint.text == nullptr) complaint = complaint_about_method(request);
    if (complaint.text == nullptr) complaint = complaint_about_goal(request);
    if (complaint.text == nullptr) complaint = complaint_about_built_mesh(request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    clear(context);
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    return mesh_points_of(context, request, monitor, watch);
}

}  // extern "C"
