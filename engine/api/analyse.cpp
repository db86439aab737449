#include "vocabulary/dimension.hpp"
#include "analysis/fatness.hpp"
#include "analysis/pacing.hpp"
#include "analysis/size.hpp"
#include "analysis/structure.hpp"
#include "api/dispatch.hpp"
#include "numerics/fingerprint.hpp"

namespace netmesh {
namespace {

constexpr std::uint64_t boxes_max = std::uint64_t{1} << 22;

void keep_size(const SizeAnalysis& from, netmesh_analysis* to) {
    to->size = from.size;
    to->size_lower = from.size_lower;
    to->size_upper = from.size_upper;
    to->feature_ratio = from.feature_ratio;
    to->feature_ratio_bound = from.feature_ratio_bound;
    to->theta = from.theta;
    to->theta_limit = from.theta_limit;
    to->theta_log_sum = from.theta_log_sum;
    for (int k = 0; k < FeatureIntegral::balls_max; ++k) {
        to->radius[k] = from.radius[k];
        to->integral_lower[k] = from.integral.lower[k];
        to->integral_upper[k] = from.integral.upper[k];
    }
    to->pace_lower = from.pace_lower;
    to->pace_upper = from.pace_upper;
    to->boxes = from.integral.boxes;
}

void keep_structure(const StructureAnalysis& from, netmesh_analysis* to) {
    to->degree_max = from.degree_max;
    to->degree_mean = from.degree_mean;
    to->star_max = from.star_max;
    to->star_mean = from.star_mean;
    to->ply_points = from.ply_points;
    to->ply_max = from.ply_max;
    to->ply_mean = from.ply_mean;
    to->balls = from.balls;
    to->intersections_max = from.intersections_max;
    to->intersections_mean = from.intersections_mean;
}

netmesh_fatness fatness_of(const FatPart& from) {
    netmesh_fatness to = {};
    to.cells = from.cells;
    to.beta_max = from.beta_max;
    to.beta_mean = from.beta_mean;
    to.aspect_ratio_max = from.aspect_max;
    to.edges = from.edges;
    to.degree_max = from.degree_max;
    to.edges_bound = from.edges_bound;
    to.faces = from.faces;
    to.faces_bound = from.faces_bound;
    to.degree_share = from.degree_share;
    to.planar_share = from.planar_share;
    to.corners_share = from.corners_share;
    return to;
}

void keep_fatness(const FatnessAnalysis& from, netmesh_analysis* to) {
    to->bounded = fatness_of(from.bounded);
    to->inside = fatness_of(from.inside);
    to->clipped_cells = from.clipped;
    to->clipped_beta_max = from.clipped_max;
    to->clipped_beta_mean = from.clipped_mean;
}

void add_fatness(Fingerprint* f, const netmesh_fatness& part) {
    f->add(part.cells);
    f->add(part.edges);
    f->add(part.degree_max);
    const double figures[] = {part.beta_max,    part.beta_mean,    part.aspect_ratio_max, part.edges_bound,  part.faces,
                              part.faces_bound, part.degree_share, part.planar_share,     part.corners_share};
    for (const double x : figures) f->add(x);
}

std::uint64_t fingerprint_of(const netmesh_analysis& a) {
    Fingerprint f;
    const std::uint64_t counts[] = {a.what,       a.size,    a.boxes, a.degree_max,        a.star_max,
                                    a.ply_points, a.ply_max, a.balls, a.intersections_max, a.clipped_cells};
    const double figures[] = {
        a.size_lower,  a.size_upper,    a.feature_ratio,      a.feature_ratio_bound, a.theta,
        a.theta_limit, a.theta_log_sum, a.pace_lower,         a.pace_upper,          a.degree_mean,
        a.star_mean,   a.ply_mean,      a.intersections_mean, a.clipped_beta_max,    a.clipped_beta_mean};
    for (const std::uint64_t count : counts) f.add(count);
    for (const double x : figures) f.add(x);
    for (int k = 0; k < 3; ++k) {
        f.add(a.radius[k]);
        f.add(a.integral_lower[k]);
        f.add(a.integral_upper[k]);
    }
    add_fatness(&f, a.bounded);
    add_fatness(&f, a.inside);
    return f.value();
}

template <int D>
Status analyse(netmesh_context* context, std::uint32_t what, double tolerance, const netmesh_options& options,
               netmesh_analysis* analysis) {
    Store<D> store(context->arena, context->store);
    Domain<D> domain = {};
    if (context->is_mesh) domain = domain_of<D>(*context);
    Monitor monitor = monitor_of(options);
    monitor.begin(NETMESH_STAGE_ANALYSE, 0);
    Status status = Status::ok;
    if ((what & NETMESH_ANALYSE_SIZE) != 0) {
        SizeAnalysis size;
        const double wanted = tolerance > 0 ? tolerance : figures<D>.integral_tolerance;
        status =
            analyse_size<D>(store, domain, context->inputs, {tau_of(options), size_rule_of(options), wanted, boxes_max},
                            {context->arena, monitor}, &size);
        if (context->hierarchy.cages > 0 || context->goal.ratio > 0) {
            // Cells are of quality in their own domains alone, or none is promised, which is what lets a mesh be smaller.
            size.size_lower = 0;
            size.size_upper = size.feature_ratio_bound = infinity;
        }
        if (status == Status::ok) keep_size(size, analysis);
    }
    if (status == Status::ok && (what & NETMESH_ANALYSE_STRUCTURE) != 0) {
        StructureAnalysis structure;
        status = analyse_structure<D>(store, domain.centre, domain.radius, {context->arena, monitor}, &structure);
        if (status == Status::ok) keep_structure(structure, analysis);
    }
    if (status == Status::ok && (what & NETMESH_ANALYSE_FATNESS) != 0) {
        FatnessAnalysis fatness;
        status = analyse_fatness<D>(store, domain, {context->arena, monitor}, &fatness);
        if (status == Status::ok) keep_fatness(fatness, analysis);
    }
    return status;
}

const char* text_of(Status status) { return netmesh_status_text(static_cast<netmesh_status>(status)); }

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_analyse(netmesh_context* context, uint32_t what, double tolerance,
                               const netmesh_options* options, netmesh_analysis* analysis) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (what == 0 || (what & ~static_cast<uint32_t>(NETMESH_ANALYSE_ALL)) != 0)
        return finish(context, Status::invalid_argument, "unknown analyses", 2);
    if (!(tolerance >= 0)) return finish(context, Status::invalid_argument, "tolerance is negative", 3);
    if (!usable(options)) return finish(context, Status::invalid_argument, "options are not initialised", 4);
    if (analysis == nullptr || analysis->struct_bytes != sizeof(netmesh_analysis))
        return finish(context, Status::invalid_argument, "analysis is null or its size is not set", 5);
    if (context->dim == 0 || context->store.cell_slots == 0)
        return finish(context, Status::no_result, "there is no triangulation or mesh");
    if ((what & NETMESH_ANALYSE_SIZE) != 0 && !context->is_mesh)
        return finish(context, Status::no_result, "the size analysis needs a mesh");
    *analysis = netmesh_analysis{};
    analysis->struct_bytes = sizeof(netmesh_analysis);
    analysis->what = what;
    const Status status = with_dimension(context->dim, [&](auto dimension) {
        return analyse<decltype(dimension)::value>(context, what, tolerance, *options, analysis);
    });
    if (status == Status::ok) analysis->fingerprint = fingerprint_of(*analysis);
    return finish(context, status, text_of(status));
}

netmesh_status netmesh_well_paced_order(netmesh_context* context, uint32_t* order, double* theta) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (order == nullptr) return finish(context, Status::invalid_argument, "order is null", 2);
    if (context->dim == 0 || context->store.cell_slots == 0)
        return finish(context, Status::no_result, "there is no triangulation or mesh");
    const Status status = with_dimension(context->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        ArenaScope scope(context->arena);
        const Store<D> store(context->arena, context->store);
        InputTree<D> tree;
        Monitor monitor;
        if (tree.build(store, context->arena, context->inputs) != Status::ok) return Status::out_of_memory;
        const Status ordered = farthest_first_order<D>(store, tree, context->inputs, {context->arena, monitor}, order);
        if (ordered != Status::ok || theta == nullptr) return ordered;
        return pace<D>(store, tree, order, context->inputs, {context->arena, monitor}, theta);
    });
    return finish(context, status, text_of(status));
}

netmesh_status netmesh_pace(netmesh_context* context, const uint32_t* order, double* theta) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (order == nullptr) return finish(context, Status::invalid_argument, "order is null", 2);
    if (theta == nullptr) return finish(context, Status::invalid_argument, "theta is null", 3);
    if (context->dim == 0 || context->store.cell_slots == 0)
        return finish(context, Status::no_result, "there is no triangulation or mesh");
    const Status status = with_dimension(context->dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        ArenaScope scope(context->arena);
        const Store<D> store(context->arena, context->store);
        InputTree<D> tree;
        Monitor monitor;
        const std::uint32_t inputs = context->inputs;
        std::uint8_t* const seen = context->arena.template take_low<std::uint8_t>(inputs);
        if (seen == nullptr) return Status::out_of_memory;
        for (std::uint32_t i = 0; i < inputs; ++i) seen[i] = 0;
        for (std::uint32_t i = 0; i < inputs; ++i) {
            if (order[i] >= inputs || seen[order[i]]) return Status::invalid_argument;
            seen[order[i]] = 1;
        }
        if (tree.build(store, context->arena, inputs) != Status::ok) return Status::out_of_memory;
        return pace<D>(store, tree, order, inputs, {context->arena, monitor}, theta);
    });
    if (status == Status::invalid_argument)
        return finish(context, status, "order is not a permutation of the inputs", 2);
    return finish(context, status, text_of(status));
}

}  // extern "C"
