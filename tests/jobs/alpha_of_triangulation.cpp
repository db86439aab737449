#include "jobs/alpha_of_triangulation.hpp"

#include "filtration/alpha.hpp"
#include "numerics/real.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "common/dimensions.hpp"
#include "common/polls.hpp"
#include "complex/triangulations.hpp"

using namespace netmesh;
using namespace netmesh_test;

namespace {

using Simplex = std::vector<std::uint32_t>;
using Values = std::map<Simplex, double>;

template <int D> struct Cloud {
    Cells<D> cells;
    std::vector<double> x;
    const double* point(std::uint32_t v) const { return x.data() + v * std::size_t{D}; }
    AlphaFiltration<D> filtration(std::ptrdiff_t stride_bytes = sizeof(double) * D) const {
        return {cells.view(), x.data(), stride_bytes, cells.hull_facets()};
    }
};

template <int D> Cloud<D> cloud(std::vector<double> x, std::vector<std::array<std::uint32_t, D + 1>> cells) {
    Cloud<D> c;
    c.x = std::move(x);
    c.cells.list = std::move(cells);
    c.cells.vertex_count = static_cast<std::uint32_t>(c.x.size() / D);
    return c;
}

template <int D> Values alpha(const Cloud<D>& c) {
    Block block(std::size_t{1} << 22);
    Monitor monitor;
    Faces<D> faces;
    REQUIRE(enumerate_faces<D>(c.cells.view(), D, {block.arena, monitor}, &faces) == Status::ok);
    double* value[D + 1];
    for (int k = 0; k <= D; ++k) value[k] = block.arena.template take_low<double>(faces.count[k]);
    REQUIRE(alpha_values<D>(faces, c.x.data(), D * sizeof(double), {block.arena, monitor}, value) == Status::ok);
    Values all;
    for (int k = 0; k <= D; ++k)
        for (std::uint32_t i = 0; i < faces.count[k]; ++i) {
            Simplex s(static_cast<std::size_t>(k + 1));
            faces.vertices(k, i, s.data());
            all[s] = value[k][i];
        }
    return all;
}

struct Diagram {
    std::vector<std::vector<std::pair<double, double>>> degree;
    std::uint64_t simplices;
};

template <int D>
Diagram diagram(const Cloud<D>& c, std::uint32_t max_degree = D, bool keep_zero = false, std::size_t stride = 0) {
    Block block(std::size_t{1} << 22);
    Monitor monitor;
    CountedPairs counted;
    Diagram out;
    const AlphaFiltration<D> filtration =
        stride == 0 ? c.filtration() : c.filtration(static_cast<std::ptrdiff_t>(stride));
    REQUIRE(alpha_of_triangulation<D>(filtration, {max_degree, keep_zero}, {block.arena, monitor}, &counted) ==
            Status::ok);
    const PairList& list = counted.pairs;
    out.simplices = counted.simplices;
    CHECK(block.arena.offset_of(list.pairs) == 0);
    CHECK(block.arena.bytes_used() == list.count * sizeof(Pair));
    for (std::uint64_t i = 0; i < list.count; ++i) {
        if (i > 0) CHECK(!CanonicalOrder{}(list.pairs[i], list.pairs[i - 1]));
        if (out.degree.size() <= list.pairs[i].degree) out.degree.resize(list.pairs[i].degree + 1);
        out.degree[list.pairs[i].degree].push_back({list.pairs[i].birth, list.pairs[i].death});
    }
    return out;
}

// An independent way to the values, in long double: centres from the normal equations, emptiness against all points.
template <int D> struct Oracle {
    const Cloud<D>& c;
    struct Ball {
        std::array<long double, D> centre;
        long double squared;
    };
    Ball ball(const Simplex& s) const {
        const std::size_t k = s.size() - 1;
        std::vector<std::vector<long double>> m(k, std::vector<long double>(k + 1));
        const auto edge = [&](std::size_t i, int d) {
            return static_cast<long double>(c.point(s[i + 1])[d]) - c.point(s[0])[d];
        };
        for (std::size_t i = 0; i < k; ++i)
            for (std::size_t j = 0; j < k; ++j)
                for (int d = 0; d < D; ++d) m[i][j] += edge(i, d) * edge(j, d);
        for (std::size_t i = 0; i < k; ++i) m[i][k] = m[i][i] / 2;
        for (std::size_t i = 0; i < k; ++i) {
            std::size_t pivot = i;
            for (std::size_t r = i; r < k; ++r)
                if (std::fabs(m[r][i]) > std::fabs(m[pivot][i])) pivot = r;
            std::swap(m[i], m[pivot]);
            for (std::size_t r = 0; r < k; ++r) {
                if (r == i) continue;
                const long double f = m[r][i] / m[i][i];
                for (std::size_t j = i; j <= k; ++j) m[r][j] -= f * m[i][j];
            }
        }
        Ball b{};
        for (int d = 0; d < D; ++d) {
            for (std::size_t i = 0; i < k; ++i) b.centre[d] += m[i][k] / m[i][i] * edge(i, d);
            b.squared += b.centre[d] * b.centre[d];
            b.centre[d] += c.point(s[0])[d];
        }
        return b;
    }
    long double power(const Ball& b, std::uint32_t v) const {
        long double s = -b.squared;
        for (int d = 0; d < D; ++d) s += (c.point(v)[d] - b.centre[d]) * (c.point(v)[d] - b.centre[d]);
        return s;
    }
    bool empty(const Simplex& s, const Ball& b) const {
        for (std::uint32_t v = 0; v < c.cells.vertex_count; ++v)
            if (std::find(s.begin(), s.end(), v) == s.end() && power(b, v) < -1e-14L * b.squared) return false;
        return true;
    }
};

// Delaunay triangulation of few points in general position, by definition.
template <int D> void triangulate(Cloud<D>& c) {
    c.cells.vertex_count = static_cast<std::uint32_t>(c.x.size() / D);
    const Oracle<D> oracle{c};
    Simplex s(D + 1);
    std::iota(s.begin(), s.end(), 0u);
    for (;;) {
        if (oracle.empty(s, oracle.ball(s))) {
            std::array<std::uint32_t, D + 1> cell;
            std::copy(s.begin(), s.end(), cell.begin());
            c.cells.list.push_back(cell);
        }
        std::size_t i = D + 1;
        while (i > 0 && s[i - 1] == c.cells.vertex_count - (D + 2 - i)) --i;
        if (i == 0) return;
        ++s[i - 1];
        for (; i <= D; ++i) s[i] = s[i - 1] + 1;
    }
}

template <int D> Values expected(const Cloud<D>& c, const Values& simplices) {
    const Oracle<D> oracle{c};
    Values values;
    for (std::size_t size = D + 1; size >= 1; --size)
        for (const auto& entry : simplices) {
            const Simplex& s = entry.first;
            if (s.size() != size) continue;
            const auto ball = oracle.ball(s);
            double value = static_cast<double>(std::sqrt(ball.squared));
            if (!oracle.empty(s, ball)) {
                value = infinity;
                for (std::uint32_t v = 0; v < c.cells.vertex_count; ++v) {
                    Simplex bigger = s;
                    bigger.insert(std::lower_bound(bigger.begin(), bigger.end(), v), v);
                    const auto it = values.find(bigger);
                    if (it != values.end() && it->second < value) value = it->second;
                }
            }
            values[s] = value;
        }
    return values;
}

void check_monotone(const Values& values) {
    std::size_t wrong = 0;
    for (const auto& entry : values)
        for (std::size_t i = 0; i < entry.first.size() && entry.first.size() > 1; ++i) {
            Simplex facet = entry.first;
            facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
            wrong += !(values.at(facet) <= entry.second);
        }
    CHECK(wrong == 0);
}

template <int D> void compare_with_definition(std::uint32_t points, double flatten, std::uint64_t seed) {
    CAPTURE(D);
    CAPTURE(flatten);
    CAPTURE(seed);
    Cloud<D> c;
    Random random{seed};
    for (std::uint32_t i = 0; i < points * D; ++i) c.x.push_back(random.unit() * (i % D == 0 ? flatten : 1));
    triangulate(c);
    const Values values = alpha(c);
    check_monotone(values);
    for (const auto& entry : expected(c, values))
        CHECK(values.at(entry.first) == doctest::Approx(entry.second).epsilon(1e-9));
}

}  // namespace

TEST_CASE("an acute triangle: edges at half their length, its H1 class lives until the circumradius") {
    const auto c = cloud<2>({0, 0, 4, 0, 2, 3}, {{0, 1, 2}});
    const double side = std::sqrt(13.0) / 2;
    const Values v = alpha(c);
    CHECK(v.at({0}) == 0);
    CHECK(v.at({0, 1}) == 2);
    CHECK(v.at({0, 2}) == side);
    CHECK(v.at({1, 2}) == side);
    CHECK(v.at({0, 1, 2}) == doctest::Approx(13.0 / 6).epsilon(1e-15));
    const Diagram d = diagram(c);
    REQUIRE(d.degree.size() == 2);
    CHECK(d.degree[0] == std::vector<std::pair<double, double>>{{0, side}, {0, side}, {0, infinity}});
    REQUIRE(d.degree[1].size() == 1);
    CHECK(d.degree[1][0].first == 2);
    CHECK(d.degree[1][0].second == v.at({0, 1, 2}));
    CHECK(d.simplices == 7);
}

TEST_CASE("an obtuse triangle: the longest edge enters with the triangle, at the circumradius") {
    const auto c = cloud<2>({0, 0, 4, 0, 2, 1}, {{0, 1, 2}});
    const Values v = alpha(c);
    CHECK(v.at({0, 1, 2}) == 2.5);
    CHECK(v.at({0, 1}) == 2.5);
    CHECK(v.at({0, 2}) == std::sqrt(5.0) / 2);
    const Diagram d = diagram(c);
    REQUIRE(d.degree.size() == 1);
    CHECK(d.degree[0].size() == 3);
}

TEST_CASE("a right triangle is both") {
    const Values v = alpha(cloud<2>({0, 0, 3, 0, 0, 4}, {{0, 1, 2}}));
    CHECK(v.at({0, 1, 2}) == 2.5);
    CHECK(v.at({1, 2}) == 2.5);
}

// With its apex at (0, h) above (-1, 0) and (1, 0): the loop is there from 1 to (h + 1 / h) / 2, 1 + e^2 / 2 and more
// for h = 1 + e.
TEST_CASE("a triangle that is hardly acute has a short loop, one that is not has none") {
    for (const double e : {0x1p-4, 0x1p-8, 0x1p-12, 0x1p-16}) {
        CAPTURE(e);
        const Diagram acute = diagram(cloud<2>({-1, 0, 1, 0, 0, 1 + e}, {{0, 1, 2}}));
        REQUIRE(acute.degree.size() == 2);
        REQUIRE(acute.degree[1].size() == 1);
        CHECK(acute.degree[1][0].first == 1);
        CHECK(acute.degree[1][0].second - 1 == doctest::Approx(e * e / (2 + 2 * e)).epsilon(1e-5));
        CHECK(diagram(cloud<2>({-1, 0, 1, 0, 0, 1 - e}, {{0, 1, 2}})).degree.size() == 1);
    }
    CHECK(diagram(cloud<2>({-1, 0, 1, 0, 0, 1}, {{0, 1, 2}})).degree.size() == 1);
}

TEST_CASE("a square, either way of cutting it") {
    for (int cut = 0; cut < 2; ++cut) {
        const auto c = cut == 0 ? cloud<2>({0, 0, 1, 0, 1, 1, 0, 1}, {{0, 1, 2}, {0, 2, 3}})
                                : cloud<2>({0, 0, 1, 0, 1, 1, 0, 1}, {{0, 1, 3}, {1, 2, 3}});
        const Diagram d = diagram(c);
        REQUIRE(d.degree.size() == 2);
        CHECK(d.degree[0] == std::vector<std::pair<double, double>>{{0, .5}, {0, .5}, {0, .5}, {0, infinity}});
        CHECK(d.degree[1] == std::vector<std::pair<double, double>>{{.5, std::sqrt(.5)}});
    }
}

TEST_CASE("a regular hexagon has one hole, whose triangles all enter together") {
    const double h = std::sqrt(3.0) / 2;
    const auto c =
        cloud<2>({1, 0, .5, h, -.5, h, -1, 0, -.5, -h, .5, -h}, {{0, 2, 4}, {0, 1, 2}, {2, 3, 4}, {4, 5, 0}});
    const Diagram d = diagram(c);
    REQUIRE(d.degree.size() == 2);
    // h is rounded: a second bar, of two triangles, is as long as that, and shorter than a double tells.
    REQUIRE(d.degree[1].size() == 1);
    CHECK(d.degree[1][0].first == .5);
    CHECK(d.degree[1][0].second == 1);
}

// What was wrong up to 0.2.0: radii that differ by less than a double tells. Each is rounded by itself, so many share a
// double, and none is moved for the sake of another.
TEST_CASE("many radii in one double are that double") {
    // Edges across a gap with offsets of 1, 3, 5, ... quanta, so different radii that all round to half the gap.
    constexpr std::uint32_t count = 100;
    const double quantum = 0x1p-46;
    for (int step = 0; step < 70; ++step) {
        CAPTURE(step);
        const double gap = 1 + step * 0x1p-48, apart = gap + 80 * 0x1p-51;
        std::vector<double> x;
        std::vector<std::array<std::uint32_t, 3>> cells;
        for (std::uint32_t i = 0; i < count; ++i) {
            x.insert(x.end(), {i % 2 * gap, quantum * (i * i)});
            if (i > 1) cells.push_back({i - 2, i - 1, i});
        }
        x.insert(x.end(), {-20, 0, -20, apart, -20.9, .5});
        cells.push_back({count, count + 1, count + 2});
        const Values values = alpha(cloud<2>(x, cells));
        CHECK(values.at({count, count + 1}) == apart / 2);
        bool right = true;
        for (std::uint32_t i = 0; i + 1 < count; ++i) right = right && values.at({i, i + 1}) == gap / 2;
        CHECK(right);
    }
}

TEST_CASE("radii next to the least double are rounded as such, and do not touch the others") {
    // A fan of thin triangles with vertices at 0, 1, 2, 4, ... least doubles, and triangles of ordinary size.
    std::vector<double> x = {0, 1};
    std::vector<std::array<std::uint32_t, 3>> cells;
    std::vector<double> at = {0};
    for (int i = 0; i < 6; ++i) at.push_back(std::ldexp(1.0, i - 1074));
    for (double& a : at) x.insert(x.end(), {a, 0});
    for (std::uint32_t i = 1; i < at.size(); ++i) cells.push_back({0, i, i + 1});
    const std::uint32_t first = 1 + static_cast<std::uint32_t>(at.size());
    const double legs[] = {3, 5, 6, 1024, 0x1p-10};
    for (std::uint32_t i = 0; i < 5; ++i) {
        const double away = 1e4 * (i + 1);
        x.insert(x.end(), {away, 0, away + legs[i], 0, away, legs[i]});
        cells.push_back({first + 3 * i, first + 3 * i + 1, first + 3 * i + 2});
    }
    const Values values = alpha(cloud<2>(x, cells));
    for (std::uint32_t i = 1; i < at.size(); ++i) {
        CAPTURE(i);
        CHECK(values.at({i, i + 1}) == (at[i] - at[i - 1]) / 2);  // half of an odd number: ties go to even
        CHECK(values.at({0, i + 1}) == .5);
        CHECK(values.at({0, i, i + 1}) == .5);
    }
    CHECK(values.at({1, 2}) == 0);
    for (std::uint32_t i = 0; i < 5; ++i) {
        CAPTURE(i);
        const std::uint32_t a = first + 3 * i;
        CHECK(values.at({a, a + 1}) == legs[i] / 2);
        CHECK(values.at({a + 1, a + 2}) == doctest::Approx(legs[i] / std::sqrt(2)).epsilon(1e-15));
        CHECK(values.at({a, a + 1, a + 2}) == values.at({a + 1, a + 2}));
    }
}

TEST_CASE("flat triangles turned by an angle with rational sine have the same radius, whatever rounding says") {
    std::vector<double> x;
    std::vector<std::array<std::uint32_t, 3>> cells;
    for (std::uint32_t i = 0; i < 40; ++i) {
        const double corner[][2] = {{0, 0}, {1001, 1}, {433 + i / 4.0, 3 + i / 4.0}};
        for (const double turn : {0, 1}) {
            for (const auto& [a, b] : corner) {
                x.push_back(10000 * (2 * i + turn) + (turn == 0 ? 5 * a : 3 * a - 4 * b));
                x.push_back(turn == 0 ? 5 * b : 4 * a + 3 * b);
            }
            const std::uint32_t first = 6 * i + 3 * (turn == 0 ? 0 : 1);
            cells.push_back({first, first + 1, first + 2});
        }
    }
    const Values values = alpha(cloud<2>(x, cells));
    for (std::uint32_t i = 0; i < 40; ++i) {
        CAPTURE(i);
        CHECK(values.at({6 * i, 6 * i + 1, 6 * i + 2}) == values.at({6 * i + 3, 6 * i + 4, 6 * i + 5}));
    }
}

TEST_CASE("a regular tetrahedron: a class in each degree") {
    const auto c = cloud<3>({1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1}, {{0, 1, 2, 3}});
    const Diagram d = diagram(c);
    REQUIRE(d.degree.size() == 3);
    const double edge = std::sqrt(2.0), face = std::sqrt(8.0 / 3), cell = std::sqrt(3.0);
    CHECK(d.degree[0].size() == 4);
    REQUIRE(d.degree[1].size() == 3);
    for (const auto& pair : d.degree[1]) {
        CHECK(pair.first == doctest::Approx(edge).epsilon(1e-15));
        CHECK(pair.second == doctest::Approx(face).epsilon(1e-15));
    }
    REQUIRE(d.degree[2].size() == 1);
    CHECK(d.degree[2][0].first == doctest::Approx(face).epsilon(1e-15));
    CHECK(d.degree[2][0].second == doctest::Approx(cell).epsilon(1e-15));
}

template <int D> void check_cubes(std::uint32_t side, double step) {
    CAPTURE(D);
    CAPTURE(step);
    Cloud<D> c;
    c.cells = freudenthal<D>(side);
    c.x = freudenthal_points<D>(side, step);
    check_monotone(alpha(c));
    // The cubical complex in disguise: all k-faces of cubes at sqrt(k)/2 steps. H_k lives from there to sqrt(k+1)/2.
    const Diagram d = diagram(c);
    REQUIRE(d.degree.size() == D);
    std::int64_t rank = 0;  // of the boundary map from k-faces of the cubes: what is killed in degree k-1
    for (int k = 0; k < D; ++k) {
        std::int64_t faces = 0, choose = 1;
        for (int s = 0; s < k; ++s) choose = choose * (D - s) / (s + 1);
        faces = choose;
        for (int a = 0; a < D; ++a) faces *= a < k ? side : side + 1;
        const std::int64_t cycles = faces - rank;
        const auto& pairs = d.degree[static_cast<std::size_t>(k)];
        CHECK(pairs.size() == static_cast<std::size_t>(cycles));
        for (const auto& pair : pairs) {
            CHECK(pair.first == doctest::Approx(std::sqrt(k) / 2 * step).epsilon(1e-12));
            if (pair.second < infinity) {
                CHECK(pair.second == doctest::Approx(std::sqrt(k + 1.0) / 2 * step).epsilon(1e-12));
            } else {
                CHECK(k == 0);
            }
        }
        rank = cycles - (k == 0 ? 1 : 0);
    }
}

TEST_CASE("grids: every tie there is") {
    for (double step : {1.0, 0.1}) {
        check_cubes<2>(7, step);
        check_cubes<3>(4, step);
        for_each_dimension<4, 4>([&](auto dim) { check_cubes<dim>(2, step); });
        for_each_dimension<5, 5>([&](auto dim) { check_cubes<dim>(1, step); });
        for_each_dimension<6, 6>([&](auto dim) { check_cubes<dim>(1, step); });
    }
}

TEST_CASE("values are those of the definition") {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        for (double flatten : {1.0, 1e-2, 1e-3}) {
            compare_with_definition<2>(16, flatten, seed);
            compare_with_definition<3>(13, flatten, seed);
            if (flatten > 1e-3)
                for_each_dimension<4, 4>(
                    [&](auto dim) { compare_with_definition<dim>(11, flatten, seed); });  // all that long double can do
        }
        for_each_dimension<5, 5>([&](auto dim) { compare_with_definition<dim>(10, 1, seed); });
        for_each_dimension<6, 6>([&](auto dim) { compare_with_definition<dim>(10, 1, seed); });
    }
}

TEST_CASE_TEMPLATE_DEFINE("the diagram in low degrees is that part of the whole", T, low_degrees) {
    constexpr int D = T::value;
    Cloud<D> c;
    Random random{7};
    for (int i = 0; i < 10 * D; ++i) c.x.push_back(random.unit());
    triangulate(c);
    const Diagram whole = diagram(c);
    for (std::uint32_t p = 0; p < D; ++p) {
        const Diagram part = diagram(c, p);
        REQUIRE(part.degree.size() <= p + 1);
        for (std::size_t k = 0; k < part.degree.size(); ++k) CHECK(part.degree[k] == whole.degree[k]);
        CHECK((part.simplices < whole.simplices) == (p + 1 < D));
    }
    Block block(std::size_t{1} << 22);
    Monitor monitor;
    CountedPairs counted;
    REQUIRE(alpha_of_triangulation<D>(c.filtration(), {D}, {block.arena, monitor}, &counted) == Status::ok);
    std::size_t pairs = 0;
    for (const auto& degree : whole.degree) pairs += degree.size();
    CHECK(counted.pairs.count == pairs);
}
TEST_CASE_TEMPLATE_APPLY(low_degrees, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("values can be stopped at the cells", T, stopped) {
    constexpr int D = T::value;
    constexpr std::uint32_t side[] = {0, 0, 170, 19, 6, 3, 2};
    Cloud<D> c;
    c.cells = freudenthal<D>(side[D]);
    c.x = freudenthal_points<D>(side[D]);
    Block block(std::size_t{1} << 28);
    // Once the number of simplices is known.
    Monitor stopping([](void*, const netmesh_progress* progress) { return static_cast<int>(progress->total > 0); },
                     nullptr);
    CountedPairs counted;
    CHECK(alpha_of_triangulation<D>(c.filtration(), {D}, {block.arena, stopping}, &counted) == Status::cancelled);
    CHECK(block.arena.bytes_used() == 0);
}
TEST_CASE_TEMPLATE_APPLY(stopped, Dimensions<>);

TEST_CASE("values of edges can be stopped, and may be as long as squares overflow") {
    Cloud<2> c;
    c.cells = freudenthal<2>(190);
    c.x = freudenthal_points<2>(190);
    Block block(std::size_t{1} << 25);
    int polls = 0;
    Monitor second(
        [](void* user, const netmesh_progress* progress) {
            return static_cast<int>(progress->total > 0 && ++*static_cast<int*>(user) == 2);
        },
        &polls);
    CountedPairs counted;
    CHECK(alpha_of_triangulation<2>(c.filtration(), {2}, {block.arena, second}, &counted) == Status::cancelled);
    CHECK(polls == 2);
    const double huge = 0x1p600;
    const auto far = cloud<2>({0, 0, 6 * huge, 0, 0, 8 * huge}, {{0, 1, 2}});
    const Values values = alpha(far);
    CHECK(values.at({0, 1}) == 3 * huge);
    CHECK(values.at({0, 2}) == 4 * huge);
    CHECK(values.at({1, 2}) == 5 * huge);
}

TEST_CASE("the diagram has no memory of the order of cells, of spare bytes in the records, or of higher degrees") {
    Cloud<3> c;
    Random random{5};
    for (int i = 0; i < 3 * 14; ++i) c.x.push_back(random.unit());
    triangulate(c);
    const Diagram whole = diagram(c);
    Cloud<3> mixed = c;
    std::reverse(mixed.cells.list.begin(), mixed.cells.list.end());
    for (auto& cell : mixed.cells.list) std::swap(cell[0], cell[2]);
    CHECK(diagram(mixed).degree == whole.degree);
    Cloud<3> wide = c;
    wide.x.clear();
    for (std::uint32_t v = 0; v < c.cells.vertex_count; ++v) {
        wide.x.insert(wide.x.end(), c.point(v), c.point(v) + 3);
        wide.x.insert(wide.x.end(), 2, std::nan(""));
    }
    CHECK(diagram(wide, 3, false, 5 * sizeof(double)).degree == whole.degree);
    for (std::uint32_t p = 0; p < 3; ++p) {
        const Diagram part = diagram(c, p);
        REQUIRE(part.degree.size() <= p + 1);
        for (std::size_t k = 0; k < part.degree.size(); ++k) CHECK(part.degree[k] == whole.degree[k]);
    }
}

TEST_CASE("with zero-length pairs every simplex is in exactly one pair") {
    Cloud<3> c;
    c.cells = freudenthal<3>(3);
    c.x = freudenthal_points<3>(3, 0.3);
    const Diagram d = diagram(c, 2, true);
    std::size_t simplices = 0;
    for (const auto& degree : d.degree)
        for (const auto& pair : degree) simplices += pair.second < infinity ? 2 : 1;
    CHECK(simplices == d.simplices);
}

TEST_CASE("any amount of memory gives the diagram or says that it is too little; the caller can stop it anywhere") {
    Cloud<3> c;
    c.cells = freudenthal<3>(2);
    c.x = freudenthal_points<3>(2);
    const auto run = [&](Block& block, Monitor monitor, std::vector<double>& deaths) {
        CountedPairs counted;
        const Status status = alpha_of_triangulation<3>(c.filtration(), {2}, {block.arena, monitor}, &counted);
        const PairList& list = counted.pairs;
        deaths.clear();
        for (std::uint64_t i = 0; status == Status::ok && i < list.count; ++i) deaths.push_back(list.pairs[i].death);
        if (status != Status::ok) CHECK(block.arena.bytes_used() == 0);
        return status;
    };
    Block whole(1 << 20);
    std::vector<double> expected_deaths, deaths;
    REQUIRE(run(whole, Monitor(), expected_deaths) == Status::ok);
    bool succeeded = false;
    for (std::size_t bytes = 0; bytes <= whole.arena.bytes_peak() + 80; bytes += 80) {
        Block block(bytes);
        if (run(block, Monitor(), deaths) == Status::ok) {
            succeeded = true;
            CHECK(deaths == expected_deaths);
        } else {
            CHECK(!succeeded);
            CHECK(block.arena.bytes_wanted() > block.arena.bytes());
        }
    }
    CHECK(succeeded);
}

TEST_CASE("a caller that wants to stop stops it at any of its polls") {
    Cloud<3> c;
    c.cells = freudenthal<3>(18);
    c.x = freudenthal_points<3>(18);
    Block block(std::size_t{1} << 25);
    Polls none_stopped;
    CountedPairs counted;
    Monitor monitor(Polls::answer, &none_stopped);
    REQUIRE(alpha_of_triangulation<3>(c.filtration(), {2}, {block.arena, monitor}, &counted) == Status::ok);
    REQUIRE(none_stopped.made > 3);
    for (long stop = 0; stop < none_stopped.made; stop += 1 + none_stopped.made / 50) {
        Polls polls = {0, stop};
        Monitor stopping(Polls::answer, &polls);
        block.arena.release_low(0);
        CHECK(alpha_of_triangulation<3>(c.filtration(), {2}, {block.arena, stopping}, &counted) == Status::cancelled);
        CHECK(block.arena.bytes_used() == 0);
    }
}
