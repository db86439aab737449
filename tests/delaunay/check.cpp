// The checkers see every kind of damage, and name it.
#include "delaunay/check.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "common/block.hpp"
#include "common/dimensions.hpp"
#include "common/inputs.hpp"
#include "delaunay/load.hpp"
#include "delaunay/triangulate.hpp"

using namespace netmesh;

namespace {

// A triangulation of few points, damaged and restored.
template <int D> struct Patient {
    Patient() : block(std::size_t{1} << 20), store(block.arena, state) {
        const inputs::Points points = inputs::uniform(D, 3 * D + 3);
        Monitor monitor;
        InputReport input;
        REQUIRE(triangulate<D>(store, points.data(), points.size() / D, 1, monitor, &input) == Status::ok);
        REQUIRE(state.cell_slots > 2);
        REQUIRE(check_combinatorial(store).violation == nullptr);
        REQUIRE(check_geometric(store).violation == nullptr);
        REQUIRE(check_delaunay(store).violation == nullptr);
    }
    std::string combinatorial() const { return said(check_combinatorial(store)); }
    std::string geometric() const { return said(check_geometric(store)); }
    static std::string said(const CheckResult& r) { return r.violation == nullptr ? "nothing" : r.violation; }

    // A cell and a position with a neighbour.
    std::pair<CellId, int> inner_facet() const {
        for (CellId c(0); c < state.cell_slots; ++c)
            for (int i = 0; i <= D; ++i)
                if (store.cell(c).neighbour[i] != none) return {c, i};
        return {none, 0};
    }
    Block block;
    StoreState state = {};
    Store<D> store;
};

template <class T> class Changed {
public:
    Changed(T& place, T value) : place_(place), kept_(place) { place = value; }
    ~Changed() { place_ = kept_; }
    Changed(const Changed&) = delete;
    Changed& operator=(const Changed&) = delete;

private:
    T &place_, kept_;
};

template <int D> void damage_cells() {
    Patient<D> p;
    const auto [c, i] = p.inner_facet();
    Cell<D>& cell = p.store.cell(c);
    {
        const Changed<VertexId> change(cell.vertex[0], VertexId(p.state.vertex_count));
        CHECK(p.combinatorial() == "a cell has a vertex that does not exist");
    }
    {
        const Changed<VertexId> change(cell.vertex[0], cell.vertex[1]);
        CHECK(p.combinatorial() == "a cell has a vertex twice");
    }
    for (const FacetId facet : {FacetId(CellId(p.state.cell_slots), 0), FacetId(c, 0), FacetId(CellId(c == 0), 7)}) {
        const Changed<FacetId> change(cell.neighbour[i], facet);
        CHECK(p.combinatorial() == "a neighbour does not exist");
    }
    {
        const FacetId facet = cell.neighbour[i];
        const std::uint32_t other = facet.position() ^ (facet.position() < 2 ? 1u : 2u);
        const Changed<FacetId> change(cell.neighbour[i], FacetId(facet.cell(), other));
        const std::string said = p.combinatorial();
        CHECK((said == "neighbours are not mutual" || said == "a neighbour does not exist"));
    }
    {
        const FacetId facet = cell.neighbour[i];
        const Changed<FacetId> change(p.store.cell(facet.cell()).neighbour[facet.position()], none);
        CHECK(p.combinatorial() == "neighbours are not mutual");
    }
    {  // a facet that the neighbour does not have
        const FacetId facet = cell.neighbour[i];
        Cell<D>& other = p.store.cell(facet.cell());
        const int j = facet.position() == 0 ? 1 : 0;
        std::uint32_t stranger = 0;
        const auto has = [&](const Cell<D>& of, std::uint32_t v) {
            for (const std::uint32_t u : of.vertex)
                if (u == v) return true;
            return false;
        };
        while (has(cell, stranger) || has(other, stranger)) ++stranger;
        const Changed<VertexId> change(other.vertex[j], VertexId(stranger));
        CHECK(p.combinatorial() == "neighbours do not share a facet");
    }
    {  // all of the cell's vertices
        const FacetId facet = cell.neighbour[i];
        Cell<D>& other = p.store.cell(facet.cell());
        const Changed<VertexId> change(other.vertex[facet.position()], cell.vertex[i]);
        CHECK(p.combinatorial() == "neighbours share more than a facet");
    }
    {
        std::uint32_t v = 0;
        while (p.store.vertex(v).cell == none) ++v;
        const Changed<CellId> nowhere(p.store.vertex(v).cell, CellId(p.state.cell_slots));
        CHECK(p.combinatorial() == "a vertex points to a cell that it does not belong to");
    }
    {
        const std::uint32_t v = cell.vertex[0];
        std::uint32_t elsewhere = 0;
        for (; elsewhere < p.state.cell_slots; ++elsewhere) {
            bool there = false;
            for (const std::uint32_t u : p.store.cell(elsewhere).vertex) there = there || u == v;
            if (!there) break;
        }
        REQUIRE(elsewhere < p.state.cell_slots);
        const Changed<CellId> change(p.store.vertex(v).cell, CellId(elsewhere));
        CHECK(p.combinatorial() == "a vertex points to a cell that it does not belong to");
    }
    CHECK(p.combinatorial() == "nothing");
}

template <int D> void damage_places() {
    Patient<D> p;
    const auto [c, i] = p.inner_facet();
    {
        Cell<D>& cell = p.store.cell(c);
        std::swap(cell.vertex[0], cell.vertex[1]);
        CHECK(p.geometric() == "a cell is not positively oriented");
        std::swap(cell.vertex[0], cell.vertex[1]);
    }
    CHECK(p.geometric() == "nothing");
}

// A triangulation without one of its cells.
template <int D> void leave_out() {
    const Patient<D> p;
    std::vector<double> x;
    for (std::uint32_t v = 0; v < p.state.vertex_count; ++v) x.insert(x.end(), p.store.point(v), p.store.point(v) + D);
    int not_convex = 0;
    for (std::uint32_t out = 0; out < p.state.cell_slots; ++out) {
        std::vector<std::uint32_t> cells;
        for (std::uint32_t c = 0; c < p.state.cell_slots; ++c)
            if (c != out) cells.insert(cells.end(), p.store.cell(c).vertex, p.store.cell(c).vertex + D + 1);
        Block block(std::size_t{1} << 20);
        StoreState state = {};
        Store<D> store(block.arena, state);
        CheckResult why;
        if (load_cells<D>(store, x.data(), p.state.vertex_count, cells.data(), p.state.cell_slots - 1, &why) !=
            Status::ok)
            continue;
        not_convex += Patient<D>::said(check_geometric(store)) == "the hull is not convex";
    }
    CHECK(not_convex > 0);
}

// Two copies of one simplex, each with a hull of its own, and two that cross.
template <int D> void overlap(double shift) {
    double x[2 * (D + 1) * D] = {};
    std::uint32_t cells[2 * (D + 1)];
    for (int v = 0; v <= D; ++v)
        for (int k = 0; k < D; ++k) {
            x[v * D + k] = v == k + 1 ? 1 : 0;
            x[(D + 1 + v) * D + k] = x[v * D + k] + shift;
        }
    for (std::uint32_t v = 0; v < 2 * (D + 1); ++v) cells[v] = v;
    Block block(std::size_t{1} << 18);
    StoreState state = {};
    Store<D> store(block.arena, state);
    CheckResult why;
    const Status status = load_cells<D>(store, x, 2 * (D + 1), cells, 2, &why);
    if (status != Status::ok) {
        CHECK(status == Status::check_failed);
        return;
    }
    const CheckResult r = check_geometric(store);
    REQUIRE(r.violation != nullptr);
    CHECK(std::string(r.violation) == "two cells overlap");
}

// Two simplices with the facet of the unit vectors in common: the origin and `apex`, each at the same position, in all
// orders of the others that a swap leads to. What is said of every one of them.
template <int D, class Check> std::string of_two_cells(const double* apex, Check&& check) {
    std::string said;
    for (int position = 0; position <= D; ++position)
        for (unsigned swaps = 0; swaps < 4; ++swaps) {
            double x[(D + 2) * D] = {};
            for (int k = 0; k < D; ++k) {
                x[k * D + k] = 1;
                x[(D + 1) * D + k] = apex[k];
            }
            std::uint32_t cells[2 * (D + 1)];
            for (unsigned c = 0; c < 2; ++c) {
                std::uint32_t* const cell = cells + c * (D + 1);
                for (int i = 0, w = 0; i <= D; ++i) cell[i] = i == position ? D + c : static_cast<std::uint32_t>(w++);
                if (swaps >> c & 1u) std::swap(cell[position == 0 ? 1 : 0], cell[position == D ? D - 1 : D]);
            }
            Block block(std::size_t{1} << 18);
            StoreState state = {};
            Store<D> store(block.arena, state);
            CheckResult why;
            REQUIRE(load_cells<D>(store, x, D + 2, cells, 2, &why) == Status::ok);
            const std::string now = Patient<D>::said(check(store));
            if (said.empty()) said = now;
            CHECK(said == now);
        }
    return said;
}

template <int D> void two_cells() {
    double inside[D], dent[D];
    for (int k = 0; k < D; ++k) {
        inside[k] = 0.75;                          // within the cube whose corners the ball passes through
        dent[k] = k == 0 ? -0.25 : 1.5 / (D - 1);  // beyond the plane of the origin's cell's facet opposite to e_0
    }
    CHECK(of_two_cells<D>(inside, check_delaunay) == "a vertex lies inside the ball of a cell");
    CHECK(of_two_cells<D>(inside, check_geometric) == "nothing");
    CHECK(of_two_cells<D>(dent, check_geometric) == "the hull is not convex");
}

// Simplices apart from each other, two of which are the same.
template <int D> void covered_twice() {
    for (std::uint32_t second = 1; second < 4; ++second) {
        double x[4 * (D + 1) * D] = {};
        std::uint32_t cells[4 * (D + 1)];
        for (std::uint32_t v = 0; v < 4 * (D + 1); ++v) {
            const std::uint32_t cell = v / (D + 1), corner = v % (D + 1);
            for (std::uint32_t k = 0; k < D; ++k)
                x[v * D + k] = (corner == k + 1 ? 1 : 0) + (cell == second ? 0 : 8.0 * cell);
            cells[v] = v;
        }
        Block block(std::size_t{1} << 18);
        StoreState state = {};
        Store<D> store(block.arena, state);
        CheckResult why;
        REQUIRE(load_cells<D>(store, x, 4 * (D + 1), cells, 4, &why) == Status::ok);
        const CheckResult r = check_geometric(store);
        REQUIRE(r.violation != nullptr);
        CHECK(std::string(r.violation) == "two cells overlap");
        CHECK(r.cell == second);
    }
}

// One simplex, its vertices in any order: each knows its nearest.
template <int D> void nearest_of_simplex() {
    for (std::uint32_t turn = 0; turn <= D; ++turn) {
        double x[(D + 1) * D] = {};
        std::uint32_t cell[D + 1];
        for (std::uint32_t i = 0; i <= D; ++i) {
            if (i < D) x[i * D + i] = 1 + 0.125 * i;
            cell[i] = (i + turn) % (D + 1);
        }
        Block block(std::size_t{1} << 18);
        StoreState state = {};
        Store<D> store(block.arena, state);
        CheckResult why;
        REQUIRE(load_cells<D>(store, x, D + 1, cell, 1, &why) == Status::ok);
        for (std::uint32_t v = 0; v <= D; ++v) {
            double nearest2 = HUGE_VAL;
            for (std::uint32_t w = 0; w <= D; ++w) {
                double d2 = 0;
                for (int k = 0; k < D; ++k) d2 += (x[v * D + k] - x[w * D + k]) * (x[v * D + k] - x[w * D + k]);
                if (w != v && d2 < nearest2) nearest2 = d2;
            }
            CHECK(store.vertex(VertexId(v)).nearest2 == nearest2);
        }
    }
}

// What load refuses: a facet of three cells, a vertex that does not exist or comes twice.
template <int D> void refuse_to_load() {
    double x[(D + 3) * D] = {};
    for (int v = 0; v < D + 3; ++v)
        for (int k = 0; k < D; ++k) x[v * D + k] = v == k + 1 ? 1 : v > D ? (v - D) * (k + 1) * 0.75 : 0;
    std::uint32_t cells[3 * (D + 1)];
    for (std::uint32_t c = 0; c < 3; ++c)
        for (std::uint32_t i = 0; i <= D; ++i) cells[c * (D + 1) + i] = i < D ? i + 1 : c == 0 ? 0 : D + c;
    Block block(std::size_t{1} << 18);
    CheckResult why = {nullptr, none};
    const auto load = [&](std::uint32_t count) {
        StoreState state = {};
        const std::size_t low = block.arena.low_mark(), high = block.arena.high_mark();
        Store<D> store(block.arena, state);
        const Status status = load_cells<D>(store, x, D + 3, cells, count, &why);
        block.arena.release_low(low);
        block.arena.release_high(high);
        return status;
    };
    CHECK(load(2) == Status::ok);
    CHECK(load(3) == Status::check_failed);
    const Changed<std::uint32_t> far(cells[0], D + 3);
    CHECK(load(1) == Status::check_failed);
    const Changed<std::uint32_t> twice(cells[0], cells[1]);
    CHECK(load(1) == Status::check_failed);
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("damage is seen", T, damage) {
    constexpr int D = T::value;
    damage_cells<D>();
    damage_places<D>();
    leave_out<D>();
    overlap<D>(0);
    overlap<D>(1.0 / 64);
    covered_twice<D>();
    two_cells<D>();
    nearest_of_simplex<D>();
    refuse_to_load<D>();
}
TEST_CASE_TEMPLATE_APPLY(damage, Dimensions<>);
