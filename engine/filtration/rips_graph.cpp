#include "filtration/rips_graph.hpp"

#include "filtration/half_distance.hpp"
#include "filtration/point_complexes.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Calls f(i, j, half their distance) for all j < i within the limit. False: cancelled.
template <int D, class F>
bool each_edge(const double* coordinates, std::uint32_t n, double limit, Monitor& monitor, F f) {
    for (std::uint32_t i = 1; i < n; ++i) {
        if (monitor.advance(i, 1 + i / 12)) return false;
        for (std::uint32_t j = 0; j < i; ++j) {
            const double half = half_distance<D>(coordinates + std::size_t{i} * D, coordinates + std::size_t{j} * D);
            if (half <= limit) f(i, j, half);
        }
    }
    return true;
}

}  // namespace

template <int D>
Status rips_graph(const double* coordinates, std::uint32_t n, double threshold, const Work& work, RipsGraph* out) {
    *out = {};
    if (n > RipsGraph::vertices_max) return Status::invalid_argument;
    work.monitor.begin(NETMESH_STAGE_FILTER, 0);
    const double cone = cone_radius(D, coordinates, n), limit = threshold < cone ? threshold : cone;
    std::uint32_t count = 0;  // below 2^31, as n is
    if (!each_edge<D>(coordinates, n, limit, work.monitor, [&](std::uint32_t, std::uint32_t, double) { ++count; }))
        return Status::cancelled;
    double* const value = work.arena.take_low<double>(count);
    std::uint32_t* const ends = work.arena.take_low<std::uint32_t>(count);
    if (value == nullptr || ends == nullptr) return Status::out_of_memory;
    std::uint32_t at = 0;
    const bool going =
        each_edge<D>(coordinates, n, limit, work.monitor, [&](std::uint32_t i, std::uint32_t j, double half) {
            value[at] = half;
            ends[at++] = RipsGraph::edge(i, j);
        });
    *out = {n, count, value, ends};
    return going ? Status::ok : Status::cancelled;
}

// Edges, their ranks and bits; then columns with their pivots and pairs. Columns of degree 1 are edges that close no
// triangle when they enter; so they hold none, and by Mantel's theorem they are n^2 / 4 at most.
double rips_bytes(std::uint64_t n, std::uint32_t max_degree, double edges) {
    const double points = static_cast<double>(n), triangle_free = points * points / 4;
    double bytes = 2048 + 80 * points + 12.6 * edges;
    if (max_degree == 0) return bytes;
    double columns = edges < triangle_free ? edges : triangle_free;
    for (std::uint32_t p = 2; p <= max_degree; ++p) columns += skeleton_count(n, p) - skeleton_count(n, p - 1);
    return bytes + 4 * points * points + 12 * points * (max_degree + 2) + 72 * columns;
}

#define NETMESH_INSTANTIATE(D)                                                                                  \
    template Status rips_graph<D>(const double*, std::uint32_t, double, const Work&, RipsGraph*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
