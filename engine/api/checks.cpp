#include "analysis/fatness.hpp"
#include "analysis/size.hpp"
#include "api/dispatch.hpp"
#include "delaunay/load.hpp"
#include "filtration/filters.hpp"
#include "mesh/input_tree.hpp"

namespace netmesh {
namespace {

// Room for the rounding of a ratio, when the mesh was made elsewhere.
constexpr double ratio_tolerance = 0x1p-40;

template <int D> CheckResult check_markers(const Store<D>& store) {
    for (std::uint32_t c = 0; c < store.state.cell_slots; ++c)
        for (int i = 0; i <= D; ++i) {
            if (store.cell(c).neighbour[i] != none) continue;
            for (int j = 0; j <= D; ++j)
                if (j != i && store.vertex(store.cell(c).vertex[j]).marker != Marker::exempt)
                    return {"a vertex of the mesh's hull is not exempt", c};
        }
    return {nullptr, none};
}

// Quality by definition 4.5 where there are cages, of each clipped cell and its size where there are none.
template <int D>
Status check_quality(Context& context, Store<D>& store, double tau, const SizeRule& rule, CheckResult* why) {
    *why = check_markers<D>(store);
    if (why->violation != nullptr) return Status::check_failed;
    const Domain<D> domain = domain_of<D>(context);
    HierarchyQuality quality = {};
    Status status =
        context.hierarchy.cages == 0
            ? recomputed_aspect_ratio<D>(store, domain, context.arena, &quality.worst, &quality.vertex)
            : measure_hierarchy<D>(store, cages_of(context), context.hierarchy.cages, domain, context.arena, &quality);
    if (status != Status::ok) return status;
    *why = quality.encroached;
    if (why->violation != nullptr) return Status::check_failed;
    if (!(quality.worst <= tau * (1 + ratio_tolerance))) {
        *why = {"a clipped Voronoi cell has an aspect ratio above tau", quality.vertex};
        return Status::check_failed;
    }
    if (context.hierarchy.cages > 0) return Status::ok;
    double worst;
    status = worst_size_ratio<D>(store, domain, context.inputs, rule, Corners::recomputed, context.arena, &worst,
                                 &why->cell);
    if (status != Status::ok || worst <= 1 + ratio_tolerance) return status;
    why->violation = "a clipped Voronoi cell is larger than the size asked for";
    return Status::check_failed;
}

// What refinement by the certificate promises, from the bounds of every cell.
template <int D> Status check_ratio(Context& context, Store<D>& store, const RatioGoal& goal, CheckResult* why) {
    *why = check_markers<D>(store);
    if (why->violation != nullptr) return Status::check_failed;
    const ArenaScope scope(context.arena);
    double* const value = context.arena.take_high<double>(store.state.vertex_count);
    Interval* const interval = context.arena.take_high<Interval>(store.state.vertex_count);
    if (value == nullptr || interval == nullptr) return Status::out_of_memory;
    Evaluation complete = {value, interval};
    Monitor unwatched;
    const Status status =
        evaluate<D>({store, domain_of<D>(context), context.inputs},
                    {NETMESH_FILTER_COMPLETE, FilterValues::certified}, {context.arena, unwatched}, &complete);
    if (status != Status::ok) return status;
    for (std::uint32_t v = 0; v < store.state.vertex_count && why->violation == nullptr; ++v) {
        const Interval& i = interval[v];
        const double ratio = square_root(i.hi / i.lo) * (1 - ratio_tolerance);
        const bool focused =
            goal.focus > 0 && store.vertex(v).marker == Marker::steiner && i.hi > goal.from && i.lo < goal.to;
        if (ratio > goal.ratio) *why = {"the certified ratio is above the one asked for", v};
        if (focused && ratio > goal.focus) *why = {"a cell's ratio is above the one asked for at its scale", v};
    }
    return why->violation == nullptr ? Status::ok : Status::check_failed;
}

// What chapters 3 (of meshes without cages, which may be smaller than its lower bound) and 5 say about sizes and degrees.
template <int D>
Status check_bounds(Store<D>& store, const Context& context, const netmesh_options& options, Arena& arena,
                    CheckResult* why) {
    Monitor monitor = monitor_of(options);
    monitor.begin(NETMESH_STAGE_ANALYSE, 0);
    Status status = Status::ok;
    if (context.is_mesh && context.hierarchy.cages == 0 && context.tau > 0) {
        SizeAnalysis size;
        status = analyse_size<D>(store, domain_of<D>(context), context.inputs,
                                 {tau_of(options), size_rule_of(options), infinity, 0}, {arena, monitor}, &size);
        if (status == Status::ok) why->violation = violated_size_bound(size);
    }
    if (status != Status::ok || why->violation != nullptr) return status;
    FatnessAnalysis fatness;
    status = analyse_fatness<D>(store, domain_of<D>(context), {arena, monitor}, &fatness);
    if (status != Status::ok) return status;
    why->violation = violated_fatness_bound(fatness.bounded);
    if (why->violation == nullptr) why->violation = violated_fatness_bound(fatness.inside);
    return Status::ok;
}

// Nearest inputs of all vertices; inputs come first.
template <int D> Status find_origins(Store<D>& store, std::uint32_t inputs) {
    ArenaScope scope(store.arena);
    InputTree<D> tree;
    if (tree.build(store, store.arena, inputs) != Status::ok) return Status::out_of_memory;
    std::uint32_t last = 0;
    for (std::uint32_t v = inputs; v < store.state.vertex_count; ++v) {
        double d2;
        store.vertex(v).origin = last = tree.nearest(store.point(v), last, none, &d2);
    }
    return Status::ok;
}

bool are_markers_valid(const uint8_t* markers, size_t count, std::uint32_t* inputs) {
    *inputs = 0;
    for (size_t v = 0; v < count; ++v) {
        if (markers[v] > 2) return false;
        if (markers[v] != 0) continue;
        if (*inputs != v) return false;
        ++*inputs;
    }
    return true;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_load(netmesh_context* context, const double* vertices, const uint8_t* markers,
                            size_t vertex_count, const uint32_t* cells, size_t cell_count, const double* domain,
                            const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    const auto refuse = [&](const char* message, std::uint64_t position) {
        return finish(context, Status::invalid_argument, message, position);
    };
    if (vertices == nullptr || vertex_count == 0) return refuse("there are no vertices", 2);
    std::uint32_t inputs;
    if (markers == nullptr || !are_markers_valid(markers, vertex_count, &inputs))
        return refuse("markers are not 0, 1 or 2 with the inputs first", 3);
    if (inputs == 0) return refuse("there is no input vertex", 3);
    if (vertex_count > (size_t{1} << 28)) return refuse("more than 2^28 vertices", 4);
    if (cells == nullptr || cell_count == 0) return refuse("there are no cells", 5);
    if (cell_count > Store<2>::slots_max) return refuse("more than 2^29 cells", 6);
    if (!usable(options)) return refuse("options are not initialised or the dimension is not 2..6", 8);
    for (size_t i = 0; i < vertex_count * options->dim; ++i)
        if (!is_finite(vertices[i]))
            return finish(context, Status::not_finite, "a coordinate is not a finite number", i / options->dim);
    if (domain != nullptr)
        for (std::uint32_t k = 0; k <= options->dim; ++k)
            if (!is_finite(domain[k]) || (k == options->dim && !(domain[k] > 0))) return refuse("bad domain ball", 7);
    clear(context);
    return with_dimension(options->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Store<D> store(context->arena, context->store);
        CheckResult why;
        Status status = load_cells<D>(store, vertices, static_cast<std::uint32_t>(vertex_count), cells,
                                      static_cast<std::uint32_t>(cell_count), &why);
        if (status == Status::ok) {
            for (size_t v = 0; v < vertex_count; ++v)
                store.vertex(static_cast<std::uint32_t>(v)).marker = static_cast<Marker>(markers[v]);
            status = find_origins<D>(store, inputs);
        }
        if (status != Status::ok) {
            const std::uint64_t wanted = context->arena.bytes_wanted();
            clear(context);
            finish(context, status,
                   why.violation != nullptr ? why.violation : netmesh_status_text(NETMESH_OUT_OF_MEMORY), why.cell);
            if (status == Status::out_of_memory) context->detail.bytes_wanted = wanted;
            return context->detail.status;
        }
        context->dim = D;
        context->complete = true;
        context->is_mesh = domain != nullptr;
        context->is_loaded = true;
        context->points = context->inputs = inputs;
        context->duplicates = 0;
        context->input_fingerprint = 0;
        context->mesh_mark = context->arena.low_mark();
        context->tau = options->ratio > 0 ? 0 : tau_of(*options);
        context->goal = goal_of(*options);
        context->over_refine_eps = options->over_refine_eps;
        context->aspect_ratio_max = context->size_ratio_max = 0;
        if (domain != nullptr) {
            Domain<D> ball;
            smallest_enclosing_ball<D>(store, inputs, ball);
            context->enclosing_radius = 0;
            for (int k = 0; k < D; ++k) context->domain_centre[k] = ball.centre[k] = domain[k];
            for (std::uint32_t v = 0; v < inputs; ++v) {
                const double r = square_root(ball.distance2(store.point(v))) * (1 + 8 * unit_roundoff);
                if (r > context->enclosing_radius) context->enclosing_radius = r;
            }
            if (context->enclosing_radius == 0) context->enclosing_radius = ball.enclosing_radius;
            context->domain_radius = domain[D];
            HierarchyQuality quality;
            std::uint32_t worst;
            if (measure_mesh<D>(*context, store, &quality) != Status::ok ||
                worst_size_ratio<D>(store, domain_of<D>(*context), inputs, size_rule_of(*options), Corners::kept,
                                    context->arena, &context->size_ratio_max, &worst) != Status::ok) {
                clear(context);
                return finish(context, Status::out_of_memory, netmesh_status_text(NETMESH_OUT_OF_MEMORY));
            }
            context->aspect_ratio_max = quality.worst;
        }
        return finish(context, Status::ok, "");
    });
}

netmesh_status netmesh_measure_cells(netmesh_context* context, double* ratios, uint32_t* domains) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (ratios == nullptr || domains == nullptr)
        return finish(context, Status::invalid_argument, "an array is null", ratios == nullptr ? 2 : 3);
    if (context->dim == 0 || !context->is_mesh) return finish(context, Status::no_result, "there is no mesh");
    return with_dimension(context->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Store<D> store(context->arena, context->store);
        HierarchyQuality quality;
        const Status status = measure_hierarchy<D>(store, cages_of(*context), context->hierarchy.cages,
                                                   domain_of<D>(*context), context->arena, &quality, ratios, domains);
        return finish(context, status, netmesh_status_text(static_cast<netmesh_status>(status)));
    });
}

netmesh_status netmesh_load_cages(netmesh_context* context, const netmesh_cage* cages, size_t count,
                                  const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (cages == nullptr && count > 0) return finish(context, Status::invalid_argument, "cages is null", 2);
    if (count >= NETMESH_NONE) return finish(context, Status::invalid_argument, "too many cages", 3);
    if (!usable(options)) return finish(context, Status::invalid_argument, "options are not initialised", 4);
    if (context->dim == 0 || !context->is_mesh)
        return finish(context, Status::no_result, "there is no mesh with a domain");
    clear_diagram(context);
    context->hierarchy = HierarchyCounts{};
    context->mesh_audit = MeshAudit{};
    Cage* const kept = context->arena.take_low<Cage>(count);
    if (kept == nullptr) return finish(context, Status::out_of_memory, netmesh_status_text(NETMESH_OUT_OF_MEMORY));
    for (size_t d = 0; d < count; ++d) kept[d] = {cages[d].centre, none, none, none, cages[d].radius, infinity};
    return with_dimension(context->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Store<D> store(context->arena, context->store);
        HierarchyQuality quality = {};
        const Status status = measure_hierarchy<D>(store, kept, static_cast<std::uint32_t>(count),
                                                   domain_of<D>(*context), context->arena, &quality);
        if (status != Status::ok || !quality.is_hierarchy) {
            context->arena.release_low(context->mesh_mark);
            const char* const why =
                status != Status::ok ? netmesh_status_text(NETMESH_OUT_OF_MEMORY) : quality.encroached.violation;
            return finish(context, status != Status::ok ? status : Status::check_failed, why, quality.encroached.cell);
        }
        context->cages_offset = context->arena.offset_of(kept);
        context->hierarchy.cages = static_cast<std::uint32_t>(count);
        context->mesh_mark = context->arena.low_mark();
        context->aspect_ratio_max = quality.worst;
        return finish(context, Status::ok, "");
    });
}

netmesh_status netmesh_check(netmesh_context* context, uint32_t what, const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (what == 0 || (what & ~static_cast<uint32_t>(NETMESH_CHECK_ALL)) != 0)
        return finish(context, Status::invalid_argument, "unknown checks", 2);
    if (!usable(options)) return finish(context, Status::invalid_argument, "options are not initialised", 3);
    if (context->dim == 0 || context->store.cell_slots == 0)
        return finish(context, Status::no_result, "there is no triangulation or mesh");
    return with_dimension(context->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        Store<D> store(context->arena, context->store);
        CheckResult why = check_combinatorial<D>(store);  // of every kind of check
        Status status = Status::ok;
        if (why.violation == nullptr && (what & (NETMESH_CHECK_GEOMETRIC | NETMESH_CHECK_DELAUNAY)) != 0)
            why = check_geometric<D>(store);
        if (why.violation == nullptr && (what & NETMESH_CHECK_DELAUNAY) != 0) why = check_delaunay<D>(store);
        if (why.violation == nullptr && (what & NETMESH_CHECK_QUALITY) != 0 && context->is_mesh)
            status = options->ratio > 0
                         ? check_ratio<D>(*context, store, goal_of(*options), &why)
                         : check_quality<D>(*context, store, tau_of(*options), size_rule_of(*options), &why);
        if (status == Status::ok && why.violation == nullptr && (what & NETMESH_CHECK_BOUNDS) != 0)
            status = check_bounds<D>(store, *context, *options, context->arena, &why);
        if (why.violation != nullptr) return finish(context, Status::check_failed, why.violation, why.cell);
        return finish(context, status, netmesh_status_text(static_cast<netmesh_status>(status)));
    });
}

}  // extern "C"
