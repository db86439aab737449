#include "filtration/mesh_filter.hpp"

#include "certificate/cells.hpp"
#include "mesh/clip/clipped_reach.hpp"
#include "vocabulary/dimension.hpp"
#include "vocabulary/features.hpp"

namespace netmesh {
namespace {

struct CellBounds {
    const AnyMesh& mesh;
    const AnyStore& store;
    double rho;
    double* out_radius;     // R_v, or more
    double* steiner_reach;  // without inputs: largest distance from a point of v's cell to v's nearest input, or more

    double& reach(VertexId v) const { return steiner_reach[v - mesh.inputs]; }

    // lo_v and hi_v, both cut at rho; of an absent vertex what holds of any cell.
    [[gnu::noinline]] Interval interval(VertexId v) const {
        const AnyVertex vertex = store.vertex(v);
        const bool bounded = vertex.marker != Marker::exempt && mesh.has(v);
        if (vertex.marker == Marker::input)
            return cut_at(rho, input_interval(square_root(vertex.nearest2), out_radius[v]));
        const double d = distance_to_inputs(store, v);
        return cut_at(rho, bounded ? steiner_interval(d, out_radius[v], reach(v)) : unbounded_interval(d));
    }
    // The thesis's own value: s of 7.4.2.
    [[gnu::noinline]] double own_value(VertexId v) const {
        const AnyVertex vertex = store.vertex(v);
        const double s =
            vertex.marker == Marker::input ? 0.5 * square_root(vertex.nearest2) : distance_to_inputs(store, v);
        return s < rho ? s : rho;
    }
};

// Lowers the bounds of v, which the clipper has marked, as far as its value, the ratio and its best depend on them when
// those of all cells that are not marked have been shown to the clamp (Clamp::sure_ratio).
Status clip_as_needed(const CellBounds& bounds, CellClipper& clipper, const Clamp& clamp, VertexId v) {
    const AnyVertex vertex = bounds.store.vertex(v);
    const double c = clamp.sure_ratio(), own = bounds.own_value(v);
    Interval i = bounds.interval(v);
    if (own <= c * i.lo && i.hi <= c * own) {
        clipper.pass_over(v);
        return Status::ok;
    }
    if (!clipper.open(v)) return Status::out_of_memory;
    const bool is_input = vertex.marker == Marker::input;
    double& far = is_input ? bounds.out_radius[v] : bounds.reach(v);
    const double* const from = bounds.store.point(nearest_input(bounds.store, v));
    if (!is_input && !(own <= c * i.lo)) {
        const double half = 0.5 * distance_to_inputs(bounds.store, v);
        bounds.out_radius[v] = clipper.bound(vertex.x, bounds.out_radius[v], half);
        i = bounds.interval(v);
    }
    if (own <= c * i.lo && c * own < far && clipper.is_bound(from, c * own)) {
        far = c * own;
        return Status::ok;
    }
    // A better lo has nothing to say now. With d = own (where rho cuts own, it cuts hi as well) and w = R_v / d: lo is
    // at least d / 2 and d - R_v, hi at most d + R_v, and own <= c lo, or lo is the best there is. Where w < 1/2, lo =
    // d (1 - w), so c >= 1 / (1 - w) and hi <= d (1 + w) <= d / (1 - w) <= c^2 lo. Elsewhere lo = d / 2 and c >= 2; hi
    // > c^2 lo >= 2 d takes a clipped cell that reaches d or farther, of which d / 2 is all that is known.
    far = clipper.bound(from, far, bounds.rho);
    return Status::ok;
}

// The basic filter's inputs are there from the start: no ratio relates their value 0 to what their cells reach.
Status mesh_filter(const AnyMesh& mesh, bool basic, FilterValues values, const Work& work, Evaluation* out) {
    const ArenaScope scope(work.arena);
    const AnyStore& store = mesh.store;
    const std::uint32_t count = mesh.vertices();
    work.monitor.begin(NETMESH_STAGE_CERTIFY, store.state.cell_slots);
    // Radii stand where values do until these are made of them.
    const CellBounds bounds{mesh, store, mesh.cut, out->value, work.arena.take_high<double>(count - mesh.inputs)};
    if (bounds.steiner_reach == nullptr) return Status::out_of_memory;
    measure_cells(store, bounds.out_radius, bounds.steiner_reach, mesh.inputs);
    const bool clips = built::certificate && mesh.present != nullptr, clips_all = basic || out->interval != nullptr;
    const NeededReach needed = {clips ? mesh.present : nullptr, true, mesh.cut};
    if (clips && clips_all) {
        const Status status =
            clip_cell_bounds(mesh.store, mesh.domain, needed, bounds.out_radius, bounds.steiner_reach, mesh.inputs);
        if (status != Status::ok) return status;
    }
    CellClipper clipper(mesh.store, mesh.domain, needed);
    if (clips && !clips_all) clipper.mark();

    const auto is_zero = [&](VertexId v) { return basic && store.vertex(v).marker == Marker::input; };
    double from = 0;
    Clamp clamp(values);
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = store.arena.piece(v, count, 60); v < piece; ++v) {
            if (!mesh.has(v) || (clips && clipper.is_marked(v))) continue;
            const Interval i = bounds.interval(v);
            if (!is_zero(v)) {
                clamp.show(i);
            } else if (i.hi > from) {
                from = i.hi;
            }
        }
    Status status = Status::ok;
    for (VertexId v(0); clips && v < count; ++v) {
        store.arena.step(v, 300);
        if (!clipper.is_marked(v)) continue;
        const Status clipped = clip_as_needed(bounds, clipper, clamp, v);
        if (clipped != Status::ok) status = clipped;
        clamp.show(bounds.interval(v));
    }
    if (status != Status::ok) return status;
    clamp.fix_ratio();
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = store.arena.piece(v, count, 60); v < piece; ++v) {
            const Interval i = mesh.has(v) ? bounds.interval(v) : Interval{mesh.cut, mesh.cut};
            if (out->interval != nullptr) out->interval[v] = i;
            out->value[v] = is_zero(v) ? 0 : mesh.has(v) ? clamp.value(bounds.own_value(v), i) : mesh.cut;
        }
    out->certificate = clamp.certificate();
    out->certificate.from = from;
    return Status::ok;
}

}  // namespace

Status complete_filter(const AnyMesh& mesh, FilterValues values, const Work& work, Evaluation* out) {
    return mesh_filter(mesh, false, values, work, out);
}

Status basic_filter(const AnyMesh& mesh, FilterValues values, const Work& work, Evaluation* out) {
    return mesh_filter(mesh, true, values, work, out);
}

}  // namespace netmesh
