// What tight_filter.hpp says of its cover, at sampled points: the ball that stands for a clump lies in its cells, and
// everywhere else min(d_P, rho) is between the bounds. On meshes that are not over-refined too, where the bounds are
// far from what refinement would make of them.
#include "filtration/tight_filter.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/dimensions.hpp"
#include "common/filtered_mesh.hpp"
#include "common/meshed.hpp"
#include "filtration/filters.hpp"
#include "geometry/sides.hpp"

using namespace netmesh;

namespace {

template <int D> struct Nearest {
    std::uint32_t vertex;
    double distance, second;  // to the nearest and the second nearest
};

// Of vertices first..last-1, but for `except`.
template <int D>
Nearest<D> nearest_of(const Store<D>& store, std::uint32_t last, const double* x, std::uint32_t except = none) {
    Nearest<D> found = {none, infinity, infinity};
    for (std::uint32_t v = 0; v < last; ++v) {
        if (v == except) continue;
        const double d = distance<D>(x, store.point(v));
        found.second = std::min(found.second, std::max(d, found.distance));
        if (d < found.distance) found = {v, d, found.second};
    }
    return found;
}

template <int D> void sample_cover(const inputs::Points& points, const MeshRequest& request, int samples) {
    Meshed<D> mesh(points, request, std::size_t{1} << 25);
    REQUIRE(mesh.status == Status::ok);
    const Store<D>& store = mesh.store;
    const std::uint32_t count = store.state.vertex_count, inputs = mesh.inputs();
    const double rho = mesh.result.domain.enclosing_radius * up;
    std::vector<double> value(count);
    std::vector<Interval> interval(count);
    Evaluation tight = {value.data(), interval.data()};
    REQUIRE(evaluate(FilteredMesh<D>{mesh.store, mesh.result.domain, inputs},
                     {NETMESH_FILTER_TIGHT, &tight_on_mesh, FilterValues::certified}, {mesh.block.arena, mesh.monitor},
                     &tight) == Status::ok);
    // Clumps by their definition.
    std::vector<std::uint32_t> clump(count, none);
    for (std::uint32_t v = 0; v < count; ++v) {
        if (store.vertex(v).marker == Marker::exempt) continue;
        const Nearest<D> n = nearest_of<D>(store, inputs, store.point(v));
        const double f = nearest_of<D>(store, inputs, store.point(n.vertex), n.vertex).distance;
        if (n.distance <= 0.5 * f) clump[v] = n.vertex;
    }
    // The thesis's own values: what is in a clump comes with it, at half of its input's distance to the others.
    std::vector<double> own(count);
    Evaluation thesis = {own.data()};
    REQUIRE(evaluate(FilteredMesh<D>{mesh.store, mesh.result.domain, inputs},
                     {NETMESH_FILTER_TIGHT, &tight_on_mesh, FilterValues::thesis}, {mesh.block.arena, mesh.monitor},
                     &thesis) == Status::ok);
    for (std::uint32_t v = 0; v < count; ++v) {
        const Nearest<D> n = nearest_of<D>(store, inputs, store.point(v));
        const double f = nearest_of<D>(store, inputs, store.point(n.vertex), n.vertex).distance;
        CHECK(own[v] == doctest::Approx(std::min(std::max(n.distance, f / 2), rho)).epsilon(1e-11));
        if (clump[v] != none) CHECK(value[v] == value[clump[v]]);
    }
    int in_balls = 0, in_clumps = 0, others = 0;
    inputs::Random random(8);
    for (int s = 0; s < samples; ++s) {
        double x[D];
        const auto near = static_cast<std::uint32_t>(random.below(s % 3 == 0 ? count : inputs));
        const double scale = (s % 3 == 2 ? 1.2 * interval[near].lo : 3 * interval[near].lo) + (s % 3 == 0 ? rho : 0);
        for (int k = 0; k < D; ++k) x[k] = store.point(near)[k] + scale * (2 * random.uniform() - 1);
        if (s % 3 == 1 && s % 2 == 0) {  // about the middle between two inputs
            const std::uint32_t next = nearest_of<D>(store, inputs, store.point(near), near).vertex;
            const double share = 0.35 + 0.3 * random.uniform(),
                         aside = distance<D>(store.point(near), store.point(next));
            for (int k = 0; k < D; ++k)
                x[k] = store.point(near)[k] + share * (store.point(next)[k] - store.point(near)[k]) +
                       0.1 * aside * (2 * random.uniform() - 1);
        }
        const Nearest<D> at = nearest_of<D>(store, count, x);
        if (at.second - at.distance < 1e-9 * at.second) continue;
        const double f = std::min(nearest_of<D>(store, inputs, x).distance, rho);
        // The ball of any clump that x is in: x is in one of the clump's cells.
        for (std::uint32_t p = 0; p < inputs; ++p) {
            if (!(distance<D>(x, store.point(p)) < interval[p].lo)) continue;
            ++in_balls;
            CHECK(clump[at.vertex] == p);
        }
        const Interval& i = interval[at.vertex];
        const std::uint32_t p = clump[at.vertex];
        ++(p == none ? others : in_clumps);
        CHECK(f <= i.hi);
        // No other input comes nearer to the clump's cells than the ball's radius.
        if (p != none) CHECK(i.lo <= nearest_of<D>(store, inputs, x, p).distance);
        if (p == none || !(distance<D>(x, store.point(p)) < i.lo)) CHECK(i.lo <= f);
    }
    CHECK(in_balls > samples / 50);
    CHECK(in_clumps > samples / 50);
    CHECK(others > samples / 50);
}

}  // namespace

TEST_CASE("balls of clumps lie in their cells, and bounds hold everywhere else") {
    for (const double tau : {2.5, 3.0, 3.5, 4.0, 6.0}) {
        CAPTURE(tau);
        sample_cover<2>(inputs::uniform(2, 40), by_quality(tau), 15000);
        sample_cover<2>(inputs::circle(24), by_quality(tau, 3), 6000);
        sample_cover<2>(inputs::clusters(2, 30), by_quality(tau), 6000);
        sample_cover<3>(inputs::uniform(3, 20), by_quality(tau), 6000);
    }
    for_each_dimension<4, 4>([&](auto dim) { sample_cover<dim>(inputs::uniform(4, 6), by_quality(4), 3000); });
    MeshRequest fine = by_quality(2.5, tight_domain_factor(0.5));
    fine.size.eps = tight_size(0.5);
    sample_cover<2>(inputs::uniform(2, 15), fine, 6000);
}

// Seldom is it another input, not a cell outside, that bounds a ball: a case in some twenty meshes of this kind.
TEST_CASE("no other input is nearer to the cells of a clump than its ball's radius, by the sides of cells") {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        CAPTURE(seed);
        Meshed<2> mesh(inputs::uniform(2, 40, seed), by_quality(3), std::size_t{1} << 24);
        REQUIRE(mesh.status == Status::ok);
        const Store<2>& store = mesh.store;
        const std::uint32_t count = store.state.vertex_count, inputs = mesh.inputs();
        std::vector<double> value(count);
        std::vector<Interval> interval(count);
        Evaluation tight = {value.data(), interval.data()};
        REQUIRE(evaluate(FilteredMesh<2>{mesh.store, mesh.result.domain, inputs},
                         {NETMESH_FILTER_TIGHT, &tight_on_mesh, FilterValues::certified},
                         {mesh.block.arena, mesh.monitor}, &tight) == Status::ok);
        for_each_side(store, [&](std::uint32_t v, const double* a, const double* b) {
            if (store.vertex(v).marker == Marker::exempt) return;
            const Nearest<2> n = nearest_of<2>(store, inputs, store.point(v));
            const Nearest<2> other = nearest_of<2>(store, inputs, store.point(n.vertex), n.vertex);
            if (n.distance > 0.5 * other.distance) return;
            for (std::uint32_t p = 0; p < inputs; ++p)
                if (p != n.vertex) CHECK(interval[n.vertex].lo <= distance_to_side(store.point(p), a, b) * (1 + 1e-12));
        });
    }
}

// 7.5.1 and 7.5.3: on a mesh of the size that is asked for, in its domain, the thesis's values have the ratio 1 + eps.
TEST_CASE("the sizes of the tight filter reach the accuracy that is promised") {
    const auto ratio = [](auto dim, const inputs::Points& points, double eps) {
        constexpr int D = decltype(dim)::value;
        MeshRequest fine = by_quality(2.5, tight_domain_factor(eps));
        fine.size.eps = tight_size(eps);
        Meshed<D> mesh(points, fine, std::size_t{1} << 26);
        REQUIRE(mesh.status == Status::ok);
        std::vector<double> value(mesh.store.state.vertex_count);
        Evaluation out = {value.data()};
        REQUIRE(evaluate(FilteredMesh<D>{mesh.store, mesh.result.domain, mesh.inputs()},
                         {NETMESH_FILTER_TIGHT, &tight_on_mesh, FilterValues::thesis}, {mesh.block.arena, mesh.monitor},
                         &out) == Status::ok);
        return out.certificate.ratio;
    };
    using Plane = std::integral_constant<int, 2>;
    for (const double eps : {0.5, 0.2, 0.1}) {
        CAPTURE(eps);
        CHECK(ratio(Plane(), inputs::uniform(2, 8), eps) <= (1 + eps) * (1 + 1e-9));
        CHECK(ratio(Plane(), {0, 0, 1, 0, 0.25, 0.75, -2, 1}, eps) <= (1 + eps) * (1 + 1e-9));
    }
    CHECK(ratio(std::integral_constant<int, 3>(), inputs::uniform(3, 3), 0.5) <= 1.5 * (1 + 1e-9));
}
