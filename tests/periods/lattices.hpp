// Points that repeat, for tests: lattices by name, cells of many kinds and points in special and general position.
// Coordinates are small whole numbers or multiples of a power of 2, so that all copies are doubles.
#pragma once
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "exact/families.hpp"
#include "truth.hpp"

namespace periods {

using families::Random;

constexpr int cell_kinds = 6;
constexpr int place_kinds = 8;
constexpr int weight_kinds = 7;

struct Recipe {
    int cell, place, weight, periods;
};

inline double determinant_of(const Numbers& b, std::size_t d) {  // of whole numbers, d = 2 or 3
    if (d == 2) return b[0] * b[3] - b[1] * b[2];
    return b[0] * (b[4] * b[8] - b[5] * b[7]) - b[1] * (b[3] * b[8] - b[5] * b[6]) + b[2] * (b[3] * b[7] - b[4] * b[6]);
}

// d vectors of whole numbers, of either orientation, in two or three dimensions.
inline Numbers make_cell(Random& random, int kind, std::size_t d) {
    Numbers b(d * d, 0.0);
    const auto whole = [&](int from, int to) { return static_cast<double>(random.whole(from, to)); };
    switch (kind) {
    case 0:  // cube
        for (std::size_t i = 0; i < d; ++i) b[i * d + i] = 2;
        break;
    case 1:  // box
        for (std::size_t i = 0; i < d; ++i) b[i * d + i] = whole(1, 5);
        break;
    case 2:  // nearly hexagonal; face-centred or body-centred
        if (d == 2) {
            b = random.one_in(2) ? Numbers{7, 4, 0, 8} : Numbers{1, 2, 2, -1};
            if (random.one_in(3)) b = {2, 0, 1, 2};
        } else {
            b = random.one_in(2) ? Numbers{0, 1, 1, 1, 0, 1, 1, 1, 0} : Numbers{-1, 1, 1, 1, -1, 1, 1, 1, -1};
        }
        break;
    case 5:  // extreme aspect
        for (std::size_t i = 0; i < d; ++i) b[i * d + i] = i == 0 ? whole(20, 60) : whole(1, 3);
        if (random.one_in(2)) b[d] = whole(-30, 30);
        break;
    default:  // any
        do {
            for (double& c : b) c = kind == 3 ? whole(-3, 3) : whole(-40, 40);
        } while (determinant_of(b, d) == 0);
    }
    if (random.one_in(2))  // the other hand
        for (std::size_t c = 0; c < d; ++c) b[c] = -b[c];
    return b;
}

// Another basis of the same lattice.
inline void skew(Random& random, int steps, Cloud* cloud) {
    const std::size_t d = cloud->width(), m = cloud->periods();
    Numbers& b = cloud->lattice;
    for (; steps > 0; --steps) {
        const std::size_t i = random.bits() % m, j = random.bits() % m;
        const double times = random.whole(-2, 2), sign = random.one_in(2) ? 1 : -1;
        for (std::size_t c = 0; c < d; ++c)
            b[i * d + c] = i == j ? sign * b[i * d + c] : b[i * d + c] + times * b[j * d + c];
        if (i != j && random.one_in(3))
            for (std::size_t c = 0; c < d; ++c) std::swap(b[i * d + c], b[j * d + c]);
    }
}
// Each point by a vector of the lattice.
inline void move_by_lattice(Random& random, int most, Cloud* cloud) {
    const std::size_t d = cloud->width();
    for (std::size_t i = 0; i < cloud->count(); ++i)
        for (std::size_t j = 0; j < cloud->periods(); ++j) {
            const double k = random.whole(-most, most);
            for (std::size_t c = 0; c < d; ++c) cloud->x[i * d + c] += k * cloud->lattice[j * d + c];
        }
}
inline void translate(Random& random, Cloud* cloud) {
    const std::size_t d = cloud->width();
    for (std::size_t c = 0; c < d; ++c) {
        const double by = random.whole(-50, 50);
        for (std::size_t i = 0; i < cloud->count(); ++i) cloud->x[i * d + c] += by;
    }
}
inline void permute(Random& random, Cloud* cloud) {
    const std::size_t d = cloud->width();
    for (std::size_t i = cloud->count(); i > 1; --i) {
        const std::size_t j = random.bits() % i;
        for (std::size_t c = 0; c < d; ++c) std::swap(cloud->x[(i - 1) * d + c], cloud->x[j * d + c]);
        if (!cloud->numbers.empty()) std::swap(cloud->numbers[i - 1], cloud->numbers[j]);
    }
}
// Twice the cell, along one vector.
inline Cloud supercell(const Cloud& cloud, std::size_t along) {
    Cloud twice = cloud;
    const std::size_t d = cloud.width();
    for (std::size_t i = 0; i < cloud.count(); ++i)
        for (std::size_t c = 0; c < d; ++c) twice.x.push_back(cloud.x[i * d + c] + cloud.lattice[along * d + c]);
    twice.numbers.insert(twice.numbers.end(), cloud.numbers.begin(), cloud.numbers.end());
    for (std::size_t c = 0; c < d; ++c) twice.lattice[along * d + c] *= 2;
    return twice;
}

inline void multiply(Numbers* x, double by) {
    for (double& c : *x) c *= by;
}

// n points; the cell, whole numbers so far, is made larger where points are at parts of it.
inline void place_points(Random& random, int kind, std::size_t n, Cloud* cloud) {
    const std::size_t d = cloud->width();
    Numbers& b = cloud->lattice;
    const double parts[] = {0, 2, 3, 4, 6, 8, 9, 10};  // of 12: halves, thirds, quarters, sixths
    const bool are_parts = kind == 1 || kind == 2 || kind == 7;
    if (are_parts) multiply(&b, kind == 2 ? 120 : 12);
    if (kind == 4) multiply(&b, 16);
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<double> p(d, 0.0);
        const bool is_again = kind == 7 && i > 0 && random.one_in(3);  // a copy of a point that is there
        for (std::size_t j = 0; j < d && are_parts && !is_again; ++j) {
            const double part = parts[random.bits() % (kind == 7 ? 3u : 8u)] / 12;
            for (std::size_t c = 0; c < d; ++c) p[c] += std::round(12 * part) * (b[j * d + c] / 12);
        }
        for (std::size_t c = 0; c < d; ++c) {
            if (kind == 0) p[c] = random.whole(0, 3);
            if (kind == 2) p[c] += random.whole(-1, 1);  // by one unit
            if (kind == 3) p[c] = random.whole(-60, 60);
            if (kind == 4) p[c] = c == 0 ? random.whole(0, 31) : 0;  // on a line
            if (kind == 5) p[c] = random.whole(0, 7) * 0.25;
            if (kind == 6) p[c] = random.whole(-1000000, 1000000) * 0x1p-19;
            if (is_again) p[c] = cloud->x[c] + b[c];
        }
        cloud->x.insert(cloud->x.end(), p.begin(), p.end());
    }
}

// The mean square of a cell's edges.
inline double area_of(const Cloud& cloud) {
    double sum = 0;
    for (const double c : cloud.lattice) sum += c * c;
    return std::ceil(sum / static_cast<double>(cloud.periods()));
}

inline void weigh(Random& random, int kind, Cloud* cloud) {
    if (kind == 0) return;
    const int area = static_cast<int>(std::min(area_of(*cloud), 1e6));
    const int equal = random.whole(-3, 20);
    for (std::size_t i = 0; i < cloud->count(); ++i) {
        double w = 0;
        if (kind == 1) w = equal;
        if (kind == 2) w = random.whole(0, 3);
        if (kind == 3) w = random.whole(0, std::max(1, area / 8));
        if (kind == 4) w = random.whole(-area, area);  // many hidden
        if (kind == 5) w = random.whole(-4, 4) * 0.25;
        if (kind == 6) w = random.whole(0, 12) * 0.125;  // radii
        cloud->numbers.push_back(w);
    }
    cloud->are_radii = kind == 6;
}

// One cloud; many choices at random, so a seed gives the same one everywhere.
inline Cloud make_cloud(Random& random, int dim, std::size_t count_max) {
    Cloud cloud;
    cloud.dim = dim;
    const std::size_t d = cloud.width();
    Recipe recipe;
    recipe.cell = random.whole(0, cell_kinds - 1);
    recipe.place = random.whole(0, place_kinds - 1);
    recipe.weight = random.one_in(2) ? 0 : random.whole(1, weight_kinds - 1);
    recipe.periods = random.one_in(3) ? random.whole(1, dim) : dim;
    const std::size_t n = static_cast<std::size_t>(random.whole(1, static_cast<int>(count_max)));
    cloud.lattice = make_cell(random, recipe.cell, d);
    place_points(random, recipe.place, n, &cloud);
    const std::size_t kept = static_cast<std::size_t>(recipe.periods);
    cloud.lattice.resize(kept * d);
    weigh(random, recipe.weight, &cloud);
    if (random.one_in(3)) skew(random, 3, &cloud);
    if (random.one_in(3)) move_by_lattice(random, 2, &cloud);
    return cloud;
}

inline void print_cloud(const Cloud& cloud) {
    const std::size_t d = cloud.width();
    std::printf("  %dD, %s\n", cloud.dim, cloud.numbers.empty() ? "no weights" : cloud.are_radii ? "radii" : "weights");
    for (std::size_t j = 0; j < cloud.periods(); ++j) {
        std::printf("  period");
        for (std::size_t c = 0; c < d; ++c) std::printf(" %.17g", cloud.lattice[j * d + c]);
        std::printf("\n");
    }
    for (std::size_t i = 0; i < cloud.count(); ++i) {
        std::printf("  point ");
        for (std::size_t c = 0; c < d; ++c) std::printf(" %.17g", cloud.x[i * d + c]);
        if (!cloud.numbers.empty()) std::printf("  %.17g", cloud.numbers[i]);
        std::printf("\n");
    }
}

inline bool lasts(const Bar& bar) { return std::isinf(bar.death); }
inline bool lasts(const ExactBar& bar) { return bar.is_essential; }
// Classes that last are those of a torus of as many dimensions as there are periods.
template <class List> bool is_torus(const Cloud& cloud, const List& bars) {
    std::size_t wanted = 1;
    for (std::size_t degree = 0; degree <= cloud.width(); ++degree) {
        std::size_t count = 0;
        for (const auto& bar : bars) count += bar.degree == degree && lasts(bar);
        if (count != wanted) return false;
        wanted = degree < cloud.periods() ? wanted * (cloud.periods() - degree) / (degree + 1) : 0;
    }
    return true;
}

// ---- by hand ----

struct Named {
    std::string name;
    Cloud cloud;
    ExactBars bars;  // of squared radii, or of powers
};

inline ExactBar last(std::size_t degree, mpq_class birth) { return {degree, birth, 0, true}; }
inline ExactBar bar(std::size_t degree, mpq_class birth, mpq_class death) { return {degree, birth, death, false}; }
inline Cloud cloud_of(int dim, Numbers x, Numbers lattice, Numbers weights = {}) {
    return {dim, std::move(x), std::move(lattice), std::move(weights), false};
}
inline void repeat(std::size_t times, const ExactBar& bar, ExactBars* bars) { bars->insert(bars->end(), times, bar); }

// A box has critical points in the middle of its faces alone: as many as a torus needs. Its sides, ascending, squared.
inline ExactBars bars_of_box(const std::vector<long>& sides) {
    ExactBars bars;
    for (unsigned set = 0; set < 1u << sides.size(); ++set) {
        std::size_t degree = 0;
        long sum = 0;
        for (std::size_t i = 0; i < sides.size(); ++i)
            if ((set >> i & 1u) != 0) {
                ++degree;
                sum += sides[i] * sides[i];
            }
        mpq_class value(sum, 4);
        value.canonicalize();
        bars.push_back(last(degree, value));
    }
    return bars;
}

inline std::vector<Named> named() {
    std::vector<Named> all;
    const auto add = [&](const char* name, Cloud cloud, ExactBars bars) {
        for (ExactBar& bar : bars) {
            bar.birth.canonicalize();
            bar.death.canonicalize();
        }
        std::sort(bars.begin(), bars.end());
        all.push_back({name, std::move(cloud), std::move(bars)});
    };
    add("square", cloud_of(2, {0, 0}, {1, 0, 0, 1}), bars_of_box({1, 1}));
    add("square, skewed", cloud_of(2, {5, -3}, {1, 7, 0, -1}), bars_of_box({1, 1}));
    add("rectangle", cloud_of(2, {0, 0}, {3, 0, 0, 4}), bars_of_box({3, 4}));
    add("cube", cloud_of(3, {0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1}), bars_of_box({1, 1, 1}));
    add("box", cloud_of(3, {1, 1, 1}, {2, 0, 0, 0, 3, 0, 0, 0, -7}), bars_of_box({2, 3, 7}));
    add("cube, four dimensions", cloud_of(4, {0, 0, 0, 0}, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}),
        bars_of_box({1, 1, 1, 1}));
    // Acute triangles, sides 2, sqrt 5, sqrt 5, and radius 5/4, two of them: the third edge cuts the hole in two.
    add("triangles", cloud_of(2, {0, 0}, {2, 0, 1, 2}),
        {last(0, 0), last(1, 1), last(1, {5, 4}), bar(1, {5, 4}, {25, 16}), last(2, {25, 16})});
    // Two rows of the square lattice: an edge more joins them, a square more is filled.
    add("two squares", cloud_of(2, {0, 0, 1, 0}, {2, 0, 0, 1}),
        {last(0, 0), bar(0, 0, {1, 4}), last(1, {1, 4}), last(1, {1, 4}), bar(1, {1, 4}, {1, 2}), last(2, {1, 2})});
    // Of a cubic cell of 2: 6 edges at 1/2, 8 triangles at 2/3, 2 tetrahedra at 3/4, an octahedron at 1.
    ExactBars fcc = {last(0, 0), last(3, 1)};
    repeat(3, last(1, {1, 2}), &fcc);
    repeat(3, bar(1, {1, 2}, {2, 3}), &fcc);
    repeat(3, last(2, {2, 3}), &fcc);
    repeat(2, bar(2, {2, 3}, {3, 4}), &fcc);
    add("face-centred", cloud_of(3, {0, 0, 0}, {0, 1, 1, 1, 0, 1, 1, 1, 0}), fcc);
    // Of a cubic cell of 2: 4 edges at 3/4 and 3 at 1, 12 triangles at 9/8, 6 tetrahedra at 5/4.
    ExactBars bcc = {last(0, 0), last(3, {5, 4}), bar(1, {3, 4}, {9, 8})};
    repeat(3, last(1, {3, 4}), &bcc);
    repeat(3, bar(1, 1, {9, 8}), &bcc);
    repeat(3, last(2, {9, 8}), &bcc);
    repeat(5, bar(2, {9, 8}, {5, 4}), &bcc);
    add("body-centred", cloud_of(3, {0, 0, 0}, {-1, 1, 1, 1, -1, 1, 1, 1, -1}), bcc);
    // Of a cubic cell of 4: 4 edges at 3/4 (one joins the two points), 8 triangles between second neighbours at 8/3,
    // the middles of 4 rings of six points at 11/4 and of 2 tetrahedra of second neighbours at 3.
    ExactBars diamond = {last(0, 0), bar(0, 0, {3, 4}), bar(2, {8, 3}, 3), last(3, 3)};
    repeat(3, last(1, {3, 4}), &diamond);
    repeat(3, last(2, {8, 3}), &diamond);
    repeat(4, bar(2, {8, 3}, {11, 4}), &diamond);
    add("diamond", cloud_of(3, {0, 0, 0, 1, 1, 1}, {0, 2, 2, 2, 0, 2, 2, 2, 0}), diamond);
    // Rows and layers of squares and cubes of 2, which repeat in one direction and in two.
    add("two rows", cloud_of(2, {0, 0, 0, 2}, {2, 0}), {last(0, 0), bar(0, 0, 1), last(1, 1), bar(1, 1, 2)});
    add("two layers", cloud_of(3, {0, 0, 0, 0, 0, 2}, {2, 0, 0, 0, 2, 0}),
        {last(0, 0), bar(0, 0, 1), last(1, 1), last(1, 1), bar(1, 1, 2), bar(1, 1, 2), last(2, 2), bar(2, 2, 3)});
    // For each period 4 points, 8 edges, 4 walls and a square between layers, a cube.
    add("four columns", cloud_of(3, {0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0}, {0, 0, 2}),
        {last(0, 0), bar(0, 0, 1), bar(0, 0, 1), bar(0, 0, 1), last(1, 1), bar(1, 1, 2), bar(1, 1, 2), bar(1, 1, 2),
         bar(1, 1, 2), bar(2, 2, 3)});
    // Equal weights move all powers; a light point in the middle of a square is hidden.
    add("square, weights", cloud_of(2, {0, 0}, {2, 0, 0, 2}, {3}),
        {last(0, -3), last(1, -2), last(1, -2), last(2, -1)});
    add("square, a hidden point", cloud_of(2, {0, 0, 1, 1}, {2, 0, 0, 2}, {0, -3}), bars_of_box({2, 2}));
    // The middle of a square of 2, weight -1, enters at 1, where its sides do. To a corner, weight 0, at squared
    // distance 2, powers are equal after 3/4 of the way: 9/8. Of the middle and two corners the centre is (1, 1/2):
    // 5/4. Of four edges one joins, three make loops; four triangles fill them and close the surface.
    add("square, a late point", cloud_of(2, {0, 0, 1, 1}, {2, 0, 0, 2}, {0, -1}),
        {last(0, 0), bar(0, 1, {9, 8}), last(1, 1), last(1, 1), bar(1, {9, 8}, {5, 4}), bar(1, {9, 8}, {5, 4}),
         bar(1, {9, 8}, {5, 4}), last(2, {5, 4})});
    return all;
}

}  // namespace periods
