// How far clipped cells reach, on triangulations made by hand: against sampling, with flat cells, and where memory is
// short.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "delaunay/load.hpp"
#include "delaunay/triangulate.hpp"
#include "mesh/sizing.hpp"
#include "numerics/vector.hpp"

using namespace netmesh;

namespace {}  // namespace

TEST_CASE_TEMPLATE_DEFINE("size ratios in any gap: the same figure, or none", T, gaps) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::jittered(D, 2, 0.1, 3);
    const std::uint32_t n = 1u << D;
    Block block(std::size_t{1} << 23);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    REQUIRE(triangulate<D>(store, points.data(), n, 1, monitor, &input) == Status::ok);
    measure_edges<D>(store);
    Domain<D> domain;
    smallest_enclosing_ball<D>(store, n, domain);
    domain.radius = domain.enclosing_radius;
    store.vertex(3).cell = none;  // what is not in the mesh has no size
    SizeRule rule;
    rule.eps = 0.5;
    double worst, aspect;
    std::uint32_t v;
    SizeRatio expected, sized;
    REQUIRE(worst_size_ratio<D>(store, {domain, n, rule, Corners::recomputed}, block.arena, &expected) == Status::ok);
    REQUIRE(recomputed_aspect_ratio<D>(store, domain, block.arena, &aspect, &v) == Status::ok);
    CHECK(expected.worst > 0);
    CHECK(expected.vertex != 3);
    const std::size_t low = block.arena.low_mark(), top = block.arena.high_mark();
    bool fits = false;
    for (std::size_t bytes = 0; !fits; bytes += 16) {
        block.arena.release_low(top - bytes);
        const Status status = worst_size_ratio<D>(store, {domain, n, rule, Corners::kept}, block.arena, &sized);
        block.arena.release_low(low);
        fits = status == Status::ok;
        REQUIRE((fits || status == Status::out_of_memory));
        if (fits) CHECK(sized.worst == doctest::Approx(expected.worst));
    }
    bool measured = false;
    for (std::size_t bytes = 0; !measured; bytes += 16) {
        block.arena.release_low(top - bytes);
        const Status status = recomputed_aspect_ratio<D>(store, domain, block.arena, &worst, &v);
        block.arena.release_low(low);
        measured = status == Status::ok;
        REQUIRE((measured || status == Status::out_of_memory));
    }
    CHECK(worst == aspect);
}
TEST_CASE_TEMPLATE_APPLY(gaps, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("the farthest pole of a half ball, wherever the domain lies", T, poles) {
    constexpr int D = T::value;
    // v at the origin, w beside it, all others far away: in the domain there is only the bisector of v and w.
    inputs::Points points(static_cast<std::size_t>(D), 0.0);
    points.resize(2 * D, 0.0);
    points[D] = 1;
    for (int i = 1; i < D; ++i)
        for (const double far : {-1e3, 1e3}) {
            points.resize(points.size() + D, 0.0);
            points[points.size() - D + static_cast<std::size_t>(i)] = far;
        }
    points.resize(points.size() + D, 0.0);
    points[points.size() - D] = -1e3;
    const std::uint32_t n = static_cast<std::uint32_t>(points.size() / D);
    Block block(std::size_t{1} << 20);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    REQUIRE(triangulate<D>(store, points.data(), n, 1, monitor, &input) == Status::ok);
    std::uint32_t v = 0, count = 0;
    while (store.point(v)[0] != 0 || std::fabs(store.point(v)[D - 1]) > 1) ++v;
    for (CellId c(0); c < state.cell_slots; ++c)
        if (std::count(store.cell(c).vertex, store.cell(c).vertex + D + 1, v) == 1)
            store.list_top()[-1 - static_cast<std::ptrdiff_t>(count++)] = c;
    REQUIRE(count > 1);
    inputs::Random random(4);
    for (const double off : {-3.0, -0.5, 0.0, 0.25, 0.4, 0.5}) {
        Domain<D> domain = {};
        domain.centre[0] = off;
        if (D > 2 && off == 0.25) domain.centre[D - 1] = 0.25;
        domain.radius = 2;
        double x[D], farthest = 0;
        CellId cell;
        const double found = std::sqrt(farthest_pole<D>(store, domain, v, store.list_top(), count, x, &cell));
        for (int sample = 0; sample < 4000; ++sample) {
            double y[D], length = 0;
            for (double& c : y) {
                c = 2 * random.uniform() - 1;
                length += c * c;
            }
            for (int k = 0; k < D; ++k) y[k] = domain.centre[k] + domain.radius * y[k] / std::sqrt(length);
            if (y[0] <= 0.5) farthest = std::max(farthest, std::sqrt(distance2<D>(y, store.point(v))));
        }
        CHECK(found >= farthest * (1 - 1e-9));
        CHECK(found <= farthest * 1.2);
        CHECK(std::sqrt(distance2<D>(x, store.point(v))) == doctest::Approx(found));
        CHECK(std::sqrt(domain.distance2(x)) == doctest::Approx(domain.radius));
        CHECK(x[0] <= 0.5 + 1e-6);
        CHECK(std::count(store.cell(cell).vertex, store.cell(cell).vertex + D + 1, v) == 1);
    }
}
TEST_CASE_TEMPLATE_APPLY(poles, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("cells too flat for a corner do not count", T, flat) {
    constexpr int D = T::value;
    // Two cells at a common facet; with all of the first one's vertices in a plane it has no corner.
    std::vector<double> x(static_cast<std::size_t>(D * (D + 2)), 0.0);
    for (int i = 1; i <= D; ++i) x[static_cast<std::size_t>(i * D + i - 1)] = 1;
    for (int k = 0; k < D; ++k) x[static_cast<std::size_t>((D + 1) * D + k)] = 1;
    std::uint32_t cells[2 * (D + 1)];
    for (std::uint32_t i = 0; i <= D; ++i) {
        cells[i] = i;
        cells[D + 1 + i] = i == 0 ? D + 1 : i;
    }
    const auto out_radii = [&](const double* places, Corners corners, std::uint32_t count, double radius) {
        Block block(std::size_t{1} << 16);
        StoreState state = {};
        Store<D> store(block.arena, state);
        CheckResult why;
        REQUIRE(load_cells<D>(store, places, D + 2, cells + (count == 1 ? D + 1 : 0), count, &why) == Status::ok);
        Domain<D> domain = {};
        domain.radius = domain.enclosing_radius = radius;
        std::vector<double> out2(D + 2);
        clipped_out_radii<D>(store, domain, corners, out2.data());
        return out2;
    };
    // The common corner inside of the domain and outside.
    for (const double radius : {0.6 * std::sqrt(D), 0.4 * std::sqrt(D)})
        for (const Corners corners : {Corners::kept, Corners::recomputed}) {
            const std::vector<double> alone = out_radii(x.data(), corners, 1, radius);
            std::vector<double> flattened = x;  // vertex 0 into the plane of the common facet
            for (int k = 0; k < D; ++k) flattened[static_cast<std::size_t>(k)] = k < 2 ? 0.5 : 0;
            CHECK(out_radii(flattened.data(), corners, 2, radius) == alone);
            if (radius > 0.5 * std::sqrt(D)) CHECK(out_radii(x.data(), corners, 2, radius) != alone);
        }
}
TEST_CASE_TEMPLATE_APPLY(flat, Dimensions<>);
