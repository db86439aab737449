#include "jobs/diagram_of_points.hpp"

#include "filtration/distance_graph.hpp"
#include "filtration/point_complexes.hpp"
#include "filtration/rips_graph.hpp"
#include "jobs/rips_bound.hpp"
#include "jobs/rips_tree.hpp"
#include "numerics/bits.hpp"
#include "vocabulary/dimension.hpp"

namespace netmesh {
namespace {

bool is_rips(netmesh_filter_id filter) { return has_edges(filter) && !is_barycentric(filter); }

// Dimension of the complex on n points, and of the nested sets in it.
std::uint32_t skeleton_dimension(const PointsFilter& filter, std::uint64_t n) {
    const std::uint64_t wanted = is_barycentric(filter.filter) ? std::uint64_t{filter.k} + filter.max_degree
                                                               : std::uint64_t{filter.max_degree} + 1;
    return static_cast<std::uint32_t>(wanted < n ? wanted : n - 1);
}

Status make_complex(const PointSet& points, const PointsFilter& filter, double threshold, const Work& work,
                    ListedComplex* out) {
    const std::uint32_t dimension = skeleton_dimension(filter, points.count), top = filter.max_degree + 1;
    if (is_rips(filter.filter))
        return rips_complex(static_cast<int>(points.dim), points.coordinates, points.count, dimension, threshold, work,
                            out);
    if (!is_barycentric(filter.filter)) return list_sets(points, filter.filter, dimension, work, out);
    ListedComplex sets;
    Status status = list_sets(points, filter.filter, dimension, work, &sets);
    if (status == Status::ok) status = barycentric_complex(sets, filter.k, top, top, work, out);
    for (std::uint32_t m = 0; status == Status::ok && m <= out->dimension; ++m) {
        for (std::uint32_t i = 0; i < out->count[m];)
            for (const std::uint64_t piece = work.arena.piece(i, out->count[m], 5); i < piece; ++i) {
                out->value[m][i] *= factor_of(filter);
            }
    }
    return status;
}

Status persist_listed(const PointsRequest& request, const PointSet& set, const Work& work, PointsDiagram* out) {
    const PointsFilter& filter = request.filter;
    ListedComplex& complex = out->complex;
    const Status status = make_complex(set, filter, request.threshold, work, &complex);
    if (status != Status::ok) return status;
    ComplexRequest counted = {{filter.max_degree, request.keep_zero}, request.representatives};
    if (is_rips(filter.filter)) counted.counted = filter.max_degree > 1 ? filter.max_degree : 1;
    return diagram_of_complex(complex, counted, work, &out->diagram);
}

// Which edges are wanted, and what else is known.
struct NoBound {
    static Status find(const PointsRequest& request, const PointSet&, const Work&, RipsBound* out) {
        *out = {request.threshold, nullptr, 0};
        return Status::ok;
    }
};
struct BoundByAlpha {
    static Status find(const PointsRequest& request, const PointSet& set, const Work& work, RipsBound* out) {
        if (request.filter.max_degree == 1 && !request.keep_zero) return bound_rips(set, request.threshold, work, out);
        return NoBound::find(request, set, work, out);
    }
};

// The diagram of a Rips complex from its edges alone, as far as there are numbers for its simplices.
template <class Bound>
Status persist_edges(const PointsRequest& request, const PointSet& set, const Work& work, PointsDiagram* out,
                     bool* done) {
    const std::uint32_t max_degree = request.filter.max_degree;
    if (max_degree == 0) {
        const DistanceSource source = {
            DistanceSource::Kind::points, set.count, set.coordinates, set.dim, nullptr, nullptr};
        DistanceLimits limits;
        DistanceFault fault;
        *done = true;
        return persist_tree(source, request.threshold, request.keep_zero, work, &out->diagram, &limits, &fault);
    }
    *done = false;
    RipsGraph graph;
    RipsBound bound;
    const std::size_t low = work.arena.low_mark();
    Status status = Bound::find(request, set, work, &bound);
    if (status != Status::ok) {
        *done = true;
        return status;
    }
    const int dim = static_cast<int>(set.dim);
    const auto list = [&](auto dimension) {
        return rips_graph<decltype(dimension)::value>(dim, set.coordinates, set.count, bound.limit, work, &graph);
    };
    status = set.dim > NETMESH_DIM_MAX ? list(Dimension<any_dimension>()) : with_dimension(request.dim, list);
    graph.joined_at = bound.joined_at;
    graph.joins = bound.joins;
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

template <class Bound> Status persist_set(const PointsRequest& request, const Work& work, PointsDiagram* out) {
    PointSet set = {};
    Status status = take_points({request.points, request.count, request.dim}, work.arena, &set, &out->culprit);
    if (status != Status::ok) return status;
    if (is_barycentric(request.filter.filter) && request.filter.k > set.count) return Status::invalid_argument;
    out->distinct = set.count;
    out->input_fingerprint = set.fingerprint;
    out->ratio = ratio_of(request.filter);
    bool done = false;
    if (is_rips(request.filter.filter) && !request.representatives)
        status = persist_edges<Bound>(request, set, work, out, &done);
    if (!done) status = persist_listed(request, set, work, out);
    return status;
}

template <class Bound> Status diagram_by(const PointsRequest& request, const Work& work, PointsDiagram* out) {
    const std::size_t low = work.arena.low_mark(), high = work.arena.high_mark();
    *out = PointsDiagram{};
    out->is_listed = request.representatives;
    const Status status = persist_set<Bound>(request, work, out);
    if (status == Status::ok && request.representatives) return status;
    if (status == Status::ok) return move_pairs_down(low, work.arena, &out->diagram.pairs);
    work.arena.release_low(low);
    work.arena.release_high(high);
    return status;
}

}  // namespace

Status diagram_of_points(const PointsRequest& request, const Work& work, PointsDiagram* out) {
    return diagram_by<NoBound>(request, work, out);
}

Status bounded_diagram_of_points(const PointsRequest& request, const Work& work, PointsDiagram* out) {
    return diagram_by<BoundByAlpha>(request, work, out);
}

// Uniform points have this many edges and columns, and additions to columns, at most, up to the bound.
double bounded_points_bytes(const PointsFilter& filter, std::uint64_t n, std::uint32_t dim) {
    const std::size_t bound = bound_bytes(n, dim);
    if (!is_rips(filter.filter) || filter.max_degree != 1 || bound == 0) return points_bytes(filter, n, dim);
    const double points = static_cast<double>(n), edges = points * (dim == 2 ? 2.4 : 4.4) * (highest_bit(n) + 1);
    const double graph = edges * 36.5 + points * (dim == 2 ? 140 : 320) + 0x1p17, all = points_bytes(filter, n, dim);
    const double bytes =
        (graph > static_cast<double>(bound) ? graph : static_cast<double>(bound)) + points * (8.0 * dim + 5);
    return bytes < all ? bytes : all + static_cast<double>(bound);
}

double points_bytes(const PointsFilter& filter, std::uint64_t n, std::uint32_t dim) {
    const double points = static_cast<double>(n), of_points = points * (8.0 * dim + 5);
    if (is_rips(filter.filter)) return rips_bytes(n, filter.max_degree, points * (points - 1) / 2) + of_points;
    const std::uint32_t dimension = skeleton_dimension(filter, n);
    // A simplex of `width` vertices: facets, cofaces, value; then tables, orders and columns.
    const auto bytes = [](double count, std::uint32_t width) { return count * (8.0 * width + 8 + 24); };
    double total = bytes(skeleton_count(n, dimension), dimension + 1);
    if (is_barycentric(filter.filter)) {
        const double chains = barycentric_count(n, filter.k, dimension + 1, filter.max_degree + 1);
        total += bytes(chains, filter.max_degree + 2);
    }
    return 1.1 * total + of_points;
}

}  // namespace netmesh
