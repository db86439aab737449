// Cells without their balls, and with them again: not a bit is lost, and what stands behind them follows.
#include "delaunay/packed_cells.hpp"

#include <doctest/doctest.h>

#include <cstring>
#include <vector>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "delaunay/triangulate.hpp"

using namespace netmesh;

namespace {

constexpr std::size_t table_size = 1001;

// A triangulation with its own balls, and a table behind it.
template <int D> struct Packable {
    explicit Packable(std::size_t bytes = std::size_t{1} << 20) : block(bytes), store(block.arena, state) {
        const inputs::Points points = inputs::uniform(D, D < 4 ? 60 : 3 * D + 3);
        Monitor monitor;
        InputReport input;
        REQUIRE(triangulate<D>(store, points.data(), points.size() / D, 1, monitor, &input) == Status::ok);
        recompute_balls<D>(store);
        for (std::uint32_t c = 0; c < state.cell_slots; ++c) store.cell(c).mark = 0;
        behind = block.arena.low_mark();
    }
    // The cells as they are before.
    std::vector<unsigned char> add_table() {
        table = block.arena.template take_low<double>(table_size);
        REQUIRE(table != nullptr);
        for (std::size_t i = 0; i < table_size; ++i) table[i] = 0.5 * static_cast<double>(i);
        return cells();
    }
    std::vector<unsigned char> cells() const {
        const auto* const first = reinterpret_cast<const unsigned char*>(&store.cell(0));
        return {first, first + state.cell_slots * sizeof(Cell<D>)};
    }
    bool has_table(const double* at) const {
        for (std::size_t i = 0; i < table_size; ++i)
            if (at[i] != 0.5 * static_cast<double>(i)) return false;
        return true;
    }
    Block block;
    StoreState state = {};
    Store<D> store;
    std::size_t behind = 0;
    double* table = nullptr;
};

// The same cells, read through views.
template <int D> bool are_alike(const TriangulationView<D>& a, const std::vector<unsigned char>& cells) {
    const TriangulationView<D> b = {cells.data(), sizeof(Cell<D>), a.cell_count, a.vertex_count};
    for (CellId c(0); c < a.cell_count; ++c)
        for (std::uint32_t i = 0; i <= D; ++i)
            if (a.vertices(c)[i] != b.vertices(c)[i] || a.facet_beyond(c, i) != b.facet_beyond(c, i)) return false;
    return cells.size() == a.cell_count * sizeof(Cell<D>);
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("packed cells: the gap grows by their balls, tables follow, and all comes back", Dim,
                          packed_and_back) {
    constexpr int D = Dim::value;
    Packable<D> p;
    const std::vector<unsigned char> before = p.add_table();
    const std::size_t low = p.block.arena.low_mark(), high = p.block.arena.high_mark();
    PackedCells packed(p.store, p.behind);
    const std::size_t given = low - p.block.arena.low_mark(), balls = p.state.cell_slots * (8 * D + 16);
    CHECK(given <= balls);
    CHECK(given + Arena::alignment > balls);
    CHECK(are_alike<D>(packed.view().template of_dimension<D>({}), before));
    CHECK(p.has_table(packed.packed_place(p.table)));
    // What a job leaves at the low end, and at the other for a time.
    double* const more = p.block.arena.template take_low<double>(3);
    {
        const HighScope scope(p.block.arena);
        REQUIRE(p.block.arena.template take_high<double>(5) != nullptr);
    }
    more[0] = 1, more[1] = 2, more[2] = 3;
    REQUIRE(packed.unpack());
    CHECK(p.cells() == before);
    CHECK(p.has_table(p.table));
    const double* const moved = packed.place(more);
    CHECK(moved[0] == 1);
    CHECK(moved[2] == 3);
    CHECK(p.block.arena.offset_of(moved + 3) == p.block.arena.low_mark());
    CHECK(p.block.arena.high_mark() == high);
}
TEST_CASE_TEMPLATE_APPLY(packed_and_back, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("packed cells: where what has been made meanwhile leaves no room, the cells come back", Dim,
                          packed_without_room) {
    constexpr int D = Dim::value;
    Packable<D> p;
    const std::vector<unsigned char> before = p.add_table();
    PackedCells packed(p.store, p.behind);
    {
        const HighScope scope(p.block.arena);
        while (p.block.arena.bytes_free() > 1024) REQUIRE(p.block.arena.template take_low<double>(64) != nullptr);
    }
    CHECK_FALSE(packed.unpack());
    CHECK(p.cells() == before);
    CHECK(p.block.arena.low_mark() == p.behind);
    CHECK(p.block.arena.bytes_wanted() > p.block.arena.bytes());
}
TEST_CASE_TEMPLATE_APPLY(packed_without_room, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("packed cells: nothing is packed when something else stands between cells and tables", Dim,
                          not_packed) {
    constexpr int D = Dim::value;
    Packable<D> p;
    REQUIRE(p.block.arena.template take_low<double>(2) != nullptr);
    const std::size_t behind = p.block.arena.low_mark();
    const std::vector<unsigned char> before = p.add_table();
    const std::size_t low = p.block.arena.low_mark();
    PackedCells packed(p.store, behind);
    CHECK(p.block.arena.low_mark() == low);
    CHECK(are_alike<D>(packed.view().template of_dimension<D>({}), before));
    CHECK(packed.packed_place(p.table) == p.table);
    CHECK(packed.unpack());
    CHECK(packed.place(p.table) == p.table);
    CHECK(p.cells() == before);
    CHECK(p.has_table(p.table));
}
TEST_CASE_TEMPLATE_APPLY(not_packed, Dimensions<>);
