// Budget mode: the best certified diagram that fits in the block.
#include "api/dispatch.hpp"
#include "jobs/fit.hpp"

namespace netmesh {
namespace {

constexpr double coarsest_ratio = 4;

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" netmesh_status netmesh_fit(netmesh_context* context, const double* points, size_t n, uint32_t max_degree,
                                      int keep_zero_pairs, int bounds, const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    const auto refuse = [&](const char* message) { return finish(context, Status::invalid_argument, message, 7); };
    if (!usable(options)) return refuse("options are not initialised or the dimension is not 2..6");
    const bool focused = options->focus_from != 0 || options->focus_to != 0;
    if (options->focus_ratio != 0) return refuse("focus_ratio is what is to be found");
    if (focused && !(options->focus_from > 0 && options->focus_from < options->focus_to))
        return refuse("not 0 < focus_from < focus_to");
    const RatioLadder ladder(options->ratio != 0 ? options->ratio : coarsest_ratio, options->focus_from,
                             options->focus_to);
    const auto climb = [&](const RatioGoal& goal) {
        netmesh_options asked = *options;
        asked.ratio = goal.ratio;
        asked.focus_ratio = goal.focus;
        asked.focus_from = goal.from;
        asked.focus_to = goal.to;
        netmesh_status status = netmesh_mesh(context, points, n, NETMESH_JOB_PERSIST, &asked);
        if (status == NETMESH_OK)
            status = netmesh_persist(context, NETMESH_FILTER_COMPLETE, NETMESH_VALUES_CERTIFIED, max_degree,
                                     keep_zero_pairs, &asked);
        if (status == NETMESH_OK && bounds != 0) status = netmesh_bound_bars(context, &asked);
        return static_cast<Status>(status);
    };
    return static_cast<netmesh_status>(fit(ladder, climb));
}
