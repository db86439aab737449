#include "filtration/cell_intervals.hpp"

#include "vocabulary/features.hpp"

namespace netmesh {

CellIntervals::CellIntervals(const AnyMesh& mesh, Arena& arena)
    : mesh_(mesh), arena_(arena), bounds_{mesh, mesh.store, mesh.cut, nullptr, nullptr},
      clipper_(mesh.store, mesh.domain, {mesh.present, true, mesh.cut}),
      tightener_(mesh.store, tree_, mesh.cut, arena) {}

Status CellIntervals::open(Monitor& monitor) {
    const std::uint32_t count = mesh_.vertices();
    interval_ = arena_.take_high<Interval>(count);
    bounds_.out_radius = arena_.take_high<double>(count);
    bounds_.steiner_reach = arena_.take_high<double>(count - mesh_.inputs);
    state_ = arena_.take_high<std::uint8_t>(count);
    if (interval_ == nullptr || bounds_.out_radius == nullptr || bounds_.steiner_reach == nullptr ||
        state_ == nullptr || tree_.build(mesh_.store, arena_, mesh_.inputs) != Status::ok || !tree_.move_high(arena_) ||
        tightener_.open() != Status::ok)
        return Status::out_of_memory;
    monitor.begin(NETMESH_STAGE_CERTIFY, mesh_.store.state.cell_slots);
    measure_cells(mesh_.store, bounds_.out_radius, bounds_.steiner_reach, mesh_.inputs);
    const bool clips = built::certificate && mesh_.present != nullptr;
    if (clips) clipper_.mark();
    for (VertexId v(0); v < count;)
        for (const std::uint64_t piece = arena_.piece(v, count, 60); v < piece; ++v) {
            const bool is_there = mesh_.has(v);
            interval_[v] = is_there ? bounds_.interval(v) : Interval{mesh_.cut, mesh_.cut};
            state_[v] = !is_there || mesh_.store.vertex(v).marker == Marker::exempt ? low_done | high_done
                        : v < mesh_.inputs                                          ? low_done
                                                                                    : 0;
            if (clips && clipper_.is_marked(v)) {
                state_[v] |= is_cut;
                clipper_.pass_over(v);
            }
        }
    return Status::ok;
}

// False: no room.
bool CellIntervals::open_cut(VertexId v) {
    if (clipper_.open(v)) return true;
    status_ = Status::out_of_memory;
    return false;
}

void CellIntervals::tighten(VertexId v, const Interval& enough) {
    if (v < mesh_.inputs || !(interval_[v].lo < mesh_.cut)) return;
    const Status status = tightener_.tighten(v, enough, &interval_[v]);
    if (status != Status::ok) status_ = status;
}

// Clipping says nothing of a cell whose vertex is within twice its reach.
void CellIntervals::raise_low(VertexId v, double enough) {
    arena_.pass(2);
    if ((state_[v] & is_cut) != 0) {
        if (!open_cut(v)) return;
        const double half = 0.5 * distance_to_inputs(mesh_.store, v);
        bounds_.out_radius[v] = clipper_.bound(mesh_.store.point(v), bounds_.out_radius[v], half);
        const double lo = bounds_.interval(v).lo;
        if (lo > interval_[v].lo) interval_[v].lo = lo;
    }
    tighten(v, {enough, infinity});
    if (!(interval_[v].lo < enough)) return;
    state_[v] |= low_done;
    if (enough < infinity) tighten(v, {infinity, infinity});  // what does matter is known as well as can be
}

void CellIntervals::lower_high(VertexId v, double enough) {
    arena_.pass(2);
    if ((state_[v] & is_cut) != 0) {
        if (!open_cut(v)) return;
        double& far = v < mesh_.inputs ? bounds_.out_radius[v] : bounds_.reach(v);
        const double* const from = mesh_.store.point(nearest_input(mesh_.store, v));
        far = enough > 0 && clipper_.is_bound(from, enough) ? enough : clipper_.bound(from, far, mesh_.cut);
        const double hi = bounds_.interval(v).hi;
        if (hi < interval_[v].hi) interval_[v].hi = hi;
    }
    tighten(v, {-infinity, enough});
    if (interval_[v].hi > enough) state_[v] |= high_done;
}

void CellIntervals::narrow_extremes(const std::uint32_t* order) {
    const std::uint32_t count = mesh_.vertices();
    double most = 0, least = infinity;
    for (std::uint32_t i = 0; i < count; ++i) {
        arena_.step(i, 20);
        const std::uint32_t v = order[i], w = order[count - 1 - i];
        narrow_high(v, most);
        if (interval_[v].hi > most) most = interval_[v].hi;
        narrow_low(w, least);
        if (interval_[w].lo < least) least = interval_[w].lo;
    }
}

}  // namespace netmesh
