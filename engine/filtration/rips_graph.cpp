#include "filtration/rips_graph.hpp"

#include "filtration/point_complexes.hpp"
#include "geometry/half_distance.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

// Cubes of a grid over the widest axes. Points are put in order of their cubes, those of a row of cubes along the first
// axis one after the other.
class Cubes {
public:
    static constexpr int axes_most = 3;

    // Cubes as wide as the longest edge, and wider so that there are not many more than points; one where most pairs
    // would be looked at anyway.
    void choose(int dim, const double* coordinates, std::uint32_t n, double limit, const Arena& arena) {
        dim_ = static_cast<std::size_t>(dim);
        double sides[axes_most] = {};
        for (int k = 0; k < dim; ++k) {
            double low = infinity, high = -infinity;
            arena.each(n, 4, [&](std::uint64_t i) {
                const double x = coordinates[i * dim_ + static_cast<std::size_t>(k)];
                low = x < low ? x : low;
                high = x > high ? x : high;
            });
            const double side = high - low;
            // The widest so far, widest first.
            for (int at = 0; at < axes_most; ++at) {
                if (!(side > sides[at])) continue;
                for (int other = axes_most - 1; other > at; --other) {
                    sides[other] = sides[other - 1];
                    axis_[other] = axis_[other - 1];
                    least_[other] = least_[other - 1];
                }
                sides[at] = side;
                axis_[at] = static_cast<std::size_t>(k);
                least_[at] = low;
                break;
            }
        }
        extent_ = sides[0];
        if (!(extent_ < infinity && limit < infinity)) return;
        // An edge is at most so long, what is rounded counted; places are off by less than this margin.
        width_ = 2 * limit * (1 + 0x1p-10);
        if (!(width_ > extent_ * 0x1p-20)) width_ = extent_ * 0x1p-20;
        if (!(width_ > 0x1p-1000)) return;  // it would not grow
        double all;
        for (double most = 2.0 * n + 64;; width_ *= 1.25) {
            all = 1;
            for (const double side : sides) all *= side / width_ + 1;
            if (all <= most) break;
        }
        constexpr double touching = 27;
        if (all < 2 * touching) return;
        for (int at = 0; at < axes_most; ++at) counts_[at] = static_cast<std::uint32_t>(sides[at] / width_) + 1;
    }
    bool is_one() const { return count() == 1; }
    std::uint32_t count() const { return counts_[0] * counts_[1] * counts_[2]; }
    double extent() const { return extent_; }  // of the widest axis

    // The points in order of their cubes, and where those of each cube begin, at the arena's high end. False: out of
    // memory.
    bool sort(const double* coordinates, std::uint32_t n, Arena& arena) {
        begin_ = arena.take_high<std::uint32_t>(std::size_t{count()} + 2);
        double* const sorted = arena.take_high<double>(n * dim_);
        if (begin_ == nullptr || sorted == nullptr) return false;
        arena.each(std::uint64_t{count()} + 2, 1, [this](std::uint64_t c) { begin_[c] = 0; });
        arena.each(n, 30, [&](std::uint64_t i) { ++begin_[cube_of(coordinates + i * dim_) + 2]; });
        arena.each(count(), 2, [this](std::uint64_t c) { begin_[c + 2] += begin_[c + 1]; });
        arena.each(n, 30 + 2 * static_cast<std::uint32_t>(dim_), [&](std::uint64_t i) {
            const double* const from = coordinates + i * dim_;
            double* const to = sorted + begin_[cube_of(from) + 1]++ * dim_;
            for (std::size_t k = 0; k < dim_; ++k) to[k] = from[k];
        });
        sorted_ = sorted;
        return true;
    }
    const double* sorted() const { return sorted_; }
    // Calls visit(first, last), ranges of vertices before i, ascending, for all that are in cubes that touch that of i.
    // Stops and returns false when it does.
    template <class Visit> bool each_before(std::uint32_t i, Visit visit) const {
        std::uint32_t at[axes_most];
        for (int k = 0; k < axes_most; ++k) at[k] = place_along(k, sorted_ + i * dim_);
        for (std::uint32_t z = at[2] > 0 ? at[2] - 1 : 0; z <= at[2] + 1 && z < counts_[2]; ++z)
            for (std::uint32_t y = at[1] > 0 ? at[1] - 1 : 0; y <= at[1] + 1 && y < counts_[1]; ++y) {
                const std::uint32_t row = (z * counts_[1] + y) * counts_[0];
                const std::uint32_t from = at[0] > 0 ? at[0] - 1 : 0;
                const std::uint32_t to = at[0] + 2 < counts_[0] ? at[0] + 2 : counts_[0];
                const std::uint32_t first = begin_[row + from], last = begin_[row + to];
                if (first >= i) return true;
                if (!visit(first, last < i ? last : i)) return false;
            }
        return true;
    }

private:
    std::uint32_t place_along(int k, const double* x) const {
        if (counts_[k] == 1) return 0;
        const double place = (x[axis_[k]] - least_[k]) / width_;
        return place < counts_[k] ? static_cast<std::uint32_t>(place) : counts_[k] - 1;
    }
    std::uint32_t cube_of(const double* x) const {
        return (place_along(2, x) * counts_[1] + place_along(1, x)) * counts_[0] + place_along(0, x);
    }

    std::size_t dim_ = 0, axis_[axes_most] = {};
    double width_ = 0, least_[axes_most] = {}, extent_ = 0;
    std::uint32_t counts_[axes_most] = {1, 1, 1};
    std::uint32_t* begin_ = nullptr;
    const double* sorted_ = nullptr;
};

// Calls f(i, j) for all j < i whose half distance is within the limit, ascending. False: cancelled.
template <int D, class F>
bool each_edge(int dim, const double* coordinates, std::uint32_t n, const Cubes& cubes, double limit, Monitor& monitor,
               F f) {
    constexpr std::uint32_t piece = 4096;
    const std::size_t row = static_cast<std::size_t>(dim);
    for (std::uint32_t i = 1; i < n; ++i) {
        const double* const a = coordinates + i * row;
        if (monitor.advance(i, 1)) return false;
        const auto visit = [&](std::uint32_t first, std::uint32_t last) {
            for (std::uint32_t j = first; j < last;) {
                const std::uint32_t end = last - j < piece ? last : j + piece;
                if (monitor.advance(i, (end - j) / 12 * (1 + static_cast<std::uint32_t>(dim) / 16))) return false;
                for (; j < end; ++j) {
                    const double* const b = coordinates + j * row;
                    const double squared = distance2<D>(dim, a, b);
                    if (surely_above(dim, squared, limit)) continue;
                    if (surely_below(dim, squared, limit) || half_distance(dim, a, b) <= limit) f(i, j);
                }
            }
            return true;
        };
        if (!(cubes.is_one() ? visit(0, i) : cubes.each_before(i, visit))) return false;
    }
    return true;
}

// Edges as they are found, two at a time.
class EdgeList {
public:
    // begin: where lists are made; else null.
    EdgeList(int dim, const double* coordinates, double* value, std::uint32_t* ends, std::uint32_t* begin)
        : dim_(static_cast<std::uint32_t>(dim)), coordinates_(coordinates), value_(value), ends_(ends), begin_(begin) {}

    void add(std::uint32_t i, std::uint32_t j) {
        if (begin_ != nullptr) ++begin_[i];
        edge_[waiting_] = begin_ != nullptr ? j : RipsGraph::edge(i, j);
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
    std::uint32_t *const ends_, *const begin_;
    std::uint32_t count_ = 0, waiting_ = 0, edge_[2];
    const double *from_[2], *to_[2];
};

}  // namespace

template <int D>
Status rips_graph(int dim, const double* coordinates, std::uint32_t n, double threshold, const Work& work,
                  RipsGraph* out) {
    *out = {};
    if (n > RipsGraph::vertices_max) return Status::invalid_argument;
    Arena& arena = work.arena;
    work.monitor.begin(NETMESH_STAGE_FILTER, 0);
    // Edges of infinite values are none. Some end of the widest axis is at least half of it away from any point, so a
    // smaller threshold comes before the cone.
    constexpr double largest = 0x1.fffffffffffffp1023;
    double limit = threshold < largest ? threshold : largest;
    Cubes cubes;
    cubes.choose(dim, coordinates, n, limit, arena);
    if (!(cubes.extent() < infinity && limit < 0.249 * cubes.extent())) {
        const double cone = cone_radius<D>(dim, coordinates, n);
        limit = cone < limit ? cone : limit;
    }
    const HighScope scope(arena);
    if (!cubes.is_one()) {
        if (!cubes.sort(coordinates, n, arena)) return Status::out_of_memory;
        coordinates = cubes.sorted();
    }
    std::uint64_t count = 0;
    if (!each_edge<D>(dim, coordinates, n, cubes, limit, work.monitor, [&](std::uint32_t, std::uint32_t) { ++count; }))
        return Status::cancelled;
    if (count >= std::uint64_t{1} << 31) return Status::out_of_memory;
    std::uint32_t* begin = nullptr;
    if (RipsGraph::takes_lists(n, count)) {
        begin = arena.take_low<std::uint32_t>(std::size_t{n} + 2);
        if (begin == nullptr) return Status::out_of_memory;
        arena.each(std::uint64_t{n} + 2, 1, [begin](std::uint64_t v) { begin[v] = 0; });
    }
    double* const value = arena.take_low<double>(static_cast<std::size_t>(count));
    std::uint32_t* const ends = arena.take_low<std::uint32_t>(static_cast<std::size_t>(count));
    if (value == nullptr || ends == nullptr) return Status::out_of_memory;
    EdgeList list(dim, coordinates, value, ends, begin == nullptr ? nullptr : begin + 1);
    const bool going = each_edge<D>(dim, coordinates, n, cubes, limit, work.monitor,
                                    [&](std::uint32_t i, std::uint32_t j) { list.add(i, j); });
    list.finish();
    if (begin != nullptr) arena.each(n, 2, [begin](std::uint64_t v) { begin[v + 1] += begin[v]; });
    *out = {n, static_cast<std::uint32_t>(count), value, ends, begin};
    return going ? Status::ok : Status::cancelled;
}

// Edges, their ranks and bits; then columns with their pivots and pairs. Columns of degree 1 are edges that close no
// triangle when they enter; so they hold none, and by Mantel's theorem they are n^2 / 4 at most.
double rips_bytes(std::uint64_t n, std::uint32_t max_degree, double edges) {
    const double points = static_cast<double>(n), triangle_free = points * points / 4;
    const bool is_listed = n > RipsGraph::table_max || edges < points * points / 32;
    double bytes = 2048 + 80 * points + (is_listed ? 20.2 : 12.6) * edges;
    if (max_degree == 0) return bytes;
    double columns = edges < triangle_free ? edges : triangle_free;
    for (std::uint32_t p = 2; p <= max_degree; ++p) columns += skeleton_count(n, p) - skeleton_count(n, p - 1);
    return bytes + (is_listed ? 16 * edges : 4 * points * points) + 12 * points * (max_degree + 2) + 72 * columns;
}

#define NETMESH_INSTANTIATE(D)                                                                                         \
    template Status rips_graph<D>(int, const double*, std::uint32_t, double, const Work&, RipsGraph*);
NETMESH_EACH_DIMENSION(NETMESH_INSTANTIATE)
NETMESH_INSTANTIATE(any_dimension)
#undef NETMESH_INSTANTIATE

}  // namespace netmesh
