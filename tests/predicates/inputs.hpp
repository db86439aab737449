// Points that predicates find hard, D+2 at a time. Random draws are sequenced, so that every compiler makes the same.
#pragma once
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <utility>
#include <vector>

namespace inputs {

enum class Kind {
    uniform,           // 53 random bits
    grid,              // a coarse grid, scaled and moved
    cospherical,       // integer points of one norm, moved
    flips,             // sign changes and permutations of one vector of 53-bit coordinates
    flips_ulp,         // the same, one coordinate one unit in the last place off
    hyperplane,        // all points on a hyperplane
    hyperplane_ulp,    // the same, one coordinate one unit in the last place off
    cluster,           // a tiny cell and a far point
    zoom,              // points at distances 2^-i
    own_scales,        // each point at its own scale
    mixed_scales,      // flips of a vector with exponents between -70 and 70
    full_range,        // random bit patterns
    full_range_flips,  // flips of a random bit pattern
    denormal,          // small multiples of the least double
    denormal_flips,    // flips of denormals
    offset_flips,      // finely resolved flips, far from the origin along one axis
    extremes,          // tiny and huge points together
    huge,              // near the greatest double, so that differences overflow
    specials,          // from a short list of extremes, with both zeros
    count
};

inline const char* name(Kind kind) {
    static const char* const names[] = {"uniform",      "grid",      "cospherical", "flips",    "flips_ulp",
                                        "plane",        "plane_ulp", "cluster",     "zoom",     "own_scales",
                                        "mixed_scales", "range",     "range_flips", "denormal", "denormal_flips",
                                        "offset_flips", "extremes",  "huge",        "specials"};
    return names[static_cast<int>(kind)];
}

// Numbers so long that the oracle takes a millisecond.
inline bool is_slow(Kind kind) {
    return kind == Kind::full_range || kind == Kind::full_range_flips || kind == Kind::extremes ||
           kind == Kind::own_scales || kind == Kind::specials;
}

using Point = std::vector<double>;

class Source {
public:
    explicit Source(std::uint64_t seed) : engine_(seed) {}

    std::uint64_t below(std::uint64_t n) { return engine_() % n; }
    bool coin() { return (engine_() & 1) != 0; }
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    int between(int a, int b) { return a + static_cast<int>(below(static_cast<std::uint64_t>(b - a + 1))); }
    double any_finite() {
        for (;;) {
            const std::uint64_t bits = engine_();
            double x;
            std::memcpy(&x, &bits, sizeof x);
            if (std::isfinite(x)) return x;
        }
    }

    std::vector<Point> points(Kind kind, int dim) {
        std::vector<Point> p(static_cast<std::size_t>(dim) + 2, Point(static_cast<std::size_t>(dim)));
        switch (kind) {
        case Kind::uniform: each(p, [&] { return 2 * unit() - 1; }); break;
        case Kind::grid: {
            const double step = coin() ? 1 : 0.1;
            const double shift = coin() ? 0 : 1000;
            const int side = between(2, 5);
            each(p, [&] { return shift + step * between(0, side - 1); });
            break;
        }
        case Kind::cospherical: {
            const int width = between(1, 20);
            flips(p, [&] { return std::ldexp(between(1, 1 << width), -10); });
            move_all(p, std::ldexp(between(0, 1 << 20), -10));
            break;
        }
        case Kind::flips:
        case Kind::flips_ulp: flips(p, [&] { return 1 + unit(); }); break;
        case Kind::hyperplane:
        case Kind::hyperplane_ulp: {
            each(p, [&] { return std::ldexp(between(-(1 << 25), 1 << 25), -25); });
            for (Point& x : p) x.back() = dim > 2 ? 3 * x[0] - 5 * x[1] : 3 * x[0];
            break;
        }
        case Kind::cluster: {
            const double size = std::ldexp(1, -between(5, 45));
            each(p, [&] { return 0.5 + size * unit(); });
            for (double& x : p.back()) x = unit();
            break;
        }
        case Kind::zoom: {
            const int step = between(1, 30);
            for (std::size_t i = 0; i < p.size(); ++i)
                for (double& x : p[i]) x = std::ldexp(2 * unit() - 1, -step * static_cast<int>(i));
            break;
        }
        case Kind::own_scales: {
            const int spread = between(60, 500);
            for (Point& x : p) {
                const int exponent = between(-spread, spread);
                for (double& c : x) c = std::ldexp(2 * unit() - 1, exponent);
            }
            break;
        }
        case Kind::mixed_scales:
            flips(p, [&] {
                const double m = 1 + unit();
                return std::ldexp(m, between(-70, 70));
            });
            break;
        case Kind::full_range: each(p, [&] { return any_finite(); }); break;
        case Kind::full_range_flips: flips(p, [&] { return any_finite(); }); break;
        case Kind::denormal: {
            const int width = between(1, 53);
            each(p, [&] {
                const double whole = between(-3, 3);
                return std::ldexp(whole + unit(), width - 1074);
            });
            break;
        }
        case Kind::denormal_flips: {
            const int width = between(1, 52);
            flips(p, [&] { return std::ldexp(unit(), width - 1074); });
            break;
        }
        case Kind::offset_flips: {
            Point v(p[0].size());
            for (double& c : v) c = std::ldexp(between(1, 1 << 30) * 1024.0 + between(0, 1023), -60 + between(0, 15));
            v[0] = std::ldexp(between(1, 1 << 30), -40);
            for (Point& x : p) {
                for (std::size_t c = 0; c < v.size(); ++c) x[c] = coin() ? v[c] : -v[c];
                x[0] += 4096;
            }
            break;
        }
        case Kind::extremes:
            for (Point& x : p) {
                const bool tiny = coin();
                for (double& c : x) {
                    const double m = 2 * unit() - 1;
                    c = tiny ? std::ldexp(m, between(-1074, -1040)) : std::ldexp(m, between(1000, 1023));
                }
            }
            break;
        case Kind::huge:
            each(p, [&] {
                const double m = static_cast<double>(between(-3, 3)) / 3;
                return std::ldexp(coin() ? m : m * unit(), 1023);
            });
            break;
        default: {
            static const double list[] = {
                0.0,      -0.0,    1.0,      -1.0,         0x1p-1074,    -0x1p-1074,
                1e308,    -1e308,  0x1p1023, 1 + 0x1p-52,  0x1p-1022,    0x1.fffffffffffffp1023,
                0x1p-500, 0x1p500, 0.1,      -0x1.8p-1000, -0x1.5p+1000, 3.0};
            each(p, [&] { return list[below(sizeof list / sizeof list[0])]; });
            break;
        }
        }
        if (kind == Kind::flips_ulp || kind == Kind::hyperplane_ulp || (kind == Kind::offset_flips && coin())) {
            Point& moved = p[below(p.size())];
            double& x = moved[below(static_cast<std::uint64_t>(dim))];
            x = std::nextafter(x, coin() ? 10 : -10);
        }
        return p;
    }

private:
    template <class F> static void each(std::vector<Point>& p, F next) {
        for (Point& x : p)
            for (double& c : x) c = next();
    }
    template <class F> void flips(std::vector<Point>& p, F next) {
        Point v(p[0].size());
        for (double& c : v) c = next();
        for (Point& x : p) {
            for (std::size_t c = v.size() - 1; c > 0; --c) std::swap(v[c], v[below(c + 1)]);
            for (std::size_t c = 0; c < v.size(); ++c) x[c] = coin() ? v[c] : -v[c];
        }
    }
    static void move_all(std::vector<Point>& p, double shift) {
        for (Point& x : p)
            for (double& c : x) c += shift;
    }

    std::mt19937_64 engine_;
};

}  // namespace inputs
