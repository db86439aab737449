#include "laboratory/size.hpp"

#include "laboratory/hierarchy_size.hpp"
#include "laboratory/pacing.hpp"
#include "mesh/check/quality.hpp"
#include "mesh/loop/split.hpp"
#include "numerics/elementary.hpp"
#include "numerics/vector.hpp"

namespace netmesh {
namespace {

constexpr double bound_tolerance = 0x1p-15;  // of tau and of distances, where a bound is compared

// Distance from vertex v to its second nearest input, v itself counted when it is one.
double feature_size_at(const AnyStore& store, const AnyInputTree& tree, std::uint32_t v) {
    const AnyVertex vertex = store.vertex(v);
    double d2;
    tree.nearest(vertex.x, none, vertex.marker == Marker::input ? v : vertex.origin, &d2);
    return square_root(d2);
}

// |M|, the feature ratio and how far in-balls reach from the domain's centre.
Status measure_vertices(const AnyStore& store, const AnyDomain& domain, const AnyInputTree& tree, Arena& arena,
                        SizeAnalysis* analysis) {
    ArenaScope scope(arena);
    double* const nearest2 = arena.take_high<double>(store.state.vertex_count);
    if (nearest2 == nullptr) return Status::out_of_memory;
    recomputed_nearest2(store, nearest2);
    double reach = domain.radius;
    for (std::uint32_t v = 0; v < store.state.vertex_count;)
        for (const std::uint64_t piece = arena.piece(v, store.state.vertex_count, 700 * store.dim); v < piece; ++v) {
            if (store.vertex(v).cell == none || store.vertex(v).marker == Marker::exempt) continue;
            ++analysis->size;
            const double nearest = square_root(nearest2[v]);
            const double ratio = feature_size_at(store, tree, v) / nearest;
            if (ratio > analysis->feature_ratio) analysis->feature_ratio = ratio;
            const double out = distance(store.dim, store.point(v), domain.centre) + 0.5 * nearest;
            if (out > reach) reach = out;
        }
    analysis->radius[ball_domain] = domain.radius;
    analysis->radius[ball_vertices] = reach;
    const double wide = 7 * domain.enclosing_radius;
    analysis->radius[ball_wide] = wide > reach ? wide : reach;
    return Status::ok;
}

// The theta_i of the farthest-first ordering and what they say about the wide integral.
Status measure_pace(const AnyStore& store, const AnyDomain& domain, const AnyInputTree& tree, std::uint32_t inputs,
                    const Work& work, SizeAnalysis* analysis) {
    ArenaScope scope(work.arena);
    const int dim = store.dim;
    std::uint32_t* const order = work.arena.take_high<std::uint32_t>(inputs);
    double* const theta = work.arena.take_high<double>(inputs);
    if (order == nullptr || theta == nullptr) return Status::out_of_memory;
    Status status = farthest_first_order(store, tree, inputs, work, order);
    if (status == Status::ok) status = pace(store, tree, order, inputs, work, theta);
    if (status != Status::ok) return status;
    const double first = distance(dim, store.point(order[0]), store.point(order[1]));
    const double c = (distance(dim, store.point(order[0]), domain.centre) + analysis->radius[ball_wide]) / first;
    // 3.8.3 is V_D (1 + D ln(2c)); 3.8.5 adds 1 + D ln(3D / theta_i), 3.8.6 at least D ln(1 / theta_i) / 3^D +
    // theta_i^D - 1.
    double lower = 0, upper = 1 + dim * logarithm(2 * c);
    for (std::uint32_t i = 2; i < inputs;)
        for (const std::uint64_t piece = work.arena.piece(i, inputs, 200); i < piece; ++i) {
            const double log_inverse = -logarithm(theta[i]);
            const double gain = dim * log_inverse / power(3, dim) + power(theta[i], dim) - 1;
            analysis->theta_log_sum += log_inverse;
            if (theta[i] < analysis->theta) analysis->theta = theta[i];
            if (gain > 0) lower += gain;
            upper += 1 + dim * (log_inverse + logarithm(3.0 * dim));
        }
    const double t = analysis->theta;
    if (inputs > 2 && 5 * t < 1) analysis->theta_limit = 2 * t / (1 - 3 * t);
    analysis->pace_lower = unit_ball_volume(dim) * lower * (1 - bound_tolerance);
    analysis->pace_upper = unit_ball_volume(dim) * upper * (1 + bound_tolerance);
    return Status::ok;
}

// With cages; the theorems of chapter 3 on distances are about meshes without.
Status sum_domains(const AnyStore& store, const AnyDomain& domain, std::uint32_t inputs, const SizeOptions& options,
                   const Work& work, SizeAnalysis* analysis) {
    DomainSum sum;
    const Status status = sum_over_domains(
        store, {domain, options.cages, options.cage_count, inputs, options.tau, options.tolerance, options.boxes_max},
        work, &sum);
    analysis->size = sum.size;
    analysis->integral.boxes += sum.boxes;
    analysis->feature_ratio = sum.feature_ratio;
    analysis->feature_ratio_bound = infinity;
    analysis->size_lower = sum.lower;
    analysis->size_upper = sum.upper;
    return status;
}

}  // namespace

double feature_ratio_bound(double tau, const SizeRule& rule) {
    const double loss = 2 / (yield_radius * tau * (1 - bound_tolerance));
    if (rule.function != nullptr || rule.at_inputs > 0 || !(loss < 1)) return infinity;
    const double k = (2 + 1 / yield_radius) / (1 - loss);
    return rule.eps > 0 && rule.eps < 1 ? k / rule.eps : k;
}

Status analyse_size(const AnyStore& store, const AnyDomain& domain, std::uint32_t inputs, const SizeOptions& options,
                    const Work& work, SizeAnalysis* analysis) {
    *analysis = {};
    analysis->theta = analysis->theta_limit = 1;
    analysis->feature_ratio_bound = feature_ratio_bound(options.tau, options.rule);
    analysis->size_upper = infinity;
    ArenaScope scope(work.arena);
    AnyInputTree tree;
    if (tree.build(store, work.arena, inputs) != Status::ok) return Status::out_of_memory;
    Status status = measure_vertices(store, domain, tree, work.arena, analysis);
    if (status != Status::ok || inputs < 2) return status;
    status = measure_pace(store, domain, tree, inputs, work, analysis);
    if (status == Status::ok)
        status = feature_integral(
            store, tree,
            {domain.centre, analysis->radius, FeatureIntegral::balls_max, options.tolerance, options.boxes_max}, work,
            &analysis->integral);
    if (status != Status::ok) return status;
    if (options.cage_count > 0 && options.kind == CageKind::thesis) {
        analysis->feature_ratio_bound = infinity;
        return Status::ok;
    }
    if (options.cage_count > 0) return sum_domains(store, domain, inputs, options, work, analysis);
    const int dim = store.dim;
    const double volume = unit_ball_volume(dim);
    analysis->size_lower =
        analysis->integral.lower[ball_domain] / (volume * power(options.tau, dim)) * (1 - bound_tolerance);
    analysis->size_upper = analysis->integral.upper[ball_vertices] / volume *
                           power(2 * analysis->feature_ratio + 1, dim) * (1 + bound_tolerance);
    return Status::ok;
}

const char* violated_size_bound(const SizeAnalysis& a) {
    const double size = static_cast<double>(a.size);
    if (!(a.size_lower <= size)) return "fewer vertices than any mesh of this quality has (3.4.2)";
    if (!(size <= a.size_upper)) return "more vertices than their distances to each other allow (3.4.1)";
    if (a.integral.boxes > 0 && !(a.feature_ratio <= a.feature_ratio_bound))
        return "two vertices are nearer to each other than the feature size allows (3.3.2)";
    if (a.integral.boxes > 0 &&
        !(a.pace_lower <= a.integral.upper[ball_wide] && a.integral.lower[ball_wide] <= a.pace_upper))
        return "the feature size integral is not what the pace of the inputs says (3.8.1)";
    return nullptr;
}

}  // namespace netmesh
