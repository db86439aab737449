#include "filtration/mesh_filter.hpp"

#include "filtration/cell_bounds.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

template <int D> struct Bounds {
    const Store<D>& store;
    double rho;
    double* out_radius;  // R_v, or more
    double* reach;       // largest distance from a corner of v's cell to v's nearest input, or more

    void measure() { measure_cells<D>(store, out_radius, reach); }
    double input_distance(std::uint32_t v) const {
        return distance<D>(store.point(v), store.point(nearest_input<D>(store, v)));
    }
    // lo_v and hi_v, both cut at rho.
    Interval interval(std::uint32_t v) const {
        const Vertex<D>& vertex = store.vertex(v);
        Interval i;
        if (vertex.marker == Marker::input) {
            i.lo = 0.5 * square_root(vertex.nearest2) * down;
            i.hi = out_radius[v];
        } else {
            const double d = input_distance(v);
            const double inner = (d - out_radius[v]) * down;
            i.lo = (inner > 0.5 * d ? inner : 0.5 * d) * down;
            i.hi = vertex.marker == Marker::exempt ? infinity : reach[v];
        }
        if (!(i.hi <= rho)) i.hi = rho;
        if (i.lo > rho) i.lo = rho;
        return i;
    }
    // The thesis's own value: s of 7.4.2.
    double own_value(std::uint32_t v) const {
        const Vertex<D>& vertex = store.vertex(v);
        const double s = vertex.marker == Marker::input ? 0.5 * square_root(vertex.nearest2) : input_distance(v);
        return s < rho ? s : rho;
    }
};

}  // namespace

template <int D>
Status mesh_filter_values(const Store<D>& store, const Domain<D>& domain, MeshFilter filter, FilterValues values,
                          Arena& arena, double* value, MeshCertificate* certificate, Interval* intervals) {
    ArenaScope scope(arena);
    const std::uint32_t count = store.state.vertex_count;
    Bounds<D> bounds{store, domain.enclosing_radius * up, arena.take_high<double>(count),
                     arena.take_high<double>(count)};
    if (bounds.out_radius == nullptr || bounds.reach == nullptr) return Status::out_of_memory;
    bounds.measure();

    *certificate = {1, 1, 0};
    const bool basic = filter == MeshFilter::basic;
    double best2 = 1;
    for (std::uint32_t v = 0; v < count; ++v) {
        const Interval i = bounds.interval(v);
        if (basic && store.vertex(v).marker == Marker::input) {
            if (i.hi > certificate->from) certificate->from = i.hi;
            continue;
        }
        if (i.hi / i.lo > best2) best2 = i.hi / i.lo;
    }
    const double best = best2 > 1 ? square_root(best2) * up : 1;
    certificate->ratio_best = best;
    double ratio = 1;
    for (std::uint32_t v = 0; v < count; ++v) {
        const Interval i = bounds.interval(v);
        if (intervals != nullptr) intervals[v] = i;
        if (basic && store.vertex(v).marker == Marker::input) {
            value[v] = 0;
            continue;
        }
        double t = bounds.own_value(v);
        if (values == FilterValues::certified) {
            const double least = i.hi / best, most = i.lo * best;
            if (t < least) t = least;
            if (t > most) t = most;
        }
        value[v] = t;
        if (i.hi / t * up > ratio && i.hi > t) ratio = i.hi / t * up;
        if (t / i.lo * up > ratio && t > i.lo) ratio = t / i.lo * up;
    }
    certificate->ratio = ratio;
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status mesh_filter_values<D>(const Store<D>&, const Domain<D>&, MeshFilter, FilterValues, Arena&,         \
                                          double*, MeshCertificate*, Interval*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
