#include "analysis/structure.hpp"

#include <doctest/doctest.h>

#include "analysis/common.hpp"
#include "common/dimensions.hpp"

using namespace netmesh;

namespace {

template <int D> StructureAnalysis analyse(Held<D>& held) {
    StructureAnalysis a;
    REQUIRE(analyse_structure<D>(held.store, held.domain.centre, held.domain.radius, {held.block.arena, held.monitor},
                                 &a) == Status::ok);
    return a;
}

// A point in the ball, evenly enough.
template <int D> void point_in_ball(inputs::Random& random, const double* centre, double radius, double* x) {
    double d2;
    do {
        d2 = 0;
        for (int k = 0; k < D; ++k) {
            x[k] = 2 * random.uniform() - 1;
            d2 += x[k] * x[k];
        }
    } while (d2 > 1);
    for (int k = 0; k < D; ++k) x[k] = centre[k] + radius * x[k];
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("ply and intersections by looking at all balls", T, all_balls) {
    constexpr int D = T::value;
    constexpr std::size_t sizes = by_dimension<std::size_t>(D, {60, 15, 5});
    for (const inputs::Points& points : {inputs::uniform(D, sizes), inputs::clusters(D, sizes)}) {
        Held<D> held;
        REQUIRE(held.mesh(points, D == 4 ? 3.5 : 3) == Status::ok);
        const StructureAnalysis a = analyse<D>(held);
        const std::uint32_t cells = held.state.cell_slots;
        std::uint64_t ply_max = 0, ply_points = 0, met_max = 0, balls = 0;
        double ply_sum = 0, met_sum = 0;
        const auto ply_at = [&](const double* x) {
            std::uint64_t ply = 0;
            for (std::uint32_t c = 0; c < cells; ++c)
                ply += std::pow(distance(x, held.store.cell(c).centre, D), 2) < held.store.cell(c).radius2;
            ply_max = std::max(ply_max, ply);
            ply_sum += static_cast<double>(ply);
            ++ply_points;
        };
        for (std::uint32_t c = 0; c < cells; ++c) {
            const Cell<D>& cell = held.store.cell(c);
            double x[D] = {};
            bool ordinary = true;
            for (std::uint32_t v : cell.vertex) {
                for (int k = 0; k < D; ++k) x[k] += held.store.point(v)[k] / (D + 1);
                ordinary = ordinary && held.store.vertex(v).marker != Marker::exempt;
            }
            ply_at(x);
            if (held.domain.contains(cell.centre)) ply_at(cell.centre);
            if (!ordinary) continue;
            std::uint64_t met = 0;
            for (std::uint32_t b = 0; b < cells; ++b)
                met += b != c && distance(cell.centre, held.store.cell(b).centre, D) <
                                     std::sqrt(cell.radius2) + std::sqrt(held.store.cell(b).radius2);
            met_max = std::max(met_max, met);
            met_sum += static_cast<double>(met);
            ++balls;
        }
        CHECK(a.ply_points == ply_points);
        CHECK(a.ply_max == ply_max);
        CHECK(a.ply_mean == doctest::Approx(ply_sum / static_cast<double>(ply_points)).epsilon(1e-4));
        CHECK(a.balls == balls);
        CHECK(a.intersections_max == met_max);
        CHECK(a.intersections_mean == doctest::Approx(met_sum / static_cast<double>(balls)).epsilon(1e-4));
        CHECK(a.degree_max >= static_cast<std::uint64_t>(D + 1));
        CHECK(a.star_mean > D);
        // Euler: a closed star in the plane has as many neighbours as cells.
        if (D == 2) CHECK(a.degree_mean == a.star_mean);
        if (D == 3) CHECK(2 * a.degree_mean - 4 == doctest::Approx(a.star_mean).epsilon(1e-12));
    }
}
TEST_CASE_TEMPLATE_APPLY(all_balls, Dimensions<2, 4>);

// 4.16.8, constructively: the ray from the nearest vertex v through the centre c of an empty ball leaves Vor(v) at c'
// in the facet between v and u. c' is a convex combination of D corners of that facet (Caratheodory); their D-balls
// cover ball(c', |c' - v|), which contains the empty ball, and share a neighbourhood of the midpoint of u and v.
TEST_CASE_TEMPLATE_DEFINE("D-ball cover theorem", T, cover) {
    constexpr int D = T::value;
    constexpr std::size_t sizes = by_dimension<std::size_t>(D, {60, 30, 8});
    Held<D> held;
    REQUIRE(held.mesh(inputs::clusters(D, sizes), D == 4 ? 3.08 : 2.5) == Status::ok);
    inputs::Random random(17);
    int covered = 0;
    for (int trial = 0; trial < 150; ++trial) {
        double c[D], exit[D];
        point_in_ball<D>(random, held.domain.centre, held.domain.radius, c);
        std::uint32_t v = 0, u = none;
        for (std::uint32_t w = 1; w < held.state.vertex_count; ++w)
            if (distance(c, held.store.point(w), D) < distance(c, held.store.point(v), D)) v = w;
        const double* const p = held.store.point(v);
        double leave = HUGE_VAL;
        for (std::uint32_t w = 0; w < held.state.vertex_count; ++w) {
            double dot = 0;
            for (int k = 0; k < D; ++k) dot += (c[k] - p[k]) * (held.store.point(w)[k] - p[k]);
            if (w == v || !(dot > 0)) continue;
            const double t = std::pow(distance(p, held.store.point(w), D), 2) / (2 * dot);
            if (t < leave) {
                leave = t;
                u = w;
            }
        }
        REQUIRE(u != none);
        CHECK(leave > 1 - 1e-9);
        for (int k = 0; k < D; ++k) exit[k] = p[k] + leave * (c[k] - p[k]);
        std::vector<const Cell<D>*> facet;
        for (std::uint32_t b = 0; b < held.state.cell_slots; ++b) {
            const Cell<D>& cell = held.store.cell(b);
            if (std::find(cell.vertex, cell.vertex + D + 1, v) == cell.vertex + D + 1) continue;
            if (std::find(cell.vertex, cell.vertex + D + 1, u) != cell.vertex + D + 1) facet.push_back(&cell);
        }
        REQUIRE(facet.size() >= D);
        const double scale = distance(exit, p, D);
        const Cell<D>* ball[D] = {};
        const bool found = any_subset(static_cast<int>(facet.size()), D, [&](const std::vector<int>& chosen) {
            // Barycentric coordinates by least squares; the corners lie in a hyperplane with c'.
            const auto entry = [&](int i, int k) {
                return k == D ? 1.0
                              : (facet[static_cast<std::size_t>(chosen[static_cast<std::size_t>(i)])]->centre[k] -
                                 exit[k]) /
                                    scale;
            };
            std::vector<std::vector<double>> a(D, std::vector<double>(D + 1, 0));
            for (int i = 0; i < D; ++i) {
                for (int j = 0; j < D; ++j)
                    for (int k = 0; k <= D; ++k)
                        a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += entry(i, k) * entry(j, k);
                a[static_cast<std::size_t>(i)][D] = 1;
            }
            std::vector<double> weight;
            if (!solve(a, &weight)) return false;
            for (int k = 0; k <= D; ++k) {
                double sum = k == D ? -1 : 0;
                for (int i = 0; i < D; ++i) sum += weight[static_cast<std::size_t>(i)] * entry(i, k);
                if (std::fabs(sum) > 1e-6) return false;
            }
            for (int i = 0; i < D; ++i) {
                if (weight[static_cast<std::size_t>(i)] < -1e-9) return false;
                ball[i] = facet[static_cast<std::size_t>(chosen[static_cast<std::size_t>(i)])];
            }
            return true;
        });
        if (!found) continue;  // corners too close to each other for the solver
        ++covered;
        double middle[D];
        for (int k = 0; k < D; ++k) middle[k] = 0.5 * (p[k] + held.store.point(u)[k]);
        for (const Cell<D>* b : ball) CHECK(distance(middle, b->centre, D) < std::sqrt(b->radius2));
        for (int sample = 0; sample < 200; ++sample) {
            double x[D];
            point_in_ball<D>(random, exit, scale, x);
            bool inside = false;
            for (const Cell<D>* b : ball)
                inside = inside || distance(x, b->centre, D) < std::sqrt(b->radius2) * (1 + 1e-9);
            CHECK(inside);
        }
    }
    CHECK(covered > 140);
}
TEST_CASE_TEMPLATE_APPLY(cover, Dimensions<2, 4>);
