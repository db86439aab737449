// Budget mode: the best certified diagram that fits in the block.
#include "api/dispatch.hpp"

namespace netmesh {
namespace {

constexpr double coarsest_ratio = 4;
constexpr int rungs_a_halving = 8;  // of ratio - 1

// The ratio of a rung: rung 0 is the coarsest; eight rungs halve what is above 1. By square roots alone.
double ratio_of(double coarsest, int rung) {
    const double eighth = square_root(square_root(square_root(0.5)));
    double excess = coarsest - 1;
    for (; rung >= rungs_a_halving; rung -= rungs_a_halving) excess *= 0.5;
    for (; rung > 0; --rung) excess *= eighth;
    return 1 + excess;
}

struct Ladder {
    netmesh_context* context;
    const double* points;
    size_t n;
    uint32_t max_degree;
    int keep_zero_pairs, bounds;
    netmesh_options options;  // as asked for
    double coarsest;
    bool focused;

    bool has(int rung) const {
        const double ratio = ratio_of(coarsest, rung);
        return focused ? ratio > 1 + 0x1p-10 : is_valid_ratio(ratio);
    }
    netmesh_status climb(int rung) const {
        netmesh_options asked = options;
        asked.ratio = focused ? coarsest : ratio_of(coarsest, rung);
        asked.focus_ratio = focused && rung > 0 ? ratio_of(coarsest, rung) : 0;
        if (asked.focus_ratio == 0) asked.focus_from = asked.focus_to = 0;
        netmesh_status status = netmesh_mesh(context, points, n, NETMESH_JOB_PERSIST, &asked);
        if (status != NETMESH_OK) return status;
        status = netmesh_persist(context, NETMESH_FILTER_COMPLETE, NETMESH_VALUES_CERTIFIED, max_degree,
                                 keep_zero_pairs, &asked);
        return status == NETMESH_OK && bounds != 0 ? netmesh_bound_bars(context, &asked) : status;
    }
};

}  // namespace
}  // namespace netmesh

using namespace netmesh;

// With steps of 8, 4, 2 and 1 rungs, each step taken when what it leads to fits. What a block reaches by a step of 8 a larger one
// reaches too, as it is no matter of the block whether a rung is tried; if it reaches more, it is ahead by more than the steps of 4,
// 2 and 1 can make up for together; and so on down. So more memory never gives a coarser rung.
extern "C" netmesh_status netmesh_fit(netmesh_context* context, const double* points, size_t n, uint32_t max_degree,
                                      int keep_zero_pairs, int bounds, const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    const auto refuse = [&](const char* message) { return finish(context, Status::invalid_argument, message, 7); };
    if (!usable(options)) return refuse("options are not initialised or the dimension is not 2..6");
    const bool focused = options->focus_from != 0 || options->focus_to != 0;
    if (options->focus_ratio != 0) return refuse("focus_ratio is what is to be found");
    if (focused && !(options->focus_from > 0 && options->focus_from < options->focus_to))
        return refuse("not 0 < focus_from < focus_to");
    const Ladder ladder = {context,         points, n,        max_degree,
                           keep_zero_pairs, bounds, *options, options->ratio != 0 ? options->ratio : coarsest_ratio,
                           focused};
    netmesh_status status = ladder.climb(0);
    if (status != NETMESH_OK) return status;
    int reached = 0, held = 0;  // held: the rung whose result is in the context, -1 for none
    for (int step = rungs_a_halving; step > 0; step /= 2) {
        for (bool fits = true; fits && ladder.has(reached + step);) {
            status = ladder.climb(reached + step);
            fits = status == NETMESH_OK;
            if (!fits && status != NETMESH_OUT_OF_MEMORY) return status;
            held = fits ? reached += step : -1;
            if (step < rungs_a_halving) break;  // the next one is known not to fit
        }
    }
    return held == reached ? NETMESH_OK : ladder.climb(reached);
}
