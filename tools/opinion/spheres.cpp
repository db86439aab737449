#include "tools/opinion/spheres.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace netmesh::tool {

Real distance2(const Place& a, const Place& b) {
    Real sum = 0;
    for (std::size_t k = 0; k < a.size(); k++) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

namespace {

constexpr Real most_error = 0x1p-45L;  // over the radius

Wide dot(const WidePlace& a, const WidePlace& b) {
    Wide sum;
    for (std::size_t k = 0; k < a.size(); k++) sum = sum + a[k] * b[k];
    return sum;
}
Real length(const WidePlace& a) { return std::sqrt(static_cast<Real>(dot(a, a).high)); }

void add(WidePlace* a, const Wide& factor, const WidePlace& b) {
    for (std::size_t k = 0; k < a->size(); k++) (*a)[k] = (*a)[k] + factor * b[k];
}

// b - a, exactly.
WidePlace edge(const Place& a, const Place& b) {
    WidePlace e(a.size());
    for (std::size_t k = 0; k < a.size(); k++) e[k] = exact_sum(static_cast<Half>(b[k]), -static_cast<Half>(a[k]));
    return e;
}

// Pairs of points, those with the shorter edge first where one can choose; each first one is the first point or the
// second one of an earlier pair.
std::vector<std::pair<std::size_t, std::size_t>> spanning_tree(const std::vector<Place>& points) {
    std::vector<std::pair<std::size_t, std::size_t>> tree;
    std::vector<bool> reached(points.size(), false);
    reached[0] = true;
    while (tree.size() + 1 < points.size()) {
        Real least = HUGE_VALL;
        std::pair<std::size_t, std::size_t> best;
        for (std::size_t i = 0; i < points.size(); i++) {
            for (std::size_t j = 0; j < points.size(); j++) {
                if (!reached[i] || reached[j] || !(distance2(points[i], points[j]) < least)) continue;
                least = distance2(points[i], points[j]);
                best = {i, j};
            }
        }
        tree.push_back(best);
        reached[best.second] = true;
    }
    return tree;
}

// d_j with e_i . d_j = 1 where i = j, else 0, as well as it comes out: orthogonal directions of the edges, each made
// orthogonal to those before it twice, then back substitution. Not a number where an edge depends on those before. The
// volume that they span is that of the orthogonal directions.
std::vector<WidePlace> dual_edges(const std::vector<WidePlace>& edges, Real* volume) {
    const std::size_t n = edges.size();
    std::vector<WidePlace> across = edges, dual(n);
    for (std::size_t i = 0; i < n; i++) {
        for (std::size_t j = 0; j < 2 * i; j++) {
            const WidePlace& q = across[j % i];
            add(&across[i], -(dot(across[i], q) / dot(q, q)), q);
        }
    }
    *volume = 1;
    for (const WidePlace& q : across) *volume *= length(q);
    // across_j . e_i = 0 for i < j: the last is dual but for its length.
    for (std::size_t j = n; j-- > 0;) {
        const Wide unit = dot(across[j], edges[j]);
        dual[j] = across[j];
        for (Wide& x : dual[j]) x = x / unit;
        for (std::size_t i = n; i-- > j + 1;) add(&dual[j], -dot(dual[j], edges[i]), dual[i]);
    }
    return dual;
}

}  // namespace

Place Sphere::centre() const {
    Place sum = point;
    for (std::size_t k = 0; k < sum.size(); k++) sum[k] += static_cast<Real>(offset[k].high);
    return sum;
}

Real Sphere::distance_to_centre(const Place& place) const {
    Real sum = 0;
    for (std::size_t k = 0; k < place.size(); k++) {
        const Real d = place[k] - point[k] - static_cast<Real>(offset[k].high);
        sum += d * d;
    }
    return std::sqrt(sum);
}

// With f = place - point, which is exact, |f - x|^2 - |x|^2 = f . (f - 2 x). Its terms are at most |f| (|f| + 2 |x|),
// and D + 3 operations take part in each; x is off by no more than the error.
int Sphere::holds(const Place& place) const {
    const WidePlace f = edge(point, place);
    WidePlace rest = f;
    add(&rest, {-2, 0}, offset);
    const Real power = static_cast<Real>(dot(f, rest).high), size = length(f);
    const Real rounding = static_cast<Real>(wide_error()) * (static_cast<Real>(f.size()) + 4);
    const Real bound = 2.01L * size * error + rounding * size * (size + 2 * radius);
    return power < -bound ? 1 : power > bound ? -1 : 0;
}

// The edges e_i of a shortest spanning tree: clusters keep the digits of their own short edges. From the first point p
// on the centre is p + x, x in the span of the edges, e_i . x = h_i = e_i . (f + g) / 2 with f and g from p to the
// ends.
//
// Whatever found them, x and d_j prove the error. Let E and D have the columns e_j and d_j, M = E^T D, and let all rows
// of 1 - M have sums of absolute values of at most v <= 1/2, so that no vector that M^-1 makes has entries of more than
// twice the largest before. With the projection P to the span of the edges, the true x* and r = h - E^T x = h - E^T P
// x, x* - P x = E (E^T E)^-1 r. As P D = E (E^T E)^-1 M, that is P D M^-1 r, and M^-1 r = r + (1 - M) M^-1 r:
//
//   |x* - P x| <= sum of |d_j| (|r_j| + 2 v max |r_i|).
//
// r_i is computed with D + 4 operations on terms that add up to at most |e_i| (max |f| + |x|). x - P x is no longer
// than x - sum of l_j e_j for any l_j, such as d_j . x; there D + n operations take part. Three steps x += D r make r
// small.
bool smallest_circumsphere(const std::vector<Place>& points, Sphere* sphere) {
    const std::size_t n = points.size() - 1, dim = points[0].size();
    std::vector<WidePlace> edges;
    WidePlace half(n);
    Real reach = 0;
    for (const auto& [from, to] : spanning_tree(points)) {
        edges.push_back(edge(points[from], points[to]));
        WidePlace ends = edge(points[0], points[from]);
        add(&ends, {1, 0}, edge(points[0], points[to]));
        const Wide twice = dot(edges.back(), ends);
        half[edges.size() - 1] = {twice.high / 2, twice.low / 2};
        reach = std::max(reach, std::sqrt(distance2(points[0], points[to])) * 1.01L);
    }
    const std::vector<WidePlace> dual = dual_edges(edges, &sphere->volume);
    const Real share = static_cast<Real>(wide_error()) * (2 * static_cast<Real>(dim) + 5);
    Real most = 0;
    for (std::size_t i = 0; i < n; i++) {
        Real row = 0;
        for (std::size_t j = 0; j < n; j++) {
            const Wide off = dot(edges[i], dual[j]) - Wide{i == j ? Half{1} : Half{0}, 0};
            row += std::fabs(static_cast<Real>(off.high)) + share * length(edges[i]) * length(dual[j]);
        }
        if (!(row < 0.5L)) return false;
        most = std::max(most, row);
    }
    WidePlace x(dim), rest(n);
    for (int turn = 0; turn < 4; turn++) {
        for (std::size_t i = 0; i < n; i++) rest[i] = half[i] - dot(edges[i], x);
        for (std::size_t j = 0; j < n && turn < 3; j++) add(&x, rest[j], dual[j]);
    }
    WidePlace beside = x;
    std::vector<Real> residual(n);
    Real largest = 0, terms = 0, error = 0;
    for (std::size_t j = 0; j < n; j++) {
        const Wide weight = dot(dual[j], x);
        add(&beside, -weight, edges[j]);
        terms += std::fabs(static_cast<Real>(weight.high)) * length(edges[j]);
        residual[j] = std::fabs(static_cast<Real>(rest[j].high)) + share * length(edges[j]) * (reach + length(x));
        largest = std::max(largest, residual[j]);
    }
    for (std::size_t j = 0; j < n; j++) error += length(dual[j]) * (residual[j] + 2 * most * largest);
    sphere->point = points[0];
    sphere->offset = x;
    sphere->radius = length(x);
    sphere->error = 1.01L * (error + length(beside) + share * terms);
    return n == 0 || sphere->error <= most_error * sphere->radius;
}

Real enclosing_radius(const std::vector<Place>& points) {
    constexpr Real slack = 1 + 1e-15L;
    Real least = HUGE_VALL;
    for (std::uint32_t set = 1; set < (1u << points.size()); set++) {
        std::vector<Place> some;
        for (std::size_t i = 0; i < points.size(); i++) {
            if ((set >> i & 1) != 0) some.push_back(points[i]);
        }
        Sphere sphere;
        if (some.size() > points[0].size() + 1 || !smallest_circumsphere(some, &sphere)) continue;
        bool all = true;
        for (const Place& p : points) all = all && sphere.distance_to_centre(p) <= sphere.radius * slack;
        if (all && sphere.radius < least) least = sphere.radius;
    }
    return least;
}

}  // namespace netmesh::tool
