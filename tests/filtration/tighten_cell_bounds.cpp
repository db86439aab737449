#include "filtration/tighten_cell_bounds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/dimensions.hpp"
#include "common/filtered_mesh.hpp"
#include "common/meshed.hpp"
#include "filtration/filters.hpp"
#include "geometry/nearest_in_hull.hpp"
#include "geometry/sides.hpp"

using namespace netmesh;

namespace {

// Samples points, near vertices where cells are small, and compares the distance to the inputs with the bounds of the
// cell that each is in.
template <int D>
void sample_cells(const inputs::Points& points, double tau, int samples, double share, double factor = 1) {
    Meshed<D> meshed(points, by_quality(tau, factor, true), std::size_t{1} << 27);
    REQUIRE(meshed.status == Status::ok);
    Arena& arena = meshed.block.arena;
    Store<D>& store = meshed.store;
    Monitor& monitor = meshed.monitor;
    const std::uint32_t inputs = meshed.inputs(), count = store.state.vertex_count;
    const FilteredMesh<D> mesh = {store, meshed.result.domain, inputs};
    const double rho = mesh.cut();
    std::vector<double> value(count);
    std::vector<Interval> known(count), sharp;
    Evaluation complete = {value.data(), known.data()};
    REQUIRE(evaluate(mesh, {NETMESH_FILTER_COMPLETE, &complete_on_mesh, FilterValues::certified}, {arena, monitor},
                     &complete) == Status::ok);
    sharp = known;
    const std::size_t low = arena.low_mark(), high = arena.high_mark();
    REQUIRE(tighten_cell_bounds(mesh, {arena, monitor}, sharp.data()) == Status::ok);
    CHECK(arena.low_mark() == low);
    CHECK(arena.high_mark() == high);
    std::size_t narrower = 0;
    for (std::uint32_t v = 0; v < count; ++v) {
        CHECK(sharp[v].lo >= known[v].lo);
        CHECK(sharp[v].hi <= known[v].hi);
        CHECK(sharp[v].lo <= sharp[v].hi);
        narrower += sharp[v].hi / sharp[v].lo < 0.95 * known[v].hi / known[v].lo;
    }
    CHECK(static_cast<double>(narrower) >= share * count);
    inputs::Random random(8);
    for (int s = 0; s < samples; ++s) {
        double x[D];
        const std::uint32_t near = inputs + static_cast<std::uint32_t>(random.below(count - inputs));
        const double scale = 2 * std::sqrt(store.vertex(near).nearest2);
        for (int k = 0; k < D; ++k) x[k] = store.point(near)[k] + scale * (2 * random.uniform() - 1);
        std::uint32_t v = 0;
        double best = infinity, offset = infinity;
        for (std::uint32_t w = 0; w < count; ++w) {
            const double d = distance<D>(x, store.point(w));
            if (d < best) {
                best = d;
                v = w;
            }
            if (w < inputs) offset = std::min(offset, d);
        }
        const double f = std::min(offset, rho);
        // An input's cell has a ball in it before lo.
        CHECK((v < inputs || sharp[v].lo <= f * (1 + 1e-12)));
        CHECK(f <= sharp[v].hi * (1 + 1e-12));
    }
}

// Points one after the other in columns, with room to spare.
HalfSpace nearest(int dim, const double* points, std::uint32_t count, const double* q) {
    const std::size_t stride = count + 3;
    std::vector<double> y(stride * static_cast<std::size_t>(dim)), scratch(count);
    for (std::uint32_t i = 0; i < count; ++i)
        for (int k = 0; k < dim; ++k)
            y[static_cast<std::size_t>(k) * stride + i] = points[static_cast<int>(i) * dim + k];
    HalfSpace best;
    NearestInHull(dim).run({y.data(), stride, count, dim}, q, scratch.data(), &best);
    return best;
}

// Never above the distance to a point of the hull.
template <int D> void random_hulls() {
    CAPTURE(D);
    inputs::Random random(5);
    for (int i = 0; i < 1000; ++i) {
        double y[12][D], q[D], x[D] = {}, sum = 0, weight[12];
        for (double& w : weight) sum += w = random.uniform() * random.uniform();
        for (int j = 0; j < 12; ++j)
            for (int k = 0; k < D; ++k) x[k] += weight[j] / sum * (y[j][k] = random.uniform());
        const bool inside = i % 4 == 0;
        for (int k = 0; k < D; ++k) q[k] = inside ? x[k] : 3 * random.uniform() - 1;
        const HalfSpace best = nearest(D, y[0], 12, q);
        CHECK(best.distance(q) <= distance<D>(x, q) * (1 + 1e-12) + 1e-12);
        for (const auto& corner : y) CHECK(best.distance(corner) <= 1e-12);
    }
}

// What does not fit, and a caller that wants to stop, leave the arena as it was.
template <int D> void little_memory(const inputs::Points& points, double tau) {
    CAPTURE(D);
    Meshed<D> meshed(points, by_quality(tau, 1, true), std::size_t{1} << 25);
    REQUIRE(meshed.status == Status::ok);
    Arena& arena = meshed.block.arena;
    Store<D>& store = meshed.store;
    Monitor& monitor = meshed.monitor;
    const std::uint32_t inputs = meshed.inputs(), count = store.state.vertex_count;
    const FilteredMesh<D> mesh = {store, meshed.result.domain, inputs};
    const double rho = mesh.cut();
    std::vector<double> value(count);
    std::vector<Interval> known(count), whole, sharp;
    Evaluation complete = {value.data(), known.data()};
    REQUIRE(evaluate(mesh, {NETMESH_FILTER_COMPLETE, &complete_on_mesh, FilterValues::certified}, {arena, monitor},
                     &complete) == Status::ok);
    whole = known;
    REQUIRE(tighten_cell_bounds(mesh, {arena, monitor}, whole.data()) == Status::ok);
    const std::size_t free_bytes = arena.bytes_free();
    int refused = 0;
    for (std::size_t left = 64; left <= std::size_t{1} << 20; left += left / 8) {
        const std::size_t high = arena.high_mark();
        REQUIRE(arena.template take_high<unsigned char>(free_bytes - left) != nullptr);
        sharp = known;
        const Status status = tighten_cell_bounds(mesh, {arena, monitor}, sharp.data());
        arena.release_high(high);
        CHECK(arena.bytes_free() == free_bytes);
        for (std::uint32_t v = 0; v < count; ++v) {  // each as it was or as it will be
            CHECK((sharp[v].lo == known[v].lo || sharp[v].lo == whole[v].lo));
            if (status == Status::ok) CHECK(sharp[v].hi == whole[v].hi);
        }
        CHECK((status == Status::ok || status == Status::out_of_memory));
        refused += status != Status::ok;
    }
    CHECK(refused > 3);
    // Of a vertex on the hull, and of one with a corner that is not known, no more is found.
    std::uint32_t open = none, vague = none;
    for (std::uint32_t c = 0; c < store.state.cell_slots; ++c)
        for (int i = 0; i <= D; ++i)
            if (store.cell(c).neighbour[i] == none) open = store.cell(c).vertex[i == 0];
    for (std::uint32_t v = inputs; v < count; ++v)
        if (store.vertex(v).marker == Marker::steiner && known[v].lo < rho) vague = v;
    REQUIRE(open != none);
    REQUIRE(vague != none);
    const Marker marker = store.vertex(open).marker;
    std::vector<double> kept;
    store.vertex(open).marker = Marker::steiner;
    for (std::uint32_t c = 0; c < store.state.cell_slots; ++c) {
        kept.push_back(store.cell(c).radius2);
        for (const std::uint32_t v : store.cell(c).vertex)
            if (v == vague) store.cell(c).radius2 = infinity;
    }
    std::vector<Interval> before = known;
    before[open] = {rho / 8, rho};
    sharp = before;
    CHECK(tighten_cell_bounds(mesh, {arena, monitor}, sharp.data()) == Status::ok);
    for (const std::uint32_t v : {open, vague}) {
        CHECK(sharp[v].lo == before[v].lo);
        CHECK(sharp[v].hi == before[v].hi);
    }
    store.vertex(open).marker = marker;
    for (std::uint32_t c = 0; c < store.state.cell_slots; ++c) store.cell(c).radius2 = kept[c];
    // Stopped at the first poll, if there is one.
    int polls = 0;
    Monitor stopping(
        [](void* user, const netmesh_progress*) {
            ++*static_cast<int*>(user);
            return 1;
        },
        &polls);
    sharp = known;
    const Status status = tighten_cell_bounds(mesh, {arena, stopping}, sharp.data());
    CHECK(status == (polls > 0 ? Status::cancelled : Status::ok));
    CHECK((polls > 0 || store.state.vertex_count < 1000));
}

// Inputs in columns, on which the planes of their tree stand: its boxes end where inputs are.
inputs::Points columns(int count, int rows, double step, double apart) {
    inputs::Random random(108);
    inputs::Points points;
    for (int c = 0; c < count; ++c) {
        const double shift = random.uniform();
        for (int row = 0; row < rows; ++row) {
            points.push_back(c * apart);
            points.push_back(step * (row + shift));
        }
    }
    return points;
}

}  // namespace

TEST_CASE("the nearest point of a hull, from below") {
    // A square, its centre (0, 0); from (3, 0.5) the nearest point is (1, 0.5), from (2, 3) the corner (1, 1).
    const double square[] = {1, 1, 1, -1, -1, 1, -1, -1};
    const auto bound = [&](double x, double y) {
        const double q[] = {x, y};
        return nearest(2, square, 4, q).distance(q);
    };
    CHECK(bound(3, 0.5) == doctest::Approx(2));
    CHECK(bound(2, 3) == doctest::Approx(std::sqrt(5)));
    CHECK(bound(0.5, -7) == doctest::Approx(6));
    CHECK(bound(0.2, 0.1) == 0);
    for_each_dimension([](auto dim) { random_hulls<dim>(); });
}

TEST_CASE_TEMPLATE_DEFINE("hulls that are flat, and points on them", T, hulls) {
    constexpr int D = T::value;
    // A cross of the first axes, some of its points twice; from a corner, from inside of it, and from above.
    constexpr int axes = D - 1, count = 3 * axes;
    double y[count][D] = {};
    for (int a = 0; a < axes; ++a) {
        y[3 * a][a] = 1;
        y[3 * a + 1][a] = -1;
        y[3 * a + 2][a] = 1;
    }
    const auto bound = [&](const double* q) {
        const HalfSpace best = nearest(D, y[0], count, q);
        for (const auto& corner : y) CHECK(best.distance(corner) <= 1e-12);
        return best.distance(q);
    };
    double q[D] = {};
    CHECK(bound(q) == 0);
    q[0] = 1;
    CHECK(bound(q) == 0);
    q[0] = 0.25;
    CHECK(bound(q) <= 1e-12);
    q[D - 1] = 3;
    CHECK(bound(q) == doctest::Approx(3));
    q[0] = 2;
    CHECK(bound(q) == doctest::Approx(std::sqrt(10.0)));
}
TEST_CASE_TEMPLATE_APPLY(hulls, Dimensions<>);

TEST_CASE("the distance to the inputs is within the bounds of every cell") {
    sample_cells<2>(inputs::uniform(2, 60), 2.5, 10000, 0.1);
    sample_cells<2>(inputs::clusters(2, 40), 3.08, 10000, 0.1);
    sample_cells<3>(inputs::torus(60, 27), 3.08, 5000, 0.1);
    for_each_dimension<4, 4>([&](auto dim) { sample_cells<dim>(inputs::clifford(200), 3.08, 2000, 0.02); });
    for_each_dimension<5, 5>([&](auto dim) { sample_cells<dim>(inputs::uniform(5, 8), 2.2, 300, 0.02); });
    for_each_dimension<6, 6>([&](auto dim) { sample_cells<dim>(inputs::clusters(6, 8), 3, 300, 0.1); });
    for_each_dimension<6, 6>([&](auto dim) {
        sample_cells<dim>(inputs::uniform(6, 14), 3, 300, 0);
    });  // more inputs than a leaf of the tree has
    // Cells that are farther from all inputs than these are from each other.
    sample_cells<2>(inputs::uniform(2, 20), 2.5, 2000, 0.02, 3);
    sample_cells<3>(inputs::uniform(3, 12), 2.5, 2000, 0.02, 3);
    for_each_dimension<4, 4>([&](auto dim) { sample_cells<dim>(inputs::uniform(4, 7), 3, 1000, 0, 3); });
    for_each_dimension<5, 5>([&](auto dim) { sample_cells<dim>(inputs::uniform(5, 6), 4, 300, 0, 4); });
}

// In the plane a cell is a polygon, whose distance to a point outside is that to one of its sides.
TEST_CASE("no input is nearer to a cell of the plane than its lower bound, to the last digits") {
    int touched = 0;
    for (const inputs::Points& points : {inputs::uniform(2, 90), inputs::clusters(2, 120), inputs::circle(40),
                                         columns(4, 15, 0.11, 2.4), columns(3, 15, 0.3, 1.9)}) {
        Meshed<2> meshed(points, by_quality(2.5, 1, true), std::size_t{1} << 25);
        REQUIRE(meshed.status == Status::ok);
        const Store<2>& store = meshed.store;
        const std::uint32_t inputs = meshed.inputs(), count = store.state.vertex_count;
        const FilteredMesh<2> mesh = {meshed.store, meshed.result.domain, inputs};
        std::vector<double> value(count);
        std::vector<Interval> interval(count);
        Evaluation complete = {value.data(), interval.data()};
        REQUIRE(evaluate(mesh, {NETMESH_FILTER_COMPLETE, &complete_on_mesh, FilterValues::certified},
                         {meshed.block.arena, meshed.monitor}, &complete) == Status::ok);
        REQUIRE(tighten_cell_bounds(mesh, {meshed.block.arena, meshed.monitor}, interval.data()) == Status::ok);
        std::vector<double> least(count, infinity);
        for_each_side(store, [&](std::uint32_t v, const double* a, const double* b) {
            for (std::uint32_t p = 0; p < inputs; ++p)
                least[v] = std::min(least[v], distance_to_side(store.point(p), a, b));
        });
        for (std::uint32_t v = inputs; v < count; ++v) {
            if (store.vertex(v).marker != Marker::steiner || !(interval[v].lo < mesh.cut())) continue;
            CHECK(interval[v].lo <= least[v] * (1 + 1e-13));
            touched += interval[v].lo > least[v] * (1 - 1e-9);
        }
    }
    CHECK(touched > 100);  // as near as the bound says
}

TEST_CASE("bounds of cells in little memory") {
    little_memory<2>(inputs::uniform(2, 300), 2.5);
    little_memory<3>(inputs::uniform(3, 120), 2.5);
    for_each_dimension<4, 4>([&](auto dim) { little_memory<dim>(inputs::uniform(4, 16), 2.5); });
    for_each_dimension<5, 5>([&](auto dim) { little_memory<dim>(inputs::uniform(5, 8), 4); });
    for_each_dimension<6, 6>([&](auto dim) { little_memory<dim>(inputs::uniform(6, 5), 2.2); });
}
