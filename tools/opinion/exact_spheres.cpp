#include "tools/opinion/exact_spheres.hpp"

namespace netmesh::tool {

namespace {

Exact dot_of(const ExactPlace& a, const ExactPlace& b) {
    Exact sum;
    for (std::size_t k = 0; k < a.size(); k++) sum = sum + a[k] * b[k];
    return sum;
}

ExactPlace difference(const ExactPlace& a, const ExactPlace& b) {
    ExactPlace v;
    for (std::size_t k = 0; k < a.size(); k++) v.push_back(a[k] - b[k]);
    return v;
}

// Determinants of the first rows of a matrix on as many of its columns, by the set of columns: expanded by the last of
// these rows. One of no columns is 1.
std::vector<Exact> minors(const std::vector<std::vector<Exact>>& rows, std::size_t columns) {
    std::vector<Exact> minor(std::size_t{1} << columns);
    minor[0] = Exact(1);
    for (std::size_t set = 1; set < minor.size(); set++) {
        std::size_t size = 0, before = 0;
        for (std::size_t c = 0; c < columns; c++) size += set >> c & 1;
        if (size > rows.size()) continue;
        for (std::size_t c = 0; c < columns; c++) {
            if ((set >> c & 1) == 0) continue;
            const Exact product = rows[size - 1][c] * minor[set ^ std::size_t{1} << c];
            minor[set] = (size - 1 + before) % 2 == 0 ? minor[set] + product : minor[set] - product;
            before++;
        }
    }
    return minor;
}

}  // namespace

std::vector<ExactPlace> exact_places(const PointCloud& cloud) {
    std::vector<ExactPlace> places(cloud.rows());
    for (std::size_t i = 0; i < cloud.coordinates.size(); i++) places[i / cloud.dim].emplace_back(cloud.coordinates[i]);
    return places;
}

double half_distance(const double* a, const double* b, std::size_t dim) {
    Exact sum;
    for (std::size_t k = 0; k < dim; k++) {
        const Exact d = Exact(a[k]) - Exact(b[k]);
        sum = sum + d * d;
    }
    return nearest_root(sum, Exact(4));
}

int orientation(const std::vector<const ExactPlace*>& points) {
    std::vector<std::vector<Exact>> rows;
    for (std::size_t i = 1; i < points.size(); i++) rows.push_back(difference(*points[i], *points[0]));
    return minors(rows, rows.size()).back().sign();
}

// The centre c is as far from p as from p + v_i: 2 v_i (c - p) = v_i v_i, with weights v_i v_i - w_i + w, solved by
// Cramer's rule. The last column is the right side; where it replaces another one it has to go past those between.
// The power |c - p|^2 - w is sum x_i v_i (c - p) - w, the half of sum x_i times the right side, less w.
ExactSphere::ExactSphere(const std::vector<const ExactPlace*>& points, const std::vector<Exact>& weights)
    : origin_(*points[0]) {
    const Exact weight = weights.empty() ? Exact() : weights[0];
    const std::size_t n = points.size() - 1;
    for (std::size_t i = 1; i <= n; i++) edges_.push_back(difference(*points[i], origin_));
    std::vector<std::vector<Exact>> rows(n, std::vector<Exact>(n + 1));
    for (std::size_t i = 0; i < n; i++) {
        const Exact square = dot_of(edges_[i], edges_[i]);
        squares_.push_back(weights.empty() ? square : square - weights[i + 1] + weight);
        rows[i][i] = square + square;
        rows[i][n] = squares_[i];
        for (std::size_t j = 0; j < i; j++) {
            const Exact product = dot_of(edges_[i], edges_[j]);
            rows[i][j] = rows[j][i] = product + product;
        }
    }
    const std::vector<Exact> minor = minors(rows, n + 1);
    const std::size_t all = minor.size() - 1;
    volume_ = minor[all ^ std::size_t{1} << n];
    for (std::size_t i = 0; i < n; i++) {
        const Exact& replaced = minor[all ^ std::size_t{1} << i];
        coordinates_.push_back((n - 1 - i) % 2 == 0 ? replaced : -replaced);
        power_ = power_ + coordinates_[i] * squares_[i];
    }
    const Exact of_origin = volume_ * weight;
    power_ = power_ - of_origin - of_origin;
}

bool ExactSphere::is_centred() const {
    Exact rest = volume_;
    for (const Exact& x : coordinates_) {
        if (x.sign() <= 0) return false;
        rest = rest - x;
    }
    return rest.sign() > 0;
}

// |q - c|^2 - |p - c|^2 = |q - p|^2 - 2 (q - p) (c - p)
int ExactSphere::side(const ExactPlace& place) const {
    const ExactPlace way = difference(place, origin_);
    Exact ahead;
    for (std::size_t i = 0; i < edges_.size(); i++) ahead = ahead + coordinates_[i] * dot_of(way, edges_[i]);
    return compare(volume_ * dot_of(way, way), ahead + ahead);
}

double ExactSphere::radius() const { return nearest_signed_root(power_, volume_ + volume_); }

double ExactSphere::square() const { return nearest_quotient(power_, volume_ + volume_); }

}  // namespace netmesh::tool
