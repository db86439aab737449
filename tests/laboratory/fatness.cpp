#include "laboratory/fatness.hpp"

#include <doctest/doctest.h>

#include "common/dimensions.hpp"
#include "laboratory/common.hpp"
#include "laboratory/in_ball.hpp"

using namespace netmesh;

namespace {

// The in-ball's radius from all sets of D+1 constraints u_i . x + r = |w_i| / 2: the best feasible solution.
template <int D> double in_radius_by_exhaustion(const std::vector<double>& w) {
    const int count = static_cast<int>(w.size()) / D;
    double best = 0;
    any_subset(count, D + 1, [&](const std::vector<int>& chosen) {
        std::vector<std::vector<double>> a;
        for (int i : chosen) {
            const double* const p = &w[static_cast<std::size_t>(i) * D];
            const double zero[D] = {}, length = distance(p, zero, D);
            std::vector<double> row;
            for (int k = 0; k < D; ++k) row.push_back(p[k] / length);
            row.push_back(1);
            row.push_back(length / 2);
            a.push_back(row);
        }
        std::vector<double> y;
        if (!solve(a, &y) || !(y[D] > best)) return false;
        for (int i = 0; i < count; ++i) {
            const double* const p = &w[static_cast<std::size_t>(i) * D];
            const double zero[D] = {}, length = distance(p, zero, D);
            double dot = 0;
            for (int k = 0; k < D; ++k) dot += p[k] / length * y[static_cast<std::size_t>(k)];
            if (dot + y[D] > length / 2 + 1e-12) return false;
        }
        best = y[D];
        return false;
    });
    return best;
}

template <int D> FatnessAnalysis analyse(Held<D>& held) {
    FatnessAnalysis a;
    REQUIRE(analyse_fatness<D>(held.store, held.domain, {held.block.arena, held.monitor}, &a) == Status::ok);
    return a;
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("in-balls against all sets of constraints", T, in_balls) {
    constexpr int D = T::value;
    inputs::Random random(5);
    for (int trial = 0; trial < (D < 5 ? 200 : 8); ++trial) {
        std::vector<double> w;
        const int count = 2 * D + static_cast<int>(random.below(D == 2 ? 12 : 8));
        for (int i = 0; i < count; ++i)
            for (int k = 0; k < D; ++k)
                w.push_back(i < 2 * D ? (k == i / 2 ? (i % 2 ? 4 : -4) * (0.05 + random.uniform()) : 0)
                                      : 3 * random.uniform() - 1.5);
        double centre[D];
        const double radius = largest_inscribed_ball(D, w.data(), static_cast<std::uint32_t>(count), 1, centre);
        CHECK(radius == doctest::Approx(in_radius_by_exhaustion<D>(w)).epsilon(1e-9));
    }
}
TEST_CASE_TEMPLATE_APPLY(in_balls, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("cells of the integer grid are cubes: fatness sqrt D", T, cubes) {
    constexpr int D = T::value;
    Held<D> held;
    REQUIRE(held.triangulate(inputs::grid(D, D < 5 ? 4 : 3)) == Status::ok);
    const FatnessAnalysis a = analyse<D>(held);
    CHECK(a.bounded.cells == (D < 5 ? 1u << D : 1));
    CHECK(a.bounded.beta_max == doctest::Approx(std::sqrt(1.0 * D)).epsilon(1e-9));
    CHECK(a.bounded.beta_mean == doctest::Approx(std::sqrt(1.0 * D)).epsilon(1e-9));
    CHECK(a.bounded.aspect_max == doctest::Approx(std::sqrt(1.0 * D)).epsilon(1e-9));
    CHECK(violated_fatness_bound(a.bounded) == nullptr);
    CHECK(a.inside.cells == 0);
    CHECK(a.clipped == 0);
}
TEST_CASE_TEMPLATE_APPLY(cubes, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("bounds of chapter 5 hold on meshes and triangulations", T, bounds) {
    constexpr int D = T::value;
    constexpr std::size_t sizes = by_dimension<std::size_t>(D, {400, 150, 40, 12, 6});
    constexpr double taus = by_dimension<double>(D, {2.5, 2.5, 3.08, 4, 4});
    for (const inputs::Points& points : {inputs::uniform(D, sizes), inputs::clusters(D, sizes / 2),
                                         inputs::zoom(D, D < 4 ? 40 : 4, 1), inputs::grid(D, D < 4 ? 4 : 2)}) {
        Held<D> held;
        REQUIRE(held.mesh(points, taus) == Status::ok);
        const FatnessAnalysis a = analyse<D>(held);
        for (const FatPart* part : {&a.bounded, &a.inside}) {
            CHECK(violated_fatness_bound(*part) == nullptr);
            CHECK(part->beta_max <= part->aspect_max * (1 + 1e-9));
            if (part->cells > 0) CHECK(part->beta_mean > 1);
        }
        CHECK(a.bounded.cells >= a.inside.cells);
        CHECK(a.bounded.cells >= a.clipped);
        CHECK(a.inside.aspect_max <= taus * (1 + 1e-5));
        if (D == 2) CHECK(a.inside.cells > 0);
        if (a.inside.cells > 0) CHECK(a.clipped_max >= a.inside.beta_max * (1 - 1e-9));
        CHECK(a.clipped_max < 6);
        if (D > 4) continue;
        Held<D> triangulated;
        REQUIRE(triangulated.triangulate(points) == Status::ok);
        CHECK(violated_fatness_bound(analyse<D>(triangulated).bounded) == nullptr);
    }
}
TEST_CASE_TEMPLATE_APPLY(bounds, Dimensions<>);

TEST_CASE("degrees and edges of a part are those of the triangulation") {
    Held<3> held;
    REQUIRE(held.mesh(inputs::uniform(3, 60), 2.5) == Status::ok);
    const FatnessAnalysis a = analyse<3>(held);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    std::vector<std::uint64_t> degree(held.state.vertex_count);
    for (std::uint32_t c = 0; c < held.state.cell_slots; ++c)
        for (std::uint32_t v : held.store.cell(c).vertex)
            for (std::uint32_t w : held.store.cell(c).vertex)
                if (v < w && held.store.vertex(v).marker != Marker::exempt &&
                    held.store.vertex(w).marker != Marker::exempt)
                    edges.emplace_back(v, w);
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& e : edges) ++degree[e.first], ++degree[e.second];
    CHECK(a.bounded.edges == edges.size());
    CHECK(a.bounded.degree_max == *std::max_element(degree.begin(), degree.end()));
    CHECK(a.bounded.cells == held.state.vertex_count - 6);
    // Faces of two to four vertices, none exempt.
    std::vector<std::vector<std::uint32_t>> faces;
    for (std::uint32_t c = 0; c < held.state.cell_slots; ++c)
        for (unsigned set = 0; set < 16; ++set) {
            std::vector<std::uint32_t> face;
            for (unsigned i = 0; i < 4; ++i)
                if ((set >> i & 1u) && held.store.vertex(held.store.cell(c).vertex[i]).marker != Marker::exempt)
                    face.push_back(held.store.cell(c).vertex[i]);
            std::sort(face.begin(), face.end());
            if (face.size() > 1) faces.push_back(face);
        }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    CHECK(a.bounded.faces >= static_cast<double>(faces.size()));
}

TEST_CASE("a wheel: one cell that is bounded, with as many corners as there are spokes") {
    inputs::Points points = inputs::cospherical(2, 32045);
    const std::size_t spokes = points.size() / 2;
    points.insert(points.end(), {0, 0});
    Held<2> held;
    REQUIRE(held.triangulate(points) == Status::ok);
    const FatPart part = analyse<2>(held).bounded;
    CHECK(spokes > 60);
    CHECK(part.cells == 1);
    CHECK(part.edges == 0);
    CHECK(part.faces == 0);
    CHECK(part.beta_max < 1.1);
    CHECK(violated_fatness_bound(part) == nullptr);
}

TEST_CASE("points whose distances have no squares that doubles hold") {
    Held<2> held;
    REQUIRE(held.triangulate(inputs::zoom(2, 1000, 1)) == Status::ok);
    const FatPart part = analyse<2>(held).bounded;
    CHECK(part.cells > 300);
    CHECK(part.cells < 600);
    CHECK(violated_fatness_bound(part) == nullptr);
}

TEST_CASE("figures that break a bound are found out") {
    Held<2> held;
    REQUIRE(held.mesh(inputs::uniform(2, 100), 2.5) == Status::ok);
    const FatPart good = analyse<2>(held).inside;
    REQUIRE(violated_fatness_bound(good) == nullptr);
    FatPart a = good;
    a.edges = static_cast<std::uint64_t>(good.edges_bound) + 1;
    CHECK(violated_fatness_bound(a) != nullptr);
    a = good;
    a.faces = 2 * good.faces_bound;
    CHECK(violated_fatness_bound(a) != nullptr);
    for (double FatPart::*share : {&FatPart::degree_share, &FatPart::planar_share, &FatPart::corners_share}) {
        a = good;
        a.*share = 1.01;
        CHECK(violated_fatness_bound(a) != nullptr);
    }
}

// Of v, p and q nearly on a line with it and r on the other side the cell is a triangle with a corner far away, whose
// place is known to few digits. The fatness that is told is no less than that of the triangle in more digits.
TEST_CASE("fatness is not underestimated where corners are known to few digits") {
    using Real = long double;
    struct Point {
        Real x, y;
    };
    inputs::Random random(19);
    int told = 0;
    for (int trial = 0; trial < 400; ++trial) {
        CAPTURE(trial);
        const double flat = std::ldexp(1, -6 - trial % 14), dx = 0.3 + random.uniform(), dy = 0.3 + random.uniform();
        const auto place = [&](double along, double across) {
            return std::vector<double>{along * dx - across * dy, along * dy + across * dx};
        };
        std::vector<double> w[3] = {place(1 + random.uniform(), flat), place(-1 - random.uniform(), flat),
                                    place(0.2 * random.uniform(), -1 - random.uniform())};
        inputs::Points points = {0, 0};
        for (const auto& p : w) points.insert(points.end(), p.begin(), p.end());
        Held<2> held(std::size_t{1} << 16);
        REQUIRE(held.triangulate(points) == Status::ok);
        const FatPart part = analyse<2>(held).bounded;
        if (part.cells == 0) continue;  // the corner is not known at all
        ++told;
        // x . w_i = |w_i|^2 / 2 are the sides.
        const auto corner = [&](int i, int j) {
            const Real a = w[i][0], b = w[i][1], c = w[j][0], d = w[j][1], e = (a * a + b * b) / 2,
                       f = (c * c + d * d) / 2, det = a * d - b * c;
            return Point{(e * d - b * f) / det, (a * f - e * c) / det};
        };
        const Point corners[3] = {corner(0, 1), corner(1, 2), corner(2, 0)};
        Real side[3], longest = 0, sum = 0, squares = 0;
        for (int i = 0; i < 3; ++i) {
            const Point &a = corners[i], &b = corners[(i + 1) % 3];
            side[i] = std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
            longest = std::max(longest, side[i]);
            sum += side[i];
            squares += side[i] * side[i];
        }
        const Real twice = std::fabs((corners[1].x - corners[0].x) * (corners[2].y - corners[0].y) -
                                     (corners[1].y - corners[0].y) * (corners[2].x - corners[0].x));
        const bool obtuse = 2 * longest * longest >= squares;
        const Real out = obtuse ? longest / 2 : side[0] * side[1] * side[2] / (2 * twice), in = twice / sum;
        CHECK(part.beta_max >= static_cast<double>(out / in * (1 - 0x1p-44L)));
        CHECK(part.beta_max <= static_cast<double>(out / in * 1.02L));
    }
    CHECK(told > 200);
}
