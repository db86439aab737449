#include "tools/opinion/spheres.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace netmesh::tool {

Real distance2(const Place& a, const Place& b) {
    Real sum = 0;
    for (std::size_t k = 0; k < a.size(); k++) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

namespace {

constexpr Real most_error = 0x1p-45L;  // over the radius

// The same in long doubles and in twice their digits.
template <class N> using Vector = std::vector<N>;
constexpr Half leading(const Half& a) { return a; }
constexpr Half leading(const Wide& a) { return a.high; }
constexpr Wide wide(const Half& a) { return {a, 0}; }
constexpr Wide wide(const Wide& a) { return a; }

template <class N> N dot_of(const Vector<N>& a, const Vector<N>& b) {
    N sum{};
    for (std::size_t k = 0; k < a.size(); k++) sum = sum + a[k] * b[k];
    return sum;
}
template <class N> Real length(const Vector<N>& a) { return std::sqrt(static_cast<Real>(leading(dot_of(a, a)))); }

template <class N> void add_to(Vector<N>* a, const N& factor, const Vector<N>& b) {
    for (std::size_t k = 0; k < a->size(); k++) (*a)[k] = (*a)[k] + factor * b[k];
}

// b - a; with twice the digits exactly.
template <class N> Vector<N> edge(const Place& a, const Place& b) {
    Vector<N> e(a.size());
    for (std::size_t k = 0; k < a.size(); k++) {
        const Half from = static_cast<Half>(a[k]), to = static_cast<Half>(b[k]);
        if constexpr (std::is_same_v<N, Wide>) {
            e[k] = exact_sum(to, -from);
        } else {
            e[k] = to - from;
        }
    }
    return e;
}

// Share by which an operation is off; of long doubles four times as much, for the edges that are rounded, too.
template <class N> Real operation_error() {
    if constexpr (std::is_same_v<N, Wide>) return static_cast<Real>(wide_error());
    return std::ldexp(Real{1}, 2 - half_digits);
}

// Pairs of points, those with the shorter edge first where one can choose; each first one is the first point or the
// second one of an earlier pair.
std::vector<std::pair<std::size_t, std::size_t>> spanning_tree(const std::vector<Place>& points) {
    const std::size_t count = points.size();
    // Of each point that is not in the tree, the nearest one that is.
    std::vector<std::size_t> from(count, 0);
    std::vector<Real> squares(count);
    for (std::size_t j = 1; j < count; j++) squares[j] = distance2(points[0], points[j]);
    squares[0] = HUGE_VALL;
    std::vector<std::pair<std::size_t, std::size_t>> tree;
    while (tree.size() + 1 < count) {
        const std::size_t next =
            static_cast<std::size_t>(std::min_element(squares.begin(), squares.end()) - squares.begin());
        tree.emplace_back(from[next], next);
        squares[next] = HUGE_VALL;
        for (std::size_t j = 1; j < count; j++) {
            if (squares[j] == HUGE_VALL) continue;
            const Real square = distance2(points[next], points[j]);
            if (square < squares[j]) squares[j] = square, from[j] = next;
        }
    }
    return tree;
}

// d_j with e_i . d_j = 1 where i = j, else 0, as well as it comes out: orthogonal directions of the edges, each made
// orthogonal to those before it twice, then back substitution. Not a number where an edge depends on those before. The
// volume that they span is that of the orthogonal directions.
template <class N> std::vector<Vector<N>> dual_edges(const std::vector<Vector<N>>& edges, Real* volume) {
    const std::size_t n = edges.size();
    std::vector<Vector<N>> across = edges, dual(n);
    for (std::size_t i = 0; i < n; i++) {
        for (std::size_t j = 0; j < 2 * i; j++) {
            const Vector<N>& q = across[j % i];
            add_to<N>(&across[i], -(dot_of(across[i], q) / dot_of(q, q)), q);
        }
    }
    *volume = 1;
    for (const Vector<N>& q : across) *volume *= length(q);
    // across_j . e_i = 0 for i < j: the last is dual but for its length.
    for (std::size_t j = n; j-- > 0;) {
        const N unit = dot_of(across[j], edges[j]);
        dual[j] = across[j];
        for (N& x : dual[j]) x = x / unit;
        for (std::size_t i = n; i-- > j + 1;) add_to<N>(&dual[j], -dot_of(dual[j], edges[i]), dual[i]);
    }
    return dual;
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
template <class N> bool find_circumsphere(const std::vector<Place>& points, Real enough, Sphere* sphere) {
    const std::size_t n = points.size() - 1, dim = points[0].size();
    std::vector<Vector<N>> edges;
    Vector<N> half(n);
    Real reach = 0;
    for (const auto& [from, to] : spanning_tree(points)) {
        edges.push_back(edge<N>(points[from], points[to]));
        Vector<N> ends = edge<N>(points[0], points[from]);
        add_to<N>(&ends, N{1}, edge<N>(points[0], points[to]));
        half[edges.size() - 1] = N{0.5} * dot_of(edges.back(), ends);
        reach = std::max(reach, std::sqrt(distance2(points[0], points[to])) * 1.01L);
    }
    const std::vector<Vector<N>> dual = dual_edges(edges, &sphere->volume);
    const Real share = operation_error<N>() * (2 * static_cast<Real>(dim) + 5);
    Real most = 0;
    for (std::size_t i = 0; i < n; i++) {
        Real row = 0;
        for (std::size_t j = 0; j < n; j++) {
            const N off = dot_of(edges[i], dual[j]) - (i == j ? N{1} : N{0});
            row += std::fabs(static_cast<Real>(leading(off))) + share * length(edges[i]) * length(dual[j]);
        }
        if (!(row < 0.5L)) return false;
        most = std::max(most, row);
    }
    Vector<N> x(dim), rest(n);
    for (int turn = 0; turn < 4; turn++) {
        for (std::size_t i = 0; i < n; i++) rest[i] = half[i] - dot_of(edges[i], x);
        for (std::size_t j = 0; j < n && turn < 3; j++) add_to(&x, rest[j], dual[j]);
    }
    Vector<N> beside = x;
    std::vector<Real> residual(n);
    Real largest = 0, terms = 0, error = 0;
    for (std::size_t j = 0; j < n; j++) {
        const N weight = dot_of(dual[j], x);
        add_to<N>(&beside, -weight, edges[j]);
        terms += std::fabs(static_cast<Real>(leading(weight))) * length(edges[j]);
        residual[j] = std::fabs(static_cast<Real>(leading(rest[j]))) + share * length(edges[j]) * (reach + length(x));
        largest = std::max(largest, residual[j]);
    }
    for (std::size_t j = 0; j < n; j++) error += length(dual[j]) * (residual[j] + 2 * most * largest);
    sphere->point = points[0];
    sphere->offset.assign(dim, {});
    for (std::size_t k = 0; k < dim; k++) sphere->offset[k] = wide(x[k]);
    sphere->radius = length(x);
    sphere->error = 1.01L * (error + length(beside) + share * terms);
    return n == 0 || sphere->error <= enough * sphere->radius;
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
    const WidePlace f = edge<Wide>(point, place);
    WidePlace rest = f;
    add_to<Wide>(&rest, {-2, 0}, offset);
    const Real power = static_cast<Real>(dot_of(f, rest).high), size = length(f);
    const Real rounding = static_cast<Real>(wide_error()) * (static_cast<Real>(f.size()) + 4);
    const Real bound = 2.01L * size * error + rounding * size * (size + 2 * radius);
    return power < -bound ? 1 : power > bound ? -1 : 0;
}

bool smallest_circumsphere(const std::vector<Place>& points, Sphere* sphere, Real enough) {
    if (enough > 0 && find_circumsphere<Half>(points, std::min(enough, most_error), sphere)) return true;
    return find_circumsphere<Wide>(points, most_error, sphere);
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
