// Small point sets that are nearly degenerate: points as programs compute them, on circles, spheres, flats and
// lattices, whose distances and radii are some units in the last place apart; and such points at all sizes of doubles.
// By + - * / and square roots alone, so that a seed gives the same points everywhere. No other header of the tests is
// needed.
//
//     families::Random random(seed);
//     std::vector<double> x = families::all()[i].make(random, dim, n);    // [n][dim], about n rows
//     families::move_units(random, 3, &x);                                // each coordinate moved by -3 to 3 units
//     families::moved(inputs::grid(3, 5), 3)                              // the same of any points
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace families {

using Points = std::vector<double>;
using Row = std::vector<double>;

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
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }  // [0, 1)
    double uniform(double from, double to) { return from + (to - from) * uniform(); }
    int whole(int from, int to) { return from + static_cast<int>(bits() % static_cast<std::uint64_t>(to - from + 1)); }
    bool one_in(int n) { return whole(1, n) == 1; }

private:
    std::uint64_t state_;
};

// x moved by so many units in the last place.
inline double moved(double x, int units) {
    for (; units > 0; --units) x = std::nextafter(x, std::numeric_limits<double>::max());
    for (; units < 0; ++units) x = std::nextafter(x, std::numeric_limits<double>::lowest());
    return x;
}
// Each coordinate by -units to units. Zeros stay: their neighbours are smaller than anything else by far.
inline void move_units(Random& random, int units, Points* x) {
    for (double& c : *x)
        if (c != 0) c = moved(c, random.whole(-units, units));
}

inline Points moved(Points x, int units, std::uint64_t seed = 1) {
    Random random(seed);
    move_units(random, units, &x);
    return x;
}

// A unit vector in k dimensions, as well as doubles can.
inline Row direction(Random& random, int k) {
    for (;;) {
        Row v(static_cast<std::size_t>(k));
        double square = 0;
        for (double& c : v) {
            c = random.uniform(-1, 1);
            square += c * c;
        }
        if ((k <= 6 && square > 1) || square < 0.01) continue;  // in a ball, but where balls fill little of a cube
        for (double& c : v) c /= std::sqrt(square);
        return v;
    }
}

// A place and a position in space: turns, then a shift, in doubles.
class Frame {
public:
    Frame(Random& random, int dim) : dim_(static_cast<std::size_t>(dim)), centre_(dim_) {
        const double reach = random.one_in(3) ? 0 : random.one_in(2) ? 1 : 100;
        for (double& c : centre_) c = random.uniform(-reach, reach);
        scale_ = random.one_in(3) ? 1 : random.uniform(0.1, 40);
        if (random.one_in(4)) return;  // along the axes
        for (std::size_t i = 0; i < dim_; ++i)
            for (std::size_t j = i + 1; j < dim_; ++j) {
                const Row v = direction(random, 2);
                turns_.push_back({i, j, v[0], v[1]});
            }
    }
    // `local` has at most dim coordinates, the others are 0.
    void place(Row local, Points* x) const {
        local.resize(dim_);
        for (const Turn& t : turns_) {
            const double a = local[t.i], b = local[t.j];
            local[t.i] = t.c * a - t.s * b;
            local[t.j] = t.s * a + t.c * b;
        }
        for (std::size_t c = 0; c < dim_; ++c) x->push_back(centre_[c] + scale_ * local[c]);
    }

private:
    struct Turn {
        std::size_t i, j;
        double c, s;
    };
    std::size_t dim_;
    Row centre_;
    double scale_;
    std::vector<Turn> turns_;
};

// Corners of a regular polygon on the unit circle, each the one before turned on: within some units in the last place.
inline std::vector<Row> polygon(int corners) {
    const double t = 6.283185307179586 / corners;
    double c = 1, s = 1;
    for (int k = 15; k >= 1; --k) {
        c = 1 - c * t * t / ((2 * k - 1) * (2 * k));
        s = 1 - s * t * t / ((2 * k) * (2 * k + 1));
    }
    s *= t;
    std::vector<Row> p = {{1, 0}};
    for (int i = 1; i < corners; ++i) {
        const double x = p.back()[0], y = p.back()[1];
        p.push_back({c * x - s * y, s * x + c * y});
    }
    return p;
}

// Corners of a regular polytope in k dimensions: simplex, cross-polytope, cube; in space also those of five-fold
// symmetry.
inline std::vector<Row> polytope(Random& random, int k) {
    std::vector<Row> p;
    const std::size_t d = static_cast<std::size_t>(k);
    const int kind = random.whole(0, k == 3 ? 4 : 2);
    if (kind == 0) {
        // e_i, and the point on the diagonal as far from them as they are from each other
        for (std::size_t i = 0; i <= d; ++i) {
            Row v(d, i == d ? (1 - std::sqrt(k + 1.0)) / k : 0.0);
            if (i < d) v[i] = 1;
            p.push_back(v);
        }
    } else if (kind == 1) {
        for (std::size_t i = 0; i < 2 * d; ++i) {
            Row v(d, 0.0);
            v[i / 2] = i % 2 == 0 ? 1 : -1;
            p.push_back(v);
        }
    } else if (kind == 2) {
        for (std::size_t i = 0; i < std::size_t(1) << d; ++i) {
            Row v(d);
            for (std::size_t c = 0; c < d; ++c) v[c] = (i >> c & 1) != 0 ? 0.5 : -0.5;
            p.push_back(v);
        }
    } else {
        const double golden = (1 + std::sqrt(5.0)) / 2;
        for (std::size_t c = 0; c < 3; ++c)
            for (int signs = 0; signs < 4; ++signs) {
                const double a = signs & 1 ? -1 : 1, b = signs & 2 ? -golden : golden;
                Row v(3, 0.0);
                v[(c + 1) % 3] = kind == 3 ? a : a / golden;  // icosahedron; dodecahedron without its cube
                v[(c + 2) % 3] = b;
                p.push_back(v);
            }
        if (kind == 4)
            for (int i = 0; i < 8; ++i) p.push_back({i & 1 ? -1.0 : 1.0, i & 2 ? -1.0 : 1.0, i & 4 ? -1.0 : 1.0});
    }
    return p;
}

// n of the rows, in random order.
inline std::vector<Row> some_of(Random& random, std::vector<Row> rows, std::size_t n) {
    for (std::size_t i = rows.size(); i > 1; --i)
        std::swap(rows[i - 1], rows[static_cast<std::size_t>(random.whole(0, static_cast<int>(i) - 1))]);
    if (rows.size() > n) rows.resize(n);
    return rows;
}

inline Points uniform(Random& random, int dim, std::size_t n) {
    Points x(n * static_cast<std::size_t>(dim));
    for (double& c : x) c = random.uniform();
    return x;
}
inline Points small_integers(Random& random, int dim, std::size_t n) {
    Points x(n * static_cast<std::size_t>(dim));
    const int side = random.whole(1, 4);
    for (double& c : x) c = random.whole(0, side);
    return x;
}
inline Points tenths(Random& random, int dim, std::size_t n) {
    Points x(n * static_cast<std::size_t>(dim));
    const int side = random.whole(1, 5), shift = random.one_in(2) ? 0 : random.whole(-200, 200);
    for (double& c : x) c = 0.1 * (shift + random.whole(0, side));
    return x;
}
// On a sphere of dimension k - 1, in a flat of dimension k.
inline Points on_sphere(Random& random, int dim, int k, std::size_t n) {
    Points x;
    const Frame frame(random, dim);
    for (std::size_t i = 0; i < n; ++i) frame.place(direction(random, k), &x);
    return x;
}
inline Points circle(Random& random, int dim, std::size_t n) { return on_sphere(random, dim, 2, n); }
inline Points sphere(Random& random, int dim, std::size_t n) { return on_sphere(random, dim, dim, n); }
inline Points low_sphere(Random& random, int dim, std::size_t n) {
    return on_sphere(random, dim, random.whole(1, dim), n);
}
// Products of circles; in space the surface of revolution, in the plane two circles about one centre.
inline Points torus(Random& random, int dim, std::size_t n) {
    Points x;
    const Frame frame(random, dim);
    const double inner = random.one_in(2) ? 0.5 : random.uniform();
    for (std::size_t i = 0; i < n; ++i) {
        Row v;
        const Row u = direction(random, 2), w = direction(random, 2);
        if (dim == 2) {
            v = u;
            if (i % 2 != 0) v[0] *= inner, v[1] *= inner;
        } else if (dim == 3) {
            v = {(1 + inner * w[0]) * u[0], (1 + inner * w[0]) * u[1], inner * w[1]};
        } else {
            while (v.size() + 2 <= static_cast<std::size_t>(dim)) {
                const Row next = direction(random, 2);
                v.insert(v.end(), next.begin(), next.end());
            }
        }
        frame.place(v, &x);
    }
    return x;
}
// In a flat of lower dimension but for roundings.
inline Points flat(Random& random, int dim, std::size_t n) {
    Points x;
    const Frame frame(random, dim);
    const int k = random.whole(1, dim - 1);
    for (std::size_t i = 0; i < n; ++i) {
        Row v(static_cast<std::size_t>(k));
        for (double& c : v) c = random.uniform(-1, 1);
        frame.place(v, &x);
    }
    return x;
}
inline Points two_spheres(Random& random, int dim, std::size_t n) {
    const int k = random.whole(2, dim), l = random.whole(2, dim);
    const std::size_t first = n / 2;
    Points x = on_sphere(random, dim, k, first);
    const Points y = on_sphere(random, dim, l, n - first);
    x.insert(x.end(), y.begin(), y.end());
    return x;
}
inline Points sphere_in_noise(Random& random, int dim, std::size_t n) {
    Points x;
    const Frame frame(random, dim);
    const int k = random.whole(2, dim);
    const int noise = random.whole(1, 3);
    for (std::size_t i = 0; i < n; ++i) {
        Row v = direction(random, k);
        if (static_cast<int>(i) < noise) {
            v = direction(random, dim);
            const double out = random.one_in(2) ? random.uniform() : random.uniform(1, 2);
            for (double& c : v) c *= out;
        }
        frame.place(v, &x);
    }
    return x;
}
inline Points regular_polygon(Random& random, int dim, std::size_t n) {
    Points x;
    const Frame frame(random, dim);
    const int corners = std::max(3, static_cast<int>(n) + (random.one_in(3) ? random.whole(0, 3) : 0));
    for (const Row& v : some_of(random, polygon(corners), n)) frame.place(v, &x);
    move_units(random, random.whole(0, 3), &x);
    return x;
}
inline Points regular_polytope(Random& random, int dim, std::size_t n) {
    Points x;
    const Frame frame(random, dim);
    for (const Row& v : some_of(random, polytope(random, random.one_in(3) ? random.whole(2, dim) : dim), n))
        frame.place(v, &x);
    move_units(random, random.whole(0, 3), &x);
    return x;
}
inline Points lattice(Random& random, int dim, std::size_t n) {
    Points x;
    const std::size_t d = static_cast<std::size_t>(dim);
    const int kind = random.whole(0, 2);  // cubic, sheared by halves, hexagonal in pairs of coordinates
    const double root = std::sqrt(3.0) / 2, step = random.one_in(2) ? 1 : random.uniform(0.1, 10);
    const double shift = random.one_in(2) ? 0 : random.uniform(-50, 50);
    for (std::size_t i = 0; i < n; ++i) {
        Row v(d);
        for (double& c : v) c = random.whole(0, 2);
        if (kind == 1)
            for (std::size_t c = 0; c + 1 < d; ++c) v[c] += 0.5 * v[d - 1];
        if (kind == 2)
            for (std::size_t c = 0; c + 1 < d; c += 2) {
                v[c] += 0.5 * v[c + 1];
                v[c + 1] *= root;
            }
        for (const double c : v) x.push_back(shift + step * c);
    }
    move_units(random, random.whole(0, 3), &x);
    return x;
}
// A lattice bent by a paraboloid's last digits: cospherical but for these.
inline Points bent_lattice(Random& random, int dim, std::size_t n) {
    Points x;
    for (std::size_t i = 0; i < n; ++i) {
        double bend = 0;
        const std::size_t first = x.size();
        for (int c = 0; c < dim; ++c) {
            const double along = random.whole(0, 2);
            x.push_back(along);
            bend += along * along;
        }
        x[first] += 0x1p-45 * bend;
    }
    return x;
}
// Few places, some 2^-40 wide.
inline Points clusters(Random& random, int dim, std::size_t n) {
    Points x;
    for (std::size_t i = 0; i < n * static_cast<std::size_t>(dim); ++i)
        x.push_back(0.25 + 0.5 * random.whole(0, 1) + 0x1p-40 * random.uniform());
    return x;
}
// Copies of one simplex, of the size of a triangle up to that of a cell, each turned and shifted by itself.
inline Points copies(Random& random, int dim, std::size_t n) {
    Points x;
    const std::size_t corners = static_cast<std::size_t>(random.whole(2, std::min(dim + 1, 4)));
    std::vector<Row> simplex;
    for (std::size_t i = 0; i < corners; ++i) {
        Row v(static_cast<std::size_t>(dim));
        for (double& c : v) c = random.uniform(-1, 1);
        simplex.push_back(v);
    }
    while (x.size() < n * static_cast<std::size_t>(dim)) {
        std::vector<double> turn, shift;
        for (int i = 0; i < dim - 1; ++i) {
            const Row v = direction(random, 2);
            turn.insert(turn.end(), v.begin(), v.end());
        }
        for (int i = 0; i < dim; ++i) shift.push_back(random.uniform(-3, 3));
        for (Row v : simplex) {
            for (std::size_t i = 0; i + 1 < v.size(); ++i) {
                const double a = v[i], b = v[i + 1], c = turn[2 * i], s = turn[2 * i + 1];
                v[i] = c * a - s * b;
                v[i + 1] = s * a + c * b;
            }
            for (std::size_t i = 0; i < v.size(); ++i) x.push_back(shift[i] + v[i]);
        }
    }
    x.resize(n * static_cast<std::size_t>(dim));
    return x;
}
// A base point and 0 to 7 units in the last place of each coordinate.
inline Points last_digits(Random& random, int dim, std::size_t n) {
    Points base(static_cast<std::size_t>(dim)), x;
    const double size = std::ldexp(1, random.whole(-3, 3));
    for (double& c : base) c = random.one_in(5) ? 1 : size * random.uniform(-1, 1);
    const int units = random.whole(1, 7);
    for (std::size_t i = 0; i < n; ++i)
        for (const double c : base) x.push_back(moved(c, random.whole(0, units)));
    return x;
}
// Corners of boxes, whose angles are right but for some units in the last place.
inline Points right_angles(Random& random, int dim, std::size_t n) {
    Points x;
    const std::size_t d = static_cast<std::size_t>(dim);
    Row low(d), high(d);
    for (std::size_t c = 0; c < d; ++c) {
        low[c] = random.one_in(3) ? 1 : random.uniform(0.5, 2);
        high[c] = low[c] + (random.one_in(3) ? 1 : random.uniform());
    }
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t c = 0; c < d; ++c) x.push_back(random.one_in(2) ? low[c] : high[c]);
    move_units(random, random.whole(1, 2), &x);
    return x;
}
// Two points, and others on the sphere that has them for a diameter: angles nearly right, of whole simplices as well.
inline Points thales(Random& random, int dim, std::size_t n) {
    Points x;
    const Frame frame(random, dim);
    Row pole(static_cast<std::size_t>(dim), 0.0);
    pole[0] = 1;
    frame.place(pole, &x);
    pole[0] = -1;
    frame.place(pole, &x);
    for (std::size_t i = 2; i < n; ++i) {
        Row v = direction(random, random.whole(2, dim));
        if (random.one_in(4)) v[0] *= 1 + std::ldexp(1, -random.whole(20, 52));
        frame.place(v, &x);
    }
    x.resize(n * static_cast<std::size_t>(dim));
    move_units(random, random.whole(0, 2), &x);
    return x;
}
// Points of integers on one circle or sphere, exactly, then shifted and moved.
inline Points whole_circle(Random& random, int dim, std::size_t n) {
    static const double on[][2] = {{3, 4}, {4, 3}, {5, 0}, {0, 5}};
    Points x;
    const double shift = random.one_in(2) ? 0 : random.whole(1, 20);
    for (std::size_t i = 0; i < n; ++i) {
        Row v(static_cast<std::size_t>(dim), 0.0);
        const double* const at = on[random.whole(0, 3)];
        const int first = random.whole(0, dim - 1), second = (first + random.whole(1, dim - 1)) % dim;
        v[static_cast<std::size_t>(first)] = random.one_in(2) ? at[0] : -at[0];
        v[static_cast<std::size_t>(second)] = random.one_in(2) ? at[1] : -at[1];
        for (const double c : v) x.push_back(shift + c);
    }
    if (!random.one_in(3)) move_units(random, random.whole(1, 2), &x);
    return x;
}
// Two groups far apart for their size: many distances share one double.
inline Points across_a_gap(Random& random, int dim, std::size_t n) {
    Points x;
    const int units = -random.whole(30, 52);
    for (std::size_t i = 0; i < n; ++i)
        for (int c = 0; c < dim; ++c)
            x.push_back((c == 0 && i % 2 == 0 ? 1 : 0.25) + std::ldexp(random.whole(0, 60), units));
    return x;
}
// Slivers: corners of a cell about one circle or in one flat, out of it by a power of two.
inline Points slivers(Random& random, int dim, std::size_t n) {
    Points x;
    const std::size_t d = static_cast<std::size_t>(dim);
    const Frame frame(random, dim);
    const int thin = random.whole(4, 50);
    for (std::size_t i = 0; i < n; ++i) {
        Row v = direction(random, dim - 1);
        v.resize(d);
        v[d - 1] = std::ldexp(random.uniform(-1, 1), -thin);
        if (dim == 2) v[0] = random.uniform(-1, 1);
        frame.place(v, &x);
    }
    return x;
}
inline Points far_away(Random& random, int dim, std::size_t n) {
    Points x = random.one_in(2) ? uniform(random, dim, n) : sphere(random, dim, n);
    const double offset = random.one_in(2) ? 1e8 : std::ldexp(1, random.whole(10, 40));
    for (double& c : x) c += offset;
    return x;
}

// One of the families above whose coordinates are of the order of 1.
inline Points near_one(Random& random, int dim, std::size_t n) {
    switch (random.whole(0, 9)) {
    case 0: return uniform(random, dim, n);
    case 1: return small_integers(random, dim, n);
    case 2: return tenths(random, dim, n);
    case 3: return sphere(random, dim, n);
    case 4: return circle(random, dim, n);
    case 5: return regular_polytope(random, dim, n);
    case 6: return lattice(random, dim, n);
    case 7: return last_digits(random, dim, n);
    case 8: return thales(random, dim, n);
    default: return flat(random, dim, n);
    }
}
inline void scale_all(double by, Points* x) {
    for (double& c : *x) c *= by;
}
inline Points any_size(Random& random, int dim, std::size_t n) {
    Points x = near_one(random, dim, n);
    scale_all(std::ldexp(1, random.whole(-300, 300)), &x);
    return x;
}
// Each point at a scale of its own.
inline Points mixed_sizes(Random& random, int dim, std::size_t n) {
    Points x = near_one(random, dim, n);
    const int reach = random.one_in(8) ? 300 : 40;
    double by = 1;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (i % static_cast<std::size_t>(dim) == 0) by = std::ldexp(1, random.whole(-reach, reach));
        x[i] *= by;
    }
    return x;
}
// Subnormal coordinates, and those around the least normal double.
inline Points subnormal(Random& random, int dim, std::size_t n) {
    Points x(n * static_cast<std::size_t>(dim));
    const int kind = random.whole(0, 3), side = random.whole(1, 40);
    for (double& c : x) switch (kind) {
        case 0: c = random.whole(0, side) * 0x1p-1074; break;
        case 1: c = 0x1p-1022 + random.whole(-side, side) * 0x1p-1074; break;
        case 2: c = random.whole(-1, 1) * 0x1p-1022 + random.whole(-2, 2) * 0x1p-1074; break;
        default: c = random.uniform() * 0x1p-1021;
        }
    if (kind == 3 && random.one_in(2)) {
        x = near_one(random, dim, n);
        scale_all(std::ldexp(1, -random.whole(1000, 1060)), &x);
    }
    return x;
}
// Up to the largest double: radii beyond it as well as just below.
inline Points huge(Random& random, int dim, std::size_t n) {
    Points x;
    const double top = std::numeric_limits<double>::max();
    if (random.one_in(2)) {
        x = Points(n * static_cast<std::size_t>(dim));
        const int kind = random.whole(0, 2);
        for (double& c : x) {
            const double size = kind == 0 ? top : kind == 1 ? moved(top, -random.whole(0, 3)) : random.uniform(0, top);
            c = random.one_in(2) ? size : random.one_in(2) ? -size : 0;
        }
        return x;
    }
    x = near_one(random, dim, n);
    double widest = 0;
    for (const double c : x) widest = std::max(widest, std::fabs(c));
    const double size = random.one_in(2) ? top : top / 2;
    for (double& c : x) c = widest > 0 ? c / widest * size : c;
    return x;
}
// Points of another family, some of them repeated.
inline Points duplicates(Random& random, int dim, std::size_t n) {
    const std::size_t d = static_cast<std::size_t>(dim);
    Points x = near_one(random, dim, std::max<std::size_t>(1, n - n / 4));
    const std::size_t rows = x.size() / d, more = static_cast<std::size_t>(random.whole(1, 3));
    for (std::size_t i = 0; i < more; ++i) {
        const std::size_t from = static_cast<std::size_t>(random.whole(0, static_cast<int>(rows) - 1)) * d;
        const Row row(x.begin() + static_cast<std::ptrdiff_t>(from), x.begin() + static_cast<std::ptrdiff_t>(from + d));
        const std::size_t to = static_cast<std::size_t>(random.whole(0, static_cast<int>(x.size() / d))) * d;
        x.insert(x.begin() + static_cast<std::ptrdiff_t>(to), row.begin(), row.end());
    }
    return x;
}

// For Rips complexes, of 7 coordinates and more.
inline Points many_coordinates(Random& random, int dim, std::size_t n) {
    switch (random.whole(0, 5)) {
    case 0: return tenths(random, dim, n);
    case 1: return sphere(random, dim, n);
    case 2: return last_digits(random, dim, n);
    case 3: return lattice(random, dim, n);
    case 4: return flat(random, dim, n);
    default: return uniform(random, dim, n);
    }
}

struct Family {
    const char* name;
    Points (*make)(Random& random, int dim, std::size_t n);  // n >= 1; fewer rows, or up to 3 more
};

inline const std::vector<Family>& all() {
    static const std::vector<Family> list = {
        {"uniform", uniform},
        {"small integers", small_integers},
        {"tenths", tenths},
        {"circle", circle},
        {"sphere", sphere},
        {"sphere in a flat", low_sphere},
        {"torus", torus},
        {"flat", flat},
        {"two spheres", two_spheres},
        {"sphere in noise", sphere_in_noise},
        {"regular polygon", regular_polygon},
        {"regular polytope", regular_polytope},
        {"lattice", lattice},
        {"bent lattice", bent_lattice},
        {"clusters", clusters},
        {"copies of a simplex", copies},
        {"last digits", last_digits},
        {"right angles", right_angles},
        {"thales", thales},
        {"whole circle", whole_circle},
        {"across a gap", across_a_gap},
        {"slivers", slivers},
        {"far away", far_away},
        {"any size", any_size},
        {"mixed sizes", mixed_sizes},
        {"subnormal", subnormal},
        {"huge", huge},
        {"duplicates", duplicates},
    };
    return list;
}

// Sets of which alpha diagrams were once wrong: bars that die before they are born, voids that are not there, a stop.
struct Named {
    const char* name;
    int dim;
    Points points;
};
inline const std::vector<Named>& named() {
    static const std::vector<Named> list = {
        {"circle of 4",
         2,
         {18.68285714285716, 100.105, 13.41, 104.82100000000001, 13.41, 107.179, 18.682857142857145,
          111.89500000000001}},
        {"crash of 5 on a sphere",
         3,
         {17.020770765953273, -6.618371990708326, 31.383376850441714, -16.339042021662838, 9.94309410534511,
          -11.084586908466807, 35.80723304316885, 6.774923502568242, -0.10757581870319477, -16.649869281105378,
          -9.02649968910476, -1.0162310192198767, 24.619214024477778, -5.431232228071039, -13.382657616296342}},
        {"wrong of 5 on a sphere",
         3,
         {34.38337501547035, 11.270053931723083, 41.39934154805584, 49.61286257907077, 16.991583028404655,
          12.97574247782118, -25.737757841938937, 36.142630735593926, 1.491500018254345, 18.449157075613932,
          18.793029116743067, -34.002909082979464, 28.44155625590474, -20.336067616559337, -20.28362804586806}},
    };
    return list;
}

}  // namespace families
