// Inserts the points of a triangulation one by one, by KernelRun or PlaneRun.
#pragma once
#include "delaunay/triangulate.hpp"

namespace netmesh {

// Before so many points nothing is given up: what they share is chance.
constexpr std::uint64_t sample_least = 16;

// Notes what `points` inserted points have cost. Is it more than is allowed?
inline bool is_spent(const StoreState& state, std::uint64_t points, Allowance* allowance) {
    const std::uint64_t* const calls = state.in_ball_counts.calls;
    const std::uint64_t hard =
        calls[NETMESH_PREDICATE_FLOAT] + calls[NETMESH_PREDICATE_INTEGER] + calls[NETMESH_PREDICATE_EXACT];
    const double work = static_cast<double>(state.cells_created) + allowance->by_hard * static_cast<double>(hard) +
                        allowance->by_tie * static_cast<double>(calls[NETMESH_PREDICATE_TIE]);
    allowance->is_dear = points >= sample_least && work > allowance->work_each * static_cast<double>(points);
    allowance->points_tried = points;
    allowance->cells_made = state.cells_created;
    allowance->is_spent = allowance->is_dear || state.cell_slots - state.cells_free > allowance->cells_max;
    return allowance->is_spent;
}

// Points in their order, all of state.vertex_count. ok, out_of_memory, cancelled: those before stay inserted. With an
// allowance that is spent: cancelled.
template <class Run> Status insert_all(Run& run, StoreState& state, Monitor& monitor, Allowance* allowance) {
    const std::uint32_t count = state.vertex_count;
    monitor.begin(NETMESH_STAGE_DELAUNAY, count);
    for (std::uint32_t k = 0; k < count; ++k) {
        std::uint32_t made;
        if (!run.insert(k, &made)) return Status::out_of_memory;
        if (made == 0) continue;
        if (allowance != nullptr && is_spent(state, std::uint64_t{k} + 1, allowance)) return Status::cancelled;
        monitor.mesh_size(k, state.cell_slots - state.cells_free);
        if (monitor.advance(k, 2 + made * (Run::dim - 1))) return Status::cancelled;
    }
    return Status::ok;
}

}  // namespace netmesh
