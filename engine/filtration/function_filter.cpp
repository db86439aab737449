#include "filtration/function_filter.hpp"

#include "certificate/cells.hpp"
#include "certificate/certificate.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
template <int D>
double input_distance(const InputTree<D>& tree, InputDistance kind, const double* x, std::uint32_t k,
                      Neighbour* scratch) {
    tree.nearest_k(x, k, scratch);
    if (kind == InputDistance::kth) return square_root(scratch[k - 1].distance2);
    double sum = 0;
    for (std::uint32_t i = 0; i < k; ++i) sum += scratch[i].distance2;
    return square_root(sum / k);
}

template <int D>
Status distance_filter_values(const Store<D>& store, const Domain<D>& domain, std::uint32_t inputs, InputDistance kind,
                              std::uint32_t k, FilterValues values, const Work& work, double* value,
                              Certificate* certificate, Interval* intervals) {
    ArenaScope scope(work.arena);
    const std::uint32_t count = store.state.vertex_count;
    double* const out_radius = work.arena.take_high<double>(count);
    Neighbour* const neighbours = work.arena.take_high<Neighbour>(k);
    InputTree<D> tree;
    if (out_radius == nullptr || neighbours == nullptr || tree.build(store, work.arena, inputs) != Status::ok)
        return Status::out_of_memory;
    work.monitor.begin(NETMESH_STAGE_CERTIFY, count);
    for (std::uint32_t v = 0; v < count; ++v) {
        value[v] = input_distance<D>(tree, kind, store.point(v), k, neighbours);
        if (work.monitor.advance(v, 10 + k)) return Status::cancelled;
    }
    measure_cells<D>(store, out_radius, nullptr);
    const double rho = domain.enclosing_radius * up;
    // The root mean square of k numbers is computed to within k + 3 roundings.
    const double doubt = (k + 16.0) * unit_roundoff;
    const auto interval = [&](std::uint32_t v) {
        const double d = value[v];
        return cut_at(rho, store.vertex(v).marker == Marker::exempt
                               ? unbounded_interval(d * (1 - doubt))
                               : Interval{least_distance(d * (1 - doubt), out_radius[v]),
                                          (d * (1 + doubt) + out_radius[v]) * up});
    };
    *certificate = clamp_values(count, rho, values, interval, value, intervals);
    return Status::ok;
}

template <int D>
Status function_filter_values(const Store<D>& store, const Domain<D>& domain, const LipschitzBounds& bounds,
                              FilterValues values, Arena& arena, double* value, Certificate* certificate) {
    ArenaScope scope(arena);
    const std::uint32_t count = store.state.vertex_count;
    double* const out_radius = arena.take_high<double>(count);
    if (out_radius == nullptr) return Status::out_of_memory;
    measure_cells<D>(store, out_radius, nullptr);
    const double cut = bounds.cut;
    const double share =
        bounds.distance_factor > 0 ? down / (1 + bounds.distance_factor * bounds.lipschitz * up) * down : 0;
    // Is v's cell outside the domain? Yes when v is farther from all of the domain than some input is, as the frame is.
    const double beyond = (2 * domain.radius + domain.enclosing_radius) * up;
    const auto is_outside = [&](std::uint32_t v) {
        const double away = square_root(domain.distance2(store.point(v))) * down;
        if (away > beyond) return true;
        return store.vertex(v).marker != Marker::exempt && away - out_radius[v] > domain.radius * up;
    };
    for (std::uint32_t v = 0; v < count; ++v)
        if (is_outside(v)) value[v] = cut;
    const auto interval = [&](std::uint32_t v) {
        if (is_outside(v)) return Interval{cut, cut};
        if (store.vertex(v).marker == Marker::exempt) return Interval{0, cut};
        const double f = value[v], change = bounds.lipschitz * out_radius[v] * up;
        Interval i = {(f - change) * down, (f + change) * up};
        if (!(i.lo > f * share)) i.lo = f * share;
        return cut_at(cut, i);
    };
    *certificate = clamp_values(count, cut, values, interval, value, nullptr);
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template double input_distance<D>(const InputTree<D>&, InputDistance, const double*, std::uint32_t, Neighbour*);   \
    template Status distance_filter_values<D>(const Store<D>&, const Domain<D>&, std::uint32_t, InputDistance,         \
                                              std::uint32_t, FilterValues, const Work&, double*,                  \
                                              Certificate*, Interval*);                                            \
    template Status function_filter_values<D>(const Store<D>&, const Domain<D>&, const LipschitzBounds&, FilterValues, \
                                              Arena&, double*, Certificate*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
