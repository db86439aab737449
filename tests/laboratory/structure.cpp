#include "laboratory/structure.hpp"

#include <doctest/doctest.h>

#include "common/dimensions.hpp"
#include "delaunay/load.hpp"
#include "laboratory/common.hpp"

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
    for (const inputs::Points& points :
         {inputs::uniform(D, sizes), inputs::clusters(D, sizes), inputs::geometric(D, 100, D == 4 ? 2 : 4)}) {
        // Of the last ones the shells of cages are exempt too.
        Held<D> held;
        MeshRequest request = by_quality(D == 4 ? 3.5 : 3);
        const bool cages = points.size() == (D == 4 ? 3u : 5u) * D;
        if (cages) request = by_hierarchy(D == 4 ? 3.5 : 3);
        REQUIRE(held.mesh(points, request) == Status::ok);
        const StructureAnalysis a = analyse<D>(held);
        const std::uint32_t cells = held.state.cell_slots;
        std::vector<bool> hull(held.state.vertex_count, false);
        for (std::uint32_t c = 0; c < cells; ++c)
            for (int i = 0; i <= D; ++i)
                for (int j = 0; j <= D; ++j)
                    if (i != j && held.store.cell(c).neighbour[i] == none) hull[held.store.cell(c).vertex[j]] = true;
        std::vector<std::vector<std::uint32_t>> near(held.state.vertex_count);
        std::uint64_t ply_max = 0, ply_points = 0, met_max = 0, balls = 0, hull_met_max = 0, hull_balls = 0;
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
            bool boundary = false;
            for (std::uint32_t v : cell.vertex) {
                for (int k = 0; k < D; ++k) x[k] += held.store.point(v)[k] / (D + 1);
                boundary = boundary || hull[v];
                for (std::uint32_t w : cell.vertex)
                    if (w != v) near[v].push_back(w);
            }
            ply_at(x);
            if (held.domain.contains(cell.centre)) ply_at(cell.centre);
            std::uint64_t met = 0;
            for (std::uint32_t b = 0; b < cells; ++b)
                met += b != c && distance(cell.centre, held.store.cell(b).centre, D) <
                                     std::sqrt(cell.radius2) + std::sqrt(held.store.cell(b).radius2);
            (boundary ? hull_met_max : met_max) = std::max(boundary ? hull_met_max : met_max, met);
            met_sum += boundary ? 0 : static_cast<double>(met);
            ++(boundary ? hull_balls : balls);
        }
        CHECK(a.ply_points == ply_points);
        CHECK(a.ply_max == ply_max);
        CHECK(a.ply_mean == doctest::Approx(ply_sum / static_cast<double>(ply_points)).epsilon(1e-4));
        CHECK(a.balls == balls);
        CHECK(a.intersections_max == met_max);
        CHECK(a.intersections_mean == doctest::Approx(met_sum / static_cast<double>(balls)).epsilon(1e-4));
        CHECK(a.hull_balls == hull_balls);
        CHECK(a.hull_intersections_max == hull_met_max);
        CHECK(a.ply_stride == 1);
        CHECK(a.balls_stride == 1);
        std::uint64_t degree_max[2] = {};
        for (std::uint32_t v = 0; v < held.state.vertex_count; ++v) {
            std::sort(near[v].begin(), near[v].end());
            const auto degree = std::unique(near[v].begin(), near[v].end()) - near[v].begin();
            degree_max[hull[v]] = std::max(degree_max[hull[v]], static_cast<std::uint64_t>(degree));
        }
        CHECK(a.degree_max == degree_max[0]);
        CHECK(a.hull_degree_max == degree_max[1]);
        CHECK(a.hull_vertices == 2 * D);
        CHECK(a.vertices == held.state.vertex_count - 2 * D);
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

namespace {

double inner(const double* a, const double* b, int dim) {
    double sum = 0;
    for (int k = 0; k < dim; ++k) sum += a[k] * b[k];
    return sum;
}

// A D-ball: circumscribed to a cell, or the half-space beyond a facet of the hull.
struct Ball {
    bool finite;
    std::vector<double> x;  // centre, or outward normal
    double radius;
    const double* on;  // a point of the boundary
    bool contains(const double* y, double slack) const {
        const int dim = static_cast<int>(x.size());
        if (finite) return distance(y, x.data(), dim) < radius * (1 + slack);
        double height = 0;
        for (int k = 0; k < dim; ++k) height += x[static_cast<std::size_t>(k)] * (y[k] - on[k]);
        return height > -slack * (1 + distance(y, on, dim));
    }
};

// The D-balls at vertex v, and at u as well unless that is none.
template <int D> std::vector<Ball> balls_of(const Store<D>& store, std::uint32_t v, std::uint32_t u) {
    std::vector<Ball> balls;
    const auto has = [&](const Cell<D>& cell, int left, std::uint32_t w) {
        for (int i = 0; i <= D; ++i)
            if (i != left && cell.vertex[i] == w) return true;
        return w == none;
    };
    for (std::uint32_t c = 0; c < store.state.cell_slots; ++c) {
        const Cell<D>& cell = store.cell(c);
        if (has(cell, -1, v) && has(cell, -1, u))
            balls.push_back({true, {cell.centre, cell.centre + D}, std::sqrt(cell.radius2), store.point(v)});
        for (int i = 0; i <= D; ++i) {
            if (cell.neighbour[i] != none || !has(cell, i, v) || !has(cell, i, u)) continue;
            // Orthogonal to the facet: Gram and Schmidt on its edges, then on the way from the vertex opposite.
            std::vector<std::vector<double>> base;
            const std::uint32_t first = cell.vertex[i == 0 ? 1 : 0];
            std::vector<double> e(D);
            std::vector<std::uint32_t> others;
            for (int j = 0; j <= D; ++j)
                if (j != i && cell.vertex[j] != first) others.push_back(cell.vertex[j]);
            others.push_back(cell.vertex[i]);
            for (const std::uint32_t w : others) {
                for (int k = 0; k < D; ++k) e[static_cast<std::size_t>(k)] = store.point(w)[k] - store.point(first)[k];
                for (const auto& b : base) {
                    const double along = inner(e.data(), b.data(), D);
                    for (int k = 0; k < D; ++k)
                        e[static_cast<std::size_t>(k)] -= along * b[static_cast<std::size_t>(k)];
                }
                const double length = std::sqrt(inner(e.data(), e.data(), D)) * (w == cell.vertex[i] ? -1 : 1);
                for (double& component : e) component /= length;
                base.push_back(e);
            }
            balls.push_back({false, base.back(), HUGE_VAL, store.point(v)});
        }
    }
    return balls;
}

// Weights >= 0 of at most `size` of the balls with c = sum, those of centres adding up to 1 where there are any: what
// Caratheodory says of conv(Q) + cone(H). Centres relative to c.
template <int D>
bool combine(const std::vector<Ball>& balls, const double* c, double scale, bool in_cone, const double* goal, int size,
             std::vector<Ball>* chosen) {
    return any_subset(static_cast<int>(balls.size()), size, [&](const std::vector<int>& set) {
        const auto entry = [&](int i, int k) {
            const Ball& ball = balls[static_cast<std::size_t>(set[static_cast<std::size_t>(i)])];
            if (k == D) return ball.finite ? 1.0 : 0.0;
            return ball.finite ? (ball.x[static_cast<std::size_t>(k)] - c[k]) / scale
                               : ball.x[static_cast<std::size_t>(k)];
        };
        const auto wanted = [&](int k) { return k == D ? (in_cone ? 0.0 : 1.0) : in_cone ? goal[k] / scale : 0.0; };
        std::vector<std::vector<double>> a(static_cast<std::size_t>(size),
                                           std::vector<double>(static_cast<std::size_t>(size) + 1, 0));
        for (int i = 0; i < size; ++i)
            for (int k = 0; k <= D; ++k) {
                for (int j = 0; j < size; ++j)
                    a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] += entry(i, k) * entry(j, k);
                a[static_cast<std::size_t>(i)][static_cast<std::size_t>(size)] += entry(i, k) * wanted(k);
            }
        std::vector<double> weight;
        if (!solve(a, &weight)) return false;
        for (int k = 0; k <= D; ++k) {
            double sum = -wanted(k);
            for (int i = 0; i < size; ++i) sum += weight[static_cast<std::size_t>(i)] * entry(i, k);
            if (std::fabs(sum) > 1e-6) return false;
        }
        for (const double w : weight)
            if (w < -1e-9) return false;
        chosen->clear();
        for (const int i : set) chosen->push_back(balls[static_cast<std::size_t>(i)]);
        return true;
    });
}

}  // namespace

// 4.16.8 with balls of infinite radius: empty balls anywhere, far outside too, of a triangulation without a boundary.
// Case 1, the ray from v through c stays in the cell: D half-spaces, c - v being in the cone of their normals. Case 2:
// balls and half-spaces at the facet through which it leaves.
TEST_CASE_TEMPLATE_DEFINE("D-ball cover theorem with infinite balls", T, infinite_cover) {
    constexpr int D = T::value;
    constexpr std::size_t sizes = by_dimension<std::size_t>(D, {25, 18, 12});
    Held<D> held;
    REQUIRE(held.triangulate(inputs::uniform(D, sizes, 3)) == Status::ok);
    recompute_balls<D>(held.store);
    inputs::Random random(23);
    int cones = 0, mixed = 0, bounded = 0, missed = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const double middle[D] = {};
        double c[D], exit[D], towards[D];
        point_in_ball<D>(random, middle, std::pow(10, 2 * random.uniform() - 1), c);
        std::uint32_t v = 0, u = none;
        for (std::uint32_t w = 1; w < held.state.vertex_count; ++w)
            if (distance(c, held.store.point(w), D) < distance(c, held.store.point(v), D)) v = w;
        const double* const p = held.store.point(v);
        for (int k = 0; k < D; ++k) towards[k] = c[k] - p[k];
        double leave = HUGE_VAL;
        for (std::uint32_t w = 0; w < held.state.vertex_count; ++w) {
            double along = 0;
            for (int k = 0; k < D; ++k) along += towards[k] * (held.store.point(w)[k] - p[k]);
            const double t = std::pow(distance(p, held.store.point(w), D), 2) / (2 * along);
            if (w != v && along > 0 && t < leave) leave = t, u = w;
        }
        const double t = u == none ? 1 : leave;
        CHECK(t > 1 - 1e-9);
        for (int k = 0; k < D; ++k) exit[k] = p[k] + t * towards[k];
        const double radius = distance(exit, p, D);
        std::vector<Ball> balls = balls_of<D>(held.store, v, u), chosen;
        if (u == none)
            balls.erase(std::remove_if(balls.begin(), balls.end(), [](const Ball& b) { return b.finite; }),
                        balls.end());
        if (!combine<D>(balls, exit, radius, u == none, towards, D, &chosen)) {
            ++missed;
            continue;
        }
        const auto infinite = std::count_if(chosen.begin(), chosen.end(), [](const Ball& b) { return !b.finite; });
        ++(u == none ? cones : infinite > 0 ? mixed : bounded);
        for (int sample = 0; sample < 200; ++sample) {
            double x[D];
            point_in_ball<D>(random, exit, radius, x);
            bool inside = false;
            for (const Ball& b : chosen) inside = inside || b.contains(x, 1e-9);
            CHECK(inside);
        }
        // A point of all of them: near the middle of u and v (case 1: near v), on the inner side of all half-spaces.
        std::vector<std::vector<double>> gram;
        std::vector<const Ball*> half;
        for (const Ball& b : chosen)
            if (!b.finite) half.push_back(&b);
        for (const Ball* a : half) {
            gram.emplace_back();
            for (const Ball* b : half) gram.back().push_back(inner(a->x.data(), b->x.data(), D));
            gram.back().push_back(1);
        }
        std::vector<double> weight;
        REQUIRE((half.empty() || solve(gram, &weight)));
        double common[D];
        for (int k = 0; k < D; ++k) {
            common[k] = u == none ? p[k] : 0.5 * (p[k] + held.store.point(u)[k]);
            for (std::size_t i = 0; i < half.size(); ++i)
                common[k] += 1e-7 * weight[i] * half[i]->x[static_cast<std::size_t>(k)];
        }
        for (const Ball& b : chosen) CHECK(b.contains(common, 0));
    }
    CHECK(cones > 20);
    CHECK(mixed > 20);
    CHECK(bounded > (D < 4 ? 10 : 2));
    CHECK(missed < 20);
}
TEST_CASE_TEMPLATE_APPLY(infinite_cover, Dimensions<2, 4>);

// The proof takes c itself for the point that the half-spaces of case 1 have in common. It need not be one: at a sharp
// corner v the normals point away from each other. Another point does.
TEST_CASE("4.16.8: half-spaces around a sharp corner do not meet in the centre") {
    const double first[2] = {0.1, 1}, second[2] = {0.1, -1};  // outward normals of a narrow triangle's sides at v = 0
    const double c[2] = {first[0] + 0.01 * second[0], first[1] + 0.01 * second[1]};
    CHECK(inner(c, first, 2) > 0);
    CHECK(inner(c, second, 2) < 0);
    const double common[2] = {1, 0};
    CHECK(inner(common, first, 2) > 0);
    CHECK(inner(common, second, 2) > 0);
}
