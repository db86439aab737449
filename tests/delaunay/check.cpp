// The checkers see every kind of damage, and name it.
#include "delaunay/check.hpp"

#include <doctest/doctest.h>

#include <algorithm>
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
        CHECK(p.geometric() == "a cell is flat or not positively oriented");
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
        const std::string said = Patient<D>::said(check_geometric(store));
        not_convex += said == "the hull is not convex";
        std::vector<char> used(p.state.vertex_count);
        for (const std::uint32_t v : cells) used[v] = 1;
        const bool all = std::count(used.begin(), used.end(), 0) == 0;
        if (all) CHECK(said != "nothing");
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
    CHECK(Patient<D>::said(check_geometric(store)) == "the hull is not that of one convex body");
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
        CHECK(Patient<D>::said(check_geometric(store)) == "the hull is not that of one convex body");
    }
}

constexpr const char* not_one_body = "the hull is not that of one convex body";

// What check_geometric says of cells that combine.
template <int D> std::string said_of(const std::vector<double>& x, const std::vector<std::uint32_t>& cells) {
    Block block(std::size_t{1} << 20);
    StoreState state = {};
    Store<D> store(block.arena, state);
    CheckResult why;
    REQUIRE(load_cells<D>(store, x.data(), static_cast<std::uint32_t>(x.size() / D), cells.data(),
                          static_cast<std::uint32_t>(cells.size() / (D + 1)), &why) == Status::ok);
    REQUIRE(Patient<D>::said(check_combinatorial(store)) == "nothing");
    return Patient<D>::said(check_geometric(store));
}

// Two simplices, one on each side of a point, that share 0..D-1 vertices; unit: 1, or one in the last place, where no
// double lies inside.
template <int D> void pinched(double at, double unit) {
    for (std::uint32_t shared = 0; shared < D; ++shared) {
        std::vector<double> x(2 * (D + 1) * D, at);
        std::vector<std::uint32_t> cells;
        for (std::uint32_t v = 0; v <= D; ++v) cells.push_back(v);
        for (std::uint32_t v = 0; v <= D; ++v) {
            cells.push_back(v < shared ? v : D + 1 + v);
            if (v > 0) x[v * D + v - 1] += unit;
            if (v > 0) x[(D + 1 + v) * D + v - 1] -= 2 * unit;
            if (shared == 0)
                for (std::uint32_t k = 0; k < D; ++k) x[(D + 1 + v) * D + k] -= unit;
        }
        CAPTURE(shared);
        CHECK(said_of<D>(x, cells) == not_one_body);
        cells.resize(D + 1);
        CHECK(said_of<D>(x, cells) == "nothing");
    }
}

// Two simplices of the same vertices but for one, which are in one place or on one side.
template <int D> void folded() {
    for (const double height : {1.0, 0.5, 3.0}) {
        std::vector<double> x((D + 2) * D);
        for (std::uint32_t v = 1; v <= D; ++v) x[v * D + v - 1] = 1;
        x[(D + 1) * D + D - 1] = height;
        std::vector<std::uint32_t> cells;
        for (std::uint32_t v = 0; v <= D; ++v) cells.push_back(v);
        for (std::uint32_t v = 0; v <= D; ++v) cells.push_back(v < D ? v : D + 1);
        const std::string said = said_of<D>(x, cells);
        CHECK((said == "two neighbours overlap" || (height != 1 && said == "the hull is not convex")));
    }
    // The whole boundary of a simplex of D + 1 dimensions: nothing is on the hull.
    std::vector<double> x((D + 2) * D);
    for (std::uint32_t v = 0; v <= D; ++v)
        for (std::uint32_t k = 0; k < D; ++k) x[v * D + k] = v == k + 1 ? 8 : k + 0.5;
    std::vector<std::uint32_t> cells;
    for (std::uint32_t k = 0; k < D; ++k) x[(D + 1) * D + k] = 2 + k * k;
    for (std::uint32_t out = 0; out < D + 2; ++out)
        for (std::uint32_t v = 0; v < D + 2; ++v)
            if (v != out) cells.push_back(v);
    CHECK(said_of<D>(x, cells) == "two neighbours overlap");
}

// Cells about a simplex of codimension 2, `times` around, their hull locally convex.
template <int D> std::string fan(std::uint32_t times) {
    constexpr std::uint32_t around = 7;
    std::vector<double> x((D - 1 + around) * D);
    for (std::uint32_t v = 0; v < D - 1; ++v)
        for (std::uint32_t k = 2; k < D; ++k) x[v * D + k] = v == 0 ? -1 : v == k - 1;
    std::vector<std::uint32_t> cells;
    for (std::uint32_t i = 0; i < around; ++i) {
        x[(D - 1 + i) * D] = std::cos(times * i * 6.283185307179586 / around);
        x[(D - 1 + i) * D + 1] = std::sin(times * i * 6.283185307179586 / around);
        for (std::uint32_t v = 0; v < D - 1; ++v) cells.push_back(v);
        cells.push_back(D - 1 + i);
        cells.push_back(D - 1 + (i + 1) % around);
    }
    return said_of<D>(x, cells);
}

// D! times the volume of cells whose coordinates are small integers.
template <int D> double volume(const std::vector<double>& x, const std::vector<std::uint32_t>& cells) {
    double sum = 0;
    for (std::size_t c = 0; c < cells.size(); c += D + 1) {
        double m[D][D], det = 1;
        for (int i = 0; i < D; ++i)
            for (int k = 0; k < D; ++k) m[i][k] = x[cells[c + 1 + i] * D + k] - x[cells[c] * D + k];
        for (int i = 0; i < D; ++i) {
            int pivot = i;
            for (int j = i; j < D; ++j)
                if (std::fabs(m[j][i]) > std::fabs(m[pivot][i])) pivot = j;
            std::swap(m[i], m[pivot]);
            det *= m[i][i];
            for (int j = i + 1; j < D; ++j)
                for (int k = D - 1; k >= i; --k) m[j][k] -= m[j][i] / m[i][i] * m[i][k];
        }
        sum += std::fabs(det);
    }
    return sum;
}

template <int D>
void triangulate_small(const std::vector<double>& points, std::vector<double>* x, std::vector<std::uint32_t>* cells) {
    Block block(std::size_t{1} << 20);
    StoreState state = {};
    Store<D> store(block.arena, state);
    Monitor monitor;
    InputReport input;
    REQUIRE(triangulate<D>(store, points.data(), points.size() / D, 1, monitor, &input) == Status::ok);
    for (std::uint32_t v = 0; v < state.vertex_count; ++v) x->insert(x->end(), store.point(v), store.point(v) + D);
    for (std::uint32_t c = 0; c < state.cell_slots; ++c)
        cells->insert(cells->end(), store.cell(c).vertex, store.cell(c).vertex + D + 1);
}

// Some cells of a triangulation are one of the hull of their vertices if and only if they have its volume.
template <int D> void some_cells() {
    int convex = 0, others = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        std::vector<double> points = inputs::uniform(D, D + 2 + seed % 6, seed), x;
        for (double& t : points) t = std::floor(5 * t);
        for (std::uint32_t k = 0; k < D * (D + 1); ++k) points[k] = k % (D + 1) == 0 ? 7 : points[k];  // never flat
        std::vector<std::uint32_t> cells, chosen;
        triangulate_small<D>(points, &x, &cells);
        const std::size_t count = cells.size() / (D + 1);
        for (std::size_t c = 0; c < count; ++c)
            if ((seed * 0x9E3779B97F4A7C15u >> (c * 7 % 60) & 7u) > seed % 4)
                chosen.insert(chosen.end(), cells.begin() + static_cast<std::ptrdiff_t>(c * (D + 1)),
                              cells.begin() + static_cast<std::ptrdiff_t>((c + 1) * (D + 1)));
        if (chosen.empty()) continue;
        std::vector<double> used, hull_x;
        for (const std::uint32_t v : chosen) used.insert(used.end(), x.begin() + v * D, x.begin() + (v + 1) * D);
        std::vector<std::uint32_t> hull;
        triangulate_small<D>(used, &hull_x, &hull);
        const bool is_convex = std::fabs(volume<D>(hull_x, hull) - volume<D>(x, chosen)) < 0.5;
        CAPTURE(seed);
        CHECK((said_of<D>(x, chosen) == "nothing") == is_convex);
        ++(is_convex ? convex : others);
    }
    CHECK(convex > 5);
    CHECK(others > 5);
}

// Points a few units in the last place apart.
template <int D> void tiny_sets() {
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
        for (const int units : {1, 2, 64}) {
            std::vector<double> points = inputs::uniform(D, 3 * D, seed), x;
            for (std::size_t k = 0; k < points.size(); ++k)
                points[k] = 1 + std::floor((units + 1) * points[k]) * 0x1p-52;
            for (std::uint32_t v = 0; v <= D; ++v)
                for (std::uint32_t k = 0; k < D; ++k) points[v * D + k] = v == k + 1 ? 1 + 0x1p-52 : 1;
            std::vector<std::uint32_t> cells;
            triangulate_small<D>(points, &x, &cells);
            CHECK(said_of<D>(x, cells) == "nothing");
        }
}

template <int D> void hulls() {
    pinched<D>(0, 1);
    pinched<D>(1, 0x1p-52);
    folded<D>();
    CHECK(fan<D>(1) == "nothing");
    CHECK(fan<D>(2) == not_one_body);
    tiny_sets<D>();
    if constexpr (D <= 4) some_cells<D>();
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
    hulls<D>();
}
TEST_CASE_TEMPLATE_APPLY(damage, Dimensions<>);

// Triangles that meet at vertices only, one beside another or in a ring; with one cell left out; tetrahedra at an edge.
TEST_CASE("cells that meet at vertices or edges only are no triangulation") {
    CHECK(said_of<2>({0, 0, 10, 1, 10, 3, 10, -1, 10, -3}, {0, 1, 2, 0, 3, 4}) == not_one_body);
    CHECK(said_of<2>({0, 0, 1, 0, 0, 1, 100, 0, 101, 0, 100, 1}, {0, 1, 2, 3, 4, 5}) == not_one_body);
    CHECK(said_of<2>({0, 0, 4, 0.1, 2, 3.3, 2, -1, 4, 2.5, 0, 2.4}, {0, 1, 3, 1, 2, 4, 2, 0, 5}) == not_one_body);
    CHECK(said_of<3>({0, 0, 0, 0, 0, 1, 3, 1, 0, 3, -1, 0.2, -3, 1, 0, -3, -1.1, 0.2}, {0, 1, 2, 3, 0, 1, 4, 5}) ==
          not_one_body);
}
