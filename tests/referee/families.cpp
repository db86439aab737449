#include "families.hpp"

#include <algorithm>
#include <numeric>

namespace referee {
namespace {

Point ball_point(int dim, Random& random) {
    Point x = random.direction(dim);
    const double length = std::pow(random.unit(), 1.0 / dim);
    for (int k = 0; k < dim; k++) x[k] *= length;
    return x;
}

Points in_ball(int dim, std::size_t n, Random& random) {
    Points points;
    for (std::size_t i = 0; i < n; i++) points.push_back(ball_point(dim, random));
    return points;
}

Points few(int dim, std::size_t, Random& random) { return in_ball(dim, 1 + random.below(5), random); }

// A linear map into more dimensions with small integers, so that flat points with few bits stay exactly flat.
Points lifted(const Points& flat, int from, int dim, Random& random) {
    int map[dim_max][dim_max];
    for (int k = 0; k < dim; k++)
        for (int j = 0; j < from; j++) map[k][j] = k == j ? 4 : static_cast<int>(random.below(7)) - 3;
    Points points;
    for (const Point& p : flat) {
        Point x = {};
        for (int k = 0; k < dim; k++)
            for (int j = 0; j < from; j++) x[k] += map[k][j] * p[j];
        points.push_back(x);
    }
    return points;
}

// In a flat of 1 to D - 1 dimensions: exactly, or but for rounding.
Points flat(int dim, std::size_t n, Random& random) {
    const int from = 1 + static_cast<int>(random.below(static_cast<std::size_t>(dim) - 1));
    const bool rounded = random.below(2) == 0;
    Points points;
    for (std::size_t i = 0; i < n; i++) {
        Point x = {};
        for (int k = 0; k < from; k++) x[k] = rounded ? random.between(-1, 1) : random.below(1u << 20) * 0x1p-20;
        points.push_back(x);
    }
    return random.below(3) == 0 ? points : lifted(points, from, dim, random);
}

Points on_line(int dim, std::size_t n, Random& random) {
    Points points;
    const bool even = random.below(2) == 0;
    for (std::size_t i = 0; i < n; i++) {
        Point x = {};
        x[0] = even ? static_cast<double>(i) : random.unit();
        points.push_back(x);
    }
    return random.below(2) == 0 ? points : lifted(points, 1, dim, random);
}

// (cos t, sin t, t^2 / 20, ...), an arc, a whole circle or a moment curve.
Points curve(int dim, std::size_t n, Random& random) {
    const std::uint32_t kind = random.below(3);
    Points points;
    for (std::size_t i = 0; i < n; i++) {
        const double s = (static_cast<double>(i) + (random.below(2) == 0 ? 0 : 0.3)) / static_cast<double>(n);
        const double t = kind == 1 ? 6.283185307179586 * s : s;
        Point x = {std::cos(t), std::sin(t)};
        for (int k = 2; k < dim && kind == 0; k++) x[k] = std::pow(t, k) / 20;
        for (int k = 0; k < dim && kind == 2; k++) x[k] = std::pow(t, k + 1);
        points.push_back(x);
    }
    return points;
}

Points clusters(int dim, std::size_t n, Random& random, double width) {
    Points points;
    const std::size_t many = 1 + random.below(4);
    Points centres = in_ball(dim, many, random);
    if (random.below(2) == 0) centres[0] = {};
    for (std::size_t i = 0; i < n; i++) {
        Point x = ball_point(dim, random);
        for (int k = 0; k < dim; k++) x[k] = centres[i % many][k] + width * x[k];
        points.push_back(x);
    }
    return points;
}

Points grid(int dim, std::size_t n, Random& random) {
    int side = 2;
    while (std::pow(side + 1, dim) <= static_cast<double>(n)) side++;
    Points points;
    const std::size_t count = static_cast<std::size_t>(std::pow(side, dim) + 0.5);
    for (std::size_t i = 0; i < count; i++) {
        Point x = {};
        std::size_t rest = i;
        for (int k = 0; k < dim; k++, rest /= static_cast<std::size_t>(side))
            x[k] = static_cast<double>(rest % static_cast<std::size_t>(side));
        points.push_back(x);
    }
    for (std::size_t i = points.size(); i > 1; i--) std::swap(points[i - 1], points[random.below(i)]);
    return points;
}

// Coordinates are moved by an ulp or a few.
Points bent(Points points, int dim, Random& random) {
    const std::uint32_t most = 1 + random.below(4);
    for (Point& x : points)
        for (int k = 0; k < dim; k++)
            for (std::uint32_t steps = random.below(most + 1); steps > 0; steps--)
                x[k] = std::nextafter(x[k], random.below(2) == 0 ? -INFINITY : INFINITY);
    return points;
}

Points bent_grid(int dim, std::size_t n, Random& random) {
    Points points = grid(dim, n, random);
    const double corner = random.below(2) == 0 ? 1 : 0x1p-1;
    for (Point& x : points)
        for (int k = 0; k < dim; k++) x[k] += corner;
    return bent(points, dim, random);
}

// Regular polygons, one or two about the same place, and the prisms and cross polytopes over them: what is equal in
// them differs by the rounding of coordinates.
Points bent_polytope(int dim, std::size_t n, Random& random) {
    Points points;
    const std::size_t corners = 3 + random.below(6), turns = 1 + random.below(2);
    const bool cross = random.below(2) == 0;
    const double shift = random.below(2) == 0 ? 0 : 1;
    for (std::size_t i = 0; i < corners * turns; i++) {
        const double t = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(corners),
                     r = i < corners ? 1 : 0.5;
        points.push_back({shift + r * std::cos(t), r * std::sin(t)});
    }
    for (int k = 2; k < dim; k++) {
        const std::size_t below = points.size();
        if (cross)
            for (const double end : {-1., 1.}) {
                Point x = {shift};
                x[k] = end;
                points.push_back(x);
            }
        for (std::size_t i = 0; !cross && i < below; i++) {
            points.push_back(points[i]);
            points.back()[k] = 1;
        }
    }
    if (points.size() > n) points.resize(n);
    return bent(points, dim, random);
}

// Clusters as far from the others as scales are parted for theta = 1 / 10 or 1 / 20, but for an ulp or a few: three
// points in a line, the middle one chosen first; and the same about its end, at a larger scale.
Points parted(int dim, std::size_t n, Random& random) {
    const double parts = random.below(2) == 0 ? 10 : 20;
    const std::size_t axis = random.below(static_cast<std::size_t>(dim));
    Points points = {{}};
    double scale = random.below(2) == 0 ? 1 : random.between(1, 2);
    while (points.size() < n) {
        Point near = {}, far = {};
        near[axis] = scale;
        far[axis] = random.below(3) == 0 ? scale * (parts + 1) : -scale * (parts - 1);
        points.push_back(near);
        points.push_back(far);
        if (random.below(2) == 0) points.push_back(ball_point(dim, random));
        scale *= 4 * parts * parts;
    }
    if (points.size() > n) points.resize(n);
    return bent(points, dim, random);
}

// Exactly cospherical: signs and permutations of a few integers; or rounded points of a sphere.
Points cospherical(int dim, std::size_t n, Random& random) {
    Points points;
    if (random.below(2) == 0) {
        for (std::size_t i = 0; i < n; i++) points.push_back(random.direction(dim));
        return points;
    }
    Point base = {};
    for (int k = 0; k < dim; k++) base[k] = static_cast<double>(random.below(4));
    base[0] += 1;
    for (std::size_t i = 0; i < n; i++) {
        Point x = base;
        for (int k = dim; k > 1; k--)
            std::swap(x[static_cast<std::size_t>(k) - 1], x[random.below(static_cast<std::size_t>(k))]);
        for (int k = 0; k < dim; k++)
            if (random.below(2) == 0) x[k] = -x[k];
        points.push_back(x);
    }
    return points;
}

// Distances from the origin from 1 down to 1e-30.
Points spread(int dim, std::size_t n, Random& random) {
    Points points;
    const double ratio = std::pow(10, -30.0 / static_cast<double>(n));
    double length = 1;
    for (std::size_t i = 0; i < n; i++, length *= ratio) {
        Point x = random.direction(dim);
        for (int k = 0; k < dim; k++) x[k] *= length;
        points.push_back(x);
    }
    return points;
}

// To the ends of what is documented: magnitudes up to 2^500, distances from 2^-500.
Points extreme(int dim, std::size_t n, Random& random) {
    Points points = in_ball(dim, n, random);
    const double scales[] = {0x1p499, 0x1p300, 0x1p-300, 0x1p-480};
    const double scale = scales[random.below(4)];
    for (Point& x : points)
        for (int k = 0; k < dim; k++) x[k] *= scale;
    return points;
}

Points repeated(int dim, std::size_t n, Random& random) {
    Points points = in_ball(dim, n / 2 + 1, random);
    points[0] = {};
    points.push_back({});
    for (int k = 0; k < dim; k++) points.back()[k] = -0.0;
    while (points.size() < n) points.push_back(points[random.below(points.size())]);
    return points;
}

// Pairs at a distance far below that of the pairs.
Points pairs(int dim, std::size_t n, Random& random) {
    const double gap = std::pow(10, -static_cast<double>(1 + random.below(10)));
    Points points;
    for (std::size_t i = 0; i < n / 2; i++) {
        Point x = ball_point(dim, random);
        points.push_back(x);
        const Point d = random.direction(dim);
        for (int k = 0; k < dim; k++) x[k] += gap * d[k];
        points.push_back(x);
    }
    return points;
}

}  // namespace

const std::vector<Family>& families() {
    static const std::vector<Family> all = {
        {"one to five points", few},
        {"flat", flat},
        {"collinear", on_line},
        {"curve", curve},
        {"clusters 1e-12 wide", [](int dim, std::size_t n, Random& r) { return clusters(dim, n, r, 1e-12); }},
        {"clusters", [](int dim, std::size_t n, Random& r) { return clusters(dim, n, r, 1e-3); }},
        {"grid", grid},
        {"grid bent by ulps", bent_grid},
        {"cospherical", cospherical},
        {"spread 1e30", spread},
        {"extreme magnitudes", extreme},
        {"repeated points", repeated},
        {"pairs", pairs},
        {"random", in_ball},
        {"polytopes bent by ulps", bent_polytope},
        {"scales parted by ulps", parted},
    };
    return all;
}

std::vector<NamedInput> named_inputs(std::size_t share) {
    Random random(1);
    std::vector<NamedInput> all;
    const auto add = [&](const char* name, int dim, double tau, std::size_t n, const auto& point) {
        NamedInput input = {name, dim, tau, {}};
        n = std::max<std::size_t>(3, n / share);
        for (std::size_t i = 0; i < n; i++) {
            const double t = static_cast<double>(i) / static_cast<double>(n - 1);
            input.points.push_back(point(t, static_cast<double>(i)));
        }
        all.push_back(input);
    };
    add("even points of a line in space", 3, 2.5, 200, [](double, double i) { return Point{i}; });
    add("random points of a line in space", 3, 2.5, 200, [&](double, double) { return Point{random.unit()}; });
    add("an arc in space", 3, 3, 300, [](double t, double) { return Point{std::cos(t), std::sin(t), t * t / 20}; });
    add("a plane in R^4", 4, 3, 150, [&](double, double) { return Point{random.unit(), random.unit()}; });
    add("a circle in R^4", 4, 3, 60, [](double t, double) { return Point{std::cos(6 * t), std::sin(6 * t)}; });
    add("three points in R^4", 4, 3, 3, [](double, double i) {
        return i == 0 ? Point{-1} : i == 1 ? Point{1} : Point{0.35, 0.1};
    });
    return all;
}

}  // namespace referee
