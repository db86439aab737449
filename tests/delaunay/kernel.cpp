#include "delaunay/kernel.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "delaunay/any_kernel.hpp"
#include "delaunay/check.hpp"
#include "delaunay/independent_points.hpp"
#include "delaunay/load.hpp"
#include "delaunay/ridges.hpp"
#include "delaunay/spatial_order.hpp"
#include "delaunay/triangulate.hpp"

using namespace netmesh;

namespace {

// Are the vertices visited those of all cells in conflict, by the kernel of the dimension and by that of any?
template <int D> bool visits_its_vertices(const Store<D>& store, const Kernel<D>& kernel, const Cavity& cavity) {
    const AnyStore any(store);
    const Kernel<any_dimension> any_kernel(any, corner_error_max, VertexCells::kept);
    std::set<std::uint32_t> all, visited, any_visited;
    for (std::uint32_t k = 0; k < cavity.cells; ++k)
        for (const VertexId w : store.cell(kernel.cavity_cell(k)).vertex) all.insert(w);
    visit_cavity_vertices(kernel, store, cavity, [&](VertexId w) { visited.insert(w); });
    visit_cavity_vertices(any_kernel, any, cavity, [&](VertexId w) { any_visited.insert(w); });
    return visited == all && any_visited == all;
}

// By the kernel, in every dimension, as meshes are made; ghosts stay.
template <int D> void insert_all(Store<D>& store, const inputs::Points& points, double error_max) {
    Monitor monitor;
    InputReport input;
    std::uint32_t* order;
    REQUIRE(take_input<D>(store, points.data(), points.size() / D, 1, monitor, &input, &order) == Status::ok);
    const std::uint32_t count = store.state.vertex_count;
    VertexId ids[D + 1];
    REQUIRE(independent_points(store, order, count, ids));
    REQUIRE(store.open_cells() == Status::ok);
    Kernel<D> kernel(store, error_max, VertexCells::kept);
    REQUIRE(kernel.start(ids) == Status::ok);
    for (std::uint32_t k = 0; k < count; ++k) {
        const VertexId v(order[k]);
        if (store.vertex(v).cell != none) continue;
        Cavity cavity;
        REQUIRE(
            kernel.find_cavity(store.point(v), v, kernel.locate(store.point(v), v, store.state.last_cell), &cavity));
        if (k < 200) CHECK(visits_its_vertices<D>(store, kernel, cavity));
        REQUIRE(kernel.can_fill(cavity, 0));
        kernel.fill(cavity, v);
    }
}

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
    CheckResult r = check_combinatorial(store);
    if (r.violation == nullptr) r = check_geometric(store);
    if (r.violation == nullptr) r = check_delaunay(store);
    return r.violation;
}

// Cells by their vertices, least first, in the plane.
std::vector<std::array<std::uint32_t, 3>> triangles(const Store<2>& store) {
    std::vector<std::array<std::uint32_t, 3>> found;
    for (std::uint32_t c = 0; c < store.state.cell_slots; ++c) {
        if (!store.is_live(c) || store.is_ghost(c)) continue;
        const VertexId* const v = store.cell(c).vertex;
        const std::uint32_t least = v[0] < v[1] && v[0] < v[2] ? 0 : v[1] < v[2] ? 1 : 2;
        found.push_back({v[least], v[(least + 1) % 3], v[(least + 2) % 3]});
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("triangulations pass the exact checkers", T, exact_checkers) {
    constexpr int D = T::value;
    constexpr std::size_t sizes = by_dimension<std::size_t>(D, {3000, 1000, 300, 120, 50});
    for (const inputs::Points& points : {inputs::uniform(D, sizes), inputs::clusters(D, sizes)}) {
        Triangulated<D> t(points, std::size_t{1} << 26);
        REQUIRE(t.status == Status::ok);
        CHECK(violation<D>(t.store) == nullptr);
        for (std::uint32_t v = 0; v < t.state.vertex_count; ++v) CHECK(t.store.vertex(v).cell != none);
        CHECK(t.state.in_ball_counts.calls[0] > 0);
    }
}
TEST_CASE_TEMPLATE_APPLY(exact_checkers, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("cached balls contain the true centre within their error", T, ball_errors) {
    constexpr int D = T::value;
    constexpr std::size_t sizes = by_dimension<std::size_t>(D, {2000, 800, 200, 80, 40});
    // Vertices of a cell lie on its ball: their power, true value zero, must not exceed the bound that power() states.
    for (const inputs::Points& points : {inputs::uniform(D, sizes), inputs::clusters(D, sizes)}) {
        Block block(std::size_t{1} << 26);
        StoreState state = {};
        Store<D> store(block.arena, state);
        insert_all<D>(store, points, 0x1p-7);
        std::size_t known = 0, finite = 0;
        for (std::uint32_t c = 0; c < state.cell_slots; ++c) {
            const Cell<D>& cell = store.cell(c);
            if (!store.is_live(c) || store.is_ghost(c)) continue;
            ++finite;
            if (!(cell.error < 1)) continue;
            ++known;
            for (const std::uint32_t v : cell.vertex) {
                double bound;
                const double value = power<D>(cell, store.point(v), &bound);
                CHECK(std::fabs(value) <= bound);
            }
        }
        CHECK(known * 10 > finite * 9);
    }
}
TEST_CASE_TEMPLATE_APPLY(ball_errors, Dimensions<>);

TEST_CASE("in the plane points are triangulated without circles as the kernel does it with them") {
    inputs::Points far = inputs::grid(2, 12), large = inputs::uniform(2, 200), small = large;
    for (double& x : far) x += 0x1p40;
    for (double& x : large) x *= 0x1p500;   // squares of squares overflow
    for (double& x : small) x *= 0x1p-500;  // and vanish
    inputs::Points wheel = inputs::circle(300);
    wheel.insert(wheel.end(), {0.0, 0.0});
    for (const inputs::Points& points :
         {inputs::uniform(2, 2000), inputs::clusters(2, 2000), inputs::grid(2, 30), inputs::circle(500),
          inputs::zoom(2, 1000, 20), inputs::repeated(2, inputs::grid(2, 9), 3), far, large, small, wheel}) {
        Block block(std::size_t{1} << 24);
        StoreState state = {};
        Store<2> store(block.arena, state);
        insert_all<2>(store, points, 0x1p-7);
        const Triangulated<2> t(points, std::size_t{1} << 24);
        REQUIRE(t.status == Status::ok);
        CHECK(violation<2>(t.store) == nullptr);
        CHECK(triangles(t.store) == triangles(store));
        for (std::uint32_t v = 0; v < t.state.vertex_count; ++v) CHECK(t.store.vertex(v).cell != none);
    }
}

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
        CHECK(check_combinatorial(t.store).violation != nullptr);
    }
    SUBCASE("a vertex replaced") {
        t.store.cell(7).vertex[0] = VertexId((t.store.cell(7).vertex[0] + 1) % 100);
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

TEST_CASE_TEMPLATE_DEFINE("triangulation from lists of cells is the one it was made from", T, from_lists) {
    constexpr int D = T::value;
    constexpr std::uint32_t n = 20 * D;
    const inputs::Points points = inputs::uniform(D, n);
    Triangulated<D> t(points, std::size_t{1} << 24);
    std::vector<std::uint32_t> cells;
    for (std::uint32_t c = 0; c < t.state.cell_slots; ++c)
        for (const std::uint32_t v : t.store.cell(c).vertex) cells.push_back(v);
    for (std::size_t c = 0; c + D + 1 < cells.size(); c += 2 * D + 2) std::swap(cells[c], cells[c + 1]);
    Block block(std::size_t{1} << 24);
    StoreState state = {};
    Store<D> loaded(block.arena, state);
    CheckResult why;
    REQUIRE(load_cells<D>(loaded, points.data(), n, cells.data(), t.state.cell_slots, &why) == Status::ok);
    CHECK(violation<D>(loaded) == nullptr);
    for (CellId c(0); c < t.state.cell_slots; ++c)
        for (int i = 0; i <= D; ++i) {
            const std::uint32_t v = t.store.cell(c).vertex[i];
            int j = 0;
            while (loaded.cell(c).vertex[j] != v) ++j;
            CHECK(loaded.view().neighbour(c, j) == t.store.view().neighbour(c, i));
        }
    SUBCASE("three cells at one facet are refused") {
        for (int i = 0; i <= D; ++i) cells.push_back(cells[static_cast<std::size_t>(i)]);
        Block again(std::size_t{1} << 24);
        StoreState other = {};
        Store<D> bad(again.arena, other);
        CHECK(load_cells<D>(bad, points.data(), n, cells.data(), t.state.cell_slots + 1, &why) == Status::check_failed);
        CHECK(why.violation != nullptr);
    }
}
TEST_CASE_TEMPLATE_APPLY(from_lists, Dimensions<>);

// A point within a circle of others sees all cells at once, so that the list of its cavity is what does not fit.
TEST_CASE_TEMPLATE_DEFINE("any arena size, where one cavity is all there is in the plane", Dim, large_cavity) {
    std::uint32_t partial = 0, whole = 0;
    for (std::uint64_t turn = 0; turn < 12; ++turn) {
        inputs::Points points = inputs::circle(80);
        inputs::Random random(turn);
        for (int k = 0; k < 2; ++k) points.push_back(0.1 * random.uniform());
        for (std::size_t bytes = 3000; bytes < 14000; bytes += 48) {
            Triangulated<2> t(points, bytes);
            REQUIRE((t.status == Status::ok || t.status == Status::out_of_memory));
            if (t.state.cell_slots == 0) continue;
            recompute_balls(t.store);
            const char* const wrong = violation<2>(t.store);
            REQUIRE(wrong == nullptr);
            ++(t.status == Status::ok ? whole : partial);
        }
    }
    CHECK(partial > 500);
    CHECK(whole > 10);
}
TEST_CASE_TEMPLATE_APPLY(large_cavity, Dimensions<2, 2>);

// Cells are small while a triangulation in the plane grows, and get their circles in the end, where they need room.
TEST_CASE_TEMPLATE_DEFINE("any arena size, where cells in the plane grow in the end", Dim, plane_sizes) {
    const inputs::Points points = inputs::uniform(2, 60);
    const Triangulated<2> roomy(points, std::size_t{1} << 20);
    REQUIRE(roomy.status == Status::ok);
    std::uint32_t whole = 0, partial = 0;
    for (std::size_t bytes = 3000; bytes < roomy.block.arena.bytes_peak() + 1000; bytes += 16) {
        Triangulated<2> tight(points, bytes);
        REQUIRE((tight.status == Status::ok || tight.status == Status::out_of_memory));
        if (tight.state.cell_slots == 0) continue;
        REQUIRE(violation<2>(tight.store) == nullptr);
        if (tight.status == Status::ok) CHECK(tight.state.cell_slots == roomy.state.cell_slots);
        ++(tight.status == Status::ok ? whole : partial);
    }
    CHECK(partial > 50);
    CHECK(whole > 50);
}
TEST_CASE_TEMPLATE_APPLY(plane_sizes, Dimensions<2, 2>);

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

TEST_CASE_TEMPLATE_DEFINE("of equal points the first comes first, wherever halves round", T, equal_points) {
    constexpr int D = T::value;
    for (const double step : {1.0, std::numeric_limits<double>::denorm_min()}) {
        constexpr std::uint32_t n = 12;
        inputs::Points points;
        for (std::uint32_t i = 0; i < n; ++i)
            for (int k = 0; k < D; ++k) points.push_back(k == 0 ? step * (i % 2) : 0);
        Block block(std::size_t{1} << 16);
        std::vector<std::uint32_t> order(n), expected;
        bool repeats = false;
        REQUIRE(spatial_order<D>(reinterpret_cast<const unsigned char*>(points.data()), 8 * D, n, 1, block.arena,
                                 order.data(), &repeats) == Status::ok);
        CHECK(repeats);
        for (const std::uint32_t first : {order[0] % 2, 1 - order[0] % 2})
            for (std::uint32_t i = first; i < n; i += 2) expected.push_back(i);
        CHECK(order == expected);
    }
}
TEST_CASE_TEMPLATE_APPLY(equal_points, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("points that only their last bits tell apart are not taken for duplicates", T, subnormal) {
    constexpr int D = T::value;
    // Below the smallest normal number halves round, and the curve cannot tell these apart.
    const double least = std::numeric_limits<double>::denorm_min();
    inputs::Points points;
    for (int i = 0; i < 2 * D + 2; ++i)
        for (int k = 0; k < D; ++k)
            points.push_back(i == 2 * k ? 3 * least : i == 2 * k + 1 ? -least : k == 0 ? i * least : 0);
    Triangulated<D> t(points, std::size_t{1} << 20);
    REQUIRE(t.status == Status::ok);
    CHECK(violation<D>(t.store) == nullptr);
    std::size_t different = 0;
    for (int i = 0; i < 2 * D + 2; ++i) {
        bool before = false;
        for (int j = 0; j < i; ++j) before |= std::equal(&points[D * i], &points[D * i] + D, &points[D * j]);
        different += !before;
    }
    CHECK(t.state.vertex_count == different);
    CHECK(t.input.duplicates == 2 * D + 2 - different);
}
TEST_CASE_TEMPLATE_APPLY(subnormal, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("a star that the gap is too small for is refused, and walked whole when it fits", T, stars) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::uniform(D, 4 * D);
    Block block(std::size_t{1} << 20);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    std::uint32_t* order;
    REQUIRE(take_input<D>(store, points.data(), 4 * D, 1, monitor, &input, &order) == Status::ok);
    REQUIRE(store.open_cells() == Status::ok);
    Kernel<D> kernel(store, corner_error_max, VertexCells::kept);
    VertexId ids[D + 1];
    REQUIRE(independent_points(store, order, 4 * D, ids));
    REQUIRE(kernel.start(ids) == Status::ok);
    for (std::uint32_t k = 0; k < 4 * D; ++k) {
        const VertexId v(order[k]);
        if (store.vertex(v).cell != none) continue;
        Cavity cavity;
        REQUIRE(kernel.find_cavity(store.point(v), v, kernel.locate(store.point(v), v, state.last_cell), &cavity));
        kernel.fill(cavity, v);
    }
    std::uint32_t expected = 0;
    for (std::uint32_t c = 0; c < state.cell_slots; ++c)
        if (store.is_live(c)) expected += std::count(store.cell(c).vertex, store.cell(c).vertex + D + 1, 0u) == 1;
    REQUIRE(expected > D);
    const std::size_t low = block.arena.low_mark();
    const auto visited = [&](std::size_t words, std::uint32_t* count) {
        block.arena.release_low(block.arena.high_mark() - 4 * words);
        *count = 0;
        const bool fits = kernel.visit_star(VertexId(0), [&](CellId) { ++*count; });
        block.arena.release_low(low);
        return fits;
    };
    std::uint32_t count;
    for (std::uint32_t words = 0; words < expected; ++words) {
        CHECK_FALSE(visited(words, &count));
        CHECK(count <= words);
    }
    CHECK(visited(expected, &count));
    CHECK(count == expected);
}
TEST_CASE_TEMPLATE_APPLY(stars, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("a cavity's list is the same in any gap that it fits, and never leaves the gap", T, lists) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::uniform(D, 4 * D);
    Block block(std::size_t{1} << 20);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    std::uint32_t* order;
    REQUIRE(take_input<D>(store, points.data(), 4 * D, 1, monitor, &input, &order) == Status::ok);
    REQUIRE(store.open_cells() == Status::ok);
    Kernel<D> kernel(store, corner_error_max, VertexCells::kept);
    VertexId ids[D + 1];
    REQUIRE(independent_points(store, order, 4 * D, ids));
    REQUIRE(kernel.start(ids) == Status::ok);
    for (std::uint32_t k = 0; k < 4 * D; ++k) {
        const VertexId v(order[k]);
        if (store.vertex(v).cell != none) continue;
        const CellId from = kernel.locate(store.point(v), v, state.last_cell);
        Cavity whole;
        REQUIRE(kernel.find_cavity(store.point(v), v, from, &whole));
        const std::size_t low = block.arena.low_mark(), top = block.arena.high_mark();
        std::vector<unsigned char> below(64 * (D + 1), 0xA5);
        std::size_t refused = 0;
        for (std::size_t gap = 0;; gap += 4) {
            unsigned char* const edge = reinterpret_cast<unsigned char*>(block.arena.at(top - gap));
            std::copy(below.begin(), below.end(), edge - below.size());
            block.arena.release_low(top - gap);
            Cavity cavity;
            const bool fits = kernel.find_cavity(store.point(v), v, from, &cavity);
            block.arena.release_low(low);
            REQUIRE(std::equal(below.begin(), below.end(), edge - below.size()));
            if (!fits) {
                ++refused;
                continue;
            }
            CHECK(cavity.cells == whole.cells);
            CHECK(cavity.facets == whole.facets);
            break;
        }
        CHECK(refused > 0);
        REQUIRE(kernel.find_cavity(store.point(v), v, from, &whole));
        kernel.fill(whole, v);
    }
}
TEST_CASE_TEMPLATE_APPLY(lists, Dimensions<>);

// The cavity of the centre is bounded by the hull of the points on the sphere. The tables hold hulls of up to 34
// vertices; they stand in the gap, if it has room for them beside the list, and when filling beside the new cells.
TEST_CASE("in space new cells border the right ones in cavities of every size, in any gap") {
    for (const std::uint32_t n : {4u, 5u, 6u, 9u, 16u, 31u, 32u, 33u, 34u, 150u}) {
        const double corner = std::sqrt(1.0 / 3);
        inputs::Points points;
        for (const double x : {1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1}) points.push_back(corner * x);
        const inputs::Points random = inputs::uniform(3, n, n);
        for (std::size_t i = 12; i < 3 * std::size_t{n}; i += 3) {
            double length2 = 0;
            for (std::size_t k = 0; k < 3; ++k) length2 += (random[i + k] - 0.5) * (random[i + k] - 0.5);
            for (std::size_t k = 0; k < 3; ++k) points.push_back((random[i + k] - 0.5) / std::sqrt(length2));
        }
        points.insert(points.end(), {0, 0, 0});
        for (const double error_max : {corner_error_max, 0x1p-7}) {
            std::vector<std::vector<std::uint32_t>> made;  // of the last point, in each gap
            const std::size_t roomy = std::size_t{1} << 18;
            for (const std::size_t room : {roomy, std::size_t{0}, std::size_t{1000}, std::size_t{26000}}) {
                Block block(std::size_t{1} << 20);
                StoreState state = {};
                Store<3> store(block.arena, state);
                Monitor monitor;
                InputReport input;
                std::uint32_t* order;
                REQUIRE(take_input<3>(store, points.data(), n + 1, 1, monitor, &input, &order) == Status::ok);
                REQUIRE(store.open_cells() == Status::ok);
                Kernel<3> kernel(store, error_max, VertexCells::kept);
                const VertexId ids[] = {VertexId(0), VertexId(1), VertexId(2), VertexId(3)};
                REQUIRE(kernel.start(ids) == Status::ok);
                for (std::uint32_t v = 4; v <= n; ++v) {
                    Cavity cavity;
                    const double* const q = store.point(v);
                    const CellId hit = kernel.locate(q, VertexId(v), state.last_cell);
                    REQUIRE(kernel.find_cavity(q, VertexId(v), hit, &cavity));
                    if (v == n && room != roomy) {
                        const std::uint32_t lines = cavity.cells > cavity.facets ? cavity.cells : cavity.facets;
                        const std::uint32_t fresh = cavity.facets - std::min(cavity.facets, state.cells_free);
                        const std::size_t need = fresh * sizeof(Cell<3>) + (lines + 1) * sizeof(CavityLine) + 48;
                        REQUIRE(block.arena.bytes_free() > need + room);
                        REQUIRE(block.arena.take_high<char>(block.arena.bytes_free() - need - room) != nullptr);
                        REQUIRE(kernel.find_cavity(q, VertexId(v), hit, &cavity));
                    }
                    if (v == n) CHECK(cavity.facets == 2 * n - 4);
                    REQUIRE(kernel.can_fill(cavity, 0));
                    kernel.fill(cavity, VertexId(v));
                    for (std::uint32_t k = 0; k < cavity.facets; ++k)
                        for (std::uint32_t i = 0; i <= 3; ++i) {
                            const FacetId beyond = store.cell(kernel.new_cell(k)).neighbour[i];
                            REQUIRE(store.cell(beyond.cell()).neighbour[beyond.position()] ==
                                    FacetId(kernel.new_cell(k), i));
                        }
                    if (v < n) continue;
                    made.emplace_back();
                    for (std::uint32_t k = 0; k < cavity.facets; ++k) {
                        made.back().push_back(kernel.new_cell(k));
                        const Cell<3>& cell = store.cell(kernel.new_cell(k));
                        for (std::uint32_t i = 0; i <= 3; ++i) {
                            made.back().push_back(cell.vertex[i]);
                            made.back().push_back(cell.neighbour[i].word());
                        }
                    }
                    CHECK(made.back() == made.front());
                }
                // The cells stay where they are.
                store.compact(block.arena.low_mark() - std::size_t{state.cell_slots} * sizeof(Cell<3>));
                CHECK(violation<3>(store) == nullptr);
            }
        }
    }
}

#ifndef __OPTIMIZE_SIZE__
// Three new cells at vertex 7, of which the first and the last border each other. The ridge of the one between has the
// same tag as theirs, and its search begins at the same slot.
TEST_CASE("ridges that are taken for one another are noticed") {
    for (const bool collides : {false, true}) {
        Block block(std::size_t{1} << 12);
        StoreState state = {};
        const Store<3> store(block.arena, state);
        RidgeTable<3> ridges(store, 3, 0);
        REQUIRE(ridges.is_there());
        const std::uint32_t vertices[3][4] = {
            {115, 1277, 1, 7}, {201, collides ? 1252u : 1253u, 2, 7}, {1277, 115, 3, 7}};
        Cell<3> cells[3];
        for (std::uint32_t c = 0; c < 3; ++c) {
            for (std::uint32_t i = 0; i < 4; ++i) {
                cells[c].vertex[i] = VertexId(vertices[c][i]);
                cells[c].neighbour[i] = FacetId(CellId(100 + c), i);
            }
            ridges.join(cells, CellId(c), 3);
            CHECK(cells[c].neighbour[3] == FacetId(CellId(100 + c), 3));
        }
        CHECK(ridges.is_sound() == !collides);
        if (collides) continue;
        for (std::uint32_t c = 0; c < 3; ++c)
            for (std::uint32_t i = 0; i < 3; ++i)
                CHECK(cells[c].neighbour[i] == (i == 2 && c != 1 ? FacetId(CellId(2 - c), 2) : FacetId(none)));
    }
    // 32 slots of 8 bytes and three cells.
    for (const std::size_t bytes : {464u, 480u}) {
        Block block(bytes);
        StoreState state = {};
        const Store<3> store(block.arena, state);
        CHECK(RidgeTable<3>(store, 3, 0).is_there() == (bytes >= 32 * 8 + 3 * sizeof(Cell<3>)));
    }
}

TEST_CASE_TEMPLATE_DEFINE("cells are the same where the gap has no room for tables", T, small_gap) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::uniform(D, 40, 5);
    const Triangulated<D> roomy(points, std::size_t{1} << 22);
    REQUIRE(roomy.status == Status::ok);
    std::uint32_t whole = 0;
    for (std::size_t bytes = roomy.block.arena.bytes_peak() + 20000; bytes > 1000; bytes -= 400) {
        const Triangulated<D> tight(points, bytes);
        if (tight.status != Status::ok) break;
        ++whole;
        REQUIRE(tight.state.cell_slots == roomy.state.cell_slots);
        for (std::uint32_t c = 0; c < roomy.state.cell_slots; ++c)
            for (std::uint32_t i = 0; i <= D; ++i) {
                REQUIRE(tight.store.cell(c).vertex[i] == roomy.store.cell(c).vertex[i]);
                REQUIRE(tight.store.cell(c).neighbour[i] == roomy.store.cell(c).neighbour[i]);
            }
    }
    CHECK(whole > 10);
}
TEST_CASE_TEMPLATE_APPLY(small_gap, Dimensions<3, 6>);
#endif

TEST_CASE_TEMPLATE_DEFINE("a point in the plane of a hull facet: the ghost is in conflict when the cell behind is", T,
                          coplanar) {
    constexpr int D = T::value;
    // The corner simplex of a cube, and a point with x_0 = 0: inside the facet, far outside of the ball, or, but in the
    // plane, a corner of the cube too, where indices decide.
    for (const double coordinate : {0.25 / D, 4.0, 1.0}) {
        std::uint32_t conflicts = 0, tried = 0;
        for (std::uint32_t row = 0; row < D + 2; ++row) {
            if (D == 2 && coordinate == 1) continue;
            inputs::Points points;
            VertexId ids[D + 1];
            for (std::uint32_t v = 0, corner = 0; v < D + 2; ++v) {
                for (std::uint32_t k = 0; k < D; ++k)
                    points.push_back(v == row ? (k == 0 ? 0 : coordinate) : corner == k + 1 ? 1 : 0);
                if (v != row) ids[corner++] = VertexId(v);
            }
            Block block(std::size_t{1} << 18);
            StoreState state = {};
            Store<D> store(block.arena, state);
            Monitor monitor;
            InputReport input;
            std::uint32_t* order;
            REQUIRE(take_input<D>(store, points.data(), D + 2, 1, monitor, &input, &order) == Status::ok);
            REQUIRE(store.open_cells() == Status::ok);
            Kernel<D> kernel(store, corner_error_max, VertexCells::kept);
            REQUIRE(kernel.start(ids) == Status::ok);
            int position = 0;
            while (store.cell(CellId(0)).vertex[position] != ids[1]) ++position;
            const CellId ghost = store.cell(CellId(0)).neighbour[position].cell();
            const VertexId v(row);
            const bool conflict = kernel.in_conflict(ghost, store.point(v), v);
            CHECK(conflict == kernel.in_conflict(CellId(0), store.point(v), v));
            conflicts += conflict;
            ++tried;
        }
        if (coordinate < 1) CHECK(conflicts == tried);
        if (coordinate > 1) CHECK(conflicts == 0);
        if (coordinate == 1 && D > 2) CHECK((conflicts > 0 && conflicts < tried));
    }
}
TEST_CASE_TEMPLATE_APPLY(coplanar, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("stamps that run out begin anew, and the triangulation is the same", T, stamps) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::uniform(D, 6 * D);
    const auto run = [&](std::uint32_t first_stamp, std::vector<std::uint32_t>* cells) {
        Block block(std::size_t{1} << 20);
        StoreState state = {};
        Store<D> store(block.arena, state);
        Monitor monitor;
        InputReport input;
        std::uint32_t* order;
        REQUIRE(take_input<D>(store, points.data(), 6 * D, 1, monitor, &input, &order) == Status::ok);
        REQUIRE(store.open_cells() == Status::ok);
        Kernel<D> kernel(store, corner_error_max, VertexCells::ignored);
        VertexId ids[D + 1];
        REQUIRE(independent_points(store, order, 6 * D, ids));
        REQUIRE(kernel.start(ids) == Status::ok);
        state.stamp = first_stamp;
        for (std::uint32_t k = 0; k < 6 * D; ++k) {
            const VertexId v(order[k]);
            if (std::count(ids, ids + D + 1, v) == 1) continue;
            Cavity cavity;
            CHECK(store.new_stamp() % 2 == 0);
            REQUIRE(kernel.find_cavity(store.point(v), v, kernel.locate(store.point(v), v, state.last_cell), &cavity));
            kernel.fill(cavity, v);
        }
        const std::uint32_t last_stamp = state.stamp;
        store.compact(block.arena.low_mark() - std::size_t{state.cell_slots} * sizeof(Cell<D>));  // where they are
        for (std::uint32_t c = 0; c < state.cell_slots; ++c)
            cells->insert(cells->end(), store.cell(c).vertex, store.cell(c).vertex + D + 1);
        CHECK(violation<D>(store) == nullptr);
        return last_stamp;
    };
    std::vector<std::uint32_t> plain, wrapped;
    CHECK(run(2, &plain) < 1000);
    CHECK(run(0xFFFFFFF0u, &wrapped) < 1000);
    CHECK(plain == wrapped);
}
TEST_CASE_TEMPLATE_APPLY(stamps, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("inputs that are none are refused before anything is taken", T, no_inputs) {
    constexpr int D = T::value;
    Block block(std::size_t{1} << 12);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    std::uint32_t* order;
    inputs::Points points = inputs::uniform(D, 5);
    CHECK(take_input<D>(store, points.data(), 0, 1, monitor, &input, &order) == Status::invalid_argument);
    CHECK(take_input<D>(store, points.data(), std::size_t{1} << 31, 1, monitor, &input, &order) ==
          Status::invalid_argument);
    points[3 * D + D - 1] = std::numeric_limits<double>::infinity();
    CHECK(take_input<D>(store, points.data(), 5, 1, monitor, &input, &order) == Status::not_finite);
    CHECK(input.row_a == 3);
    CHECK(block.arena.bytes_used() == 0);
    CHECK_FALSE(store.has_room(none, 0, 0));  // more slots than a neighbour word can name
    CHECK(block.arena.bytes_wanted() > SIZE_MAX / 8);
    CHECK(check_geometric(store).violation == nullptr);  // nothing is no cell in disorder
    bool repeats = true;
    CHECK(spatial_order<D>(nullptr, 0, 0, 1, block.arena, nullptr, &repeats) == Status::ok);
    CHECK_FALSE(repeats);
}
TEST_CASE_TEMPLATE_APPLY(no_inputs, Dimensions<>);

// A simplex whose corner at p[0] is the origin of a cube, flattened to `height` along the last axis.
template <int D> struct FlatSimplex {
    double x[D + 1][D];
    const double* p[D + 1];
    FlatSimplex(double size, double height) {
        for (int i = 0; i <= D; ++i) {
            for (int k = 0; k < D; ++k) x[i][k] = i == k + 1 ? size : 0;
            p[i] = x[i];
        }
        for (int k = 0; k < D; ++k) x[D][k] = k < D - 1 ? size * (k + 3) / 4 : height;
    }
};

TEST_CASE_TEMPLATE_DEFINE("balls of flat cells at any scale pass through their vertices, or are said to be unknown", T,
                          flat_balls) {
    constexpr int D = T::value;
    int known = 0, unknown = 0;
    for (int exponent = -1020; exponent <= 1020; exponent += 10)
        for (const int flatness : {0, 20, 45, 52, 100}) {
            if (exponent - flatness < -1060) continue;
            const FlatSimplex<D> s(std::ldexp(1.0, exponent), std::ldexp(1.0, exponent - flatness));
            Cell<D> cell;
            solve_sphere<D>(s.p, corner_error_max, cell);
            if (!(cell.radius2 < std::numeric_limits<double>::infinity())) {
                CHECK(cell.error == std::numeric_limits<float>::infinity());
                CHECK((flatness > 20 || exponent < -400 || exponent > 400));
                ++unknown;
                continue;
            }
            ++known;
            for (int i = 0; i <= D; ++i) {
                double d2 = 0;
                for (int k = 0; k < D; ++k) d2 += (cell.centre[k] - s.x[i][k]) * (cell.centre[k] - s.x[i][k]);
                CHECK(std::fabs(std::sqrt(d2 / cell.radius2) - 1) <= 2 * cell.error + 1e-12);
            }
        }
    CHECK(known > 100);
    CHECK(unknown > 10);
}
TEST_CASE_TEMPLATE_APPLY(flat_balls, Dimensions<>);
