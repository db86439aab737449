// Additively weighted Voronoi cells and the cells of cages that approximate them (thesis 4.6).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "mesh/hierarchy_quality.hpp"
#include "mesh/mesh_points.hpp"
#include "mesh/quality.hpp"

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
        MeshResult<D> result;
        REQUIRE(mesh_points<D>(store, points.data(), points.size() / D, request, {block.arena, monitor}, &result) ==
                Status::ok);
        domain = result.domain;
        cages = result.cages;
        report = result.hierarchy;
        ratios.resize(state.vertex_count);
        domains.resize(state.vertex_count);
        nearest2.resize(state.vertex_count);
        HierarchyQuality quality;
        REQUIRE(measure_hierarchy<D>(store, {cages, report.cages, domain, ratios.data(), domains.data()}, block.arena,
                                     &quality) == Status::ok);
        recomputed_nearest2<D>(store, nearest2.data());
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
            const double r = in_radius<D>(cage), f = m.feature_size(c, cage.parent);
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
    CHECK(in_radius<2>(cage) > f);
}
