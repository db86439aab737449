// Meshes made elsewhere.
#include "delaunay/load.hpp"

#include "api/measure.hpp"
#include "api/request.hpp"
#include "mesh/input_tree.hpp"
#include "mesh/sizing.hpp"

namespace netmesh {
namespace {

// Nearest inputs of all vertices; inputs come first.
Status find_origins(const AnyStore& store, std::uint32_t inputs) {
    ArenaScope scope(store.arena);
    AnyInputTree tree;
    if (tree.build(store, store.arena, inputs) != Status::ok) return Status::out_of_memory;
    std::uint32_t last = 0;
    for (std::uint32_t v = inputs; v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 500 * store.dim); v < piece;
             ++v) {
            double d2;
            store.vertex(v).origin = last = tree.nearest(store.point(v), last, none, &d2);
        }
    return Status::ok;
}

bool are_markers_valid(const Arena& arena, const uint8_t* markers, size_t count, std::uint32_t* inputs) {
    *inputs = 0;
    for (size_t v = 0; v < count;)
        for (const std::uint64_t piece = arena.piece(v, count, 7); v < piece; ++v) {
            if (markers[v] > 2) return false;
            if (markers[v] != 0) continue;
            if (*inputs != v) return false;
            ++*inputs;
        }
    return true;
}

Complaint complaint_about_load(const netmesh_load_request& request, const Arena& arena, std::uint32_t* inputs) {
    const Complaint dim = complaint_about_dim(request.dim);
    if (dim.text != nullptr) return dim;
    if (request.vertices == nullptr) return {NETMESH_FIELD_VERTICES, "vertices is null"};
    if (request.vertex_count == 0) return {NETMESH_FIELD_VERTEX_COUNT, "there are no vertices"};
    if (request.vertex_count > NETMESH_POINTS_MAX) return {NETMESH_FIELD_VERTEX_COUNT, "more than 2^28 vertices"};
    if (request.markers == nullptr || !are_markers_valid(arena, request.markers, request.vertex_count, inputs))
        return {NETMESH_FIELD_MARKERS, "markers are not 0, 1 or 2 with the inputs first"};
    if (*inputs == 0) return {NETMESH_FIELD_MARKERS, "there is no input vertex"};
    if (request.cells == nullptr) return {NETMESH_FIELD_CELLS, "cells is null"};
    if (request.cell_count == 0) return {NETMESH_FIELD_CELL_COUNT, "there are no cells"};
    if (request.cell_count > Store<2>::slots_max) return {NETMESH_FIELD_CELL_COUNT, "more than 2^29 cells"};
    if (request.domain == nullptr) return {};
    for (std::uint32_t k = 0; k <= request.dim; ++k)
        if (!is_finite(request.domain[k]) || (k == request.dim && !(request.domain[k] > 0)))
            return {NETMESH_FIELD_DOMAIN, "bad domain ball"};
    return {};
}

// Vertices, cells, markers, and the nearest inputs of vertices.
template <int D>
Status take_over(Store<D>& store, const netmesh_load_request& request, std::uint32_t inputs, CheckResult* why) {
    const auto count = static_cast<std::uint32_t>(request.vertex_count);
    const Status status = load_cells<D>(store, request.vertices, count, request.cells,
                                        static_cast<std::uint32_t>(request.cell_count), why);
    if (status != Status::ok) return status;
    for (std::uint32_t v = 0; v < count;)
        for (const std::uint64_t piece = store.arena.piece(v, count, 8); v < piece; ++v) {
            store.vertex(v).marker = static_cast<Marker>(request.markers[v]);
        }
    return find_origins(store, inputs);
}

// What keeps cells from being a triangulation of the convex hull of their vertices.
KeptFlaw flaw_of_cells(const AnyStore& store, const Monitor& monitor) {
    CheckResult found = check_combinatorial(store);
    if (found.violation == nullptr && !monitor.has_stopped()) found = check_geometric(store);
    return {kept_text(found.violation), found.cell};
}

// The domain given, with the least enclosing radius about its centre.
AnyDomain domain_about(const AnyStore& store, std::uint32_t inputs, const double* given) {
    AnyDomain domain;
    domain.dim = store.dim;
    const PointRows points = {store.dim, store.first_point(), store.point_stride(), inputs};
    const double smallest = enclosing_radius_of_inputs(points, store.arena, domain.centre);
    copy(store.dim, given, domain.centre);
    domain.radius = given[store.dim];
    domain.enclosing_radius = 0;
    for (std::uint32_t v = 0; v < inputs;)
        for (const std::uint64_t piece = store.arena.piece(v, inputs, 10 * store.dim); v < piece; ++v) {
            const double r = square_root(domain.distance2(store.point(v))) * (1 + 8 * unit_roundoff);
            if (r > domain.enclosing_radius) domain.enclosing_radius = r;
        }
    if (domain.enclosing_radius == 0) domain.enclosing_radius = smallest;
    return domain;
}

template <int D>
Status measure_domain(netmesh_context* context, Store<D>& store, const double* given, const SizeRule& sizes) {
    KeptMesh& mesh = context->mesh;
    keep_domain(domain_about(store, context->input.distinct, given), &mesh);
    HierarchyQuality quality;
    Status status = measure_quality(*context, store, &quality);
    mesh.aspect_ratio_max = quality.worst;
    return status == Status::ok ? measure_sizes(context, store, sizes) : status;
}

Complaint read_cages(const netmesh_cages_request& given, netmesh_cages_request* to) {
    netmesh_cages_request& request = *to;
    request = given;
    if (request.cages == nullptr && request.cage_count > 0) return {NETMESH_FIELD_CAGES, "cages is null"};
    if (request.cage_bytes == 0 && request.cage_count > 0) request.cage_bytes = request.cages->struct_bytes;
    if (request.cage_count == 0) request.cage_bytes = sizeof(netmesh_cage);
    if (request.cage_count >= NETMESH_NONE) return {NETMESH_FIELD_CAGE_COUNT, "too many cages"};
    if (request.cage_bytes < sizeof(netmesh_cage))
        return {NETMESH_FIELD_CAGE_BYTES, "cage_bytes is not the size of a cage"};
    return {};
}

// Cage `index` of an array whose items have the size that the caller knows.
netmesh_cage cage_at(const netmesh_cages_request& request, std::size_t index) {
    netmesh_cage cage;
    const auto* const first = reinterpret_cast<const unsigned char*>(request.cages);
    __builtin_memcpy(&cage, first + index * request.cage_bytes, sizeof cage);
    return cage;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_load(netmesh_context* context, const netmesh_load_request* from) {
    netmesh_load_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    monitor.begin(NETMESH_STAGE_CHECK, request.cell_count);
    std::uint32_t inputs = 0;
    Complaint complaint = complaint_about_load(request, context->arena, &inputs);
    Promises promises;
    ErrorSizes error_sizes;
    if (complaint.text == nullptr)
        complaint = read_promises(context, request.promised, request.dim, &promises, &error_sizes);
    if (complaint.text != nullptr) return refuse(context, complaint);
    for (size_t i = 0; i < request.vertex_count * request.dim;)
        for (const std::uint64_t piece = context->arena.piece(i, request.vertex_count * request.dim, 6); i < piece;
             ++i) {
            if (!is_finite(request.vertices[i]))
                return fail_and_clear(context, Status::not_finite, nullptr, i / request.dim);
        }
    clear(context);
    return with_dimension(request.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Store<D> store(context->arena, context->mesh.store);
        CheckResult why = {nullptr, none};
        Status status = watch.heed(take_over<D>(store, request, inputs, &why));
        if (status != Status::ok)
            return fail_and_clear(context, status, why.violation, why.violation != nullptr ? why.cell : 0);
        context->complete = true;
        context->input = {true, false, D, inputs, 0, 0, inputs};
        KeptMesh& mesh = context->mesh;
        mesh.present = mesh.is_loaded = true;
        mesh.is_mesh = request.domain != nullptr;
        if (!mesh.is_mesh) mesh.method = NETMESH_METHOD_DELAUNAY;
        mesh.low_end = context->arena.low_mark();
        mesh.tau = promises.goal.ratio > 0 ? 0 : promises.tau;
        mesh.goal = promises.goal;
        mesh.size_eps = promises.sizes.eps;
        mesh.cage_kind = promises.cages;
        if (mesh.is_mesh)
            status = measure_domain<D>(context, store, request.domain, promises.sizes);
        else
            mesh.flaw = flaw_of_cells(store, monitor);
        status = watch.heed(status);
        return status == Status::ok ? finish(context, status) : fail_and_clear(context, status);
    });
}

netmesh_status netmesh_load_cages(netmesh_context* context, const netmesh_cages_request* from) {
    netmesh_cages_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    const Complaint complaint = read_cages(request, &request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    KeptMesh& mesh = context->mesh;
    if (!mesh.is_mesh) return finish(context, Status::no_result, "there is no mesh with a domain");
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    monitor.begin(NETMESH_STAGE_CHECK, mesh.store.cell_slots);
    clear_diagram(context);
    mesh.hierarchy = {};
    mesh.cages = {};
    Cage* const kept = context->arena.take_low<Cage>(request.cage_count);
    if (kept == nullptr) return finish(context, Status::out_of_memory);
    for (size_t d = 0; d < request.cage_count;)
        for (const std::uint64_t piece = context->arena.piece(d, request.cage_count, 30); d < piece; ++d) {
            const netmesh_cage cage = cage_at(request, d);
            kept[d] = {cage.centre, none, none, none, cage.radius, infinity, cage_epsilon * cage.radius};
        }
    return with_dimension(context->input.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Store<D> store(context->arena, mesh.store);
        HierarchyQuality quality = {};
        const auto count = static_cast<std::uint32_t>(request.cage_count);
        HierarchyRequest asked = {kept, count, domain_of<D>(mesh)};
        asked.kind = mesh.cage_kind;
        const Status status = watch.heed(measure_hierarchy(store, asked, context->arena, &quality));
        if (status != Status::ok || !quality.is_hierarchy) {
            context->arena.release_low(mesh.low_end);
            if (status != Status::ok) return finish(context, status);
            return finish(context, Status::check_failed, quality.encroached.violation, quality.encroached.cell);
        }
        mesh.cages = Slice<Cage>::of(context->arena, kept, count);
        mesh.hierarchy.cages = count;
        mesh.low_end = context->arena.low_mark();
        mesh.aspect_ratio_max = quality.worst;
        return finish(context, Status::ok);
    });
}

}  // extern "C"
