// Point sets of all kinds that people bring, for what has to decide between jobs by the points alone.
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "common/inputs.hpp"

namespace kinds {

using inputs::Points;
using inputs::Random;

// On two skew lines of R^3, half of the points each: each has an edge to nearly all of the other line.
inline Points skew_lines(std::size_t n) {
    Random random(11);
    Points p;
    for (std::size_t i = 0; i < n; ++i) {
        const double t = 2 * random.uniform() - 1;
        if (i % 2 == 0)
            p.insert(p.end(), {t, 0, -0.5});
        else
            p.insert(p.end(), {0, t, 0.5});
    }
    return p;
}

// On the curve (t, t^2, .., t^D), 0 <= t < 1.
inline Points moment_curve(int dim, std::size_t n) {
    Points p;
    for (std::size_t i = 0; i < n; ++i) {
        double power = 1;
        for (int k = 0; k < dim; ++k) p.push_back(power *= static_cast<double>(i) / static_cast<double>(n));
    }
    return p;
}

// On the closed curve (cos t, sin t, cos 2 t, sin 2 t, ..), cut off after D coordinates.
inline Points closed_curve(int dim, std::size_t n) {
    Points p;
    for (std::size_t i = 0; i < n; ++i)
        for (int k = 0; k < dim; ++k) {
            const auto [c, s] = inputs::turn(i * static_cast<std::size_t>(k / 2 + 1), n);
            p.push_back(k % 2 == 0 ? c : s);
        }
    return p;
}

// On two circles of R^4 in planes at right angles with one centre, half of the points each.
inline Points orthogonal_circles(std::size_t n) {
    Random random(12);
    Points p;
    for (std::size_t i = 0; i < n; ++i) {
        const auto [c, s] = inputs::turn(random.below(1u << 20), 1u << 20);
        if (i % 2 == 0)
            p.insert(p.end(), {c, s, 0, 0});
        else
            p.insert(p.end(), {0, 0, c, s});
    }
    return p;
}

// Three turns of a helix.
inline Points helix(std::size_t n) {
    Points p;
    for (std::size_t i = 0; i < n; ++i) {
        const auto [c, s] = inputs::turn(3 * i, n);
        p.insert(p.end(), {c, s, 2 * static_cast<double>(i) / static_cast<double>(n) - 1});
    }
    return p;
}

// Each coordinate moved by up to `size`.
inline Points moved(Points points, double size) {
    Random random(13);
    for (double& x : points) x += size * (2 * random.uniform() - 1);
    return points;
}

struct Kind {
    const char* name;
    int dim;
    std::size_t count;  // of points, about
    std::function<Points(std::size_t)> make;
};

// From the plane to R^5, 100 to 20,000 points.
inline std::vector<Kind> all() {
    const auto uniform = [](int dim) { return [dim](std::size_t n) { return inputs::uniform(dim, n); }; };
    const auto clusters = [](int dim) { return [dim](std::size_t n) { return inputs::clusters(dim, n); }; };
    const auto sphere = [](int dim) { return [dim](std::size_t n) { return inputs::shell(dim, n, 1, 1, 9); }; };
    const auto grid = [](int dim, int side) { return [=](std::size_t) { return inputs::grid(dim, side); }; };
    const auto curve = [](int dim) { return [dim](std::size_t n) { return closed_curve(dim, n); }; };
    const auto moments = [](int dim) { return [dim](std::size_t n) { return moment_curve(dim, n); }; };
    const auto torus = [](std::size_t n) { return inputs::torus(n, 10); };
    return {
        {"uniform", 2, 100, uniform(2)},
        {"uniform", 2, 20000, uniform(2)},
        {"clusters", 2, 5000, clusters(2)},
        {"circle", 2, 2000, inputs::circle},
        {"noisy circle", 2, 100, [](std::size_t n) { return moved(inputs::circle(n), 0.05); }},
        {"noisy eight", 2, 3000, [](std::size_t n) { return inputs::eight(n, 0.1, 14); }},
        {"grid", 2, 4900, grid(2, 70)},
        {"uniform", 3, 200, uniform(3)},
        {"uniform", 3, 5000, uniform(3)},
        {"clusters", 3, 3000, clusters(3)},
        {"sphere", 3, 3000, sphere(3)},
        {"torus", 3, 2000, torus},
        {"torus", 3, 20000, torus},
        {"helix", 3, 1000, helix},
        {"noisy helix", 3, 2000, [](std::size_t n) { return moved(helix(n), 0.05); }},
        {"grid", 3, 3375, grid(3, 15)},
        {"skew lines", 3, 100, skew_lines},
        {"skew lines", 3, 2000, skew_lines},
        {"closed curve", 3, 2000, curve(3)},
        {"moment curve", 3, 1000, moments(3)},
        {"uniform", 4, 100, uniform(4)},
        {"uniform", 4, 1000, uniform(4)},
        {"sphere", 4, 500, sphere(4)},
        {"clusters", 4, 300, clusters(4)},
        {"grid", 4, 256, grid(4, 4)},
        {"orthogonal circles", 4, 400, orthogonal_circles},
        {"closed curve", 4, 300, curve(4)},
        {"moment curve", 4, 300, moments(4)},
        {"Clifford curve", 4, 500, inputs::clifford},
        {"uniform", 5, 100, uniform(5)},
        {"moment curve", 5, 100, moments(5)},
        {"grid", 5, 243, grid(5, 3)},
    };
}

}  // namespace kinds
