#include "filtration/function_filter.hpp"

#include "certificate/cells.hpp"
#include "certificate/certificate.hpp"
#include "vocabulary/callback.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {

template <int D>
double input_distance(const InputTree<D>& tree, NeighbourDistance distance, const double* x, Neighbour* scratch) {
    const std::uint32_t k = distance.k;
    tree.nearest_k(x, k, scratch);
    if (distance.kind == InputDistance::kth) return square_root(scratch[k - 1].distance2);
    double sum = 0;
    for (std::uint32_t i = 0; i < k; ++i) sum += scratch[i].distance2;
    return square_root(sum / k);
}

template <int D>
Status distance_filter(const FilteredMesh<D>& mesh, NeighbourDistance distance, FilterValues values, const Work& work,
                       Evaluation* out) {
    const ArenaScope scope(work.arena);
    const Store<D>& store = mesh.store;
    const std::uint32_t count = mesh.vertices();
    double* const out_radius = work.arena.take_high<double>(count);
    Neighbour* const neighbours = work.arena.take_high<Neighbour>(distance.k);
    InputTree<D> tree;
    if (out_radius == nullptr || neighbours == nullptr || tree.build(store, work.arena, mesh.inputs) != Status::ok)
        return Status::out_of_memory;
    work.monitor.begin(NETMESH_STAGE_CERTIFY, count);
    for (VertexId v(0); v < count; ++v) {
        out->value[v] = input_distance<D>(tree, distance, store.point(v), neighbours);
        if (work.monitor.advance(v, 10 + distance.k)) return Status::cancelled;
    }
    measure_cells<D>(store, out_radius, nullptr);
    // The root mean square of k distances: the sum of their squares has D + 2 roundings in each and k - 1 of its own,
    // then come a quotient and a root, (k + D + 2) / 2 + 1 in all. D <= 6.
    const double doubt = (distance.k + 16.0) * unit_roundoff;
    const auto interval = [&](VertexId v) {
        const double most = out->value[v] * (1 + doubt), least = out->value[v] * (1 - doubt);
        return cut_at(mesh.cut(), store.vertex(v).marker == Marker::exempt
                                      ? unbounded_interval(least)
                                      : Interval{least_distance(least, out_radius[v]), (most + out_radius[v]) * up});
    };
    out->certificate = clamp_values(count, mesh.cut(), values, interval, out->value, out->interval);
    return Status::ok;
}

template <int D>
Status clamp_function(const FilteredMesh<D>& mesh, const LipschitzBounds& bounds, FilterValues values, Arena& arena,
                      Evaluation* out) {
    const ArenaScope scope(arena);
    const Store<D>& store = mesh.store;
    double* const value = out->value;
    const std::uint32_t count = mesh.vertices();
    double* const out_radius = arena.take_high<double>(count);
    if (out_radius == nullptr) return Status::out_of_memory;
    measure_cells<D>(store, out_radius, nullptr);
    const double cut = bounds.cut;
    const double share =
        bounds.distance_factor > 0 ? down / (1 + bounds.distance_factor * bounds.lipschitz * up) * down : 0;
    // Is v's cell outside the domain? Yes when v is farther from all of the domain than some input is, as the frame is.
    const double beyond = (2 * mesh.domain.radius + mesh.domain.enclosing_radius) * up;
    const auto is_outside = [&](VertexId v) {
        const double away = square_root(mesh.domain.distance2(store.point(v))) * down;
        if (away > beyond) return true;
        return store.vertex(v).marker != Marker::exempt && away - out_radius[v] > mesh.domain.radius * up;
    };
    for (VertexId v(0); v < count; ++v)
        if (is_outside(v)) value[v] = cut;
    const auto interval = [&](VertexId v) {
        if (is_outside(v)) return Interval{cut, cut};
        if (store.vertex(v).marker == Marker::exempt) return Interval{0, cut};
        const double f = value[v], change = bounds.lipschitz * out_radius[v] * up;
        Interval i = {(f - change) * down, (f + change) * up};
        if (!(i.lo > f * share)) i.lo = f * share;
        return cut_at(cut, i);
    };
    out->certificate = clamp_values(count, cut, values, interval, value, out->interval);
    return Status::ok;
}

template <int D>
Status function_filter(const FilteredMesh<D>& mesh, const netmesh_function& function, FilterValues values,
                       const Work& work, Evaluation* out) {
    work.monitor.begin(NETMESH_STAGE_CERTIFY, mesh.vertices());
    for (VertexId v(0); v < mesh.vertices(); ++v) {
        const double f = out->value[v] = value_at(function, mesh.store.point(v));
        out->culprit = v;
        if (!is_finite(f) || f < 0) return Status::not_finite;
        if (work.monitor.advance(v, 10)) return Status::cancelled;
    }
    const LipschitzBounds bounds = {function.lipschitz, function.distance_factor, function.cut};
    return clamp_function<D>(mesh, bounds, values, work.arena, out);
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template double input_distance<D>(const InputTree<D>&, NeighbourDistance, const double*, Neighbour*);              \
    template Status distance_filter<D>(const FilteredMesh<D>&, NeighbourDistance, FilterValues, const Work&,           \
                                       Evaluation*);                                                                   \
    template Status clamp_function<D>(const FilteredMesh<D>&, const LipschitzBounds&, FilterValues, Arena&,            \
                                      Evaluation*);                                                                    \
    template Status function_filter<D>(const FilteredMesh<D>&, const netmesh_function&, FilterValues, const Work&,     \
                                       Evaluation*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
