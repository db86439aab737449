// Additively weighted Voronoi cells and the cells of cages that approximate them (thesis 4.6).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "common/mesh_points.hpp"
#include "laboratory/weighted_cells.hpp"
#include "mesh/check/check_weighted_cells.hpp"
#include "mesh/check/hierarchy_quality.hpp"
#include "mesh/check/quality.hpp"

using namespace netmesh;

namespace {

// Weighted points; d_w(u, x) = |u - x| - w_u for points x without a weight.
template <int D> struct Weighted {
    inputs::Points x;
    std::vector<double> w;
    std::size_t size() const { return w.size(); }
    const double* point(std::size_t i) const { return &x[i * D]; }

    std::size_t owner(const double* at) const {
        std::size_t best = 0;
        for (std::size_t i = 1; i < size(); ++i)
            if (distance<D>(at, point(i)) - w[i] < distance<D>(at, point(best)) - w[best]) best = i;
        return best;
    }
    // Half of the least additive distance, and the weight.
    double in_radius(std::size_t v) const {
        double least = infinity;
        for (std::size_t u = 0; u < size(); ++u)
            if (u != v) least = std::min(least, distance<D>(point(u), point(v)) - w[u] - w[v]);
        return 0.5 * least + w[v];
    }
    double feature_size(std::size_t v) const {
        double least = infinity;
        for (std::size_t u = 0; u < size(); ++u)
            if (u != v) least = std::min(least, distance<D>(point(u), point(v)));
        return least;
    }
    // The least epsilon for which w_a <= epsilon (|a - b| - w_b) for all pairs.
    double epsilon() const {
        double least = 0;
        for (std::size_t a = 0; a < size(); ++a)
            for (std::size_t b = 0; b < size(); ++b)
                if (a != b) least = std::max(least, w[a] / (distance<D>(point(a), point(b)) - w[b]));
        return least;
    }
};

// Weights up to epsilon / (1 + epsilon) of the distance to the nearest point, which is what the lemma's premise allows.
template <int D> Weighted<D> weighted(std::size_t n, double epsilon, std::uint64_t seed) {
    Weighted<D> set{inputs::clusters(D, n, seed), std::vector<double>(n, 0.0)};
    inputs::Random random(seed);
    std::vector<double> w;
    for (std::size_t v = 0; v < n; ++v)
        w.push_back((random.below(3) == 0 ? 0 : random.uniform()) * epsilon / (1 + epsilon) * set.feature_size(v));
    set.w = w;
    return set;
}

void random_direction(inputs::Random& random, int dim, double* direction) {
    double squared = 0;
    while (!(squared > 0.01 && squared <= 1)) {
        squared = 0;
        for (int k = 0; k < dim; ++k) {
            direction[k] = 2 * random.uniform() - 1;
            squared += direction[k] * direction[k];
        }
    }
    for (int k = 0; k < dim; ++k) direction[k] /= std::sqrt(squared);
}

// A hierarchical mesh with what 4.5 calls M_Omega.
template <int D> struct Hierarchical {
    explicit Hierarchical(const inputs::Points& points) : block(std::size_t{1} << 24), store(block.arena, state) {
        Monitor monitor;
        MeshRequest request;
        request.method = MeshMethod::hierarchy;
        request.tau = 3;
        request.seed = 1;
        MeshResult<D> result = {};
        REQUIRE(mesh_points<D>(store, points.data(), points.size() / D, request, {block.arena, monitor}, &result) ==
                Status::ok);
        domain = result.domain;
        cages = result.cages;
        report = result.hierarchy;
        ratios.resize(state.vertex_count);
        domains.resize(state.vertex_count);
        nearest2.resize(state.vertex_count);
        HierarchyQuality quality;
        REQUIRE(measure_hierarchy(store, {cages, report.cages, domain, ratios.data(), domains.data()}, block.arena,
                                  &quality) == Status::ok);
        recomputed_nearest2(store, nearest2.data());
    }
    bool is_frame(std::uint32_t v) const { return domains[v] == none && store.vertex(v).marker == Marker::exempt; }
    // Distance from x to the nearest of M_Omega that is not x.
    double feature_size(const double* x, std::uint32_t omega) const {
        double least = infinity;
        const auto offer = [&](std::uint32_t v) {
            const double d = distance<D>(x, store.point(v));
            if (d > 0) least = std::min(least, d);
        };
        for (std::uint32_t v = 0; v < state.vertex_count; ++v)
            if (domains[v] == omega && !is_frame(v)) offer(v);
        for (std::uint32_t d = 0; d < report.cages; ++d)
            if (cages[d].parent == omega) offer(cages[d].centre);
        return least;
    }
    // Is the vertex nearest to x inside the cage?
    bool in_cell(const Cage& cage, const double* x) const {
        std::uint32_t best = 0;
        for (std::uint32_t v = 1; v < state.vertex_count; ++v)
            if (distance2<D>(x, store.point(v)) < distance2<D>(x, store.point(best))) best = v;
        return is_inside<D>(store, cage, store.point(best));
    }
    Block block;
    StoreState state = {};
    Store<D> store;
    Domain<D> domain = {};
    Cage* cages;
    HierarchyCounts report;
    std::vector<double> ratios, nearest2;
    std::vector<std::uint32_t> domains;
};

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("lemma 4.6.1: in-radius and feature size of additively weighted points", T, weighted_points) {
    constexpr int D = T::value;
    inputs::Random random(7);
    for (const double epsilon : {0.01, 0.1, 0.3, 0.6})
        for (std::uint64_t seed = 1; seed <= 5; ++seed) {
            const Weighted<D> set = weighted<D>(40, epsilon, seed);
            REQUIRE(set.epsilon() <= epsilon * (1 + 1e-12));
            REQUIRE(set.epsilon() > 0.5 * epsilon);
            for (std::size_t v = 0; v < set.size(); ++v) {
                const double r = set.in_radius(v), f = set.feature_size(v);
                CHECK(2 * r * (1 - epsilon) / (1 + epsilon) <= f * (1 + 1e-12));
                CHECK(f <= 2 * r / (1 - epsilon) * (1 + 1e-12));
                // r is the in-radius: points up to it belong to v, and some just beyond it do not.
                double direction[D], x[D];
                random_direction(random, D, direction);
                for (int k = 0; k < D; ++k) x[k] = set.point(v)[k] + 0.999999 * r * direction[k];
                CHECK(set.owner(x) == v);
                std::size_t y = v == 0 ? 1 : 0;
                for (std::size_t u = 0; u < set.size(); ++u)
                    if (u != v && distance<D>(set.point(u), set.point(v)) - set.w[u] <
                                      distance<D>(set.point(y), set.point(v)) - set.w[y])
                        y = u;
                const double length = distance<D>(set.point(y), set.point(v));
                for (int k = 0; k < D; ++k)
                    x[k] = set.point(v)[k] + 1.000001 * r / length * (set.point(y)[k] - set.point(v)[k]);
                CHECK(set.owner(x) != v);
            }
        }
}
TEST_CASE_TEMPLATE_APPLY(weighted_points, Dimensions<2, 4>);

TEST_CASE("lemma 4.6.1 needs its premise") {
    Weighted<2> set{{0, 0, 1, 0, 5, 0}, {0, 0.8, 0}};
    const double epsilon = 0.1, r = set.in_radius(0);
    CHECK(set.epsilon() > epsilon);
    CHECK(set.feature_size(0) > 2 * r / (1 - epsilon));
}

TEST_CASE_TEMPLATE_DEFINE("lemma 4.6.2: r <= f_M <= 3 r for the cells of vertices and of cages", T, caged) {
    constexpr int D = T::value;
    // A ball that a cage's cell contains for sure: between shell vertices the cell ends earlier than at one.
    const double apart = cage_clearance, shell = shell_factor * (1 + 2 * shell_jitter);
    const double inscribed = 0.97 * (apart - shell) / (apart - shell / std::sqrt(double(D)));
    inputs::Random random(3);
    std::uint32_t seen = 0;
    for (const inputs::Points& points :
         {inputs::nested(D, 4, D == 4 ? 6 : 15, 1e3), inputs::geometric(D, 1e3, 15), inputs::geometric(D, 20, 6),
          inputs::close_pairs(D, 12, 1e-12), inputs::clusters(D, D == 4 ? 15 : 60)}) {
        const Hierarchical<D> m(points);
        for (std::uint32_t v = 0; v < m.state.vertex_count; ++v) {
            if (m.store.vertex(v).marker == Marker::exempt) continue;
            const double r = 0.5 * std::sqrt(m.nearest2[v]), f = m.feature_size(m.store.point(v), m.domains[v]);
            CHECK(r <= f);
            if (f < infinity) CHECK(f <= 3 * r);
        }
        for (std::uint32_t d = 0; d < m.report.cages; ++d) {
            const Cage& cage = m.cages[d];
            const double* const c = m.store.point(cage.centre);
            const double r = in_radius(cage), f = m.feature_size(c, cage.parent);
            CHECK(r <= f);
            CHECK(f <= 3 * r);
            for (int trial = 0; trial < 20; ++trial) {
                double direction[D], x[D];
                random_direction(random, D, direction);
                for (int k = 0; k < D; ++k) x[k] = c[k] + inscribed * r * direction[k];
                CHECK(m.in_cell(cage, x));
            }
            ++seen;
        }
    }
    CHECK(seen > 30);
}
TEST_CASE_TEMPLATE_APPLY(caged, Dimensions<2, 4>);

TEST_CASE("lemma 4.6.2 fails for a cage that is encroached") {
    Hierarchical<2> m(inputs::geometric(2, 1e3, 10));
    REQUIRE(m.report.cages > 3);
    Cage cage = m.cages[3];
    const double f = m.feature_size(m.store.point(cage.centre), cage.parent);
    cage.radius = 30 * f;
    CHECK(in_radius(cage) > f);
}

namespace {

// Points of any dimension as the engine's functions take them: the inputs, then a shell of two for each cage.
struct ByHand {
    struct Vertex {
        double x[4];
        unsigned char marker;
    };
    std::vector<Vertex> vertices;
    std::vector<Cage> cages;
    std::vector<std::uint32_t> domains;
    std::vector<std::uint32_t> cells;
    Arena nobody;  // watches

    ByHand(const std::vector<std::vector<double>>& points, std::uint32_t dimensions) : dim(dimensions) {
        for (const std::vector<double>& x : points) add(x, 0, none);
    }
    void add(const std::vector<double>& x, unsigned char marker, std::uint32_t domain) {
        Vertex v = {{}, marker};
        std::copy(x.begin(), x.end(), v.x);
        vertices.push_back(v);
        domains.push_back(domain);
    }
    void cage_about(std::uint32_t centre, double weight) {
        const auto d = static_cast<std::uint32_t>(cages.size());
        cages.push_back({centre, none, none, none, weight / 0.9, 0, cage_epsilon * weight / 0.9});
        domains[centre] = d;
        for (const double side : {weight, -0.9 * weight}) {
            std::vector<double> x(vertices[centre].x, vertices[centre].x + dim);
            x[dim - 1] += side;
            add(x, 2, d);
        }
    }
    // One cell of any vertices, as far as the check goes.
    HierarchyView view() {
        cells.clear();
        for (std::uint32_t v = 0; v < vertices.size(); ++v)
            for (std::uint32_t w = 0; w < v; ++w) {
                cells.push_back(v);
                cells.insert(cells.end(), dim, w);
            }
        const auto* const first = reinterpret_cast<const unsigned char*>(vertices.data());
        return {first,
                first + offsetof(Vertex, marker),
                reinterpret_cast<const unsigned char*>(cells.data()),
                sizeof(Vertex),
                4 * (dim + 1),
                dim,
                static_cast<std::uint32_t>(vertices.size()),
                static_cast<std::uint32_t>(cells.size() / (dim + 1)),
                static_cast<std::uint32_t>(cages.size()),
                cages.data(),
                domains.data(),
                nobody};
    }
    std::vector<WeightedCell> measured() {
        std::vector<WeightedCell> found(cages.size());
        measure_weighted_cells(view(), found.data());
        return found;
    }
    bool passes() {
        std::vector<CageFigures> figures(cages.size());
        return check_weighted_cells(view(), figures.data()).violation == nullptr;
    }
    std::uint32_t dim;
};

}  // namespace

TEST_CASE("weighted cells by hand: a square, a polygon, three points in four dimensions") {
    ByHand square({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 2);
    square.cage_about(0, 0.25);
    WeightedCell cell = square.measured()[0];
    CHECK(cell.weight == 0.25);
    CHECK(cell.in_radius == 1.125);
    CHECK(cell.feature_size == 2);
    CHECK(cell.epsilon == 0.125);
    CHECK(square.passes());

    // The hexagon of side 1: neighbours of weight 1/4 and 0, then of 1/4 on both sides.
    std::vector<std::vector<double>> corners;
    for (int k = 0; k < 6; ++k) corners.push_back({std::cos(k * std::acos(0.5)), std::sin(k * std::acos(0.5))});
    ByHand hexagon(corners, 2);
    hexagon.cage_about(0, 0.25);
    hexagon.cage_about(1, 0.25);
    for (const WeightedCell& each : hexagon.measured()) {
        CHECK(each.in_radius == doctest::Approx(0.5));
        CHECK(each.feature_size == doctest::Approx(1));
        CHECK(each.epsilon == doctest::Approx(1.0 / 3));
    }

    ByHand three({{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 2, 0}}, 4);
    three.cage_about(0, 0.125);
    three.cage_about(1, 0.25);
    const std::vector<WeightedCell> cells = three.measured();
    CHECK(cells[0].in_radius == 0.4375);
    CHECK(cells[1].in_radius == 0.5625);
    CHECK(cells[0].feature_size == 1);
    CHECK(cells[1].feature_size == 1);
    CHECK(cells[0].epsilon == doctest::Approx(0.25 / 0.875));
    CHECK(cells[1].epsilon == cells[0].epsilon);
    CHECK(three.passes());

    // The origin's cage reaches the other's: no epsilon will do.
    three.cages.clear();
    three.cage_about(0, 0.5);
    three.cage_about(1, 0.75);
    CHECK(three.measured()[0].epsilon > 1);
    CHECK(!three.passes());
}

TEST_CASE("weights that are too large are refused, by a third and by little more") {
    for (const double share : {0.33, 0.34}) {
        ByHand alone({{0, 0}, {1, 0}, {0, 2}}, 2);  // a cage and vertices
        alone.cage_about(0, share);
        CHECK(alone.passes() == (share < 1.0 / 3));
        ByHand pair({{0, 0}, {1, 0}, {0, 2}}, 2);  // two cages: w <= (1 - w / 2) / 3 for w = 2 / 7
        pair.cage_about(0, share * 6 / 7);
        pair.cage_about(1, share * 3 / 7);
        CHECK(pair.passes() == (share < 1.0 / 3));
        CHECK((pair.measured()[0].epsilon < 1.0 / 3) == (share < 1.0 / 3));
    }
}

TEST_CASE("a cage whose in-radius is out of proportion is refused") {
    // The nearest vertex outside is one of another cage's shell, far from its centre for that cage's weight.
    for (const double outside : {0.9, 2.5, 5.5}) {
        ByHand cages({{0, 0}, {8, 0}, {0, 9}}, 2);
        cages.cage_about(0, 0.5);
        cages.cage_about(1, 1);
        CHECK(cages.passes());
        cages.add({outside, 0}, 1, 1);  // said to be in the other cage
        CHECK(cages.passes() == (8 <= 3 * 0.5 * (outside + 0.45)));
    }
}

TEST_CASE_TEMPLATE_DEFINE("weighted cells of meshes pass, and shells that are moved out do not", T, checked_weights) {
    constexpr int D = T::value;
    for (const inputs::Points& points : {inputs::nested(D, 3, 6, 1e3), inputs::geometric(D, 20, 8)}) {
        Hierarchical<D> m(points);
        const HierarchyView view = hierarchy_view(m.store, m.cages, m.report.cages, m.domains.data());
        std::vector<CageFigures> figures(m.report.cages);
        std::vector<WeightedCell> cells(m.report.cages);
        CHECK(check_weighted_cells(view, figures.data()).violation == nullptr);
        measure_weighted_cells(view, cells.data());
        for (std::uint32_t d = 0; d < m.report.cages; ++d) {
            const double* const c = m.store.point(m.cages[d].centre);
            CHECK(cells[d].weight > 0.8 * m.cages[d].radius);
            CHECK(cells[d].weight < m.cages[d].radius);
            CHECK(cells[d].feature_size == doctest::Approx(m.feature_size(c, m.cages[d].parent)).epsilon(1e-12));
            std::uint32_t shell = 0;
            while (m.domains[shell] != d || m.store.vertex(shell).marker != Marker::exempt) ++shell;
            double* const x = m.store.vertex(shell).x;
            const double kept = x[0], away = x[0] > c[0] ? 1 : -1;
            x[0] = c[0] + away * 0.4 * cells[d].feature_size;
            CHECK(check_weighted_cells(view, figures.data()).violation != nullptr);
            x[0] = kept;
        }
        CHECK(check_weighted_cells(view, figures.data()).violation == nullptr);
    }
}
TEST_CASE_TEMPLATE_APPLY(checked_weights, Dimensions<2, 4>);
