// Delaunay triangulations and meshes from points.
#include "api/measure.hpp"
#include "api/request.hpp"
#include "api/settling.hpp"
#include "mesh/mesh_points.hpp"
#include "mesh/sizing.hpp"
#include "vocabulary/features.hpp"

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
// An array, not a literal: a compiler may put a choice between literals into a table of pointers, and whoever links one
// such table on Arm holds the texts of all of them.
constexpr char no_ratios[] = "no mesh with cages of the thesis was found whose ratios are within tau";

netmesh_status finish_points(netmesh_context* context, Status status, const InputReport& input,
                             const char* text = nullptr) {
    const bool stays = status == Status::ok || status == Status::cancelled || status == Status::out_of_memory;
    return stays && context->mesh.present ? finish(context, status, nullptr, input.row_a, input.row_b)
                                          : fail_and_clear(context, status, text, input.row_a, input.row_b);
}

}  // namespace

netmesh_status finish_triangulation(netmesh_context* context, const InputReport& input, std::uint32_t hidden,
                                    Status status) {
    context->mesh.method = NETMESH_METHOD_DELAUNAY;
    keep_input(context, context->request.points.dim, input, status);
    context->input.distinct -= hidden;
    return finish_points(context, status, input);
}

namespace {

// Aspect ratio and sizes of a mesh that was just made, as far as it goes.
Status measure_without_cages(Context& context, const AnyStore& store, HierarchyQuality* quality) {
    *quality = HierarchyQuality{};
    return worst_aspect_ratio(store, domain_of(context), context.arena, &quality->worst, &quality->vertex);
}
[[gnu::noinline]] Status judge_measured(netmesh_context* context, const AnyStore& store, const SizeRule& sizes,
                                        const HierarchyQuality& quality, Status measured, Status status) {
    KeptMesh& mesh = context->mesh;
    mesh.aspect_ratio_max = quality.worst;
    if (status == Status::ok) status = measured;
    if (status == Status::ok && quality.encroached.violation != nullptr) status = Status::internal;
    // Whole cells: nothing else bounds those at the outermost shell.
    if (status == Status::ok && mesh.cage_kind == CageKind::thesis && !(quality.worst <= mesh.tau))
        status = Status::check_failed;
    return status == Status::ok ? measure_sizes(context, store, sizes) : status;
}
using Measure = Status (*)(Context&, const AnyStore&, HierarchyQuality*);
template <Measure measure>
Status measure_made(netmesh_context* context, const AnyStore& store, const SizeRule& sizes, Status status) {
    KeptMesh& mesh = context->mesh;
    if (!mesh.present) return status;
    if (status == Status::cancelled) {  // who cancels does not wait: corners far outside of the domain are dear
        mesh.aspect_ratio_max = infinity;
        return status;
    }
    HierarchyQuality quality;
    const Status measured = measure(*context, store, &quality);
    return judge_measured(context, store, sizes, quality, measured, status);
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

// What is said of a size, of scales or of a net that coordinates do not resolve.
netmesh_status refuse_resolution(netmesh_context* context, const MeshRequest& asked, std::uint64_t row) {
    const netmesh_request& r = context->request;
    clear(context);
    if (asked.method == MeshMethod::certificate)
        return refuse(context, NETMESH_FIELD_FOCUS_FROM, "focus_from is below what coordinates resolve at focus_ratio");
    if (asked.method == MeshMethod::reference && row == none)
        return refuse(context, r.mesh.net_spacing != 0 ? NETMESH_FIELD_NET_SPACING : NETMESH_FIELD_TAU,
                      "the boundary net on the sphere of the domain is finer than coordinates there, or the sphere out "
                      "of range");
    const bool by_distance = asked.size.eps == 0 && asked.size.function == nullptr;
    return refuse(context,
                  {r.goal.error > 0 ? NETMESH_FIELD_ERROR
                   : by_distance    ? NETMESH_FIELD_SIZE_AT_INPUTS
                                    : NETMESH_FIELD_SIZES,
                   "the size asked for is not positive or below what coordinates resolve"},
                  row);
}

template <Mesher mesher, Measure measure> netmesh_status mesh_by(netmesh_context* context) {
    clear(context);
    const netmesh_request& r = context->request;
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    ErrorSizes sizes;
    const MeshRequest asked = mesh_request_of(r, r.points.dim, &sizes);
    AnyMeshResult result = {};
    AnyStore store(static_cast<int>(r.points.dim), context->arena, context->mesh.store);
    Status status = mesher(store, rows_of(r.points), r.points.count, asked, {context->arena, monitor}, &result);
    context->mesh.method = r.mesh.method->id;
    context->mesh.audited = r.mesh.audit;
    keep_input(context, r.points.dim, result.input, status);
    keep_mesh(context, asked, result);
    status = watch.heed(measure_made<measure>(context, store, asked.size, status));
    context->complete = status == Status::ok;
    if (status == Status::invalid_argument) return refuse_resolution(context, asked, result.input.row_a);
    return finish_points(context, status, result.input, status == Status::check_failed ? no_ratios : nullptr);
}

netmesh_status mesh_by_delaunay(netmesh_context* context) { return triangulate_points(context, nullptr); }

}  // namespace

netmesh_status triangulate_points(netmesh_context* context, Allowance* allowance) {
    clear(context);
    const netmesh_request& r = context->request;
    Monitor monitor = monitor_of(r.monitor);
    const Watch watch(context->arena, monitor);
    return with_dimension(r.points.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        InputReport input;
        Store<D> store(context->arena, context->mesh.store);
        const Status status =
            watch.heed(triangulate<D>(store, rows_of(r.points), r.points.count, r.seed, monitor, &input, allowance));
        if (allowance != nullptr && allowance->is_spent) {
            allowance->is_spent = !monitor.has_stopped();
            return finish(context, Status::cancelled);
        }
        return finish_triangulation(context, input, 0, status);
    });
}

}  // namespace netmesh

using namespace netmesh;

namespace netmesh {
namespace {

// What asks for a mesh of quality tau, of any method but the certificate's and Delaunay's.
constexpr std::uint32_t of_quality = given::method | given::tau | given::audit,
                        sized = given::sizes | given::error | given::eps;

Complaint settle_triangulation(const Settling&) { return fine(); }

}  // namespace
}  // namespace netmesh

#define NETMESH_METHOD(name, id, method, cages, reads, mesh, settle)                                                   \
    extern const netmesh_method netmesh_method_##name;                                                                 \
    const netmesh_method netmesh_method_##name = {                                                                     \
        NETMESH_METHOD_##id, MeshMethod::method, CageKind::cages, reads, mesh, settle};

extern "C" {
NETMESH_METHOD(delaunay, DELAUNAY, quality, compact, given::method | given::weighting, mesh_by_delaunay,
               settle_triangulation)
NETMESH_METHOD(svr, SVR, quality, compact, of_quality | sized | given::domain_factor,
               (mesh_by<mesh_of_quality, measure_without_cages>), settle_rules)
NETMESH_METHOD(refine, REFINE, reference, compact, given::method | given::tau | sized | given::net_spacing,
               (mesh_by<mesh_of_quality, measure_without_cages>), settle_rules)
NETMESH_METHOD(netmesh, NETMESH, hierarchy, compact, of_quality | sized | given::domain_factor | given::finish,
               (mesh_by<mesh_with_cages, measure_quality>), settle_rules)
NETMESH_METHOD(thesis, THESIS, hierarchy, thesis, of_quality | given::domain_factor | given::finish,
               (mesh_by<mesh_with_thesis_cages, measure_quality>), settle_rules)
#if NETMESH_WITH_CERTIFICATE
NETMESH_METHOD(certificate, CERTIFICATE, certificate, compact,
               given::method | given::tau | given::ratio | given::focus | given::whole_cells | given::audit,
               (mesh_by<mesh_for_certificate, measure_without_cages>), settle_rules)
#else
NETMESH_METHOD(certificate, CERTIFICATE, certificate, compact,
               given::method | given::tau | given::ratio | given::focus | given::whole_cells | given::audit, nullptr,
               settle_rules)
#endif
}

#undef NETMESH_METHOD
