#include "tools/opinion/spheres.hpp"

#include <cmath>
#include <utility>

namespace netmesh::tool {

Real distance2(const Place& a, const Place& b) {
    Real sum = 0;
    for (std::size_t k = 0; k < a.size(); k++) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

namespace {

// Solves the square system rows * x = right by elimination with full rows exchanged; false when a pivot is 0.
bool solve(std::vector<Place> rows, Place right, Place* x) {
    const std::size_t n = right.size();
    for (std::size_t c = 0; c < n; c++) {
        std::size_t best = c;
        for (std::size_t r = c + 1; r < n; r++) {
            if (std::fabs(rows[r][c]) > std::fabs(rows[best][c])) best = r;
        }
        std::swap(rows[c], rows[best]);
        std::swap(right[c], right[best]);
        if (!(std::fabs(rows[c][c]) > 0)) return false;
        for (std::size_t r = c + 1; r < n; r++) {
            const Real factor = rows[r][c] / rows[c][c];
            for (std::size_t k = c; k < n; k++) rows[r][k] -= factor * rows[c][k];
            right[r] -= factor * right[c];
        }
    }
    x->assign(n, 0);
    for (std::size_t c = n; c-- > 0;) {
        Real sum = right[c];
        for (std::size_t k = c + 1; k < n; k++) sum -= rows[c][k] * (*x)[k];
        (*x)[c] = sum / rows[c][c];
    }
    return true;
}

Real dot(const Place& a, const Place& b) {
    Real sum = 0;
    for (std::size_t k = 0; k < a.size(); k++) sum += a[k] * b[k];
    return sum;
}

}  // namespace

Place Sphere::centre() const {
    Place sum = point;
    for (std::size_t k = 0; k < sum.size(); k++) sum[k] += offset[k];
    return sum;
}

Real Sphere::distance_to_centre(const Place& place) const {
    Real sum = 0;
    for (std::size_t k = 0; k < place.size(); k++) {
        const Real d = place[k] - point[k] - offset[k];
        sum += d * d;
    }
    return std::sqrt(sum);
}

// With edges e_i from the first point, the centre is p + sum of x_i e_i with e_j . sum x_i e_i = |e_j|^2 / 2. For D + 1
// points the sum itself is solved for, which squares no condition number.
bool smallest_circumsphere(const std::vector<Place>& points, Sphere* sphere) {
    const std::size_t n = points.size() - 1, dim = points[0].size();
    std::vector<Place> edges(n, Place(dim));
    Place halves(n);
    for (std::size_t i = 0; i < n; i++) {
        for (std::size_t k = 0; k < dim; k++) edges[i][k] = points[i + 1][k] - points[0][k];
        halves[i] = dot(edges[i], edges[i]) / 2;
    }
    Place offset(dim, 0);
    if (n == dim) {
        if (!solve(edges, halves, &offset)) return false;
    } else if (n > 0) {
        std::vector<Place> gram(n, Place(n));
        for (std::size_t i = 0; i < n; i++) {
            for (std::size_t j = 0; j < n; j++) gram[i][j] = dot(edges[i], edges[j]);
        }
        Place x;
        if (!solve(gram, halves, &x)) return false;
        for (std::size_t i = 0; i < n; i++) {
            for (std::size_t k = 0; k < dim; k++) offset[k] += x[i] * edges[i][k];
        }
    }
    sphere->point = points[0];
    sphere->offset = offset;
    sphere->radius = std::sqrt(dot(offset, offset));
    return true;
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
