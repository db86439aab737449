// Point sets by formula, row-major [n][dim], the same on every platform when compiled without contraction; gaussian
// goes through libm and is for tests whose answers do not depend on the last bit.
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace inputs {

using Points = std::vector<double>;

// splitmix64
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }
    // Uniform in [0, 1).
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    std::uint64_t below(std::uint64_t n) { return bits() % n; }

private:
    std::uint64_t state_;
};

inline Points uniform(int dim, std::size_t n, std::uint64_t seed = 1) {
    Random random(seed);
    Points p(n * static_cast<std::size_t>(dim));
    for (double& x : p) x = random.uniform();
    return p;
}

inline Points gaussian(int dim, std::size_t n, std::uint64_t seed = 2) {
    Random random(seed);
    Points p(n * static_cast<std::size_t>(dim));
    for (double& x : p) {
        const double u = 1.0 - random.uniform(), v = random.uniform();
        x = std::sqrt(-2.0 * std::log(u)) * std::cos(6.283185307179586 * v);
    }
    return p;
}

// About sqrt(n) clusters; cluster k has width 2^-(k mod 21), so distances span six decades.
inline Points clusters(int dim, std::size_t n, std::uint64_t seed = 3) {
    Random random(seed);
    std::size_t count = 1;
    while (count * count < n) ++count;
    const Points centres = uniform(dim, count, seed + 1000);
    Points p;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t k = i % count;
        for (int a = 0; a < dim; ++a)
            p.push_back(centres[k * static_cast<std::size_t>(dim) + static_cast<std::size_t>(a)] +
                        std::ldexp(random.uniform() - 0.5, -static_cast<int>(k % 21)));
    }
    return p;
}

// All integer points of [0, side)^dim.
inline Points grid(int dim, int side) {
    Points p;
    std::vector<int> x(static_cast<std::size_t>(dim), 0);
    for (;;) {
        for (int v : x) p.push_back(v);
        std::size_t a = 0;
        while (a < x.size() && ++x[a] == side) x[a++] = 0;
        if (a == x.size()) return p;
    }
}

// All integer points whose squared norm is exactly `norm_squared`.
inline Points cospherical(int dim, int norm_squared) {
    int reach = 0;
    while ((reach + 1) * (reach + 1) <= norm_squared) ++reach;
    Points p;
    std::vector<int> x(static_cast<std::size_t>(dim), -reach);
    for (;;) {
        int sum = 0;
        for (int v : x) sum += v * v;
        if (sum == norm_squared)
            for (int v : x) p.push_back(v);
        std::size_t a = 0;
        while (a < x.size() && ++x[a] > reach) x[a++] = -reach;
        if (a == x.size()) return p;
    }
}

// Points at distance about 2^-i from the origin for i = 0, step, 2 step, ... up to i_max: every scale of a double once.
inline Points zoom(int dim, int i_max, int step, std::uint64_t seed = 4) {
    Random random(seed);
    Points p;
    for (int i = 0; i <= i_max; i += step)
        for (int a = 0; a < dim; ++a) p.push_back(std::ldexp(2.0 * random.uniform() - 1.0, -i));
    return p;
}

// The origin and points at distance ratio^-i from it, i = 0 .. count-1, as far as distances of 2^-490 go.
inline Points geometric(int dim, double ratio, std::size_t count, std::uint64_t seed = 6) {
    Random random(seed);
    Points p(static_cast<std::size_t>(dim), 0.0);
    double size = 1;
    for (std::size_t i = 0; i < count && size > 0x1p-490; ++i, size /= ratio) {
        double squared = 0;
        Points x(static_cast<std::size_t>(dim));
        while (!(squared > 0.01 && squared <= 1)) {
            squared = 0;
            for (double& c : x) {
                c = 2 * random.uniform() - 1;
                squared += c * c;
            }
        }
        for (double c : x) p.push_back(c / std::sqrt(squared) * size);
    }
    return p;
}

// `count` pairs of points, the two of a pair about `gap` apart.
inline Points close_pairs(int dim, std::size_t count, double gap, std::uint64_t seed = 8) {
    Random random(seed);
    const Points first = uniform(dim, count, seed + 1);
    Points p = first;
    for (double c : first) p.push_back(c + gap * (0.1 + random.uniform()));
    return p;
}

// Cubes of points about the origin, each 1 / ratio the size of the one before.
inline Points nested(int dim, int levels, std::size_t count, double ratio, std::uint64_t seed = 9) {
    Points p;
    double size = 1;
    for (int level = 0; level < levels; ++level, size /= ratio)
        for (double c : uniform(dim, count, seed + static_cast<std::uint64_t>(level))) p.push_back(size * (c - 0.5));
    return p;
}

// (cos, sin) of the angle i/n of a turn, by + - * / alone: within 2 ulp, the same on every platform.
inline std::pair<double, double> turn(std::uint64_t i, std::uint64_t n) {
    i %= n;
    const std::uint64_t octant = 8 * i / n;
    // The angle to the nearest multiple of a quarter turn, at most an eighth: t = (4 i - q n) / n quarter turns.
    const std::uint64_t q = (octant + 1) / 2;
    const double t =
        (static_cast<double>(4 * i) - static_cast<double>(q * n)) / static_cast<double>(n) * 1.5707963267948966;
    double c = 1.0, s = 1.0;
    for (int k = 11; k >= 1; --k) {
        c = 1.0 - c * t * t / static_cast<double>((2 * k - 1) * (2 * k));
        s = 1.0 - s * t * t / static_cast<double>((2 * k) * (2 * k + 1));
    }
    s *= t;
    switch (q & 3) {
    case 0: return {c, s};
    case 1: return {0.0 - s, c};
    case 2: return {0.0 - c, 0.0 - s};
    default: return {s, 0.0 - c};
    }
}

inline Points circle(std::size_t n) {
    Points p;
    for (std::size_t i = 0; i < n; ++i) {
        const auto [c, s] = turn(i, n);
        p.insert(p.end(), {c, s});
    }
    return p;
}

// The closed curve (cos t, sin t, cos 10 t, sin 10 t) in R^4 (thesis 7.7).
inline Points clifford(std::size_t n) {
    Points p;
    for (std::size_t i = 0; i < n; ++i) {
        const auto [a, b] = turn(i, n);
        const auto [c, d] = turn(10 * i, n);
        p.insert(p.end(), {a, b, c, d});
    }
    return p;
}

// Every point `copies` times, in a fixed shuffled order.
inline Points repeated(int dim, const Points& points, int copies, std::uint64_t seed = 5) {
    const std::size_t d = static_cast<std::size_t>(dim), n = points.size() / d;
    std::vector<std::size_t> order;
    for (int c = 0; c < copies; ++c)
        for (std::size_t i = 0; i < n; ++i) order.push_back(i);
    Random random(seed);
    for (std::size_t i = order.size(); i > 1; --i) {
        const std::size_t j = random.below(i), t = order[i - 1];
        order[i - 1] = order[j];
        order[j] = t;
    }
    Points p;
    for (std::size_t i : order)
        p.insert(p.end(), points.begin() + static_cast<std::ptrdiff_t>(i * d),
                 points.begin() + static_cast<std::ptrdiff_t>((i + 1) * d));
    return p;
}

// A grid of unit cells, each coordinate moved by less than size.
inline Points jittered(int dim, int side, double size, std::uint64_t seed) {
    Points p = grid(dim, side);
    Random random(seed);
    for (double& x : p) x += size * random.uniform();
    return p;
}

// Directions spread evenly by rejection, radii in [low, high].
inline Points shell(int dim, std::size_t n, double low, double high, std::uint64_t seed) {
    Random random(seed);
    Points p;
    while (p.size() < n * static_cast<std::size_t>(dim)) {
        std::vector<double> x;
        double squared = 0;
        for (int d = 0; d < dim; ++d) {
            x.push_back(2 * random.uniform() - 1);
            squared += x.back() * x.back();
        }
        if (squared > 1 || squared < 0.01) continue;
        const double radius = (low + (high - low) * random.uniform()) / std::sqrt(squared);
        for (double c : x) p.push_back(c * radius);
    }
    return p;
}

// On the torus of radii 2 and 1.
inline Points torus(std::size_t n, std::uint64_t seed) {
    Random random(seed);
    Points p;
    for (std::size_t i = 0; i < n; ++i) {
        const auto [a, b] = turn(random.below(1u << 20), 1u << 20);
        const auto [c, d] = turn(random.below(1u << 20), 1u << 20);
        p.insert(p.end(), {(2 + a) * c, (2 + a) * d, b});
    }
    return p;
}

// Two circles that touch.
inline Points eight(std::size_t n, double noise, std::uint64_t seed) {
    Random random(seed);
    Points p;
    for (std::size_t i = 0; i < n; ++i) {
        const auto [c, s] = turn(i, n);
        p.push_back((i % 2 == 0 ? 1 : -1) * (1 + c) + noise * random.uniform());
        p.push_back(s + noise * random.uniform());
    }
    return p;
}

}  // namespace inputs
