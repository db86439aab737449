#include "tools/proof/rips_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "tools/opinion/exact_spheres.hpp"

namespace netmesh::tool {

namespace {

constexpr double largest = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();

// A sum of two doubles.
struct Twofold {
    double high, low;
};

Twofold sum_of(double a, double b) {
    const double sum = a + b, from_b = sum - a;
    return {sum, (a - (sum - from_b)) + (b - from_b)};
}

Twofold square_of(double a) {
    const double scaled = a * 134217729.0, upper = scaled - (scaled - a), lower = a - upper, square = a * a;
    return {square, ((upper * upper - square) + 2 * upper * lower) + lower * lower};
}

// Half of a distance, rounded to nearest. The sum of squares is known to some 2^-100 of itself; its root r is the
// nearest double where the sum is less than r times the unit in the last place away from r^2, below a power of two half
// of that. Where that is not clear, or sizes are unusual, exact numbers tell.
double half_of(const double* a, const double* b, std::size_t dim) {
    Twofold sum = {0, 0};
    for (std::size_t k = 0; k < dim; k++) {
        const Twofold d = sum_of(a[k], -b[k]), square = square_of(d.high), next = sum_of(sum.high, square.high);
        sum = {next.high, sum.low + (next.low + (square.low + 2 * d.high * d.low))};
    }
    const double root = std::sqrt(sum.high + sum.low);
    if (root > 0x1p-400 && root < 0x1p400 && dim < 1000) {
        const Twofold square = square_of(root);
        const double off = (sum.high - square.high) + (sum.low - square.low);
        int exponent;
        const double fraction = std::frexp(root, &exponent), unit = std::ldexp(1, exponent - 53);
        if (std::abs(off) < 0.999 * root * unit * (fraction == 0.5 && off < 0 ? 0.5 : 1)) return root / 2;
    }
    return half_distance(a, b, dim);
}

void put_in_order(RipsEdges* edges) {
    std::sort(edges->edges.begin(), edges->edges.end(), [](const RipsEdge& a, const RipsEdge& b) {
        return a.value != b.value     ? a.value < b.value
               : a.larger != b.larger ? a.larger < b.larger
                                      : a.smaller < b.smaller;
    });
}

// Where some vertex is joined to all others, as far as these edges tell.
void cut_at_cone(RipsEdges* edges) {
    std::vector<double> most(edges->vertices, 0);
    std::vector<std::uint32_t> joined(edges->vertices, 0);
    for (const RipsEdge& e : edges->edges)
        for (const std::uint32_t v : {e.larger, e.smaller}) {
            most[v] = std::max(most[v], e.value);
            joined[v]++;
        }
    for (std::uint32_t v = 0; v < edges->vertices; v++)
        if (joined[v] == edges->vertices - 1) edges->limit = std::min(edges->limit, most[v]);
    edges->edges.erase(std::remove_if(edges->edges.begin(), edges->edges.end(),
                                      [&](const RipsEdge& e) { return e.value > edges->limit; }),
                       edges->edges.end());
    put_in_order(edges);
}

}  // namespace

RipsEdges rips_edges(const PointCloud& points, double threshold) {
    const std::size_t dim = points.dim;
    RipsEdges out;
    out.vertices = static_cast<std::uint32_t>(points.rows());
    out.limit = threshold;
    const auto place = [&](std::uint32_t v) { return &points.coordinates[v * dim]; };
    // From left to right along the widest axis.
    std::size_t axis = 0;
    double widest = -1;
    for (std::size_t k = 0; k < dim; k++) {
        double low = infinity, high = -infinity;
        for (std::uint32_t v = 0; v < out.vertices; v++) {
            low = std::min(low, place(v)[k]);
            high = std::max(high, place(v)[k]);
        }
        if (high - low > widest) axis = k, widest = high - low;
    }
    std::vector<std::uint32_t> order(out.vertices);
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return place(a)[axis] != place(b)[axis] ? place(a)[axis] < place(b)[axis] : a < b;
    });
    // What is farther is beyond the threshold, roundings counted.
    const double far = 2 * threshold * (1 + 0x1p-40) + 0x1p-1070, far2 = far * far;
    const auto is_far = [&](const double* a, const double* b) {
        double squared = 0;
        for (std::size_t k = 0; k < dim; k++) squared += (a[k] - b[k]) * (a[k] - b[k]);
        return dim < 1000 && far2 > 0x1p-900 && squared > far2 * (1 + 0x1p-40);
    };
    for (std::size_t i = 0; i < order.size(); i++)
        for (std::size_t j = i + 1; j < order.size(); j++) {
            const double *const a = place(order[i]), *const b = place(order[j]);
            if (b[axis] - a[axis] > far) break;
            if (is_far(a, b)) continue;
            const double half = half_of(a, b, dim);
            if (half > threshold || half > largest) continue;
            out.edges.push_back({half, std::max(order[i], order[j]), std::min(order[i], order[j])});
        }
    cut_at_cone(&out);
    return out;
}

RipsEdges rips_edges(const DistanceFile& distances, double threshold) {
    RipsEdges out;
    out.vertices = static_cast<std::uint32_t>(distances.points);
    out.limit = threshold;
    // Joined within the threshold is who is before halving rounds.
    const auto add = [&](std::uint64_t i, std::uint64_t j, double distance) {
        const double half = distance / 2 + 0.0;
        if (i == j || !(half <= threshold) || half > largest || (half == threshold && half + half < distance)) return;
        out.edges.push_back(
            {half, static_cast<std::uint32_t>(std::max(i, j)), static_cast<std::uint32_t>(std::min(i, j))});
    };
    for (const netmesh_distance_entry& entry : distances.entries) add(entry.i, entry.j, entry.distance);
    if (distances.layout == NETMESH_DISTANCES_SPARSE) {
        put_in_order(&out);  // an edge may be there more than once
        out.edges.erase(std::unique(out.edges.begin(), out.edges.end(),
                                    [](const RipsEdge& a, const RipsEdge& b) {
                                        return a.larger == b.larger && a.smaller == b.smaller;
                                    }),
                        out.edges.end());
    } else {
        const bool is_full = distances.layout == NETMESH_DISTANCES_FULL;
        for (std::uint64_t i = 0; i < distances.points; i++)
            for (std::uint64_t j = 0; j < i; j++)
                add(i, j, distances.numbers[is_full ? i * distances.points + j : i * (i - 1) / 2 + j]);
    }
    cut_at_cone(&out);
    return out;
}

}  // namespace netmesh::tool
