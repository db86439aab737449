#include "delaunay/kernel.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/block.hpp"
#include "common/inputs.hpp"
#include "delaunay/check.hpp"
#include "delaunay/load.hpp"
#include "delaunay/spatial_order.hpp"
#include "delaunay/triangulate.hpp"

using namespace netmesh;

namespace {

template <int D> struct Triangulated {
    Triangulated(const inputs::Points& points, std::size_t bytes) : block(bytes), store(block.arena, state) {
        status = triangulate<D>(store, points.data(), points.size() / D, 1, monitor, &input);
    }
    Block block;
    StoreState state = {};
    Store<D> store;
    Monitor monitor;
    InputReport input;
    Status status;
};

template <int D> const char* violation(const Store<D>& store) {
    CheckResult r = check_combinatorial<D>(store);
    if (r.violation == nullptr) r = check_geometric<D>(store);
    if (r.violation == nullptr) r = check_delaunay<D>(store);
    return r.violation;
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("triangulations pass the exact checkers", T, exact_checkers) {
    constexpr int D = T::value;
    constexpr std::size_t sizes[] = {0, 0, 3000, 1000, 300, 120, 50};
    for (const inputs::Points& points : {inputs::uniform(D, sizes[D]), inputs::clusters(D, sizes[D])}) {
        Triangulated<D> t(points, std::size_t{1} << 26);
        REQUIRE(t.status == Status::ok);
        CHECK(violation<D>(t.store) == nullptr);
        for (std::uint32_t v = 0; v < t.state.vertex_count; ++v) CHECK(t.store.vertex(v).cell != none);
        CHECK(t.state.in_ball_counts.calls[0] > 0);
    }
}
TEST_CASE_TEMPLATE_INVOKE(exact_checkers, std::integral_constant<int, 2>, std::integral_constant<int, 3>,
                          std::integral_constant<int, 4>, std::integral_constant<int, 5>,
                          std::integral_constant<int, 6>);

TEST_CASE_TEMPLATE_DEFINE("cached balls contain the true centre within their error", T, ball_errors) {
    constexpr int D = T::value;
    constexpr std::size_t sizes[] = {0, 0, 2000, 800, 200, 80, 40};
    // Vertices of a cell lie on its ball: their power, true value zero, must not exceed the bound that power() states.
    for (const inputs::Points& points : {inputs::uniform(D, sizes[D]), inputs::clusters(D, sizes[D])}) {
        Triangulated<D> t(points, std::size_t{1} << 26);
        REQUIRE(t.status == Status::ok);
        std::size_t known = 0;
        for (std::uint32_t c = 0; c < t.state.cell_slots; ++c) {
            const Cell<D>& cell = t.store.cell(c);
            if (!(cell.error < 1)) continue;
            ++known;
            for (const std::uint32_t v : cell.vertex) {
                double bound;
                const double value = power<D>(cell, t.store.point(v), &bound);
                CHECK(std::fabs(value) <= bound);
            }
        }
        CHECK(known * 10 > std::size_t{t.state.cell_slots} * 9);
    }
}
TEST_CASE_TEMPLATE_INVOKE(ball_errors, std::integral_constant<int, 2>, std::integral_constant<int, 3>,
                          std::integral_constant<int, 4>, std::integral_constant<int, 5>,
                          std::integral_constant<int, 6>);

TEST_CASE("duplicates are merged into the first and counted") {
    inputs::Points points = inputs::uniform(3, 200);
    for (int k = 0; k < 3 * 100; ++k) points.push_back(points[static_cast<std::size_t>(k)]);
    points[0] = -0.0;
    points[600] = 0.0;
    Triangulated<3> t(points, std::size_t{1} << 24);
    REQUIRE(t.status == Status::ok);
    CHECK(t.input.duplicates == 100);
    CHECK(t.state.vertex_count == 200);
    for (std::uint32_t v = 0; v < 200; ++v) {
        CHECK(t.store.vertex(v).origin == v);
        for (std::size_t k = 0; k < 3; ++k) CHECK(t.store.vertex(v).x[k] == points[3 * v + k]);
    }
    CHECK_FALSE(std::signbit(t.store.vertex(0).x[0]));
}

TEST_CASE("each planted fault is found by a checker") {
    const inputs::Points points = inputs::uniform(3, 100);
    Triangulated<3> t(points, std::size_t{1} << 24);
    REQUIRE(violation<3>(t.store) == nullptr);
    SUBCASE("a neighbour that does not point back") {
        t.store.cell(5).neighbour[2] = t.store.cell(9).neighbour[1];
        CHECK(check_combinatorial<3>(t.store).violation != nullptr);
    }
    SUBCASE("a vertex replaced") {
        t.store.cell(7).vertex[0] = (t.store.cell(7).vertex[0] + 1) % 100;
        CHECK(violation<3>(t.store) != nullptr);
    }
    SUBCASE("orientation turned") {
        std::swap(t.store.cell(3).vertex[0], t.store.cell(3).vertex[1]);
        CHECK(violation<3>(t.store) != nullptr);
    }
    SUBCASE("a point moved so that balls are no longer empty") {
        for (double& x : t.store.vertex(4).x) x = 0.5 + 0.4 * (x - 0.5);
        CHECK(violation<3>(t.store) != nullptr);
    }
}

TEST_CASE("triangulation from lists of cells is the one it was made from") {
    const inputs::Points points = inputs::uniform(4, 80);
    Triangulated<4> t(points, std::size_t{1} << 24);
    std::vector<std::uint32_t> cells;
    for (std::uint32_t c = 0; c < t.state.cell_slots; ++c)
        for (const std::uint32_t v : t.store.cell(c).vertex) cells.push_back(v);
    for (std::size_t c = 0; c + 5 < cells.size(); c += 10) std::swap(cells[c], cells[c + 1]);
    Block block(std::size_t{1} << 24);
    StoreState state = {};
    Store<4> loaded(block.arena, state);
    CheckResult why;
    REQUIRE(load_cells<4>(loaded, points.data(), 80, cells.data(), t.state.cell_slots, &why) == Status::ok);
    CHECK(violation<4>(loaded) == nullptr);
    for (std::uint32_t c = 0; c < t.state.cell_slots; ++c)
        for (int i = 0; i <= 4; ++i) {
            const std::uint32_t v = t.store.cell(c).vertex[i];
            int j = 0;
            while (loaded.cell(c).vertex[j] != v) ++j;
            CHECK(loaded.view().neighbour(c, j) == t.store.view().neighbour(c, i));
        }
    SUBCASE("three cells at one facet are refused") {
        for (int i = 0; i < 5; ++i) cells.push_back(cells[static_cast<std::size_t>(i)]);
        Block again(std::size_t{1} << 24);
        StoreState other = {};
        Store<4> bad(again.arena, other);
        CHECK(load_cells<4>(bad, points.data(), 80, cells.data(), t.state.cell_slots + 1, &why) ==
              Status::check_failed);
        CHECK(why.violation != nullptr);
    }
}

TEST_CASE("any arena size ends in a status and, once there is a cell, in a triangulation") {
    const inputs::Points points = inputs::uniform(3, 60);
    std::uint32_t partial = 0, whole = 0;
    for (std::size_t bytes = 16; bytes < 60000; bytes += 160) {
        Triangulated<3> t(points, bytes);
        REQUIRE((t.status == Status::ok || t.status == Status::out_of_memory));
        if (t.status == Status::out_of_memory) CHECK(t.block.arena.bytes_wanted() > bytes - 16);
        if (t.state.cell_slots == 0) continue;
        CHECK(violation<3>(t.store) == nullptr);
        ++(t.status == Status::ok ? whole : partial);
    }
    CHECK(partial > 10);
    CHECK(whole > 10);
}

TEST_CASE("spatial order is a permutation with equal points together, for any spread") {
    inputs::Points points;
    for (int i = 0; i < 1000; ++i)
        for (int k = 0; k < 2; ++k) points.push_back(std::ldexp(1.0, -i) * (k + 1));
    for (int i = 0; i < 500; ++i) points.push_back(points[static_cast<std::size_t>(i)]);
    const std::uint32_t n = static_cast<std::uint32_t>(points.size() / 2);
    Block block(std::size_t{1} << 20);
    std::vector<std::uint32_t> order(n);
    bool repeats = false;
    REQUIRE(spatial_order<2>(reinterpret_cast<const unsigned char*>(points.data()), 16, n, 1, block.arena, order.data(),
                             &repeats) == Status::ok);
    CHECK(repeats);
    std::vector<std::uint32_t> sorted = order;
    std::sort(sorted.begin(), sorted.end());
    for (std::uint32_t i = 0; i < n; ++i) REQUIRE(sorted[i] == i);
    std::vector<std::uint32_t> position(n);
    for (std::uint32_t k = 0; k < n; ++k) position[order[k]] = k;
    for (std::uint32_t i = 0; i < 250; ++i) CHECK(position[1000 + i] == position[i] + 1);
}
