#include "filtration/mesh_filter.hpp"

#include "certificate/cells.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

template <int D> struct CellBounds {
    const Store<D>& store;
    double rho;
    double* out_radius;  // R_v, or more
    double* reach;       // largest distance from a corner of v's cell to v's nearest input, or more

    // lo_v and hi_v, both cut at rho.
    Interval interval(std::uint32_t v) const {
        const Vertex<D>& vertex = store.vertex(v);
        if (vertex.marker == Marker::input)
            return cut_at(rho, input_interval(square_root(vertex.nearest2), out_radius[v]));
        const double d = distance_to_inputs<D>(store, v);
        return cut_at(rho, vertex.marker == Marker::exempt ? unbounded_interval(d)
                                                           : steiner_interval(d, out_radius[v], reach[v]));
    }
    // The thesis's own value: s of 7.4.2.
    double own_value(std::uint32_t v) const {
        const Vertex<D>& vertex = store.vertex(v);
        const double s =
            vertex.marker == Marker::input ? 0.5 * square_root(vertex.nearest2) : distance_to_inputs<D>(store, v);
        return s < rho ? s : rho;
    }
};

}  // namespace

template <int D>
Status mesh_filter_values(const Store<D>& store, const Domain<D>& domain, MeshFilter filter, FilterValues values,
                          Arena& arena, double* value, Certificate* certificate, Interval* intervals) {
    ArenaScope scope(arena);
    const std::uint32_t count = store.state.vertex_count;
    const CellBounds<D> bounds{store, domain.enclosing_radius * up, arena.take_high<double>(count),
                               arena.take_high<double>(count)};
    if (bounds.out_radius == nullptr || bounds.reach == nullptr) return Status::out_of_memory;
    measure_cells<D>(store, bounds.out_radius, bounds.reach);

    // The basic filter's inputs are there from the start: no ratio relates their value 0 to what their cells reach.
    const auto enters_at_once = [&](std::uint32_t v) {
        return filter == MeshFilter::basic && store.vertex(v).marker == Marker::input;
    };
    double from = 0;
    Clamp clamp(values);
    for (std::uint32_t v = 0; v < count; ++v) {
        const Interval i = bounds.interval(v);
        if (!enters_at_once(v)) {
            clamp.show(i);
        } else if (i.hi > from) {
            from = i.hi;
        }
    }
    clamp.fix_ratio();
    for (std::uint32_t v = 0; v < count; ++v) {
        const Interval i = bounds.interval(v);
        if (intervals != nullptr) intervals[v] = i;
        value[v] = enters_at_once(v) ? 0 : clamp.value(bounds.own_value(v), i);
    }
    *certificate = clamp.certificate();
    certificate->from = from;
    return Status::ok;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status mesh_filter_values<D>(const Store<D>&, const Domain<D>&, MeshFilter, FilterValues, Arena&,         \
                                          double*, Certificate*, Interval*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
