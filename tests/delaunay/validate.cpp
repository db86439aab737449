// Builds with NETMESH_VALIDATE: whole structures are checked after every insertion, and a fault stops the program.
#ifdef NETMESH_VALIDATE
#include <doctest/doctest.h>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "common/last_words.hpp"
#include "delaunay/check.hpp"
#include "delaunay/independent_points.hpp"
#include "delaunay/triangulate.hpp"

using namespace netmesh;

namespace {

// A triangulation in use: all points but the last are inserted.
template <int D> struct InUse {
    InUse()
        : block(std::size_t{1} << 20), store(block.arena, state), kernel(store, corner_error_max, VertexCells::kept) {
        Monitor monitor;
        InputReport input;
        std::uint32_t* order;
        const inputs::Points points = inputs::uniform(D, count);
        REQUIRE(take_input<D>(store, points.data(), count, 1, monitor, &input, &order) == Status::ok);
        REQUIRE(store.open_cells() == Status::ok);
        VertexId ids[D + 1];
        REQUIRE(independent_points(store, order, count, ids));
        REQUIRE(kernel.start(ids) == Status::ok);
        for (VertexId v(0); v + 1 < count; ++v)
            if (store.vertex(v).cell == none) insert(v);
        REQUIRE(store.vertex(count - 1).cell == none);
    }
    void insert(VertexId v) {
        Cavity cavity;
        REQUIRE(kernel.find_cavity(store.point(v), v, kernel.locate(store.point(v), v, state.last_cell), &cavity));
        kernel.fill(cavity, v);
    }
    static constexpr std::uint32_t count = 10 * D;
    Block block;
    StoreState state = {};
    Store<D> store;
    Kernel<D> kernel;
};

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("a fault is found by the next insertion, with its place", T, faults) {
    constexpr int D = T::value;
    InUse<D> t;
    CHECK(violation_in_use(t.store) == nullptr);
    const VertexId last(InUse<D>::count - 1);
    SUBCASE("nothing wrong") {
        CHECK(last_words([&] { t.insert(last); }) == "lived");
    }
    SUBCASE("a wrong count") {
        const std::string words = last_words([&] {
            ++t.state.cells_free;
            t.insert(last);
        });
        CHECK(words.find("the count of free cells is wrong") != std::string::npos);
        CHECK(words.find("delaunay/kernel.cpp:") != std::string::npos);
    }
    SUBCASE("a cell turned") {
        CellId c(0);
        while (!t.store.is_live(c) || t.store.is_ghost(c)) ++c;
        Cell<D>& cell = t.store.cell(c);
        const VertexId first = cell.vertex[0];
        cell.vertex[0] = cell.vertex[1];
        cell.vertex[1] = first;
        CHECK(violation_in_use(t.store) != nullptr);
    }
}
TEST_CASE_TEMPLATE_APPLY(faults, Dimensions<>);

TEST_CASE("a precondition that does not hold stops with its text") {
    CHECK(last_words([] { static_cast<void>(FacetId(CellId(1), 8)); }).find("position < 8") != std::string::npos);
    Block block(1024);
    CHECK(last_words([&] { block.arena.release_high(2048); }).find("arena.hpp:") != std::string::npos);
}
#endif
