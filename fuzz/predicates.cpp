// Points in D = 2..6 through the exact predicates against determinants in GMP integers, with weights, too. Bytes become
// coordinates of few values, neighbours in the last place and many scales; points are often mirror images of one vector
// (cospherical), combinations of others (on a hyperplane), or another point moved by one unit in the last place.
#include <cmath>
#include <vector>

#include "fuzz/decoder.hpp"
#include "predicates/predicates.hpp"
#include "predicates/weighted.hpp"
#include "tests/predicates/oracle.hpp"
#include "vocabulary/dimension.hpp"

namespace {

using fuzz::require;
using Points = std::vector<oracle::Point>;

Points decode_points(fuzz::Tape& tape, std::uint32_t dim) {
    Points points;
    for (std::uint32_t i = 0; i < dim + 2; ++i) {
        const std::uint8_t how = tape.byte();
        oracle::Point p(dim);
        if (i == 0 || how % 4 == 0) {
            for (double& x : p) x = fuzz::coordinate(tape.byte());
        } else if (how % 4 == 1) {  // a mirror image, rotated
            for (std::uint32_t c = 0; c < dim; ++c) {
                const double x = points[0][(c + (how >> 3)) % dim];
                p[c] = tape.byte() & 1 ? x : -x;
            }
        } else if (how % 4 == 2) {  // on a line through two points, as far as doubles go
            const oracle::Point &a = points[tape.byte() % i], &b = points[tape.byte() % i];
            for (std::uint32_t c = 0; c < dim; ++c) p[c] = a[c] + (how >> 3) * (b[c] - a[c]) / 8;
        } else {  // another point, or its mirror image
            p = points[tape.byte() % i];
            p[(how >> 3) % dim] *= -1;
        }
        if (how & 4) {
            double& x = p[tape.byte() % dim];
            x = std::nextafter(x, tape.byte() & 1 ? 1e308 : -1e308);
        }
        for (double& x : p)
            if (!std::isfinite(x)) x = std::numeric_limits<double>::max();
        points.push_back(p);
    }
    return points;
}

template <int D> void compare(const Points& points) {
    const double* p[D + 2];
    for (int i = 0; i < D + 2; ++i) p[i] = points[static_cast<std::size_t>(i)].data();
    netmesh::PredicateCounts counts = {};
    const int orient = static_cast<int>(netmesh::orient<D>(p, counts));
    require(orient == oracle::orient(Points(points.begin(), points.end() - 1)));
    require(static_cast<int>(netmesh::in_ball<D>(p, p[D + 1], counts)) == oracle::in_ball(points));

    // Two points of the cell change places: the sign of its volume turns.
    std::swap(p[0], p[D]);
    require(static_cast<int>(netmesh::orient<D>(p, counts)) == -orient);
    if (orient == 0) return;
    if (orient > 0) std::swap(p[0], p[D]);

    // In a positively oriented cell, ties broken: an answer, the exact one where there was no tie, in any even order.
    netmesh::VertexId ids[D + 2];
    for (std::uint32_t i = 0; i < D + 2; ++i) ids[i] = netmesh::VertexId(i);
    const int exact = static_cast<int>(netmesh::in_ball<D>(p, p[D + 1], counts));
    const int broken = static_cast<int>(netmesh::in_ball_perturbed<D>(p, ids, p[D + 1], ids[D + 1], counts));
    require(broken != 0 && (exact == 0 || broken == exact));
    std::swap(p[0], p[1]);
    std::swap(p[1], p[2]);
    std::swap(ids[0], ids[1]);
    std::swap(ids[1], ids[2]);
    require(static_cast<int>(netmesh::in_ball_perturbed<D>(p, ids, p[D + 1], ids[D + 1], counts)) == broken);
}

// The power of a point is its lift less its weight. In units in which all of these are whole.
int in_power_exactly(const Points& points, const std::vector<double>& numbers, bool are_radii) {
    mpz_class unit = 1;  // a power of two
    const auto refine = [&unit](const mpz_class& den) {
        if (den > unit) unit = den;
    };
    std::vector<mpq_class> weights;
    for (const double number : numbers) {
        mpq_class w(number);
        if (are_radii) w *= mpq_class(number);
        weights.push_back(w);
        refine(w.get_den());  // more than its root
    }
    for (const oracle::Point& p : points)
        for (const double x : p) refine(mpq_class(x).get_den());
    oracle::Matrix rows;
    for (std::size_t i = 0; i < points.size(); ++i) {
        rows.emplace_back();
        mpz_class lift = 0;
        for (const double x : points[i]) {
            const mpz_class whole(mpq_class(x) * unit);
            rows.back().push_back(whole);
            lift += whole * whole;
        }
        rows.back().push_back(lift - mpz_class(weights[i] * unit * unit));
    }
    return oracle::below_lifted(rows);
}

std::vector<double> decode_weights(fuzz::Tape& tape, const Points& points, bool are_radii) {
    std::vector<double> numbers;
    for (const oracle::Point& p : points) {
        const std::uint8_t how = tape.byte();
        double w = fuzz::coordinate(tape.byte());
        if (how % 4 == 1) {  // all lifts alike
            w = how >> 5;
            for (const double x : p) w += x * x;
            if (are_radii) w = std::sqrt(w);
        } else if (how % 4 == 2) {
            w = how >> 5;
        }
        if (how & 4) w = std::nextafter(w, how & 8 ? 1e308 : -1e308);
        if (!std::isfinite(w)) w = std::numeric_limits<double>::max();
        numbers.push_back(are_radii ? std::fabs(w) : w);
    }
    return numbers;
}

template <int D> void compare_weighted(const Points& points, const std::vector<double>& numbers, bool are_radii) {
    const std::size_t n = D + 2;
    Points rows = points;
    for (std::size_t i = 0; i < n; ++i) rows[i].push_back(numbers[i]);
    std::vector<const double*> p;
    for (const oracle::Point& row : rows) p.push_back(row.data());
    netmesh::PredicateCounts counts = {};
    const int orient = static_cast<int>(netmesh::orient<D>(p.data(), counts));
    if (orient == 0) return;
    netmesh::VertexId ids[D + 2];
    for (std::uint32_t i = 0; i < D + 2; ++i) ids[i] = netmesh::VertexId(i);
    if (orient < 0) {
        std::swap(p[0], p[1]);
        std::swap(ids[0], ids[1]);
    }
    // The centre of the others does not depend on how they are numbered.
    const int exact = orient * in_power_exactly(points, numbers, are_radii);
    const auto ask = [&] {
        return static_cast<int>(netmesh::in_power_perturbed<D>(p.data(), ids, p[D + 1], ids[D + 1], are_radii, counts));
    };
    const int broken = ask();
    require(broken != 0 && (exact == 0 || broken == exact));
    std::swap(p[0], p[1]);
    std::swap(p[1], p[2]);
    std::swap(ids[0], ids[1]);
    std::swap(ids[1], ids[2]);
    require(ask() == broken);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Tape tape(data, size);
    const std::uint32_t dim = 2 + tape.below(5);
    if (!netmesh::serves_dimension(dim)) return 0;
    const Points points = decode_points(tape, dim);
    netmesh::with_dimension(dim, [&](auto d) { compare<d>(points); });
    const bool are_radii = tape.below(2) != 0;
    const std::vector<double> numbers = decode_weights(tape, points, are_radii);
    netmesh::with_dimension(dim, [&](auto d) { compare_weighted<d>(points, numbers, are_radii); });
    return 0;
}
