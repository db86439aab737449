// Budget mode: the best certified diagram that fits in the block.
#include "jobs/fit.hpp"
#include "api/requests.hpp"

namespace netmesh {
namespace {

constexpr double coarsest_ratio = 4;

// Mesh, diagram and bounds of one goal, in place of what the context held.
class FitRun {
public:
    FitRun(netmesh_context* context, const netmesh_fit_request& request) : context_(context), request_(request) {}

    Status make(const RatioGoal& goal) const {
        netmesh_status status = mesh(goal);
        if (status == NETMESH_OK) status = persist();
        if (status == NETMESH_OK && request_.bounds != 0) status = bound();
        return static_cast<Status>(status);
    }

private:
    netmesh_status mesh(const RatioGoal& goal) const {
        netmesh_mesh_request asked;
        netmesh_mesh_request_init(&asked, sizeof asked, request_.dim);
        asked.monitor = request_.monitor;
        asked.points = request_.points;
        asked.point_count = request_.point_count;
        asked.seed = request_.seed;
        asked.purpose = NETMESH_PURPOSE_PERSIST;
        asked.certificate = {goal.ratio, goal.focus, goal.from, goal.to};
        return netmesh_mesh(context_, &asked);
    }
    netmesh_status persist() const {
        netmesh_persist_request asked;
        netmesh_persist_request_init(&asked, sizeof asked);
        asked.monitor = request_.monitor;
        asked.max_degree = request_.max_degree;
        asked.keep_zero_pairs = request_.keep_zero_pairs;
        return netmesh_persist(context_, &asked);
    }
    netmesh_status bound() const {
        netmesh_bounds_request asked;
        netmesh_bounds_request_init(&asked, sizeof asked);
        asked.monitor = request_.monitor;
        return netmesh_bound_bars(context_, &asked);
    }

    netmesh_context* context_;
    const netmesh_fit_request& request_;
};

Complaint complaint_about(const netmesh_fit_request& request) {
    const Complaint complaint = complaint_about_points(request.points, request.point_count, request.dim);
    if (complaint.text != nullptr) return complaint;
    if (request.ratio != 0 && !is_valid_ratio(request.ratio))
        return {NETMESH_FIELD_RATIO, "ratio is not a finite number above the root of 2"};
    const bool focused = request.focus_from != 0 || request.focus_to != 0;
    return focused ? complaint_about_focus(request.focus_from, request.focus_to) : Complaint{};
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" netmesh_status netmesh_fit(netmesh_context* context, const netmesh_fit_request* from) {
    netmesh_fit_request request;
    const netmesh_status begun = begin(context, from, &request);
    if (begun != NETMESH_OK) return begun;
    const Complaint complaint = complaint_about(request);
    if (complaint.text != nullptr) return refuse(context, complaint);
    const RatioLadder ladder(request.ratio != 0 ? request.ratio : coarsest_ratio, request.focus_from, request.focus_to);
    const FitRun run(context, request);
    const Status status = fit(ladder, [&](const RatioGoal& goal) { return run.make(goal); });
    if (status != Status::ok) clear(context);  // a mesh or a diagram of which a part is missing is no answer
    return static_cast<netmesh_status>(status);
}
