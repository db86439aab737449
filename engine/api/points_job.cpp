// Filtrations on the points themselves: from points to a complex, from the complex to a diagram.
#include "api/complex_job.hpp"
#include "filtration/point_complexes.hpp"
#include "filtration/rips_graph.hpp"
#include "numerics/sort.hpp"
#include "numerics/fingerprint.hpp"

namespace netmesh {
namespace {

constexpr double fourth_root_of_two = 0x1.306fe0a31b716p0;  // rounded up
constexpr double root_of_two = 0x1.6a09e667f3bcdp0;         // rounded up
constexpr std::uint32_t degree_most = ListedComplex::dimension_max - 1;

struct PointSet {
    double* coordinates;  // [count][dim]
    std::uint32_t count;
    std::uint64_t duplicates, fingerprint;
};

// Copies the points, -0.0 as 0, and leaves out what equals an earlier one. *culprit: a row that is not finite.
Status take_points(const double* points, std::uint32_t n, std::uint32_t dim, Arena& arena, PointSet* out,
                   std::uint64_t* culprit) {
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
    out->duplicates = n - out->count;
    out->fingerprint = f.value();
    return Status::ok;
}

struct Filter {
    netmesh_filter filter;
    netmesh_values values;
    std::uint32_t k, max_degree;

    bool barycentric() const {
        return filter == NETMESH_FILTER_BARYCENTRIC_CECH || filter == NETMESH_FILTER_BARYCENTRIC_RIPS;
    }
    // Dimension of the complex on n points, and of the chains in it.
    std::uint32_t skeleton(std::uint64_t n) const {
        const std::uint64_t wanted = barycentric() ? std::uint64_t{k} + max_degree : std::uint64_t{max_degree} + 1;
        return static_cast<std::uint32_t>(wanted < n ? wanted : n - 1);
    }
    // The factor on the filter's own values, and the ratio that the diagram then has.
    double factor() const {
        return filter == NETMESH_FILTER_BARYCENTRIC_RIPS && values == NETMESH_VALUES_CERTIFIED ? fourth_root_of_two : 1;
    }
    double ratio() const {
        if (filter != NETMESH_FILTER_BARYCENTRIC_RIPS) return 1;
        return values == NETMESH_VALUES_CERTIFIED ? fourth_root_of_two : root_of_two;
    }
};

template <int D>
Status make_complex(const PointSet& points, const Filter& filter, const Work& work, ListedComplex* out) {
    const std::uint32_t dimension = filter.skeleton(points.count);
    const double* const x = points.coordinates;
    ListedComplex sets;
    ListedComplex* const made = filter.barycentric() ? &sets : out;
    Status status;
    switch (filter.filter) {
    case NETMESH_FILTER_RIPS: status = rips_complex<D>(x, points.count, dimension, work, made); break;
    case NETMESH_FILTER_BARYCENTRIC_RIPS:
        status = full_rips_complex<D>(x, points.count, dimension, work, made);
        break;
    default: status = cech_complex<D>(x, points.count, dimension, work, made); break;
    }
    if (status != Status::ok || !filter.barycentric()) return status;
    status = barycentric_complex(sets, filter.k, filter.max_degree + 1, work, out);
    for (std::uint32_t m = 0; status == Status::ok && m <= out->dimension; ++m) {
        for (std::uint32_t i = 0; i < out->count[m]; ++i) out->value[m][i] *= filter.factor();
    }
    return status;
}

Status persist_listed(netmesh_context* context, const PointSet& points, const Filter& filter,
                      const ComplexRequest& request, Monitor& monitor) {
    ListedComplex complex;
    const Status status = with_dimension(context->point_dim, [&](auto dimension) {
        return make_complex<decltype(dimension)::value>(points, filter, {context->arena, monitor}, &complex);
    });
    return status == Status::ok ? keep_diagram_of(context, complex, request, monitor) : status;
}

// The diagram of a Rips complex from its edges alone, as far as there are numbers for its simplices.
Status persist_edges(netmesh_context* context, const PointSet& points, const ComplexRequest& request, Monitor& monitor,
                     bool* done) {
    Arena& arena = context->arena;
    *done = false;
    RipsGraph graph;
    const std::size_t low = arena.low_mark();
    Status status = with_dimension(context->point_dim, [&](auto dimension) {
        return rips_graph<decltype(dimension)::value>(points.coordinates, points.count, {arena, monitor}, &graph);
    });
    if (status == Status::invalid_argument || (status == Status::ok && !rips_has_numbers(graph, request.max_degree))) {
        arena.release_low(low);
        return Status::ok;
    }
    *done = true;
    CountedPairs diagram = {};
    if (status == Status::ok)
        status = persist_rips(graph, {request.max_degree, request.keep_zero}, {arena, monitor}, &diagram);
    if (status != Status::ok) return status;
    context->simplices = diagram.simplices;
    return keep_pairs(context, diagram.pairs, request);
}

bool is_points_filter(const netmesh_filter& filter) {
    return in_range(filter, NETMESH_FILTER_RIPS, NETMESH_FILTER_BARYCENTRIC_RIPS);
}

// A diagram from the edges: these, their order and ranks, and the columns of two degrees with their pivots.
double edges_bytes(std::uint64_t n, std::uint32_t max_degree) {
    double columns = 0;
    for (std::uint32_t p = 1; p <= max_degree; ++p) columns += skeleton_count(n, p) - skeleton_count(n, p - 1);
    const double points = static_cast<double>(n);
    return 20 * points * points + 8 * points * (max_degree + 2) + 72 * columns;
}

double bytes_of(const Filter& filter, std::uint64_t n, std::uint32_t dim) {
    const std::uint32_t dimension = filter.skeleton(n);
    // A simplex of `width` vertices: facets, cofaces, value; then tables, orders and columns.
    const auto bytes = [](double count, std::uint32_t width) { return count * (8.0 * width + 8 + 24); };
    double total = bytes(skeleton_count(n, dimension), dimension + 1);
    if (filter.filter == NETMESH_FILTER_RIPS) total = edges_bytes(n, filter.max_degree);
    if (filter.barycentric()) {
        const double chains = barycentric_count(n, filter.k, dimension + 1, filter.max_degree + 1);
        total += bytes(chains, filter.max_degree + 2);
    }
    return 1.1 * total + static_cast<double>(n) * (8.0 * dim + 5) + sizeof(netmesh_context) + 65536;
}

const char* complaint_of(const netmesh_filter& filter, const netmesh_values& values, std::uint32_t k,
                         std::uint32_t max_degree, int representatives, std::uint64_t* position) {
    *position = 4;
    if (!is_points_filter(filter)) return "the filter is not one on points";
    *position = 5;
    if (!in_range(values, NETMESH_VALUES_CERTIFIED, NETMESH_VALUES_THESIS)) return "unknown kind of values";
    const bool sets = filter == NETMESH_FILTER_BARYCENTRIC_CECH || filter == NETMESH_FILTER_BARYCENTRIC_RIPS;
    *position = 6;
    if (sets && k == 0) return "k is 0";
    *position = 7;
    if (max_degree > degree_most) return "max_degree is above 30";
    if (sets && (k > degree_most || k + max_degree > degree_most)) return "k + max_degree is above 30";
    *position = 9;
    if (sets && representatives != 0) return "there are no representatives of barycentric filtrations";
    return nullptr;
}

}  // namespace
}  // namespace netmesh

using namespace netmesh;

extern "C" {

netmesh_status netmesh_persist_points(netmesh_context* context, const double* points, size_t n, netmesh_filter filter,
                                      netmesh_values values, uint32_t k, uint32_t max_degree, int keep_zero_pairs,
                                      int representatives, const netmesh_options* options) {
    if (!usable(context)) return NETMESH_INVALID_ARGUMENT;
    std::uint64_t position = 0;
    if (points == nullptr) return finish(context, Status::invalid_argument, "points is null", 2);
    if (n == 0) return finish(context, Status::invalid_argument, "there are no points", 3);
    if (n > (size_t{1} << 28)) return finish(context, Status::invalid_argument, "more than 2^28 points", 3);
    if (!usable(options))
        return finish(context, Status::invalid_argument, "options are not initialised or the dimension is not 2..6",
                      10);
    const char* const complaint = complaint_of(filter, values, k, max_degree, representatives, &position);
    if (complaint != nullptr) return finish(context, Status::invalid_argument, complaint, position);
    clear(context);
    const Filter wanted = {filter, values, k, max_degree};
    Monitor monitor = monitor_of(*options);
    PointSet set = {};
    std::uint64_t culprit = 0;
    Status status = take_points(points, static_cast<std::uint32_t>(n), options->dim, context->arena, &set, &culprit);
    if (status == Status::ok && wanted.barycentric() && k > set.count) {
        clear(context);
        return finish(context, Status::invalid_argument, "k is above the number of distinct points", 6);
    }
    if (status == Status::ok) {
        context->point_dim = options->dim;
        context->points = n;
        context->duplicates = set.duplicates;
        context->inputs = set.count;
        context->input_fingerprint = set.fingerprint;
        context->k = wanted.barycentric() ? k : 0;
        context->filter = filter;
        context->values = values;
        context->certified_ratio = context->certified_ratio_best = wanted.ratio();
        ComplexRequest request = {max_degree, keep_zero_pairs != 0, representatives != 0};
        if (filter == NETMESH_FILTER_RIPS) request.counted = max_degree > 1 ? max_degree : 1;
        bool done = false;
        if (filter == NETMESH_FILTER_RIPS && representatives == 0)
            status = persist_edges(context, set, request, monitor, &done);
        if (!done) status = persist_listed(context, set, wanted, request, monitor);
    }
    if (status == Status::ok) return finish(context, status, "");
    const netmesh_status result = finish(context, status, netmesh_status_text(static_cast<netmesh_status>(status)),
                                         status == Status::not_finite ? culprit : 0);
    const netmesh_detail detail = context->detail;
    clear(context);
    context->detail = detail;
    return result;
}

size_t netmesh_points_bytes(netmesh_filter filter, const netmesh_options* options, uint64_t points, uint32_t k,
                            uint32_t max_degree) {
    std::uint64_t position;
    if (!usable(options) || points == 0 || points > (uint64_t{1} << 28)) return 0;
    if (complaint_of(filter, NETMESH_VALUES_CERTIFIED, k, max_degree, 0, &position) != nullptr) return 0;
    const double bytes = bytes_of({filter, NETMESH_VALUES_CERTIFIED, k, max_degree}, points, options->dim);
    if (!(bytes < 0x1p62) || bytes >= static_cast<double>(SIZE_MAX / 2)) return SIZE_MAX;
    return (static_cast<size_t>(bytes) + Arena::alignment) & ~(Arena::alignment - 1);
}

}  // extern "C"
