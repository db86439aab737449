#include "jobs/persist_points.hpp"

#include "filtration/filters.hpp"
#include "filtration/half_distance.hpp"
#include "filtration/point_complexes.hpp"
#include "filtration/rips_graph.hpp"
#include "numerics/fingerprint.hpp"
#include "numerics/sort.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

constexpr double fourth_root_of_two = 0x1.306fe0a31b716p0;  // rounded up
constexpr double root_of_two = 0x1.6a09e667f3bcdp0;         // rounded up

struct PointSet {
    double* coordinates;  // [count][dim]
    std::uint32_t count;
    std::uint64_t fingerprint;
};

// Copies the points, -0.0 as 0, and leaves out what equals an earlier one. *culprit: a row that is not finite.
Status take_points(const PointsRequest& request, Arena& arena, PointSet* out, std::uint64_t* culprit) {
    const std::uint32_t n = request.count, dim = request.dim;
    const double* const points = request.points;
    double* const x = arena.take_low<double>(std::size_t{n} * dim);
    const ArenaScope scope(arena);
    std::uint32_t* const order = arena.take_high<std::uint32_t>(n);
    unsigned char* const repeated = arena.take_high<unsigned char>(n);
    if (x == nullptr || order == nullptr || repeated == nullptr) return Status::out_of_memory;
    Fingerprint f;
    f.add(static_cast<std::uint64_t>(dim));
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t d = 0; d < dim; ++d) {
            const std::size_t at = std::size_t{i} * dim + d;
            *culprit = i;
            if (!is_finite(points[at])) return Status::not_finite;
            x[at] = points[at] + 0.0;
            f.add(x[at]);
        }
        order[i] = i;
        repeated[i] = 0;
    }
    const auto compare = [x, dim](std::uint32_t a, std::uint32_t b) {
        for (std::uint32_t d = 0; d < dim; ++d) {
            const double xa = x[std::size_t{a} * dim + d], xb = x[std::size_t{b} * dim + d];
            if (xa != xb) return xa < xb ? -1 : 1;
        }
        return 0;
    };
    sort(order, n, [compare](std::uint32_t a, std::uint32_t b) {
        const int c = compare(a, b);
        return c != 0 ? c < 0 : a < b;
    });
    for (std::uint32_t i = 1; i < n; ++i) repeated[order[i]] = compare(order[i - 1], order[i]) == 0;
    out->count = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        if (repeated[i] != 0) continue;
        for (std::uint32_t d = 0; d < dim; ++d) x[std::size_t{out->count} * dim + d] = x[std::size_t{i} * dim + d];
        ++out->count;
    }
    out->coordinates = x;
    out->fingerprint = f.value();
    return Status::ok;
}

// Of the k-nearest-neighbour kind: chains of sets of k points and more (8.5).
bool is_barycentric(const PointsFilter& filter) { return find_filter(filter.filter)->has(filter_trait::needs_k); }
bool has_edges(const PointsFilter& filter) { return find_filter(filter.filter)->has(filter_trait::made_of_edges); }
bool is_rips(const PointsFilter& filter) { return has_edges(filter) && !is_barycentric(filter); }
// Balls of sets are told by edges alone, up to a factor between 1 and the root of 2.
bool is_approximate(const PointsFilter& filter) { return has_edges(filter) && is_barycentric(filter); }

// Dimension of the complex on n points, and of the nested sets in it.
std::uint32_t skeleton_dimension(const PointsFilter& filter, std::uint64_t n) {
    const std::uint64_t wanted =
        is_barycentric(filter) ? std::uint64_t{filter.k} + filter.max_degree : std::uint64_t{filter.max_degree} + 1;
    return static_cast<std::uint32_t>(wanted < n ? wanted : n - 1);
}

// The factor on the filter's own values, and the ratio that the diagram then has.
double factor_of(const PointsFilter& filter) {
    return is_approximate(filter) && filter.values == FilterValues::certified ? fourth_root_of_two : 1;
}
double ratio_of(const PointsFilter& filter) {
    if (!is_approximate(filter)) return 1;
    return filter.values == FilterValues::certified ? fourth_root_of_two : root_of_two;
}

template <int D>
Status make_complex(const PointSet& points, const PointsFilter& filter, const Work& work, ListedComplex* out,
                    double* error) {
    const std::uint32_t dimension = skeleton_dimension(filter, points.count);
    const double* const x = points.coordinates;
    ListedComplex sets;
    ListedComplex* const made = is_barycentric(filter) ? &sets : out;
    Status status;
    if (!has_edges(filter))
        status = cech_complex<D>(x, points.count, dimension, work, made, error);
    else if (is_barycentric(filter))
        status = full_rips_complex<D>(x, points.count, dimension, work, made);
    else
        status = rips_complex<D>(x, points.count, dimension, work, made);
    if (status != Status::ok || !is_barycentric(filter)) return status;
    status = barycentric_complex(sets, filter.k, filter.max_degree + 1, work, out);
    for (std::uint32_t m = 0; status == Status::ok && m <= out->dimension; ++m) {
        for (std::uint32_t i = 0; i < out->count[m]; ++i) out->value[m][i] *= factor_of(filter);
    }
    return status;
}

Status persist_listed(const PointsRequest& request, const PointSet& set, const Work& work, PointsDiagram* out) {
    const PointsFilter& filter = request.filter;
    ListedComplex& complex = out->complex;
    const Status status = with_dimension(request.dim, [&](auto dimension) {
        return make_complex<decltype(dimension)::value>(set, filter, work, &complex, &out->value_error);
    });
    if (status != Status::ok) return status;
    ComplexRequest counted = {{filter.max_degree, request.keep_zero}, request.representatives};
    if (is_rips(filter)) counted.counted = filter.max_degree > 1 ? filter.max_degree : 1;
    return persist_complex(complex, counted, work, &out->diagram);
}

// Of values that are half distances, and of the factor on them. The least value of all is a birth or a death of degree
// 0, so a value outside of the range of the pairs is above all of them.
void note_edge_error(const PointsRequest& request, PointsDiagram* out) {
    double least = infinity, most = 0;
    for (std::uint64_t i = 0; i < out->diagram.pairs.count; ++i) {
        const Pair& pair = out->diagram.pairs.pairs[i];
        if (pair.birth > 0 && pair.birth < least) least = pair.birth;
        if (pair.birth > most) most = pair.birth;
        if (pair.death < least && pair.death > 0) least = pair.death;
        if (pair.death < infinity && pair.death > most) most = pair.death;
    }
    with_dimension(request.dim, [&](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        const double factor = factor_of(request.filter), error = half_distance_error<D>(least / factor, most / factor);
        out->value_error = factor > 1 ? error + 1.01 * unit_roundoff : error;
        return Status::ok;
    });
}

// The diagram of a Rips complex from its edges alone, as far as there are numbers for its simplices.
Status persist_edges(const PointsRequest& request, const PointSet& set, const Work& work, PointsDiagram* out,
                     bool* done) {
    const std::uint32_t max_degree = request.filter.max_degree;
    *done = false;
    RipsGraph graph;
    const std::size_t low = work.arena.low_mark();
    const Status status = with_dimension(request.dim, [&](auto dimension) {
        return rips_graph<decltype(dimension)::value>(set.coordinates, set.count, work, &graph);
    });
    if (status == Status::invalid_argument || (status == Status::ok && !rips_has_numbers(graph, max_degree))) {
        work.arena.release_low(low);
        return Status::ok;
    }
    *done = true;
    if (status != Status::ok) return status;
    CountedPairs found = {};
    const Status reduced = persist_rips(graph, {max_degree, request.keep_zero}, work, &found);
    out->diagram.pairs = found.pairs;
    out->diagram.simplices = found.simplices;
    return reduced;
}

Status persist_set(const PointsRequest& request, const Work& work, PointsDiagram* out) {
    PointSet set = {};
    Status status = take_points(request, work.arena, &set, &out->culprit);
    if (status != Status::ok) return status;
    if (is_barycentric(request.filter) && request.filter.k > set.count) return Status::invalid_argument;
    out->distinct = set.count;
    out->input_fingerprint = set.fingerprint;
    out->ratio = ratio_of(request.filter);
    bool done = false;
    if (is_rips(request.filter) && !request.representatives) status = persist_edges(request, set, work, out, &done);
    if (!done) status = persist_listed(request, set, work, out);
    if (status == Status::ok && has_edges(request.filter)) note_edge_error(request, out);
    return status;
}

// A diagram from the edges: these, their order and ranks, and the columns of two degrees with their pivots.
double edges_bytes(std::uint64_t n, std::uint32_t max_degree) {
    double columns = 0;
    for (std::uint32_t p = 1; p <= max_degree; ++p) columns += skeleton_count(n, p) - skeleton_count(n, p - 1);
    const double points = static_cast<double>(n);
    return 20 * points * points + 8 * points * (max_degree + 2) + 72 * columns;
}

}  // namespace

Status persist_points(const PointsRequest& request, const Work& work, PointsDiagram* out) {
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    *out = PointsDiagram{};
    out->is_listed = request.representatives;
    const Status status = persist_set(request, work, out);
    if (status == Status::ok && request.representatives) return status;
    if (status == Status::ok) return move_pairs_down(low, work.arena, &out->diagram.pairs);
    work.arena.release_low(low);
    work.arena.release_high(high);
    return status;
}

double points_bytes(const PointsFilter& filter, std::uint64_t n, std::uint32_t dim) {
    const std::uint32_t dimension = skeleton_dimension(filter, n);
    // A simplex of `width` vertices: facets, cofaces, value; then tables, orders and columns.
    const auto bytes = [](double count, std::uint32_t width) { return count * (8.0 * width + 8 + 24); };
    double total = bytes(skeleton_count(n, dimension), dimension + 1);
    if (is_rips(filter)) total = edges_bytes(n, filter.max_degree);
    if (is_barycentric(filter)) {
        const double chains = barycentric_count(n, filter.k, dimension + 1, filter.max_degree + 1);
        total += bytes(chains, filter.max_degree + 2);
    }
    return 1.1 * total + static_cast<double>(n) * (8.0 * dim + 5);
}

}  // namespace netmesh
