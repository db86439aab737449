// Cells clipped to a ball: refinement for them, and their proven intervals, against sampled points of the ball and the
// farthest points as they are measured.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "api/objects.hpp"
#include "certificate/cells.hpp"
#include "common/dimensions.hpp"
#include "common/filtered_mesh.hpp"
#include "common/meshed.hpp"
#include "common/nerve.hpp"
#include "delaunay/cell_list.hpp"
#include "filtration/filters.hpp"
#include "filtration/tighten_cell_bounds.hpp"
#include "mesh/clip/clipped_cell.hpp"
#include "mesh/clip/clipped_nerve.hpp"
#include "mesh/clip/clipped_reach.hpp"

using namespace netmesh;

namespace {

// A sampled point of a ball and the vertex whose cell it is in.
template <int D> struct Sample {
    double x[D];
    std::uint32_t vertex;
    double input_distance;
};

template <int D> class Clipped : public Meshed<D> {
public:
    using Meshed<D>::store;

    Clipped(const inputs::Points& points, const RatioGoal& goal, std::size_t bytes = std::size_t{1} << 24)
        : Meshed<D>(points, by_certificate(goal), bytes), goal_(goal) {
        REQUIRE(this->status == Status::ok);
        ball_ = this->result.domain;
    }
    std::uint32_t count() const { return this->state.vertex_count; }
    bool is_exempt(std::uint32_t v) const { return store.vertex(v).marker == Marker::exempt; }
    Domain<D>& ball() { return ball_; }

    // Half of them on the sphere, where the farthest points are.
    void sample(int samples) {
        inputs::Random random(11);
        while (samples > 0) {
            Sample<D> s;
            double away2 = 0;
            for (double& x : s.x) {
                x = 2 * random.uniform() - 1;
                away2 += x * x;
            }
            if (away2 > 1 || !(away2 > 0)) continue;
            const double stretch = ball_.radius * (samples % 2 == 0 ? (1 - 0x1p-50) / std::sqrt(away2) : 1);
            for (int k = 0; k < D; ++k) s.x[k] = ball_.centre[k] + stretch * s.x[k];
            double least = HUGE_VAL, input = HUGE_VAL;
            for (std::uint32_t v = 0; v < count(); ++v) {
                const double d2 = distance2<D>(store.point(v), s.x);
                if (d2 < least) {
                    least = d2;
                    s.vertex = v;
                }
                if (v < this->inputs() && d2 < input) input = d2;
            }
            s.input_distance = std::sqrt(input);
            samples_.push_back(s);
            --samples;
        }
    }

    // Nothing is inserted outside of the ball.
    void check_place() {
        for (std::uint32_t v = 0; v < count(); ++v) {
            CAPTURE(v);
            if (!is_exempt(v)) CHECK(ball_.distance2(store.point(v)) <= ball_.radius * ball_.radius);
        }
        CHECK(ball_.radius == ball_.enclosing_radius * clip_factor);
    }

    // The same bounds when none of the inputs' reaches are asked for.
    void check_without_inputs(const std::vector<double>& out_radius, const std::vector<double>& reach) {
        const std::uint32_t first = this->inputs();
        std::vector<double> radius(count()), rest(count() - first);
        measure_cells<D>(store, radius.data(), rest.data(), first);
        REQUIRE(clip_cell_bounds(store, ball_, {}, radius.data(), rest.data(), first) == Status::ok);
        CHECK(radius == out_radius);
        CHECK(std::equal(rest.begin(), rest.end(), reach.begin() + first));
    }

    // Proven reaches contain all that was sampled and are not much more than what is measured. Returns how many cells
    // are cut by the sphere.
    int check_reach() {
        std::vector<double> out_radius(count()), reach(count()), whole(count());
        measure_cells<D>(store, out_radius.data(), reach.data());
        whole = out_radius;
        const std::size_t low = this->block.arena.low_mark(), high = this->block.arena.high_mark();
        REQUIRE(clip_cell_bounds(store, ball_, {}, out_radius.data(), reach.data()) == Status::ok);
        CHECK((this->block.arena.low_mark() == low && this->block.arena.high_mark() == high));
        check_without_inputs(out_radius, reach);
        for (const Sample<D>& s : samples_) {
            const VertexId v(s.vertex);
            if (is_exempt(v)) continue;
            CHECK(distance<D>(store.point(v), s.x) <= out_radius[v]);
            CHECK(distance<D>(store.point(nearest_input<D>(store, v)), s.x) <= reach[v]);
        }
        int cut = 0;
        for (VertexId v(0); v < count(); ++v) {
            CHECK(store.vertex(v).queued == 0);
            if (is_exempt(v)) continue;
            CAPTURE(static_cast<std::uint32_t>(v));
            const double from_vertex = farthest(v, store.point(v));
            if (from_vertex < 0) continue;
            CHECK(out_radius[v] >= from_vertex * (1 - 0x1p-20));
            CHECK(out_radius[v] <= from_vertex + excess(v, store.point(v), from_vertex));
            const double* const input = store.point(nearest_input<D>(store, v));
            const double from_input = farthest(v, input);
            CHECK(reach[v] >= from_input * (1 - 0x1p-20));
            CHECK(reach[v] <= from_input + excess(v, input, from_input));
            cut += out_radius[v] < whole[v] * (1 - 0x1p-10);
        }
        return cut;
    }

    // For the first ball whose nerve is certain: the intervals of the filter are within the ratios asked for and true
    // of all samples, and what has been sampled is there.
    void check_intervals() {
        const Work work = {this->block.arena, this->monitor};
        Subcomplex<D> there = {};
        bool found = false;
        REQUIRE(choose_nerve<D>(store, &ball_, work, &there, &found) == Status::ok);
        REQUIRE(found);
        const std::uint8_t* const part = there.vertex;
        for (const Sample<D>& s : samples_)
            if (ball_.contains(s.x)) CHECK(part[s.vertex] != VertexPart::absent);
        for (std::uint32_t v = 0; v < this->inputs(); ++v) CHECK(part[v] != VertexPart::absent);
        const FilteredMesh<D> mesh = {store, ball_, this->inputs(), true, &there};
        std::vector<double> value(count());
        std::vector<Interval> interval(count());
        Evaluation out = {value.data(), interval.data()};
        REQUIRE(evaluate(mesh, {NETMESH_FILTER_COMPLETE, &complete_on_mesh, FilterValues::certified}, work, &out) ==
                Status::ok);
        CHECK(out.certificate.ratio <= goal_.ratio);
        check_samples(interval);
        const double ratio2 = goal_.ratio * goal_.ratio, focus2 = goal_.focus * goal_.focus;
        for (std::uint32_t v = 0; v < count(); ++v) {
            CAPTURE(v);
            const Interval i = interval[v];
            if (part[v] == VertexPart::absent) continue;
            CHECK(i.hi <= ratio2 * i.lo);
            CHECK(value[v] <= out.certificate.ratio * i.lo);
            CHECK(i.hi <= out.certificate.ratio * value[v]);
            if (goal_.focus > 0 && v >= this->inputs() && i.hi > goal_.from && i.lo < goal_.to)
                CHECK(i.hi <= focus2 * i.lo);
        }
        check_without_intervals(mesh);
        const std::vector<Interval> before = interval;
        REQUIRE(tighten_cell_bounds(mesh, work, interval.data()) == Status::ok);
        check_samples(interval);
        for (std::uint32_t v = 0; v < count(); ++v) {
            CHECK((interval[v].lo >= before[v].lo && interval[v].hi <= before[v].hi));
            if (part[v] == VertexPart::absent)
                CHECK((interval[v].lo == before[v].lo && interval[v].hi == before[v].hi));
        }
    }

private:
    // Where no intervals are asked for cells are clipped as far as values depend on it: values and ratios are the same.
    void check_without_intervals(const FilteredMesh<D>& mesh) {
        for (const auto& [filter, on_mesh] : {std::pair(NETMESH_FILTER_COMPLETE, &complete_on_mesh),
                                              std::pair(NETMESH_FILTER_BASIC, netmesh_filter_basic.on_mesh)})
            for (const FilterValues values : {FilterValues::certified, FilterValues::thesis}) {
                std::vector<double> closely(count()), alone(count());
                std::vector<Interval> interval(count());
                Evaluation all = {closely.data(), interval.data()}, some = {alone.data()};
                const Work work = {this->block.arena, this->monitor};
                REQUIRE(evaluate(mesh, {filter, on_mesh, values}, work, &all) == Status::ok);
                REQUIRE(evaluate(mesh, {filter, on_mesh, values}, work, &some) == Status::ok);
                CHECK(closely == alone);
                CHECK(all.certificate.ratio == some.certificate.ratio);
                CHECK(all.certificate.ratio_best == some.certificate.ratio_best);
                CHECK(all.certificate.from == some.certificate.from);
                for (VertexId v(0); v < count(); ++v) CHECK(store.vertex(v).queued == 0);
            }
    }
    void check_samples(const std::vector<Interval>& interval) const {
        for (const Sample<D>& s : samples_) {
            if (!ball_.contains(s.x)) continue;
            const Interval i = interval[s.vertex];
            const double f = std::min(s.input_distance, ball_.enclosing_radius);
            CHECK(f <= i.hi);
            if (s.vertex >= this->inputs() ||
                s.input_distance * s.input_distance >= store.vertex(s.vertex).nearest2 / 4)
                CHECK(f >= i.lo * (1 - 0x1p-40));
        }
    }
    // What a proven reach from u may be more than the measured one: by the head of clip_cell_bounds, with the largest
    // errors and lengths of the cell's corners.
    double excess(VertexId v, const double* u, double reach) {
        double wide = 0, share = 0, doubt = 0;
        REQUIRE(visit_star(store, v, [&](CellId c) {
            const Cell<D>& cell = store.cell(c);
            const double radius = std::sqrt(cell.radius2);
            wide = std::max(wide, radius);
            share = std::max(share, double(cell.error));
            doubt = std::max(doubt, double(cell.error) * radius);
        }));
        doubt = std::min(doubt, 3 * share * reach);
        const double away = std::sqrt(ball_.distance2(u)), both = 2 * (wide + distance<D>(u, store.point(v)));
        const double rounding = 0x1p-44 * (2 * both * away + away * away + ball_.radius * ball_.radius + reach * reach);
        const double needed = (4 * away * doubt + 8 * rounding) / (2 * reach * reach);
        return std::min(0x1p-20, 0x1p6 * std::max(0x1p-38, needed)) * reach + 2 * doubt + 0x1p-43 * both;
    }
    // From u to v's clipped cell, as it is computed; -1: that is empty.
    double farthest(VertexId v, const double* u) {
        Corner<D> corner;
        if (ball_.contains(store.point(v))) corner.offer(store.point(v), distance2<D>(store.point(v), u), none);
        std::uint32_t cells = 0;
        REQUIRE(visit_star(store, v, [&](CellId c) {
            ++cells;
            const Cell<D>& cell = store.cell(c);
            if (ball_.contains(cell.centre)) return corner.offer(cell.centre, distance2<D>(cell.centre, u), c);
            for (int i = 0; i <= D; ++i) {
                if (cell.vertex[i] == v) continue;
                double z[2][D];
                const int crossings =
                    sphere_crossings<D>(ball_, cell.centre, store.cell(cell.neighbour[i].cell()).centre, z);
                for (int k = 0; k < crossings; ++k) corner.offer(z[k], distance2<D>(z[k], u), c);
            }
        }));
        offer_poles<D>(store, ball_, u, v, store.list_top(), cells, &corner);
        return corner.distance2 < 0 ? -1 : std::sqrt(corner.distance2);
    }

    RatioGoal goal_;
    Domain<D> ball_;
    std::vector<Sample<D>> samples_;
};

template <int D> int check(const inputs::Points& points, const RatioGoal& goal, int samples) {
    CAPTURE(D);
    CAPTURE(points.size() / D);
    CAPTURE(goal.ratio);
    CAPTURE(goal.focus);
    Clipped<D> mesh(points, goal);
    mesh.sample(samples);
    mesh.check_place();
    const int cut = mesh.check_reach();
    mesh.check_intervals();
    return cut;
}

// On a line along the diagonal.
inputs::Points collinear(int dim, std::size_t n) {
    inputs::Points points;
    for (std::size_t i = 0; i < n; ++i) points.insert(points.end(), std::size_t(dim), double(i * i));
    return points;
}

constexpr RatioGoal clipped_to(double ratio, double focus = 0, double from = 0, double to = 0) {
    return {ratio, focus, from, to, true};
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("meshes of clipped cells prove their ratio on all kinds of input", T, clipped_cells) {
    constexpr int D = T::value;
    const std::size_t n = D == 2 ? 120 : D == 3 ? 60 : 20;
    const int samples = D == 2 ? 20000 : 10000;
    int cut = 0;
    for (const double ratio : {2.25, 3.0, 1.95}) {
        if (D == 4 && ratio < 2) continue;
        const RatioGoal goal = clipped_to(ratio);
        cut += check<D>(inputs::uniform(D, n), goal, samples);
        cut += check<D>(inputs::shell(D, n, 1, 1, 7), goal, samples);
        cut += check<D>(inputs::clusters(D, n / 2), goal, samples);
        cut += check<D>(inputs::grid(D, D == 2 ? 6 : D == 3 ? 3 : 2), goal, samples);
        cut += check<D>(collinear(D, 12), goal, samples);
        cut += check<D>(inputs::close_pairs(D, 3, 1e-6), goal, samples);
        for (std::size_t few = 1; few <= 5; ++few) cut += check<D>(inputs::uniform(D, few), goal, samples / 10);
    }
    CHECK(cut > 100);
}
TEST_CASE_TEMPLATE_APPLY(clipped_cells, Dimensions<2, 4>);

TEST_CASE("meshes of clipped cells of curves and surfaces") {
    const RatioGoal goal = clipped_to(2.1213);
    for_each_dimension<2, 2>([&](auto dim) { check<dim>(inputs::circle(200), goal, 100000); });
    for_each_dimension<3, 3>([&](auto dim) { check<dim>(inputs::torus(300, 1), goal, 20000); });
    for_each_dimension<4, 4>([&](auto dim) { check<dim>(inputs::clifford(60), goal, 5000); });
}

TEST_CASE_TEMPLATE_DEFINE("meshes of clipped cells for scales of interest", T, clipped_focus) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::shell(D, D == 4 ? 12 : 30, 1, 1, 7);
    const double ratio = 2.25, focus = D < 4 ? 1.6 : 1.8;
    const Clipped<D> without(points, clipped_to(ratio));
    check<D>(points, clipped_to(ratio, focus, 0.1, 0.2), 4000);
    check<D>(points, clipped_to(ratio, focus, 0.3, 0.6), 4000);
    check<D>(points, clipped_to(ratio, focus, 3, 5), 4000);
    if (D < 4) check<D>(points, clipped_to(ratio, D == 2 ? 1.2 : 1.35, 0.8, 1.1), 4000);
    const Clipped<D> with(points, clipped_to(ratio, focus, 0.3, 0.6));
    CHECK(with.count() > without.count());
}
TEST_CASE_TEMPLATE_APPLY(clipped_focus, Dimensions<2, 4>);

TEST_CASE_TEMPLATE_DEFINE("clipped cells need fewer vertices than whole ones, and whole ones what they did", T, fewer) {
    constexpr int D = T::value;
    const inputs::Points points = inputs::shell(D, D == 2 ? 200 : D == 3 ? 300 : 60, 1, 1, 7);
    RatioGoal goal = clipped_to(2.25);
    const Clipped<D> clipped(points, goal);
    goal.clipped = false;
    const Meshed<D> whole(points, by_certificate(goal));
    REQUIRE(whole.status == Status::ok);
    CHECK(clipped.count() < 0.75 * whole.state.vertex_count);
    CHECK(whole.result.domain.radius == whole.result.domain.enclosing_radius);
}
TEST_CASE_TEMPLATE_APPLY(fewer, Dimensions<2, 4>);

// Smaller and larger balls than the one refined for: cells that lie outside, cells cut in every way.
TEST_CASE_TEMPLATE_DEFINE("reaches in balls of any size", T, any_ball) {
    constexpr int D = T::value;
    for (std::uint64_t set = 1; set <= (D == 2 ? 6 : 2); ++set)
        for (const double share : {0.25, 0.6, 0.9, 1.2}) {
            CAPTURE(set);
            CAPTURE(share);
            Clipped<D> mesh(inputs::uniform(D, D == 4 ? 8 : 20, set), clipped_to(2.25));
            mesh.ball().radius *= share;
            mesh.ball().centre[0] += 0.1 * mesh.ball().radius;
            mesh.sample(D == 2 ? 4000 : 2000);
            mesh.check_reach();
        }
}
TEST_CASE_TEMPLATE_APPLY(any_ball, Dimensions<2, 4>);

TEST_CASE("absent vertices have a value and an interval and count nowhere") {
    Clipped<2> mesh(inputs::uniform(2, 40), clipped_to(3));
    const std::uint32_t count = mesh.count();
    std::vector<std::uint8_t> part(count, VertexPart::cut);
    Subcomplex<2> there = {};
    there.vertex = part.data();
    const FilteredMesh<2> filtered = {mesh.store, mesh.ball(), mesh.inputs(), true, &there};
    std::vector<double> value(count);
    std::vector<Interval> interval(count);
    Evaluation out = {value.data(), interval.data()};
    const auto run = [&] {
        REQUIRE(evaluate(filtered, {NETMESH_FILTER_COMPLETE, &complete_on_mesh, FilterValues::certified},
                         {mesh.block.arena, mesh.monitor}, &out) == Status::ok);
        return out.certificate.ratio;
    };
    double before = run();
    for (int turn = 0; turn < 6; ++turn) {
        std::uint32_t worst = none;
        for (std::uint32_t v = mesh.inputs(); v < count; ++v)
            if (part[v] != VertexPart::absent &&
                (worst == none || interval[v].hi * interval[worst].lo > interval[worst].hi * interval[v].lo))
                worst = v;
        REQUIRE(worst != none);
        part[worst] = VertexPart::absent;
        const double after = run();
        CHECK(after <= before);
        CHECK(interval[worst].lo == filtered.cut());
        CHECK(interval[worst].hi == filtered.cut());
        CHECK(value[worst] == filtered.cut());
        before = after;
    }
    double widest = 1;
    for (std::uint32_t v = 0; v < count; ++v)
        if (part[v] != VertexPart::absent) widest = std::max(widest, interval[v].hi / interval[v].lo);
    CHECK(before == doctest::Approx(std::sqrt(widest)).epsilon(1e-9));
}
