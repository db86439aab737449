// The diagram of the union of balls about a few points, in rational arithmetic and from the definition: the Cech
// complex, whose simplices enter with their least enclosing balls, reduced by the standard algorithm. It has no
// triangulation, no Gabriel test, no float, and no code of the engine; by the nerve theorem it is the diagram of the
// alpha complex.
#pragma once
#include <gmpxx.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace truth {

using Point = std::vector<mpq_class>;
struct Bar {
    mpq_class birth, death;  // squared radii
    bool essential;
};
using Diagram = std::vector<std::vector<Bar>>;

struct Ball {
    Point centre;
    mpq_class squared;
};

inline mpq_class distance_squared(const Point& a, const Point& b) {
    mpq_class s = 0;
    for (std::size_t c = 0; c < a.size(); ++c) s += (a[c] - b[c]) * (a[c] - b[c]);
    return s;
}

// The smallest ball with these points on its boundary; false when they are affinely dependent.
inline bool circumscribe(const std::vector<Point>& p, Ball* ball) {
    const std::size_t k = p.size() - 1, dim = p[0].size();
    std::vector<Point> edge(k, Point(dim)), row(k, Point(k + 1));
    for (std::size_t i = 0; i < k; ++i)
        for (std::size_t c = 0; c < dim; ++c) edge[i][c] = p[i + 1][c] - p[0][c];
    for (std::size_t i = 0; i < k; ++i) {
        for (std::size_t j = 0; j < k; ++j)
            for (std::size_t c = 0; c < dim; ++c) row[i][j] += edge[i][c] * edge[j][c];
        row[i][k] = row[i][i] / 2;
    }
    for (std::size_t i = 0; i < k; ++i) {
        std::size_t pivot = i;
        while (pivot < k && row[pivot][i] == 0) ++pivot;
        if (pivot == k) return false;
        std::swap(row[i], row[pivot]);
        for (std::size_t r = 0; r < k; ++r) {
            if (r == i || row[r][i] == 0) continue;
            const mpq_class factor = row[r][i] / row[i][i];
            for (std::size_t j = i; j <= k; ++j) row[r][j] -= factor * row[i][j];
        }
    }
    ball->centre = p[0];
    for (std::size_t i = 0; i < k; ++i)
        for (std::size_t c = 0; c < dim; ++c) ball->centre[c] += row[i][k] / row[i][i] * edge[i][c];
    ball->squared = distance_squared(ball->centre, p[0]);
    return true;
}

// Squared radius of the least ball that contains these points: of those circumscribed to some of them that contain all.
inline mpq_class least_ball(const std::vector<Point>& p) {
    mpq_class least = -1;
    for (std::size_t some = 1; some < std::size_t(1) << p.size(); ++some) {
        std::vector<Point> on;
        for (std::size_t i = 0; i < p.size(); ++i)
            if ((some >> i & 1) != 0) on.push_back(p[i]);
        Ball ball;
        if (!circumscribe(on, &ball) || (least >= 0 && ball.squared >= least)) continue;
        const bool all = std::all_of(p.begin(), p.end(),
                                     [&](const Point& q) { return distance_squared(ball.centre, q) <= ball.squared; });
        if (all) least = ball.squared;
    }
    return least;
}

// Degrees 0..D-1, bars of positive length, sorted by birth and death.
inline Diagram diagram(const std::vector<Point>& points) {
    const std::size_t n = points.size(), dim = points[0].size();
    struct Simplex {
        mpq_class value;
        std::vector<std::size_t> vertices;
    };
    std::vector<Simplex> complex;
    for (std::size_t mask = 1; mask < std::size_t(1) << n; ++mask) {
        Simplex s;
        std::vector<Point> p;
        for (std::size_t i = 0; i < n; ++i)
            if ((mask >> i & 1) != 0) s.vertices.push_back(i), p.push_back(points[i]);
        if (p.size() > dim + 1) continue;
        s.value = least_ball(p);
        complex.push_back(s);
    }
    std::sort(complex.begin(), complex.end(), [](const Simplex& a, const Simplex& b) {
        if (a.value != b.value) return a.value < b.value;
        if (a.vertices.size() != b.vertices.size()) return a.vertices.size() < b.vertices.size();
        return a.vertices < b.vertices;
    });
    std::map<std::vector<std::size_t>, std::size_t> place;
    for (std::size_t i = 0; i < complex.size(); ++i) place[complex[i].vertices] = i;
    std::map<std::size_t, std::set<std::size_t>> column_of_pivot;
    std::vector<bool> positive(complex.size()), killed(complex.size());
    Diagram out(dim);
    for (std::size_t j = 0; j < complex.size(); ++j) {
        std::set<std::size_t> column;
        const auto toggle = [&](std::size_t i) {
            if (!column.insert(i).second) column.erase(i);
        };
        for (std::size_t i = 0; i < complex[j].vertices.size() && complex[j].vertices.size() > 1; ++i) {
            std::vector<std::size_t> facet = complex[j].vertices;
            facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
            toggle(place.at(facet));
        }
        while (!column.empty() && column_of_pivot.count(*column.rbegin()) != 0) {
            const std::set<std::size_t> other = column_of_pivot[*column.rbegin()];
            for (const std::size_t i : other) toggle(i);
        }
        positive[j] = column.empty();
        if (column.empty()) continue;
        const std::size_t birth = *column.rbegin();
        killed[birth] = true;
        column_of_pivot[birth] = column;
        if (complex[birth].value != complex[j].value)
            out[complex[birth].vertices.size() - 1].push_back({complex[birth].value, complex[j].value, false});
    }
    for (std::size_t j = 0; j < complex.size(); ++j)
        if (positive[j] && !killed[j] && complex[j].vertices.size() <= dim)
            out[complex[j].vertices.size() - 1].push_back({complex[j].value, 0, true});
    for (auto& bars : out)
        std::sort(bars.begin(), bars.end(), [](const Bar& a, const Bar& b) {
            if (a.birth != b.birth) return a.birth < b.birth;
            if (a.essential != b.essential) return b.essential;
            return a.death < b.death;
        });
    return out;
}

}  // namespace truth
