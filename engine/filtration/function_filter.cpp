#include "filtration/function_filter.hpp"

#include "certificate/cells.hpp"
#include "certificate/certificate.hpp"
#include "mesh/clip/clipped_reach.hpp"
#include "vocabulary/callback.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

double input_distance(const AnyInputTree& tree, NeighbourDistance distance, const double* x, Neighbour* scratch) {
    const std::uint32_t k = distance.k;
    tree.nearest_k(x, k, scratch);
    if (distance.kind == InputDistance::kth) return square_root(scratch[k - 1].distance2);
    double sum = 0;
    for (std::uint32_t i = 0; i < k; ++i) sum += scratch[i].distance2;
    return square_root(sum / k);
}

Status distance_filter(const AnyMesh& mesh, NeighbourDistance distance, FilterValues values, const Work& work,
                       Evaluation* out) {
    const ArenaScope scope(work.arena);
    const AnyStore& store = mesh.store;
    const std::uint32_t count = mesh.vertices();
    double* const out_radius = work.arena.take_high<double>(count);
    Neighbour* const neighbours = work.arena.take_high<Neighbour>(distance.k);
    AnyInputTree tree;
    if (out_radius == nullptr || neighbours == nullptr || tree.build(store, work.arena, mesh.inputs) != Status::ok)
        return Status::out_of_memory;
    work.monitor.begin(NETMESH_STAGE_CERTIFY, count);
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = work.arena.piece(v, count, 1); v < piece; ++v) {
            out->value[v] = input_distance(tree, distance, store.point(v), neighbours);
            if (work.monitor.advance(v, 10 + distance.k)) return Status::cancelled;
        }
    measure_cells(store, out_radius, nullptr);
    // The root mean square of k distances: the sum of their squares has D + 2 roundings in each and k - 1 of its own,
    // then come a quotient and a root, (k + D + 2) / 2 + 1 in all. D <= 6.
    const double doubt = (distance.k + 16.0) * unit_roundoff;
    const auto interval = [&](VertexId v) {
        work.arena.step(v, 60);
        const double most = out->value[v] * (1 + doubt), least = out->value[v] * (1 - doubt);
        return cut_at(mesh.cut, store.vertex(v).marker == Marker::exempt
                                    ? unbounded_interval(least)
                                    : Interval{least_distance(least, out_radius[v]), (most + out_radius[v]) * up});
    };
    out->certificate = clamp_values(count, mesh.cut, values, interval, out->value, out->interval);
    return Status::ok;
}

namespace {

// Away from 0 by a hair, or towards it.
double raised(double x) { return x * (x > 0 ? up : down); }
// f and a change, which may be none and is rounded outwards itself: the sum is off by less than a unit in the last
// place, however much larger than the change f is.
double more(double f, double change) {
    const double sum = f + change;
    return change > 0 && sum < infinity ? next_up(sum) : sum;
}
double less(double f, double change) { return change > 0 ? -more(-f, change) : f; }

// The intervals of F = min(f, cut) on the cells of a mesh, from f at its vertices.
class FunctionRange {
public:
    FunctionRange(const AnyMesh& mesh, const LipschitzBounds& bounds, const double* out_radius,
                  const ClippedReach* reach)
        : mesh_(mesh), bounds_(bounds), out_radius_(out_radius), reach_(reach),
          share_(bounds.distance_factor > 0 ? down / (1 + bounds.distance_factor * bounds.lipschitz * up) * down : 0),
          beyond_((2 * mesh.domain.radius + mesh.domain.enclosing_radius) * up),
          floor_(less(bounds.cut, change(mesh.domain.radius))) {}

    // May f be at v what it is, where it is the cut or more on the domain's sphere? To 2^-30, for f's own roundings.
    bool is_possible(VertexId v, double f) const {
        const double radius = mesh_.domain.radius,
                     inside = radius - square_root(mesh_.domain.distance2(mesh_.store.point(v)));
        return !(f < bounds_.cut - change(inside) - 0x1p-30 * (absolute(bounds_.cut) + change(radius)));
    }

    // Is v's cell outside the domain? Yes when v is farther from all of the domain than some input is, as the frame is.
    bool is_outside(VertexId v) const {
        const double away = square_root(mesh_.domain.distance2(mesh_.store.point(v))) * down;
        return away > beyond_ || away - out_radius_[v] > mesh_.domain.radius * up;
    }
    // `by_sphere`: is the domain's sphere heeded?
    Interval range(VertexId v, double f, bool by_sphere) const {
        const double cut = bounds_.cut;
        if (is_outside(v)) return {cut, cut};
        double lo = less(f, change(reach_[v].from_vertex));
        if (share_ > 0 && f > 0 && !(lo > f * share_)) lo = f * share_;
        const double below = less(cut, change(reach_[v].below));
        if (by_sphere && below > lo) lo = below;
        if (by_sphere && !(lo > floor_)) lo = floor_;
        if (lo > f) lo = f;  // where f is as far below the cut as it can be; v is in its cell
        return cut_at(cut, {lo, more(f, change(out_radius_[v]))});
    }

private:
    double change(double distance) const { return distance > 0 ? bounds_.lipschitz * distance * up : 0; }

    const AnyMesh& mesh_;
    const LipschitzBounds& bounds_;
    const double* const out_radius_;
    const ClippedReach* const reach_;
    const double share_, beyond_, floor_;
};

}  // namespace

Status clamp_function(const AnyMesh& mesh, const LipschitzBounds& bounds, FilterValues values, Arena& arena,
                      Evaluation* out) {
    const ArenaScope scope(arena);
    double* const value = out->value;
    const std::uint32_t count = mesh.vertices();
    double* const out_radius = arena.take_high<double>(count);
    ClippedReach* const reach = arena.take_high<ClippedReach>(count);
    Interval* const range = arena.take_high<Interval>(count);
    if (out_radius == nullptr || reach == nullptr || range == nullptr) return Status::out_of_memory;
    measure_cells(mesh.store, out_radius, nullptr);
    const Status status = bound_clipped_cells(mesh.store, mesh.domain, out_radius, arena, reach);
    if (status != Status::ok) return status;
    const FunctionRange range_of(mesh, bounds, out_radius, reach);
    bool is_possible = true, is_positive = true;
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = arena.piece(v, count, 40); v < piece; ++v) {
            is_possible &= range_of.is_possible(v, value[v]);
        }
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = arena.piece(v, count, 40); v < piece; ++v) {
            range[v] = range_of.range(v, value[v], is_possible);
            is_positive &= range[v].lo > 0;
            if (range_of.is_outside(v)) value[v] = bounds.cut;
        }
    Certificate& certificate = out->certificate = {};
    const auto interval = [&](VertexId v) {
        arena.step(v, 30);
        return range[v];
    };
    if (is_positive) {
        certificate = clamp_values(count, bounds.cut, values, interval, value, nullptr);
    } else {
        certificate.ratio = certificate.ratio_best = infinity;
        for (VertexId v(0); v < count;)
            for (const std::uint64_t piece = arena.piece(v, count, 40); v < piece; ++v) {
                if (!(value[v] < bounds.cut)) value[v] = bounds.cut;
            }
    }
    if (!is_possible) certificate.error = infinity;
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = arena.piece(v, count, 40); v < piece; ++v) {
            const double above = raised(range[v].hi - value[v]), below = raised(value[v] - range[v].lo);
            if (!(above <= certificate.error)) certificate.error = above;
            if (!(below <= certificate.error)) certificate.error = below;
            if (out->interval != nullptr) out->interval[v] = range[v];
        }
    return Status::ok;
}

Status function_filter(const AnyMesh& mesh, const netmesh_function& function, FilterValues values, const Work& work,
                       Evaluation* out) {
    work.monitor.begin(NETMESH_STAGE_CERTIFY, mesh.vertices());
    for (VertexId v(0); v < mesh.vertices(); ++v) {
        const double f = out->value[v] = value_at(function, mesh.store.point(v));
        out->culprit = v;
        if (!is_finite(f)) return Status::not_finite;
        if (work.monitor.advance(v, 10)) return Status::cancelled;
    }
    const LipschitzBounds bounds = {function.lipschitz, function.distance_factor, function.cut};
    return clamp_function(mesh, bounds, values, work.arena, out);
}

}  // namespace netmesh
