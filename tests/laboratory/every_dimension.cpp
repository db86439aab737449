// The analysis in every dimension: what coordinates do not resolve, what does not fit, what is stopped, what was
// loaded.
#include <doctest/doctest.h>

#include "api/call.hpp"
#include "common/arrays.hpp"
#include "common/dimensions.hpp"
#include "common/polls.hpp"
#include "common/session.hpp"
#include "laboratory/common.hpp"
#include "laboratory/fat_cell.hpp"
#include "laboratory/fatness.hpp"
#include "laboratory/feature_integral.hpp"
#include "laboratory/in_ball.hpp"
#include "laboratory/pacing.hpp"
#include "laboratory/size.hpp"
#include "laboratory/structure.hpp"
#include "numerics/elementary.hpp"

using namespace netmesh;

namespace {

// Points and a tree over them, no cells.
template <int D> struct Cloud {
    explicit Cloud(const inputs::Points& points)
        : block(std::size_t{1} << 24), store(block.arena, state), count(static_cast<std::uint32_t>(points.size() / D)) {
        REQUIRE(store.open_vertices(count) == Status::ok);
        for (std::uint32_t v = 0; v < count; ++v) std::copy_n(&points[std::size_t{v} * D], D, store.vertex(v).x);
        REQUIRE(tree.build(store, block.arena, count) == Status::ok);
    }
    FeatureIntegral integral(const double* centre, const double* radius, double tolerance, std::uint64_t boxes) {
        FeatureIntegral i;
        REQUIRE(feature_integral(store, tree, {centre, radius, 3, tolerance, boxes}, {block.arena, monitor}, &i) ==
                Status::ok);
        return i;
    }
    Block block;
    StoreState state = {};
    Store<D> store;
    Monitor monitor;
    InputTree<D> tree;
    std::uint32_t count;
};

// The origin and a step along each axis, another one along the first.
template <int D> inputs::Points star(double step) {
    inputs::Points p((D + 2) * D, 0.0);
    for (int k = 0; k < D; ++k) p[static_cast<std::size_t>((k + 1) * D + k)] = step;
    p[(D + 1) * D] = -step;
    return p;
}

}  // namespace

TEST_CASE_TEMPLATE_DEFINE("the feature size integral does not know scale or place", T, scale) {
    constexpr int D = T::value;
    const double radius[3] = {2, 3, 4};
    const double centre[D] = {};
    Cloud<D> cloud(star<D>(2));
    const FeatureIntegral here = cloud.integral(centre, radius, infinity, 0);
    for (int j = 0; j < 3; ++j) CHECK(here.lower[j] < here.upper[j]);
    {  // all boxes are the same but for a power of two
        Cloud<D> small(star<D>(2 * 0x1p-10));
        const double less[3] = {2 * 0x1p-10, 3 * 0x1p-10, 4 * 0x1p-10};
        const FeatureIntegral i = small.integral(centre, less, infinity, 0);
        CHECK(i.boxes == here.boxes);
        for (int j = 0; j < 3; ++j) {
            CHECK(i.lower[j] == doctest::Approx(here.lower[j]).epsilon(1e-12));
            CHECK(i.upper[j] == doctest::Approx(here.upper[j]).epsilon(1e-12));
        }
    }
    // Elsewhere, and so far away that boxes cannot be split as they have to be.
    for (const double away : {100.0, 0x1p53}) {
        inputs::Points moved = star<D>(2);
        for (double& x : moved) x += away;
        double there[D];
        for (double& x : there) x = away;
        Cloud<D> far(moved);
        const FeatureIntegral i = far.integral(there, radius, infinity, 0);
        for (int j = 0; j < 3; ++j) {
            CHECK(i.lower[j] <= here.upper[j]);
            CHECK(here.lower[j] <= i.upper[j]);
            CHECK(i.lower[j] <= i.upper[j]);
            CHECK(std::isfinite(i.upper[j]));
        }
    }
    // A tolerance that takes more boxes than there may be.
    const double boxes = static_cast<double>(here.boxes), most = boxes * std::sqrt(std::ldexp(1.0, D)) * 1.5;
    const FeatureIntegral finer = cloud.integral(centre, radius, 1e-3, static_cast<std::uint64_t>(most));
    CHECK(finer.boxes > here.boxes);
    for (int j = 0; j < 3; ++j) {
        CHECK(finer.upper[j] / finer.lower[j] < here.upper[j] / here.lower[j]);
        CHECK(finer.lower[j] <= here.upper[j]);
        CHECK(here.lower[j] <= finer.upper[j]);
    }
}
TEST_CASE_TEMPLATE_APPLY(scale, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("a close pair shows in paces, a wide domain in the ball of vertices", T, close_pair) {
    constexpr int D = T::value;
    constexpr double gaps = by_dimension<double>(D, {1e-4, 1e-6, 1e-12, 1e-24, 1e-3});
    inputs::Points points = star<D>(1);
    points[(D + 1) * D] = gaps;
    Held<D> held(std::size_t{1} << 23);
    REQUIRE(held.triangulate(points) == Status::ok);
    held.domain.radius = 10;  // more than seven enclosing radii
    held.domain.enclosing_radius = 1;
    SizeAnalysis a;
    REQUIRE(analyse_size(held.store, held.domain, held.inputs(), {3, {}, infinity, 0}, {held.block.arena, held.monitor},
                         &a) == Status::ok);
    CHECK(a.radius[ball_wide] == a.radius[ball_vertices]);
    CHECK(a.theta == doctest::Approx(gaps).epsilon(0.01));
    CHECK(a.theta_limit == doctest::Approx(2 * a.theta / (1 - 3 * a.theta)));
    const double gain = D * std::log(1 / a.theta) / std::pow(3, D) + std::pow(a.theta, D) - 1;
    if (gain > 0)
        CHECK(a.pace_lower == doctest::Approx(unit_ball_volume(D) * gain).epsilon(1e-4));
    else
        CHECK(a.pace_lower == 0);
    CHECK((gain > 0) == (D < 6));
    CHECK(a.integral.lower[ball_wide] >= a.pace_lower);
}
TEST_CASE_TEMPLATE_APPLY(close_pair, Dimensions<>);

TEST_CASE("the bound on the feature ratio needs a tau that yields, and sizes below the feature size") {
    CHECK(feature_ratio_bound(2.0001, {}) == infinity);
    SizeRule rule;
    const double bound = feature_ratio_bound(3, rule);
    CHECK(bound > 1);
    rule.eps = 2;
    CHECK(feature_ratio_bound(3, rule) == bound);
    rule.eps = 0.5;
    CHECK(feature_ratio_bound(3, rule) == 2 * bound);
}

TEST_CASE_TEMPLATE_DEFINE("balls whose squares no double holds", T, squares) {
    constexpr int D = T::value;
    inputs::Points points = inputs::uniform(D, 3 * D);
    StructureAnalysis a[2];
    for (const bool huge : {false, true}) {
        for (double& x : points) x *= huge ? 0x1p600 : 1;
        Held<D> held(std::size_t{1} << 23);
        REQUIRE(held.triangulate(points) == Status::ok);
        const double centre[D] = {};
        REQUIRE(analyse_structure<D>(held.store, centre, 1, {held.block.arena, held.monitor}, &a[huge]) == Status::ok);
    }
    CHECK(a[1].degree_max == a[0].degree_max);
    CHECK(a[1].star_max == a[0].star_max);
    CHECK(a[0].balls > 0);
    CHECK(a[1].balls == 0);
    CHECK(a[1].ply_max == 1);
}
TEST_CASE_TEMPLATE_APPLY(squares, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("structure in little memory, and stopped", T, little_memory) {
    constexpr int D = T::value;
    constexpr std::size_t few = by_dimension<std::size_t>(D, {3000, 300, 40, 16, 12});
    Held<D> held(std::size_t{1} << 23);
    REQUIRE(held.triangulate(inputs::uniform(D, few)) == Status::ok);
    const double centre[D] = {};
    StructureAnalysis whole, part;
    Polls polls;
    Monitor counting(Polls::answer, &polls);
    {
        const Watch watch(held.block.arena, counting);
        REQUIRE(analyse_structure<D>(held.store, centre, 1, {held.block.arena, counting}, &whole) == Status::ok);
    }
    REQUIRE(polls.made > 0);
    for (long stop = 0; stop < polls.made; stop += 1 + polls.made / 8) {
        Polls stopped = {0, stop};
        Monitor monitor(Polls::answer, &stopped);
        const Watch watch(held.block.arena, monitor);
        const Status status = analyse_structure<D>(held.store, centre, 1, {held.block.arena, monitor}, &part);
        CHECK(watch.heed(status) == Status::cancelled);
        CHECK(stopped.made == stop + 1);
    }
    const std::size_t free_bytes = held.block.arena.bytes_free(), high = held.block.arena.high_mark();
    int refused = 0;
    for (std::size_t left = 32; left < free_bytes; left += 16 + left / 16) {
        // In the gap, where cells are listed.
        REQUIRE(held.block.arena.template take_high<unsigned char>(free_bytes - left) != nullptr);
        const Status status = analyse_structure<D>(held.store, centre, 1, {held.block.arena, held.monitor}, &part);
        held.block.arena.release_high(high);
        CHECK(held.block.arena.bytes_free() == free_bytes);
        if (status == Status::ok) {
            CHECK(part.intersections_max == whole.intersections_max);
            CHECK(part.ply_max == whole.ply_max);
            break;
        }
        CHECK(status == Status::out_of_memory);
        ++refused;
    }
    CHECK(refused > 2);
}
TEST_CASE_TEMPLATE_APPLY(little_memory, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("fatness of cells in a wide domain", T, wide_domain) {
    constexpr int D = T::value;
    constexpr std::size_t few = by_dimension<std::size_t>(D, {20, 10, 7, 8, 8});
    Held<D> held(std::size_t{1} << 23);
    REQUIRE(held.mesh(inputs::uniform(D, few), D < 6 ? 2.2 : 3) == Status::ok);
    FatnessAnalysis narrow, wide;
    REQUIRE(analyse_fatness<D>(held.store, held.domain, {held.block.arena, held.monitor}, &narrow) == Status::ok);
    held.domain.radius *= 8;
    REQUIRE(analyse_fatness<D>(held.store, held.domain, {held.block.arena, held.monitor}, &wide) == Status::ok);
    CHECK(wide.inside.cells > narrow.inside.cells);
    CHECK(wide.bounded.cells == narrow.bounded.cells);
    CHECK(wide.bounded.beta_max == narrow.bounded.beta_max);
    for (const FatPart* part : {&wide.bounded, &wide.inside}) CHECK(violated_fatness_bound(*part) == nullptr);
    CHECK(wide.clipped >= wide.inside.cells);
    CHECK(wide.clipped_max >= wide.inside.beta_max * (1 - 1e-9));
    held.domain.radius *= 1e3;
    REQUIRE(analyse_fatness<D>(held.store, held.domain, {held.block.arena, held.monitor}, &wide) == Status::ok);
    CHECK(wide.inside.cells == wide.bounded.cells);
}
TEST_CASE_TEMPLATE_APPLY(wide_domain, Dimensions<>);

// A vertex with others all around it, and balls about places beside it of about its cell's size: where the ball's
// sphere is farthest from the vertex in the middle of the cell, or of one of its faces, no edge ends.
TEST_CASE_TEMPLATE_DEFINE("what is in a ball and in a cell is in the cell's out-ball and within its reach", T, cut) {
    constexpr int D = T::value;
    int cut_cells = 0;
    for (std::uint64_t set = 0; set < by_dimension<std::uint64_t>(D, {200, 200, 100, 60, 90}); ++set) {
        CAPTURE(set);
        inputs::Random random(set);
        inputs::Points points(D, 0.0);
        for (int i = 0; i < 2 * D + (D < 5 ? 3 : 0); ++i)
            for (int k = 0; k < D; ++k)
                points.push_back(i >= 2 * D ? 3 * random.uniform() - 1.5
                                            : 0.4 * (random.uniform() - 0.5) +
                                                  (k == i / 2 ? (i % 2 == 0 ? 1 : -1) * (0.6 + random.uniform()) : 0));
        Held<D> held(std::size_t{1} << 21);
        REQUIRE(held.triangulate(points) == Status::ok);
        Domain<D> ball = {};
        for (double& c : ball.centre) c = random.uniform() - 0.5;
        // Corners of a cell that is nearly a cube are farther from its vertex than its faces are.
        ball.radius = ball.enclosing_radius = (0.2 + random.uniform()) * std::sqrt(D / 2.0);
        FatCells cells(held.store, ball, held.block.arena, nullptr, 0);
        FatCell cell;
        REQUIRE(cells.measure(VertexId(0), &cell) == Status::ok);
        // Of a cell that has neither corners nor edges in the ball nothing is said.
        if (!cell.known || !cell.bounded || cell.whole || !(cell.reach > 0)) continue;
        ++cut_cells;
        for (int sample = 0; sample < 500; ++sample) {
            // Most of them on the sphere.
            double x[D], away2 = 0;
            for (double& c : x) {
                c = 2 * random.uniform() - 1;
                away2 += c * c;
            }
            if (!(away2 > 0)) continue;
            const double stretch = ball.radius / std::sqrt(away2) * (sample % 4 == 0 ? random.uniform() : 1);
            for (int k = 0; k < D; ++k) x[k] = ball.centre[k] + stretch * x[k];
            const double to_vertex = distance(x, held.store.point(0), D);
            bool nearest = true;
            for (std::uint32_t w = 1; w < held.state.vertex_count; ++w)
                nearest &= to_vertex <= distance(x, held.store.point(w), D);
            if (!nearest) continue;
            CHECK(to_vertex <= cell.reach * (1 + 1e-9));
            CHECK(distance(x, cell.out_centre, D) <= cell.out_radius * (1 + 1e-9));
        }
    }
    CHECK(cut_cells > 10);
}
TEST_CASE_TEMPLATE_APPLY(cut, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("in-balls of cells that are open", T, open_in_balls) {
    constexpr int D = T::value;
    // One half-space, a wedge, a slab: what is found is inside, and in a slab it is as large as can be.
    for (int planes = 1; planes <= 3; ++planes) {
        double w[3][D] = {}, centre[D];
        w[0][0] = 2;
        w[1][1] = 3;
        w[2][0] = -4;
        const double radius = largest_inscribed_ball(D, w[0], static_cast<std::uint32_t>(planes), 2, centre);
        CHECK(radius >= 1);
        CHECK(std::isfinite(radius));
        for (int i = 0; i < planes; ++i) {
            double length2 = 0, along = 0;
            for (int k = 0; k < D; ++k) {
                length2 += w[i][k] * w[i][k];
                along += w[i][k] * centre[k];
            }
            CHECK(along / std::sqrt(length2) + radius <= std::sqrt(length2) / 2 * (1 + 1e-12));
        }
        if (planes == 3) CHECK(radius == doctest::Approx(1.5));
    }
}
TEST_CASE_TEMPLATE_APPLY(open_in_balls, Dimensions<>);

TEST_CASE_TEMPLATE_DEFINE("paces of a line's points one after the other", T, line) {
    constexpr int D = T::value;
    const std::uint32_t n = 13000;
    inputs::Points points(std::size_t{n} * D, 1.0);
    for (std::uint32_t i = 0; i < n; ++i) points[std::size_t{i} * D] = i;
    Cloud<D> cloud(points);
    std::vector<std::uint32_t> order(n);
    for (std::uint32_t i = 0; i < n; ++i) order[i] = i;
    std::vector<double> theta(n, 0.0);
    REQUIRE(pace(cloud.store, cloud.tree, order.data(), n, {cloud.block.arena, cloud.monitor}, theta.data()) ==
            Status::ok);
    CHECK(theta[1] == 1);
    for (std::uint32_t i = 2; i < n; ++i) REQUIRE(theta[i] == 0.5);
    Polls polls = {0, 0};
    Monitor stopping(Polls::answer, &polls);
    CHECK(pace(cloud.store, cloud.tree, order.data(), n, {cloud.block.arena, stopping}, theta.data()) ==
          Status::cancelled);
}
TEST_CASE_TEMPLATE_APPLY(line, Dimensions<>);

TEST_CASE("a vertex in no cell changes no figure") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Session s(dim);
        REQUIRE(s.mesh(inputs::uniform(dim, dim == 2 ? 8 : 4)) == NETMESH_OK);
        Arrays mesh(s);
        std::uint64_t print[2];
        s.reserve(std::size_t{1} << 22);
        for (int extra = 0; extra < 2; ++extra) {
            REQUIRE(mesh.load(s) == NETMESH_OK);
            netmesh_analysis a;
            REQUIRE(s.analyse(&a, NETMESH_ANALYSE_ALL, 100) == NETMESH_OK);
            CHECK(a.size.lower < a.size.upper);
            print[extra] = a.fingerprint;
            for (int k = 0; k < dim; ++k) mesh.vertices.push_back(mesh.domain[static_cast<std::size_t>(k)] + 0.01);
            mesh.markers.push_back(1);
        }
        CHECK(print[0] == print[1]);
    }
}

TEST_CASE("tolerances of their own, and meshes of which sizes say nothing") {
    for (const int dim : dimensions()) {
        CAPTURE(dim);
        Session s(dim);
        netmesh_analysis a;
        const auto analyse = [&](double tolerance) {
            REQUIRE(s.analyse(&a, NETMESH_ANALYSE_SIZE, tolerance) == NETMESH_OK);
            CHECK(a.what == NETMESH_ANALYSE_SIZE);
            CHECK(a.structure.ply_points == 0);
            CHECK(a.size.integral_lower[0] < a.size.integral_upper[0]);
        };
        const inputs::Points points = inputs::uniform(dim, 2);
        s.reserve(std::size_t{1} << 22);
        REQUIRE(s.mesh(points) == NETMESH_OK);
        analyse(0);
        CHECK(a.size.lower > 0);
        CHECK(std::isfinite(a.size.upper));
        s.request.goal.ratio = 3;  // its quality is not the aspect ratio
        REQUIRE(s.mesh(points, &netmesh_filter_complete) == NETMESH_OK);
        analyse(40);
        CHECK(a.size.lower == 0);
        CHECK(std::isinf(a.size.upper));
        CHECK(std::isinf(a.size.feature_ratio_bound));
        s.request.goal.ratio = 0;
        s.request.mesh.method = &netmesh_method_netmesh;
        REQUIRE(s.mesh(inputs::geometric(dim, 40, 3)) == NETMESH_OK);
        REQUIRE(s.report().mesh.hierarchy.cages > 0);
        analyse(40);
        CHECK(a.size.lower > 0);
        CHECK(a.size.lower <= static_cast<double>(a.size.vertices));
        CHECK(static_cast<double>(a.size.vertices) <= a.size.upper);
        CHECK(std::isfinite(a.size.upper));
        CHECK(std::isinf(a.size.feature_ratio_bound));
        std::uint32_t order[] = {0, 1, 4, 2};  // there is no input 4
        double theta[4];
        REQUIRE(s.report().mesh.inputs == 4);
        CHECK(netmesh_pace(s.context, order, theta) == NETMESH_INVALID_ARGUMENT);
        order[2] = 3;
        CHECK(netmesh_pace(s.context, order, theta) == NETMESH_OK);
    }
}
