#include "filtration/rips_graph.hpp"

#include "filtration/point_complexes.hpp"
#include "geometry/half_distance.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Calls f(i, j) for all j < i whose half distance is within the limit. False: cancelled.
template <int D, class F>
bool each_edge(int dim, const double* coordinates, std::uint32_t n, double limit, Monitor& monitor, F f) {
    const std::size_t row = static_cast<std::size_t>(dim);
    for (std::uint32_t i = 1; i < n; ++i) {
        if (monitor.advance(i, 1 + i / 12 * (1 + static_cast<std::uint32_t>(dim) / 16))) return false;
        const double* const a = coordinates + i * row;
        for (std::uint32_t j = 0; j < i; ++j) {
            const double* const b = coordinates + j * row;
            const double squared = distance2<D>(dim, a, b);
            if (surely_above(dim, squared, limit)) continue;
            if (surely_below(dim, squared, limit) || half_distance(dim, a, b) <= limit) f(i, j);
        }
    }
    return true;
}

// Edges as they are found, two at a time.
class EdgeList {
public:
    EdgeList(int dim, const double* coordinates, double* value, std::uint32_t* ends)
        : dim_(static_cast<std::uint32_t>(dim)), coordinates_(coordinates), value_(value), ends_(ends) {}

    void add(std::uint32_t i, std::uint32_t j) {
        edge_[waiting_] = RipsGraph::edge(i, j);
        from_[waiting_] = coordinates_ + i * std::size_t{dim_};
        to_[waiting_] = coordinates_ + j * std::size_t{dim_};
        if (++waiting_ == 2) finish();
    }
    void finish() {
        if (waiting_ == 0) return;
        const int other = waiting_ == 2 ? 1 : 0;
        const auto difference = [&](std::uint32_t d) {
            return exact_difference(DoublePair{to_[0][d], to_[other][d]}, DoublePair{from_[0][d], from_[other][d]});
        };
        double half[2];
        const std::uint32_t certain = half_distances_fast<DoublePair>(dim_, difference, half);
        for (std::uint32_t e = 0; e < waiting_; ++e) {
            if ((certain >> e & 1u) == 0) half[e] = exact_half_distance(static_cast<int>(dim_), from_[e], to_[e]);
            value_[count_] = half[e];
            ends_[count_++] = edge_[e];
        }
        waiting_ = 0;
    }

private:
    const std::uint32_t dim_;
    const double* const coordinates_;
    double* const value_;
    std::uint32_t* const ends_;
    std::uint32_t count_ = 0, waiting_ = 0, edge_[2];
    const double *from_[2], *to_[2];
};

}  // namespace

template <int D>
Status rips_graph(int dim, const double* coordinates, std::uint32_t n, double threshold, const Work& work,
                  RipsGraph* out) {
    *out = {};
    if (n > RipsGraph::vertices_max) return Status::invalid_argument;
    work.monitor.begin(NETMESH_STAGE_FILTER, 0);
    // Edges of infinite values are none.
    const double cone = cone_radius<D>(dim, coordinates, n), wanted = threshold < cone ? threshold : cone,
                 limit = wanted < infinity ? wanted : 0x1.fffffffffffffp1023;
    std::uint32_t count = 0;  // below 2^31, as n is
    if (!each_edge<D>(dim, coordinates, n, limit, work.monitor, [&](std::uint32_t, std::uint32_t) { ++count; }))
        return Status::cancelled;
    double* const value = work.arena.take_low<double>(count);
    std::uint32_t* const ends = work.arena.take_low<std::uint32_t>(count);
    if (value == nullptr || ends == nullptr) return Status::out_of_memory;
    EdgeList list(dim, coordinates, value, ends);
    const bool going = each_edge<D>(dim, coordinates, n, limit, work.monitor,
                                    [&](std::uint32_t i, std::uint32_t j) { list.add(i, j); });
    list.finish();
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

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status rips_graph<D>(int, const double*, std::uint32_t, double, const Work&, RipsGraph*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
NETMESH_INSTANTIATE(any_dimension)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
