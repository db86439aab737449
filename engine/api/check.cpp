// Independent checkers of what the context holds.
#include "delaunay/check.hpp"
#include "api/measure.hpp"
#include "api/request.hpp"
#include "delaunay/any_kernel.hpp"
#include "filtration/filters.hpp"
#include "laboratory/fatness.hpp"
#include "laboratory/size.hpp"
#include "mesh/cages/any_cage.hpp"
#include "mesh/check/check_domain.hpp"
#include "mesh/check/check_reach.hpp"
#include "mesh/check/check_weighted_cells.hpp"
#include "mesh/sizing.hpp"

namespace netmesh {
namespace {

// Room for the rounding of a ratio, when the mesh was made elsewhere.
constexpr double ratio_tolerance = 0x1p-40;
// Cells are clipped but with cages of the thesis.
const char* aspect_violation_of(const Context& context) {
    return cage_count_of(context) > 0 && context.mesh.cage_kind == CageKind::thesis
               ? "a Voronoi cell has an aspect ratio above tau"
               : "a clipped Voronoi cell has an aspect ratio above tau";
}

// The squared size that each cell may have, by a search of its own for the two inputs nearest to each vertex; what
// refinement takes them from is kept with the vertices.
Status find_limits(const AnyStore& store, std::uint32_t inputs, const SizeRule& sizes, Arena& arena, double* limit2) {
    const ArenaScope scope(arena);
    AnyInputTree tree;
    if (tree.build(store, arena, inputs) != Status::ok) return Status::out_of_memory;
    for (std::uint32_t v = 0; v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 500 * store.dim); v < piece;
             ++v) {
            if (!(limit2[v] < infinity)) continue;
            Neighbour near[2] = {{infinity, none, 0}, {infinity, none, 0}};
            tree.nearest_k(store.point(v), inputs < 2 ? inputs : 2, near);
            double size = infinity;
            if (sizes.eps > 0) size = sizes.eps * square_root(near[1].distance2);
            if (sizes.at_inputs > 0) {
                const double by_distance = sizes.at_inputs + sizes.growth * square_root(near[0].distance2);
                if (by_distance < size) size = by_distance;
            }
            const double by_caller = sizes.by_caller(store.point(v));
            if (!(by_caller >= size)) size = by_caller;
            size *= 1 + ratio_tolerance;
            limit2[v] = size > 0 ? size * size : 0;
        }
    return Status::ok;
}

// Cells with cages of the thesis are not clipped: the ball is one that no cell within its limit, `most` nearest
// distances, can leave. All vertices but exempt ones are in the outermost cage, of radius r: their nearest neighbours
// are less than 2 r away. What a shell has yielded to has no limit.
ReachRequest whole_cells(const AnyStore& store, const ReachRequest& reach, double most, double* limit2) {
    for (std::uint32_t v = 0; v < store.state.vertex_count;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 500 * store.dim); v < piece;
             ++v) {
            if (has_yielded_to(store, reach.cages, reach.domains[v], v)) limit2[v] = infinity;
        }
    const Cage* outermost = reach.cages;
    while (outermost->parent != none) outermost = reach.cages + outermost->parent;
    AnyDomain ball = reach.outermost;
    copy(store.dim, store.point(outermost->centre), ball.centre);
    ball.radius = 4 * (1 + most) * outermost->radius;
    return {ball, limit2};
}

// What the mesher measures of clipped cells, against what is promised; check_reach is the second opinion.
Status check_measured(Context& context, const AnyStore& store, const Promises& promises, CheckResult* why) {
    double worst;
    std::uint32_t vertex;
    const AnyDomain domain = domain_of(context);
    recompute_balls(store);
    Status status = worst_aspect_ratio(store, domain, context.arena, &worst, &vertex);
    if (status == Status::ok && !(worst <= promises.tau * (1 + ratio_tolerance)))
        *why = {aspect_violation_of(context), vertex};
    const bool is_sized = built::sizes && promises.sizes.asks();
    if (status != Status::ok || why->violation != nullptr || !is_sized) return status;
    SizeRatio sized;
    status = worst_size_ratio(store, {domain, context.input.distinct, promises.sizes}, context.arena, &sized);
    if (status == Status::ok && !(sized.worst <= 1 + ratio_tolerance))
        *why = {"a clipped Voronoi cell is larger than the size asked for", sized.vertex};
    return status;
}

// Quality by definition 4.5 where there are cages, of each clipped cell and its size where there are none.
Status check_quality(Context& context, const AnyStore& store, const Promises& promises, CheckResult* why) {
    const AnyDomain domain = domain_of(context);
    const std::uint32_t cages = cage_count_of(context), vertices = store.state.vertex_count;
    Arena& arena = context.arena;
    const ArenaScope scope(arena);
    double* const limit2 = arena.take_low<double>(vertices);
    double* const ratios = arena.take_low<double>(cages == 0 ? 0 : vertices);
    std::uint32_t* const domains = arena.take_low<std::uint32_t>(cages == 0 ? 0 : vertices);
    if (limit2 == nullptr || ratios == nullptr || domains == nullptr) return Status::out_of_memory;
    if (cages > 0) {
        HierarchyQuality quality;
        HierarchyRequest request = hierarchy_of(context, domain);
        request.ratios = ratios;
        request.domains = domains;
        const Status status = measure_hierarchy(store, request, arena, &quality);
        if (status != Status::ok) return status;
        *why = quality.encroached;
        if (why->violation == nullptr && !(quality.worst <= promises.tau * (1 + ratio_tolerance)))
            *why = {aspect_violation_of(context), quality.vertex};
        CageFigures* const figures = arena.take_low<CageFigures>(cages);
        if (figures == nullptr) return Status::out_of_memory;
        if (why->violation == nullptr)
            *why = check_weighted_cells(hierarchy_view(store, cages_of(context), cages, domains), figures);
    }
    if (why->violation == nullptr)
        *why = check_domain(store, domain, cages == 0 ? nullptr : domains, context.complete, promises.net);
    if (why->violation != nullptr) return Status::check_failed;
    Status status = cages == 0 ? check_measured(context, store, promises, why) : Status::ok;
    if (status != Status::ok || why->violation != nullptr)
        return why->violation != nullptr ? Status::check_failed : status;
    recomputed_nearest2(store, limit2);
    const double most = 0.5 * promises.tau * (1 + ratio_tolerance);
    for (std::uint32_t v = 0; v < vertices;)
        for (const std::uint64_t piece = store.arena.piece(v, vertices, 15); v < piece; ++v) {
            limit2[v] = store.vertex(v).marker == Marker::exempt || store.vertex(v).cell == none
                            ? infinity
                            : most * most * limit2[v];
        }
    ReachRequest reach = {domain, limit2, cages_of(context), cages == 0 ? nullptr : domains};
    if (cages > 0 && context.mesh.cage_kind == CageKind::thesis) reach = whole_cells(store, reach, most, limit2);
    std::uint32_t beyond;
    status = check_reach(store, reach, &beyond);
    if (status == Status::ok && beyond != none) *why = {aspect_violation_of(context), beyond};
    if (status == Status::ok && why->violation == nullptr && cages == 0 && promises.sizes.asks()) {
        status = find_limits(store, context.input.distinct, promises.sizes, arena, limit2);
        if (status == Status::ok) status = check_reach(store, {domain, limit2}, &beyond);
        if (beyond != none) *why = {"a clipped Voronoi cell is larger than the size asked for", beyond};
    }
    return status == Status::ok && why->violation != nullptr ? Status::check_failed : status;
}

// What refinement by the certificate promises, from the bounds of every cell.
Status check_ratio(Context& context, const AnyStore& store, const RatioGoal& goal, Monitor& monitor, CheckResult* why) {
    const ArenaScope scope(context.arena);
    double* const value = context.arena.take_high<double>(store.state.vertex_count);
    Interval* const interval = context.arena.take_high<Interval>(store.state.vertex_count);
    if (value == nullptr || interval == nullptr) return Status::out_of_memory;
    Evaluation evaluation = {value, interval};
    static const FilterRequest filter = {NETMESH_FILTER_COMPLETE, &complete_on_mesh, FilterValues::certified};
    const Work work = {context.arena, monitor};
    AnyMesh mesh(store, domain_of(context), context.input.distinct, goal.clipped);
    Status status = clip_cells(filter, work, &mesh);
    if (status == Status::ok) status = evaluate(mesh, filter, work, &evaluation);
    if (status != Status::ok) return status;
    for (std::uint32_t v = 0; v < store.state.vertex_count && why->violation == nullptr;)
        for (const std::uint64_t piece = store.arena.piece(v, store.state.vertex_count, 25);
             v < piece && why->violation == nullptr; ++v) {
            const Interval& i = interval[v];
            const double ratio = square_root(i.hi / i.lo) * (1 - ratio_tolerance);
            const bool focused =
                goal.focus > 0 && store.vertex(v).marker == Marker::steiner && i.hi > goal.from && i.lo < goal.to;
            if (ratio > goal.ratio) *why = {"the certified ratio is above the one asked for", v};
            if (focused && ratio > goal.focus) *why = {"a cell's ratio is above the one asked for at its scale", v};
        }
    return why->violation == nullptr ? Status::ok : Status::check_failed;
}

Status check_promises(Context& context, const AnyStore& store, const Promises& promises, Monitor& monitor,
                      CheckResult* why) {
    const bool by_certificate = promises.goal.ratio > 0 && cage_count_of(context) == 0;
    if (!by_certificate) return check_quality(context, store, promises, why);
    *why = check_domain(store, domain_of(context), nullptr, context.complete, promises.net);
    return why->violation != nullptr ? Status::check_failed : check_ratio(context, store, promises.goal, monitor, why);
}

// What chapters 3, 4.9 and 5 say about sizes and degrees.
Status check_bounds(Context& context, const AnyStore& store, const Promises& promises, Monitor& monitor,
                    CheckResult* why) {
    const Work work = {context.arena, monitor};
    monitor.begin(NETMESH_STAGE_ANALYSE, 0);
    Status status = Status::ok;
    if (context.mesh.is_mesh && context.mesh.tau > 0) {
        SizeAnalysis size;
        status = analyse_size(store, domain_of(context), context.input.distinct,
                              {promises.tau, promises.sizes, infinity, 0, cages_of(context), cage_count_of(context),
                               context.mesh.cage_kind},
                              work, &size);
        if (status == Status::ok) why->violation = violated_size_bound(size);
    }
    if (status != Status::ok || why->violation != nullptr) return status;
    FatnessAnalysis fatness;
    recompute_balls(store);
    status = analyse_fatness(store, domain_of(context), work, &fatness);
    if (status != Status::ok) return status;
    why->violation = violated_fatness_bound(fatness.bounded);
    if (why->violation == nullptr) why->violation = violated_fatness_bound(fatness.inside);
    if (why->violation == nullptr) why->violation = violated_fatness_bound(fatness.all);
    return Status::ok;
}

Status check(Context& context, std::uint32_t what, const Promises& promises, Monitor& monitor, CheckResult* why) {
    const AnyStore store = store_of(context);
    Status status = Status::ok;
    const auto goes_on = [&] { return status == Status::ok && why->violation == nullptr && !monitor.has_stopped(); };
    monitor.begin(NETMESH_STAGE_CHECK, store.state.cell_slots);
    *why = check_combinatorial(store);  // of every kind of check
    if (goes_on() && (what & (NETMESH_CHECK_GEOMETRIC | NETMESH_CHECK_DELAUNAY)) != 0) *why = check_geometric(store);
    if (goes_on() && (what & NETMESH_CHECK_DELAUNAY) != 0) *why = check_delaunay(store);
    if (goes_on() && (what & NETMESH_CHECK_QUALITY) != 0 && context.mesh.is_mesh)
        status = check_promises(context, store, promises, monitor, why);
    if (goes_on() && (what & NETMESH_CHECK_BOUNDS) != 0) status = check_bounds(context, store, promises, monitor, why);
    return why->violation != nullptr ? Status::check_failed : status;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" netmesh_status netmesh_check(netmesh_context* context, const netmesh_check_request* from) {
    netmesh_check_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    if (request.what == 0) request.what = NETMESH_CHECK_ALL;
    if ((request.what & ~static_cast<uint32_t>(NETMESH_CHECK_ALL)) != 0)
        return refuse(context, NETMESH_FIELD_WHAT, "unknown checks");
    if (!context->mesh.present) return finish(context, Status::no_result, "there is no triangulation or mesh");
    if (context->input.weighting != NETMESH_WEIGHTING_NONE &&
        (request.what & ~(NETMESH_CHECK_COMBINATORIAL | NETMESH_CHECK_GEOMETRIC)) != 0)
        return refuse(context, NETMESH_FIELD_WHAT,
                      "with weights the triangulation is not Delaunay; ask for COMBINATORIAL and GEOMETRIC alone");
    Promises promises;
    ErrorSizes sizes;
    const Complaint complaint = read_promises(context, request.promised, context->input.dim, &promises, &sizes);
    if (complaint.text != nullptr) return refuse(context, complaint);
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context->arena, monitor);
    CheckResult why = {nullptr, 0};
    const Status found = check(*context, request.what, promises, monitor, &why);
    return finish(context, watch.heed(found), why.violation, why.violation != nullptr ? why.cell : 0);
}
