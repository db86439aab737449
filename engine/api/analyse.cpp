// Analyses of the triangulation or mesh that the context holds, and orderings of its inputs.
#include "api/figures.hpp"
#include "api/measure.hpp"
#include "api/request.hpp"
#include "laboratory/fatness.hpp"
#include "laboratory/pacing.hpp"
#include "laboratory/size.hpp"
#include "laboratory/structure.hpp"
#include "mesh/input_tree.hpp"

namespace netmesh {
namespace {

constexpr std::uint64_t boxes_max = std::uint64_t{1} << 22;

void give_size(const SizeAnalysis& from, netmesh_size_analysis* to) {
    to->present = 1;
    to->vertices = from.size;
    to->lower = from.size_lower;
    to->upper = from.size_upper;
    to->feature_ratio = from.feature_ratio;
    to->feature_ratio_bound = from.feature_ratio_bound;
    to->theta = from.theta;
    to->theta_limit = from.theta_limit;
    to->theta_log_sum = from.theta_log_sum;
    for (int k = 0; k < FeatureIntegral::balls_max; ++k) {
        to->radii[k] = from.radius[k];
        to->integral_lower[k] = from.integral.lower[k];
        to->integral_upper[k] = from.integral.upper[k];
    }
    to->pace_lower = from.pace_lower;
    to->pace_upper = from.pace_upper;
    to->boxes = from.integral.boxes;
    to->upper_over_lower = from.size_lower > 0 ? from.size_upper / from.size_lower : infinity;
}

void give_boundary(const StructureAnalysis& from, netmesh_boundary_analysis* to) {
    to->present = 1;
    to->vertices = from.hull_vertices;
    to->degree_max = from.hull_degree_max;
    to->balls = from.hull_balls;
    to->intersections_max = from.hull_intersections_max;
}

void give_structure(const StructureAnalysis& from, netmesh_structure_analysis* to) {
    to->present = 1;
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
    to->ply_stride = from.ply_stride;
    to->balls_stride = from.balls_stride;
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

void give_fatness(const FatnessAnalysis& from, netmesh_fatness_analysis* to) {
    to->present = 1;
    to->bounded = fatness_of(from.bounded);
    to->inside = fatness_of(from.inside);
    to->clipped_cells = from.clipped;
    to->clipped_beta_max = from.clipped_max;
    to->clipped_beta_mean = from.clipped_mean;
}

void give_all_cells(const FatnessAnalysis& from, netmesh_all_cells_analysis* to) {
    to->present = 1;
    to->cells = fatness_of(from.all);
    to->left_out = from.left_out;
    to->radius = from.all_radius;
}

template <int D>
Status analyse_sizes(Context& context, Store<D>& store, const Promises& promises, double tolerance, const Work& work,
                     netmesh_size_analysis* to) {
    SizeAnalysis size;
    const double wanted = tolerance > 0 ? tolerance : figures<D>.integral_tolerance;
    const Status status = analyse_size(store, domain_of<D>(context.mesh), context.input.distinct,
                                       {promises.tau, promises.sizes, wanted, boxes_max, cages_of(context),
                                        cage_count_of(context), context.mesh.cage_kind},
                                       work, &size);
    if (status != Status::ok) return status;
    if (context.mesh.goal.ratio > 0) {  // no quality is promised, which is what lets a mesh be smaller
        size.size_lower = 0;
        size.size_upper = size.feature_ratio_bound = infinity;
    }
    give_size(size, to);
    to->domains = std::uint64_t{cage_count_of(context)} + 1;
    return status;
}

template <int D>
Status analyse(Context& context, const netmesh_analyse_request& request, const Promises& promises,
               netmesh_analysis* analysis) {
    Monitor monitor = monitor_of(request.monitor);
    const Watch watch(context.arena, monitor);
    const Work work = {context.arena, monitor};
    Store<D> store(context.arena, context.mesh.store);
    const Domain<D> domain = domain_of<D>(context.mesh);
    monitor.begin(NETMESH_STAGE_ANALYSE, 0);
    Status status = Status::ok;
    if ((request.what & NETMESH_ANALYSE_SIZE) != 0)
        status = analyse_sizes<D>(context, store, promises, request.tolerance, work, &analysis->size);
    if (status == Status::ok && (request.what & NETMESH_ANALYSE_STRUCTURE) != 0) {
        StructureAnalysis structure;
        status = analyse_structure<D>(store, domain.centre, domain.radius, work, &structure);
        if (status == Status::ok) {
            give_structure(structure, &analysis->structure);
            give_boundary(structure, &analysis->boundary);
        }
    }
    if (status == Status::ok && (request.what & NETMESH_ANALYSE_FATNESS) != 0) {
        FatnessAnalysis fatness;
        status = analyse_fatness<D>(store, domain, work, &fatness);
        if (status == Status::ok) {
            give_fatness(fatness, &analysis->fatness);
            give_all_cells(fatness, &analysis->all_cells);
        }
    }
    return watch.heed(status);
}

const char* const no_triangulation = "there is no triangulation or mesh";

// False: not a permutation of 0 .. count-1. Scratch: `seen`, a byte each.
bool is_permutation(const std::uint32_t* order, std::uint32_t count, std::uint8_t* seen) {
    for (std::uint32_t i = 0; i < count; ++i) seen[i] = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (order[i] >= count || seen[order[i]] != 0) return false;
        seen[order[i]] = 1;
    }
    return true;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_analyse(netmesh_context* context, const netmesh_analyse_request* from,
                               netmesh_analysis* analysis) {
    netmesh_analyse_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    if (request.what == 0) request.what = NETMESH_ANALYSE_ALL;
    if ((request.what & ~static_cast<uint32_t>(NETMESH_ANALYSE_ALL)) != 0)
        return refuse(context, NETMESH_FIELD_WHAT, "unknown analyses");
    if (!(request.tolerance >= 0)) return refuse(context, NETMESH_FIELD_TOLERANCE, "tolerance is negative");
    if (!has_room(analysis)) return refuse(context, NETMESH_FIELD_RESULT, "analysis is null or its size is not set");
    if (!context->mesh.present) return finish(context, Status::no_result, no_triangulation);
    if (context->input.weighting != NETMESH_WEIGHTING_NONE) return finish(context, Status::no_result, weighted_cells);
    if ((request.what & NETMESH_ANALYSE_SIZE) != 0 && !context->mesh.is_mesh)
        return finish(context, Status::no_result, "the size analysis needs a mesh");
    Promises promises;
    ErrorSizes sizes;
    const Complaint complaint = read_promises(context, request.promised, context->input.dim, &promises, &sizes);
    if (complaint.text != nullptr) return refuse(context, complaint);
    netmesh_analysis found = {};
    found.what = request.what;
    const Status status = with_dimension(context->input.dim, [&](auto dimension) {
        return analyse<decltype(dimension)::value>(*context, request, promises, &found);
    });
    if (status == Status::ok) found.fingerprint = fingerprint_of(found);
    give_result(found, analysis);
    return finish(context, status);
}

netmesh_status netmesh_well_paced_order(netmesh_context* context, uint32_t* order, double* theta) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (order == nullptr) return refuse(context, NETMESH_FIELD_ORDER, "order is null");
    if (!context->mesh.present) return finish(context, Status::no_result, no_triangulation);
    if (context->input.weighting != NETMESH_WEIGHTING_NONE) return finish(context, Status::no_result, weighted_cells);
    const std::uint32_t inputs = context->input.distinct;
    const ArenaScope scope(context->arena);
    const AnyStore store(static_cast<int>(context->input.dim), context->arena, context->mesh.store);
    AnyInputTree tree;
    Monitor monitor;
    Status status = tree.build(store, context->arena, inputs);
    if (status == Status::ok) status = farthest_first_order(store, tree, inputs, {context->arena, monitor}, order);
    if (status == Status::ok && theta != nullptr)
        status = pace(store, tree, order, inputs, {context->arena, monitor}, theta);
    return finish(context, status);
}

netmesh_status netmesh_pace(netmesh_context* context, const uint32_t* order, double* theta) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    if (order == nullptr) return refuse(context, NETMESH_FIELD_ORDER, "order is null");
    if (theta == nullptr) return refuse(context, NETMESH_FIELD_THETAS, "theta is null");
    if (!context->mesh.present) return finish(context, Status::no_result, no_triangulation);
    if (context->input.weighting != NETMESH_WEIGHTING_NONE) return finish(context, Status::no_result, weighted_cells);
    const std::uint32_t inputs = context->input.distinct;
    const ArenaScope scope(context->arena);
    std::uint8_t* const seen = context->arena.take_low<std::uint8_t>(inputs);
    if (seen == nullptr) return finish(context, Status::out_of_memory);
    if (!is_permutation(order, inputs, seen))
        return refuse(context, NETMESH_FIELD_ORDER, "order is not a permutation of the inputs");
    const AnyStore store(static_cast<int>(context->input.dim), context->arena, context->mesh.store);
    AnyInputTree tree;
    Monitor monitor;
    Status status = tree.build(store, context->arena, inputs);
    if (status == Status::ok) status = pace(store, tree, order, inputs, {context->arena, monitor}, theta);
    return finish(context, status);
}

}  // extern "C"
